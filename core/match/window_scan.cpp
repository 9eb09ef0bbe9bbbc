#include "core/match/window_scan.h"

#include "core/base/wide_vectors.h"
#include "core/image/mirror.h"
#include "core/math/pca.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace texloom {

namespace {

constexpr int kScanLanes = 8;
/// Candidates that are compared at a time, and terms after which they may be given up.
constexpr int kScannedAtOnce = 2 * kScanLanes;
constexpr int kTerms = 4;
/// Colours are learnt from about this many pixels.
constexpr double kScanSamples = 20000;

float valueSpan(std::span<const PatchSource> exemplars) {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const PatchSource& exemplar : exemplars) {
        const ValueRange range = valueRange(exemplar.image);
        low = std::min(low, range.smallest);
        high = std::max(high, range.largest);
    }
    return high - low;
}

std::vector<float> gaussian(int window, double sigma) {
    std::vector<float> weights;
    const int reach = window / 2;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            weights.push_back(static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma))));
    return weights;
}

NeighbourhoodSet wholeWindows(std::span<const PatchSource> exemplars, const std::vector<Interleaved>& pixels,
                              int window, const std::vector<float>& weights,
                              const std::function<void()>& check) {
    std::vector<NeighbourhoodSource> sources;
    for (std::size_t e = 0; e < exemplars.size(); ++e)
        sources.push_back({{&pixels[e]}, exemplars[e].mask, exemplars[e].weight});
    return {Neighbourhood({{squareRuns(window), false, weights}}, {pixels.front().pixel}), std::move(sources),
            check};
}

std::vector<Interleaved> roomFor(std::span<const PatchSource> exemplars) {
    std::vector<Interleaved> pixels;
    for (const PatchSource& exemplar : exemplars)
        pixels.emplace_back(exemplar.image.size(), exemplar.image.channels);
    return pixels;
}

} // namespace

WindowScan::WindowScan(std::span<const PatchSource> exemplars, int window, double sigma,
                       const std::function<void()>& check)
    : m_window(window), m_channels(exemplars.front().image.channels), m_pixels(roomFor(exemplars)),
      m_weights(gaussian(window, sigma)), m_set(wholeWindows(exemplars, m_pixels, window, m_weights, check)) {
    const float step = valueSpan(exemplars) / 255;
    m_smallest = step * step;
    learnColours(exemplars);
    for (std::size_t e = 0; e < exemplars.size(); ++e)
        m_pixels[e].data = turned(exemplars[e].image, check).data;
    makePlanes(check);
    orderOffsets(sigma);
    findRows();
}

void WindowScan::learnColours(std::span<const PatchSource> exemplars) {
    double pixels = 0;
    for (const PatchSource& exemplar : exemplars)
        pixels += static_cast<double>(exemplar.image.size().area());
    const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kScanSamples)));
    std::vector<double> samples;
    for (const PatchSource& exemplar : exemplars)
        for (int y = 0; y < exemplar.image.height; y += step)
            for (int x = 0; x < exemplar.image.width; x += step)
                for (int c = 0; c < m_channels; ++c)
                    samples.push_back(static_cast<double>(exemplar.image(x, y, c)));
    const PrincipalAxes principal = principalAxes(samples, m_channels, m_channels);
    m_mean = principal.mean;
    m_axes = principal.axes;
    m_variances = principal.variances;
}

Interleaved WindowScan::turned(const ImageView& image, const std::function<void()>& check) const {
    Interleaved pixels(image.size(), m_channels);
    const auto channels = static_cast<std::size_t>(m_channels);
    std::vector<double> colour(channels);
    for (int y = 0; y < image.height; ++y) {
        check();
        for (int x = 0; x < image.width; ++x) {
            for (std::size_t c = 0; c < channels; ++c)
                colour[c] = static_cast<double>(image(x, y, static_cast<int>(c))) - m_mean[c];
            float* to = pixels.data.data() + y * pixels.stride() + x * pixels.pixel;
            for (std::size_t a = 0; a < channels; ++a) {
                double sum = 0;
                for (std::size_t c = 0; c < channels; ++c)
                    sum += m_axes[a * channels + c] * colour[c];
                to[a] = static_cast<float>(sum);
            }
        }
    }
    return pixels;
}

