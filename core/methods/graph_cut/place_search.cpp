#include "core/methods/graph_cut/place_search.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace texloom::graph_cut {

namespace {

/// Streams of random numbers, by what is drawn.
constexpr std::uint32_t kPlace = 0, kColumn = 1, kRow = 2, kExemplar = 3;

/// Pixels of an exemplar's side that are pasted at once: on an axis that wraps, few enough that no patch
/// meets itself.
int reachOf(int side, int output, bool wraps) {
    return wraps ? std::min(side, std::max(1, 2 * output / 3)) : side;
}

/// Side of the transforms: differences are wanted for anchors at up to half a side, over windows that reach
/// three quarters of a side beyond the anchor.
int transformSide(int side, bool whole) {
    return fastFftLength(whole ? 3 * side / 2 + 2 : side);
}

/// The first of these running sums that a uniform number in [0, 1) does not reach.
std::size_t chosen(const std::vector<double>& sums, double uniform) {
    const auto found = std::upper_bound(sums.begin(), sums.end(), uniform * sums.back());
    return static_cast<std::size_t>(std::min(found, sums.end() - 1) - sums.begin());
}

/// The pixels of both.
Region common(const Region& a, const Region& b) {
    const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, {std::min(a.right(), b.right()) - x, std::min(a.bottom(), b.bottom()) - y}};
}

bool looksAtWhole(const Settings& settings) {
    return settings.placement != Placement::SubPatch;
}

} // namespace

