#include "core/match/patch_proposals.h"

#include "core/base/at.h"
#include "core/job/pool.h"
#include "core/math/geometric_median.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

/// Precision of medians, as a share of the spread of the proposals.
constexpr double kTolerance = 1e-4;

} // namespace

std::vector<float> gaussianFalloff(int patch) {
    std::vector<float> weights;
    const double sigma = patch / 4.0;
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x) {
            const double dx = x - (patch - 1) / 2.0, dy = y - (patch - 1) / 2.0;
            weights.push_back(static_cast<float>(std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma))));
        }
    return weights;
}

ColorBalance::ColorBalance(const std::vector<const Interleaved*>& images, int channels)
    : m_channels(channels), m_low(static_cast<std::size_t>(channels), HUGE_VALF),
      m_scale(static_cast<std::size_t>(channels), -HUGE_VALF),
      m_excess(static_cast<std::size_t>(channels * kBins), 0.0F) {
    for (const Interleaved* image : images)
        for (int y = 0; y < image->size.height; ++y)
            for (int x = 0; x < image->size.width; ++x)
                for (std::size_t c = 0; c < m_low.size(); ++c) {
                    m_low[c] = std::min(m_low[c], image->at(x, y)[c]);
                    m_scale[c] = std::max(m_scale[c], image->at(x, y)[c]);
                }
    for (std::size_t c = 0; c < m_low.size(); ++c)
        m_scale[c] = m_scale[c] > m_low[c] ? kBins / (m_scale[c] - m_low[c]) : 0;
    std::vector<double> sum(m_excess.size(), 0);
    for (const Interleaved* image : images) {
        const std::vector<double> shares = histogram(*image, image->size);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += shares[i] / static_cast<double>(images.size());
    }
    m_wanted = std::move(sum);
}

std::size_t ColorBalance::bin(const float* pixel, int channel) const {
    const auto c = static_cast<std::size_t>(channel);
    const float place = (pixel[channel] - m_low[c]) * m_scale[c];
    return c * kBins + static_cast<std::size_t>(std::clamp(place, 0.0F, kBins - 1.0F));
}

std::vector<double> ColorBalance::histogram(const Interleaved& image, Size size) const {
    std::vector<std::int64_t> counts(m_excess.size(), 0);
    // In very large images, every few pixels are enough.
    const int step = 1 + size.longerSide() / 1024;
    std::int64_t pixels = 0;
    for (int y = 0; y < size.height; y += step)
        for (int x = 0; x < size.width; x += step, ++pixels)
            for (int c = 0; c < m_channels; ++c)
                ++counts[bin(image.at(x, y), c)];
    std::vector<double> shares;
    for (const std::int64_t count : counts)
        shares.push_back(static_cast<double>(count) / static_cast<double>(pixels));
    return shares;
}

void ColorBalance::compare(const Interleaved& canvas, Size size) {
    constexpr double kRare = 1e-3; // smaller shares are too uncertain
    const std::vector<double> shares = histogram(canvas, size);
    for (std::size_t i = 0; i < m_excess.size(); ++i)
        m_excess[i] =
            static_cast<float>(std::max(0.0, shares[i] - m_wanted[i]) / std::max(m_wanted[i], kRare));
}

float ColorBalance::factor(const float* pixel) const {
    float sum = 1;
    for (int c = 0; c < m_channels; ++c)
        sum += m_excess[bin(pixel, c)];
    return 1 / sum;
}

ProposalRow::ProposalRow(const PatchProposals& proposals)
    : m_proposals(proposals), m_pixel(proposals.images.front()->pixel),
      m_weight(static_cast<std::size_t>(proposals.lattice.canvas.width)) {}