void WindowScan::makePlanes(const std::function<void()>& check) {
    for (const Interleaved& pixels : m_pixels) {
        // Blocks may read beyond the last row's end.
        const auto area = static_cast<std::size_t>(pixels.size.area()) + kScannedAtOnce;
        std::vector<float>& planes = m_planes.emplace_back(area * static_cast<std::size_t>(m_channels), 0.0F);
        for (std::size_t a = 0; a < static_cast<std::size_t>(m_channels); ++a) {
            check();
            for (std::size_t i = 0; i + kScannedAtOnce < area; ++i)
                planes[a * area + i] = pixels.data[i * static_cast<std::size_t>(pixels.pixel) + a];
        }
    }
}

const float* WindowScan::plane(int exemplar, int axis) const {
    const auto e = static_cast<std::size_t>(exemplar);
    const auto area = static_cast<std::size_t>(m_pixels[e].size.area()) + kScannedAtOnce;
    return m_planes[e].data() + static_cast<std::size_t>(axis) * area;
}

void WindowScan::orderOffsets(double sigma) {
    const int reach = m_window / 2;
    std::size_t at = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx, ++at)
            for (int a = 0; a < m_channels; ++a) {
                // Near pixels are alike, whatever their weight: what tells windows apart lies about σ away.
                const double apart = std::sqrt(dx * dx + dy * dy) / sigma;
                const double variance = std::max(0.0, m_variances[static_cast<std::size_t>(a)]);
                const double share =
                    static_cast<double>(m_weights[at]) * variance * std::min(1.0, 0.5 + apart);
                m_offsets.push_back({dx, dy, a, m_weights[at], static_cast<float>(share)});
            }
    std::stable_sort(m_offsets.begin(), m_offsets.end(),
                     [](const Offset& a, const Offset& b) { return a.expected > b.expected; });
}

void WindowScan::findRows() {
    for (const Source& source : m_set.sources()) {
        if (!m_rows.empty()) {
            Row& last = m_rows.back();
            if (last.exemplar == source.exemplar && last.y == source.y && last.x + last.count == source.x) {
                ++last.count;
                continue;
            }
        }
        m_rows.push_back({source.exemplar, source.x, source.y, 1});
    }
}

void WindowScan::look(const PixelCanvas& canvas, const KnownPixels& known, int x, int y, Wrap wrap,
                      Query& query) const {
    const Size size = canvas.size();
    query.m_terms.clear();
    query.m_whole = 0;
    for (std::size_t i = 0; i < m_offsets.size(); ++i) {
        const Offset& offset = m_offsets[i];
        int column = x + offset.dx, row = y + offset.dy;
        if (column < 0 || column >= size.width) {
            if (!wrap.x)
                continue;
            column = repeated(column, size.width);
        }
        if (row < 0 || row >= size.height) {
            if (!wrap.y)
                continue;
            row = repeated(row, size.height);
        }
        // The centre is what is asked for, even where it is met round the border.
        const float trust = known.trust(column, row);
        if (trust == 0 || (offset.dx == 0 && offset.dy == 0))
            continue;
        const float weight = trust * offset.weight;
        query.m_terms.push_back({static_cast<int>(i), weight, canvas.pixels.at(column, row)[offset.axis]});
        query.m_whole += offset.axis == 0 ? weight : 0;
    }
}