PlaceSearch::PlaceSearch(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_initial(request.initial()), m_settings(settings), m_context(context) {
    const Image& first = *request.exemplars.front().image;
    m_means = channelMeans(first, [&] { context.check(); });
    double pixels = 0;
    for (const Exemplar& exemplar : request.exemplars) {
        for (int y = 0; y < exemplar.image->height(); ++y) {
            context.check();
            for (int x = 0; x < exemplar.image->width(); ++x)
                for (int c = 0; c < first.channels(); ++c) {
                    const double value = static_cast<double>((*exemplar.image)(x, y, c)) -
                                         m_means[static_cast<std::size_t>(c)];
                    m_variance += value * value;
                }
        }
        pixels += static_cast<double>(exemplar.image->size().area());
    }
    m_variance /= pixels;
    for (const Exemplar& exemplar : request.exemplars)
        addExemplar(exemplar);
}

void PlaceSearch::addExemplar(const Exemplar& exemplar) {
    const Size size = exemplar.image->size();
    const bool whole = looksAtWhole(m_settings);
    const RealFft2d fft({transformSide(size.width, whole), transformSide(size.height, whole)});
    Transforms own{fft,
                   {},
                   {},
                   {},
                   {reachOf(size.width, m_request.size.width, m_request.wrap.x),
                    reachOf(size.height, m_request.size.height, m_request.wrap.y)}};
    const int channels = exemplar.image->channels();
    const Image* const mask = exemplar.mask();
    FftBuffer<float> plane(fft.imageSize());
    const auto transformed = [&](const auto& value) {
        std::fill_n(plane.data(), fft.imageSize(), 0.0F);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                if (!mask || (*mask)(x, y, 0) != 0)
                    plane.data()[y * fft.rowStride() + x] = static_cast<float>(value(x, y));
        Spectrum spectrum(fft.spectrumSize());
        fft.forward(plane.data(), spectrum.data(), [this] { m_context.check(); });
        return spectrum;
    };
    const auto sampleAt = [&](int x, int y, int c) {
        return static_cast<double>((*exemplar.image)(x, y, c)) - m_means[static_cast<std::size_t>(c)];
    };
    for (int c = 0; c < channels; ++c)
        own.channels.push_back(transformed([&](int x, int y) { return sampleAt(x, y, c); }));
    own.squares = transformed([&](int x, int y) {
        double sum = 0;
        for (int c = 0; c < channels; ++c)
            sum += sampleAt(x, y, c) * sampleAt(x, y, c);
        return sum;
    });
    own.shape = transformed([](int, int) { return 1; });
    m_exemplars.push_back(std::move(own));
}

/// The patch is wanted to begin between a quarter and half of its side before the anchor, so that it overlaps
/// what is there and still covers new pixels; where only a part of the exemplar is pasted, that part may lie
/// anywhere.
PlaceSearch::Frame PlaceSearch::wholeFrame(std::size_t exemplar) const {
    const Size size = m_request.exemplars[exemplar].image->size(), reach = m_exemplars[exemplar].reach;
    struct Range {
        int first, count, before, length;
    };
    const auto along = [](int side, int part) {
        const int quarter = part / 4;
        if (part < side)
            return Range{quarter, side - part + 1, quarter, part};
        const int half = std::max(quarter, (part - 1) / 2);
        return Range{quarter, half - quarter + 1, half, half + part - quarter};
    };
    const Range x = along(size.width, reach.width), y = along(size.height, reach.height);
    return {{-x.before, -y.before, {x.length, y.length}}, {x.first, y.first, {x.count, y.count}}};
}

/// The square lies wholly in the exemplar. @param offset of its top left from the anchor.
PlaceSearch::Frame PlaceSearch::squareFrame(std::size_t exemplar, int offset) const {
    const Size size = m_request.exemplars[exemplar].image->size();
    const int patch = m_settings.patch;
    return {{offset, offset, {patch, patch}},
            {-offset, -offset, {size.width - patch + 1, size.height - patch + 1}}};
}

/// What is to be matched at a place of the output: what is there, else the initial image.
float PlaceSearch::sample(const Canvas& canvas, int x, int y, int channel, bool& counts) const {
    counts = canvas.settle(x, y) && (canvas.known(x, y) || m_initial);
    if (!counts)
        return 0;
    const Image& image = canvas.known(x, y) ? canvas.image() : *m_initial;
    return image(x, y, channel) - static_cast<float>(m_means[static_cast<std::size_t>(channel)]);
}

/// Writes sums of squares, and how many pixels are in them, for every pixel of the exemplar on the anchor.
void PlaceSearch::measure(const Canvas& canvas, int x, int y, const Frame& frame,
                          const Transforms& exemplar) {
    const RealFft2d& fft = exemplar.fft;
    const int channels = m_request.channels(), planes = channels + 2;
    m_planes.resize(static_cast<std::size_t>(planes));
    m_spectra.resize(static_cast<std::size_t>(planes));
    m_context.parallel(0, planes, [&](int p) {
        auto& plane = m_planes[static_cast<std::size_t>(p)];
        auto& spectrum = m_spectra[static_cast<std::size_t>(p)];
        if (plane.size() != fft.imageSize()) {
            plane = FftBuffer<float>(fft.imageSize());
            spectrum = Spectrum(fft.spectrumSize());
        }
        std::fill_n(plane.data(), fft.imageSize(), 0.0F);
        for (int v = 0; v < frame.looked.size.height; ++v)
            for (int u = 0; u < frame.looked.size.width; ++u) {
                const int dx = frame.looked.x + u, dy = frame.looked.y + v;
                bool counts = false;
                float value = sample(canvas, x + dx, y + dy, std::min(p, channels - 1), counts);
                if (!counts)
                    continue;
                if (p == channels) {
                    value = value * value;
                    for (int c = 0; c + 1 < channels; ++c) {
                        const float other = sample(canvas, x + dx, y + dy, c, counts);
                        value += other * other;
                    }
                } else if (p > channels)
                    value = 1;
                const int column = (dx + fft.size().width) % fft.size().width;
                const int row = (dy + fft.size().height) % fft.size().height;
                plane.data()[row * fft.rowStride() + column] = value;
            }
        fft.forward(plane.data(), spectrum.data(), [this] { m_context.check(); });
    });
    const float scale = 1 / static_cast<float>(fft.size().area());
    const auto squares = static_cast<std::size_t>(channels), count = squares + 1;
    for (std::size_t i = 0; i < fft.spectrumSize(); ++i) {
        const Complex seen = std::conj(m_spectra[count].data()[i]), shape = exemplar.shape.data()[i];
        Complex sum = std::conj(m_spectra[squares].data()[i]) * shape + seen * exemplar.squares.data()[i];
        for (std::size_t c = 0; c < squares; ++c)
            sum -= 2.0F * (std::conj(m_spectra[c].data()[i]) * exemplar.channels[c].data()[i]);
        m_spectra[squares].data()[i] = sum * scale;
        m_spectra[count].data()[i] = seen * shape * scale;
    }
    m_context.parallel(channels, planes, [&](int p) {
        fft.backward(m_spectra[static_cast<std::size_t>(p)].data(),
                     m_planes[static_cast<std::size_t>(p)].data(), [this] { m_context.check(); });
    });
}

bool PlaceSearch::allowed(std::size_t exemplar, int u, int v) const {
    const Image* const mask = m_request.exemplars[exemplar].mask();
    return !mask || (*mask)(u, v, 0) != 0;
}

void PlaceSearch::collect(const Frame& frame, std::size_t exemplar) {
    const RealFft2d& fft = m_exemplars[exemplar].fft;
    const auto squares = static_cast<std::size_t>(m_request.channels());
    // Rounding leaves sums of equal pixels a little off 0.
    const double least = 1e-6 * m_variance;
    for (int v = frame.anchors.y; v < frame.anchors.bottom(); ++v)
        for (int u = frame.anchors.x; u < frame.anchors.right(); ++u) {
            const auto at = v * fft.rowStride() + u;
            const double count = std::round(static_cast<double>(m_planes[squares + 1].data()[at]));
            if (count >= 1 && allowed(exemplar, u, v))
                m_candidates.push_back(
                    {exemplar, u, v,
                     std::max(least, static_cast<double>(m_planes[squares].data()[at]) / count)});
        }
}

/// The patch whose exemplar's pixel (u, v) lies on the output's (x, y).
Patch PlaceSearch::over(int x, int y, std::size_t exemplar, int u, int v) const {
    const Size size = m_request.exemplars[exemplar].image->size(), reach = m_exemplars[exemplar].reach;
    const int left = std::clamp(u - reach.width / 4, 0, size.width - reach.width);
    const int top = std::clamp(v - reach.height / 4, 0, size.height - reach.height);
    return {static_cast<int>(exemplar), x - u, y - v, {x - u + left, y - v + top, reach}};
}

/// The exemplar by its weight, and less likely if its best place fits much worse than another's; then one of
/// its places, in proportion to exp(−C / (k σ²)). Were all places drawn together, weights would hardly ever
/// outweigh the differences of costs.
Patch PlaceSearch::drawn(int x, int y, int step) const {
    const Random& random = m_context.random();
    std::vector<double> least(m_exemplars.size(), HUGE_VAL);
    for (const Candidate& candidate : m_candidates)
        least[candidate.exemplar] = std::min(least[candidate.exemplar], candidate.cost);
    const double best = *std::min_element(least.begin(), least.end());
    std::vector<double> shares;
    double sum = 0;
    for (std::size_t e = 0; e < least.size(); ++e) {
        const double apart = least[e] - best;
        const double likelihood = apart > 0 ? std::exp(-apart / m_variance) : 1;
        sum += likelihood * m_request.exemplars[e].weight;
        shares.push_back(sum);
    }
    const std::size_t exemplar = chosen(shares, random.uniform(step, 0, kExemplar));
    const double unit = m_settings.tolerance * m_variance;
    std::vector<double> sums;
    sum = 0;
    for (const Candidate& candidate : m_candidates) {
        if (candidate.exemplar == exemplar)
            sum += unit > 0 ? std::exp((least[exemplar] - candidate.cost) / unit) : 1;
        sums.push_back(sum);
    }
    const Candidate& candidate = m_candidates[chosen(sums, random.uniform(step, 0, kPlace))];
    return over(x, y, candidate.exemplar, candidate.u, candidate.v);
}

/// Any place that covers the anchor with a pixel that the masks allow; exemplars by weight and anchors.
Patch PlaceSearch::anywhere(int x, int y, int step) const {
    const Random& random = m_context.random();
    double whole = 0;
    std::vector<double> weights;
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const Frame frame = wholeFrame(e);
        std::int64_t count = 0;
        for (int v = frame.anchors.y; v < frame.anchors.bottom(); ++v)
            for (int u = frame.anchors.x; u < frame.anchors.right(); ++u)
                count += allowed(e, u, v) ? 1 : 0;
        whole += static_cast<double>(count) * m_request.exemplars[e].weight;
        weights.push_back(whole);
    }
    if (whole > 0) {
        const std::size_t e = chosen(weights, random.uniform(step, 0, kExemplar));
        const Region anchors = wholeFrame(e).anchors;
        for (int n = 0;; ++n) {
            const int u = anchors.x + static_cast<int>(random.below(
                                          static_cast<std::uint32_t>(anchors.size.width), step, n, kColumn));
            const int v = anchors.y + static_cast<int>(random.below(
                                          static_cast<std::uint32_t>(anchors.size.height), step, n, kRow));
            if (allowed(e, u, v))
                return over(x, y, e, u, v);
        }
    }
    // The masks leave nothing in the middle: the first pixel that they leave.
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const Size size = m_request.exemplars[e].image->size();
        for (int v = 0; v < size.height; ++v)
            for (int u = 0; u < size.width; ++u)
                if (allowed(e, u, v))
                    return over(x, y, e, u, v);
    }
    return over(x, y, 0, 0, 0);
}