/// Calls visit(x, first pixel, its place in the patch, length, weight) for what one patch proposes in its
/// line `line`, from source `first` on: in several pieces where it wraps around the border.
template <class Visit>
void ProposalRow::visitPatch(int column, int line, const Source& first, float weight,
                             const Visit& visit) const {
    const int width = m_proposals.lattice.canvas.width, patch = m_proposals.lattice.patch;
    const float* from = m_proposals.images[first.exemplar]->at(first.x, first.y + line);
    int x = column * m_proposals.lattice.stride;
    for (int done = 0; done < patch;) {
        const int length = std::min(patch - done, width - x);
        const Source source{static_cast<std::uint16_t>(first.x + done),
                            static_cast<std::uint16_t>(first.y + line), first.exemplar};
        visit(x, from + static_cast<std::ptrdiff_t>(done) * m_pixel, source, line * patch + done, length,
              weight);
        done += length;
        x = 0;
    }
}

template <class Visit> void ProposalRow::everyRun(int y, const Visit& visit) const {
    const PatchLattice& lattice = m_proposals.lattice;
    const PatchField& field = *m_proposals.field;
    for (int line = lattice.patch - 1; line >= 0; --line) {
        const int top = ((y - line) % lattice.canvas.height + lattice.canvas.height) % lattice.canvas.height;
        if (top % lattice.stride != 0)
            continue;
        const int row = top / lattice.stride;
        for (int column = 0; column < field.size().width; ++column) {
            const auto number = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.size().width) +
                                static_cast<std::size_t>(column);
            visitPatch(column, line, field.at(column, row).source, m_proposals.weights[number], visit);
            if (m_proposals.extraBegin.empty())
                continue;
            for (int i = m_proposals.extraBegin[number]; i < m_proposals.extraBegin[number + 1]; ++i)
                visitPatch(column, line, m_proposals.extra[static_cast<std::size_t>(i)],
                           m_proposals.extraWeight, visit);
        }
    }
}

template <int Pixel> void ProposalRow::meanOf(int y, float* pixels) {
    const int pixel = Pixel > 0 ? Pixel : m_pixel;
    const float* falloff = m_proposals.falloff.empty() ? nullptr : m_proposals.falloff.data();
    const ColorBalance* balance = m_proposals.balance;
    std::fill(m_weight.begin(), m_weight.end(), 0.0F);
    std::fill_n(pixels, m_weight.size() * static_cast<std::size_t>(pixel), 0.0F);
    everyRun(y, [&](int x, const float* from, const Source&, int place, int length, float patchWeight) {
        float* to = pixels + static_cast<std::ptrdiff_t>(x) * pixel;
        for (int i = 0; i < length; ++i, from += pixel, to += pixel) {
            float weight = patchWeight;
            if (falloff)
                weight *= falloff[place + i];
            if (balance)
                weight *= balance->factor(from);
            for (int c = 0; c < pixel; ++c)
                to[c] += weight * from[c];
            m_weight[at(x + i)] += weight;
        }
    });
    for (const float weight : m_weight)
        for (int c = 0; c < pixel; ++c, ++pixels)
            *pixels /= weight;
}

void ProposalRow::mean(int y, float* pixels) {
    if (m_pixel == 4)
        meanOf<4>(y, pixels);
    else if (m_pixel == 1)
        meanOf<1>(y, pixels);
    else
        meanOf<0>(y, pixels);
}