void WindowScan::complete(const PixelCanvas& canvas, const KnownPixels& known, int x, int y, Wrap wrap,
                          const Source& standIn, std::vector<float>& vector) const {
    const Size size = canvas.size();
    const int reach = m_window / 2, pixel = canvas.pixels.pixel;
    vector.resize(m_weights.size() * static_cast<std::size_t>(pixel));
    std::vector<const float*> seen;
    std::vector<float> mean(static_cast<std::size_t>(pixel), 0.0F);
    float whole = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const int column = wrap.x ? repeated(x + dx, size.width) : x + dx;
            const int row = wrap.y ? repeated(y + dy, size.height) : y + dy;
            const bool lies = column >= 0 && row >= 0 && column < size.width && row < size.height;
            const float weight = m_weights[seen.size()];
            seen.push_back(lies && known.trust(column, row) > 0 ? canvas.pixels.at(column, row) : nullptr);
            if (!seen.back())
                continue;
            for (std::size_t c = 0; c < mean.size(); ++c)
                mean[c] += weight * seen.back()[c];
            whole += weight;
        }
    for (float& value : mean)
        value = whole > 0 ? value / whole : 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const float* from = seen[i];
        if (!from && standIn.valid()) {
            const int at = static_cast<int>(i);
            from = pixels(standIn.exemplar)
                       .at(standIn.x + at % m_window - reach, standIn.y + at / m_window - reach);
        }
        std::copy_n(from ? from : mean.data(), pixel, vector.data() + i * mean.size());
    }
}

WindowScan::Bound WindowScan::boundFor(const Query& query, double tolerance) const {
    return {static_cast<float>(1 + tolerance), m_smallest * query.m_whole,
            std::numeric_limits<float>::infinity()};
}

/// Points the terms at the pixels of an exemplar.
void WindowScan::bind(Query& query, int exemplar) const {
    const std::ptrdiff_t stride = m_pixels[static_cast<std::size_t>(exemplar)].size.width;
    query.m_factors.clear();
    for (const Query::Term& term : query.m_terms) {
        const Offset& offset = m_offsets[static_cast<std::size_t>(term.number)];
        query.m_factors.push_back(
            {plane(exemplar, offset.axis) + offset.dy * stride + offset.dx, term.weight, term.value});
    }
}

/// The terms in the order of scanRow(), so that the sum is the same to the bit.
float WindowScan::distance(const Query& query, const Source& source, float limit) const {
    const std::ptrdiff_t at =
        static_cast<std::ptrdiff_t>(source.y) * m_pixels[source.exemplar].size.width + source.x;
    float sum = 0;
    for (const Factor& factor : query.m_factors) {
        const float difference = factor.from[at] - factor.value;
        sum += factor.weight * (difference * difference);
        if (sum > limit)
            break;
    }
    return sum;
}

namespace {

/// Compares a row of windows, the first of which lies `at` floats from the exemplar's beginning.
TEXLOOM_WIDE_VECTORS void scanRow(std::span<const WindowScan::Factor> factors, const WindowScan::Row& row,
                                  std::ptrdiff_t at, WindowScan::Bound& bound,
                                  std::vector<WindowScan::Found>& found) {
    using Vector =
        float __attribute__((vector_size(kScanLanes * sizeof(float)), aligned(alignof(float)), may_alias));
    const std::size_t count = factors.size();
    for (int x = 0; x < row.count; x += kScannedAtOnce) {
        Vector first{}, second{};
        std::size_t term = 0;
        while (term < count) {
            const std::size_t end = std::min(count, term + kTerms);
            for (; term < end; ++term) {
                const float* from = factors[term].from + at + x;
                const float weight = factors[term].weight, value = factors[term].value;
                const Vector a = *reinterpret_cast<const Vector*>(from) - value;
                const Vector b = *reinterpret_cast<const Vector*>(from + kScanLanes) - value;
                first += weight * (a * a);
                second += weight * (b * b);
            }
            const auto open = (first <= bound.limit) | (second <= bound.limit);
            int any = 0;
            for (int lane = 0; lane < kScanLanes; ++lane)
                any |= open[lane];
            if (any == 0)
                break;
        }
        if (term < count)
            continue;
        for (int lane = 0; lane < std::min(kScannedAtOnce, row.count - x); ++lane) {
            const float sum = lane < kScanLanes ? first[lane] : second[lane - kScanLanes];
            if (sum > bound.limit)
                continue;
            bound.lower(sum);
            found.push_back({sum,
                             {static_cast<std::uint16_t>(row.x + x + lane), static_cast<std::uint16_t>(row.y),
                              static_cast<std::uint16_t>(row.exemplar)}});
        }
    }
}

} // namespace