Patch PlaceSearch::placeOver(const Canvas& canvas, int x, int y, int step) {
    m_candidates.clear();
    if (m_settings.placement != Placement::Random && (canvas.covered() > 0 || m_request.initial()))
        for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
            const Frame frame = m_settings.placement == Placement::Entire
                                    ? wholeFrame(e)
                                    : squareFrame(e, -m_settings.patch / 2);
            measure(canvas, x, y, frame, m_exemplars[e]);
            collect(frame, e);
        }
    if (m_candidates.empty())
        return anywhere(x, y, step);
    Patch patch = drawn(x, y, step);
    // Beyond the square nothing was compared with the initial image.
    if (m_request.initial() && m_settings.placement == Placement::SubPatch)
        patch.window = common(
            patch.window,
            {x - m_settings.patch / 2, y - m_settings.patch / 2, {m_settings.patch, m_settings.patch}});
    return patch;
}

Patch PlaceSearch::placeOnto(const Canvas& canvas, int x, int y, int step) {
    m_candidates.clear();
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const Frame frame = squareFrame(e, 0);
        measure(canvas, x, y, frame, m_exemplars[e]);
        collect(frame, e);
    }
    return m_candidates.empty() ? anywhere(x, y, step) : drawn(x, y, step);
}

std::uint64_t PlaceSearch::bytesFor(const Request& request, const Settings& settings) {
    std::uint64_t bytes = 0, most = 0, candidates = 0;
    for (const Size& size : request.exemplarSizes()) {
        const bool whole = looksAtWhole(settings);
        const RealFft2d fft({transformSide(size.width, whole), transformSide(size.height, whole)});
        const auto planes = static_cast<std::uint64_t>(request.channels()) + 2;
        const std::uint64_t spectra = planes * fft.spectrumSize() * sizeof(Complex);
        bytes += spectra;
        most = std::max(most, spectra + planes * fft.imageSize() * sizeof(float));
        candidates += static_cast<std::uint64_t>(size.area()) * (2 * sizeof(Candidate) + 2 * sizeof(double));
    }
    return bytes + most + candidates;
}

} // namespace texloom::graph_cut