/// Writes all proposals for the row side by side, merging equal ones and adding their weights.
void ProposalRow::collect(int y) {
    const auto width = m_weight.size();
    std::vector<int> number(width, 0);
    everyRun(y, [&](int x, const float*, const Source&, int, int length, float) {
        for (int i = 0; i < length; ++i)
            ++number[at(x + i)];
    });
    m_most = *std::max_element(number.begin(), number.end());
    const auto places = width * static_cast<std::size_t>(m_most);
    m_points.resize(places * static_cast<std::size_t>(m_pixel));
    m_pointWeight.resize(places);
    m_count.assign(width, 0);
    everyRun(y, [&](int x, const float* from, const Source&, int place, int length, float patchWeight) {
        for (int i = 0; i < length; ++i, from += m_pixel) {
            int& count = m_count[at(x + i)];
            const std::size_t first = at(x + i) * static_cast<std::size_t>(m_most);
            float weight = patchWeight;
            if (!m_proposals.falloff.empty())
                weight *= m_proposals.falloff[at(place + i)];
            if (m_proposals.balance)
                weight *= m_proposals.balance->factor(from);
            int equal = 0;
            const float* points = m_points.data() + first * static_cast<std::size_t>(m_pixel);
            while (equal < count && !std::equal(from, from + m_pixel, points + equal * m_pixel))
                ++equal;
            const std::size_t at = first + static_cast<std::size_t>(equal);
            if (equal < count) {
                m_pointWeight[at] += weight;
                continue;
            }
            std::copy_n(from, m_pixel, m_points.data() + at * static_cast<std::size_t>(m_pixel));
            m_pointWeight[at] = weight;
            ++count;
        }
    });
}

void ProposalRow::median(int y, Solver solver, float* pixels) {
    collect(y);
    for (std::size_t x = 0; x < m_count.size(); ++x) {
        const std::size_t first = x * static_cast<std::size_t>(m_most);
        const float* points = m_points.data() + first * static_cast<std::size_t>(m_pixel);
        const float* weights = m_pointWeight.data() + first;
        const int count = m_count[x];
        float* result = pixels + x * static_cast<std::size_t>(m_pixel);
        float whole = 0;
        int heaviest = 0;
        for (int i = 0; i < count; ++i) {
            whole += weights[i];
            heaviest = weights[i] > weights[heaviest] ? i : heaviest;
        }
        // No sum of pulls can move a point that holds half of the weight.
        std::copy_n(points + heaviest * m_pixel, m_pixel, result);
        if (2 * weights[heaviest] >= whole)
            continue;
        if (solver == Solver::DouglasRachford)
            geometricMedianByDouglasRachford(points, weights, count, m_pixel, result);
        else
            geometricMedian(points, weights, count, m_pixel, result, kTolerance);
    }
}

template <int Pixel> void ProposalRow::nearestOf(int y, const float* pixels, Source* sources) const {
    const int pixel = Pixel > 0 ? Pixel : m_pixel;
    std::vector<float> least(m_weight.size(), HUGE_VALF);
    everyRun(y, [&](int x, const float* from, const Source& source, int, int length, float) {
        const float* to = pixels + static_cast<std::ptrdiff_t>(x) * pixel;
        for (int i = 0; i < length; ++i, from += pixel, to += pixel) {
            float distance = 0;
            for (int c = 0; c < pixel; ++c)
                distance += (from[c] - to[c]) * (from[c] - to[c]);
            if (distance < least[at(x + i)]) {
                least[at(x + i)] = distance;
                sources[x + i] = {static_cast<std::uint16_t>(source.x + i), source.y, source.exemplar};
            }
        }
    });
}

void ProposalRow::nearest(int y, const float* pixels, Source* sources) const {
    if (m_pixel == 4)
        nearestOf<4>(y, pixels, sources);
    else if (m_pixel == 1)
        nearestOf<1>(y, pixels, sources);
    else
        nearestOf<0>(y, pixels, sources);
}

PositionMap nearestProposed(const PatchProposals& proposals, const Interleaved& canvas,
                            std::vector<Size> exemplars, JobContext& context) {
    constexpr int kRows = 8; // each band of rows borrows its working memory once
    const Size size = proposals.lattice.canvas;
    PositionMap map(size, std::move(exemplars));
    Pool<ProposalRow> rows;
    context.parallel(0, (size.height + kRows - 1) / kRows, [&](int band) {
        const auto row = rows.borrow([&] { return ProposalRow(proposals); });
        for (int y = band * kRows; y < std::min(size.height, (band + 1) * kRows); ++y) {
            context.check();
            row->nearest(y, canvas.at(0, y), &map.at(0, y));
        }
    });
    return map;
}

} // namespace texloom