/// What is wanted of a row.
WindowScan::Row WindowScan::wanted(const Row& row, const Nearby& nearby) const {
    if (!nearby.limits(m_pixels[static_cast<std::size_t>(row.exemplar)].size))
        return row;
    const int first = std::max(row.x, nearby.x - nearby.radius);
    const int end = std::min(row.x + row.count, nearby.x + nearby.radius + 1);
    const bool far = std::abs(row.y - nearby.y) > nearby.radius;
    return {row.exemplar, first, row.y, far ? 0 : std::max(0, end - first)};
}

void WindowScan::within(double tolerance, const Nearby& nearby, std::span<const Source> hints, Query& query,
                        std::vector<Found>& found, const std::function<void()>& check) const {
    constexpr int kRows = 64;
    found.clear();
    Bound bound = boundFor(query, tolerance);
    for (int e = 0; e < static_cast<int>(m_pixels.size()) && !hints.empty(); ++e) {
        bind(query, e);
        for (const Source& hint : hints)
            if (hint.exemplar == e && lies(hint, nearby))
                bound.lower(distance(query, hint, bound.limit));
    }
    int pointed = -1, scanned = 0;
    for (const Row& whole : m_rows) {
        const Row row = wanted(whole, nearby);
        if (row.count == 0)
            continue;
        if (scanned++ % kRows == 0)
            check();
        if (row.exemplar != pointed) {
            bind(query, row.exemplar);
            pointed = row.exemplar;
        }
        const int width = m_pixels[static_cast<std::size_t>(row.exemplar)].size.width;
        scanRow(query.m_factors, row, static_cast<std::ptrdiff_t>(row.y) * width + row.x, bound, found);
    }
    std::erase_if(found, [&](const Found& one) { return one.distance > bound.limit; });
    if (scanned == 0)
        within(tolerance, {}, hints, query, found, check);
}

void WindowScan::withinOf(std::span<const Source> windows, double tolerance, Query& query,
                          std::vector<Found>& found) const {
    found.clear();
    Bound bound = boundFor(query, tolerance);
    for (int e = 0; e < static_cast<int>(m_pixels.size()); ++e) {
        bind(query, e);
        for (const Source& source : windows) {
            if (source.exemplar != e)
                continue;
            const float sum = distance(query, source, bound.limit);
            if (sum > bound.limit)
                continue;
            bound.lower(sum);
            found.push_back({sum, source});
        }
    }
    std::erase_if(found, [&](const Found& one) { return one.distance > bound.limit; });
}

Source WindowScan::nearestOf(std::span<const Source> windows, Query& query) const {
    Source nearest = windows.front();
    float limit = std::numeric_limits<float>::infinity();
    for (int e = 0; e < static_cast<int>(m_pixels.size()); ++e) {
        bind(query, e);
        for (const Source& source : windows) {
            const float sum = source.exemplar == e ? distance(query, source, limit) : limit;
            if (sum < limit) {
                limit = sum;
                nearest = source;
            }
        }
    }
    return nearest;
}

std::uint64_t WindowScan::bytesFor(std::span<const Size> exemplars, int channels) {
    std::uint64_t bytes = NeighbourhoodSet::bytesFor(exemplars);
    for (const Size& size : exemplars)
        bytes +=
            2 * Interleaved::bytesFor(size, channels) +
            static_cast<std::uint64_t>(size.area()) * static_cast<std::uint64_t>(channels) * sizeof(float) +
            (1U << 20U);
    return bytes;
}

} // namespace texloom
