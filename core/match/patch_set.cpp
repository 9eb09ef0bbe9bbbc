#include "core/match/patch_set.h"

#include "core/math/pca.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr int kBlocks = 8;
constexpr int kChannels = 3;
/// The axes are learnt from about this many patches.
constexpr double kLearnt = 500;
/// The largest rounding error of the distance of two descriptors, as a share of their length.
constexpr float kRounding = 1e-5F;

float gap(const PatchBasis::Descriptor& a, const PatchBasis::Descriptor& b) {
    constexpr int kLanes = 4;
    float lanes[kLanes] = {};
    for (int i = 0; i < PatchBasis::kAxes; i += kLanes)
        for (int lane = 0; lane < kLanes; ++lane) {
            const int at = i + lane;
            lanes[lane] += (a[at] - b[at]) * (a[at] - b[at]);
        }
    return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

} // namespace

PatchBasis::PatchBasis(std::span<const Interleaved* const> images, int channels, int patch,
                       const std::function<void()>& check)
    : m_patch(patch), m_pixel(images.front()->pixel), m_channels(std::min(channels, kChannels)),
      m_blocks(patch % kBlocks == 0 ? kBlocks : 1) {
    double pixels = 0;
    for (const Interleaved* image : images)
        pixels += static_cast<double>(image->size.area());
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kLearnt))));
    const int dimension = m_blocks * m_blocks * m_channels;
    std::vector<float> means(static_cast<std::size_t>(dimension));
    std::vector<double> samples;
    for (const Interleaved* image : images)
        for (int y = 0; y + patch <= image->size.height; y += step)
            for (int x = 0; x + patch <= image->size.width; x += step) {
                blocks(image->at(x, y), image->stride(), means.data());
                samples.insert(samples.end(), means.begin(), means.end());
            }
    check();
    const PrincipalAxes principal = principalAxes(samples, dimension, std::min(kAxes, dimension));
    m_axes.assign(static_cast<std::size_t>(dimension) * kAxes, 0);
    for (int a = 0; a < principal.count(); ++a)
        for (int i = 0; i < dimension; ++i)
            m_axes[static_cast<std::size_t>(i) * kAxes + static_cast<std::size_t>(a)] =
                static_cast<float>(principal.axis(a)[static_cast<std::size_t>(i)]);
    check();
}

/// Sums over blocks, scaled so that they are coordinates along directions of length 1.
void PatchBasis::blocks(const float* pixels, std::ptrdiff_t stride, float* means) const {
    const int side = m_patch / m_blocks;
    const float scale = 1 / static_cast<float>(side);
    for (int j = 0; j < m_blocks; ++j)
        for (int i = 0; i < m_blocks; ++i, means += m_channels) {
            std::fill_n(means, m_channels, 0.0F);
            for (int y = 0; y < side; ++y) {
                const float* row = pixels + (j * side + y) * stride + i * side * m_pixel;
                for (int x = 0; x < side; ++x)
                    for (int c = 0; c < m_channels; ++c)
                        means[c] += row[x * m_pixel + c];
            }
            for (int c = 0; c < m_channels; ++c)
                means[c] *= scale;
        }
}

PatchBasis::Descriptor PatchBasis::describe(const float* pixels, std::ptrdiff_t stride) const {
    std::array<float, kBlocks * kBlocks * kChannels> means{};
    blocks(pixels, stride, means.data());
    Descriptor descriptor{};
    const float* axis = m_axes.data();
    for (int i = 0; i < m_blocks * m_blocks * m_channels; ++i, axis += kAxes)
        for (std::size_t a = 0; a < kAxes; ++a)
            descriptor[a] += axis[a] * means[static_cast<std::size_t>(i)];
    return descriptor;
}

PatchSet::PatchSet(std::vector<const Interleaved*> images, const PatchBasis& basis, int stride,
                   const std::function<bool(const Source&)>& has, const std::function<void()>& check)
    : m_images(std::move(images)), m_basis(basis) {
    for (std::size_t e = 0; e < m_images.size(); ++e)
        for (int y = 0; y + basis.patch() <= m_images[e]->size.height; y += stride) {
            check();
            for (int x = 0; x + basis.patch() <= m_images[e]->size.width; x += stride) {
                const Source source{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                    static_cast<std::uint16_t>(e)};
                if (!has(source))
                    continue;
                m_entries.push_back({basis.describe(m_images[e]->at(x, y), m_images[e]->stride()),
                                     static_cast<int>(m_sources.size())});
                m_sources.push_back(source);
            }
        }
    check();
    std::sort(m_entries.begin(), m_entries.end(), [](const Entry& a, const Entry& b) {
        return a.descriptor[0] != b.descriptor[0] ? a.descriptor[0] < b.descriptor[0] : a.number < b.number;
    });
}

void PatchSet::setPenalties(std::vector<float> penalties) {
    m_penalties = std::move(penalties);
}

float PatchSet::distance(const float* pixels, std::ptrdiff_t stride, const Source& source,
                         float limit) const {
    const Interleaved& image = *m_images[source.exemplar];
    return squaredDistance(pixels, stride, image.at(source.x, source.y), image.stride(), m_basis.patch(),
                           m_basis.patch() * image.pixel, limit);
}

// Not inlined into the scan, whose few registers it would take: an eighth of the time.
[[gnu::noinline]] void PatchSet::consider(const Entry& entry, const PatchBasis::Descriptor& wanted,
                                          const float* pixels, std::ptrdiff_t stride, Best& best) const {
    if (gap(entry.descriptor, wanted) > best.limit)
        return;
    const float found =
        distance(pixels, stride, m_sources[static_cast<std::size_t>(entry.number)], best.cost);
    if (found > best.cost || (found == best.cost && entry.number > best.number))
        return;
    best.number = entry.number;
    best.distance = found;
    best.setCost(found);
}

void PatchSet::considerPenalised(const Entry& entry, const PatchBasis::Descriptor& wanted,
                                 const float* pixels, std::ptrdiff_t stride, Best& best) const {
    const float extra = m_penalties[static_cast<std::size_t>(entry.number)];
    if (extra > best.norm)
        return;
    const float least = best.norm - extra + best.slack;
    if (gap(entry.descriptor, wanted) > least * least)
        return;
    const float found =
        distance(pixels, stride, m_sources[static_cast<std::size_t>(entry.number)],
                 (1 + kRounding) * (best.norm - extra) * (best.norm - extra) + kRounding * best.cost);
    const float norm = std::sqrt(found) + extra;
    if (norm > best.norm || (norm == best.norm && entry.number > best.number))
        return;
    best.number = entry.number;
    best.distance = found;
    best.norm = norm;
    best.setCost(norm * norm);
}

PatchMatch PatchSet::nearest(const float* pixels, std::ptrdiff_t stride, const PatchMatch& hint) const {
    const PatchBasis::Descriptor wanted = m_basis.describe(pixels, stride);
    const auto middle =
        std::lower_bound(m_entries.begin(), m_entries.end(), wanted[0],
                         [](const Entry& entry, float first) { return entry.descriptor[0] < first; });
    Best best;
    best.number = count();
    best.slack = kRounding * std::sqrt(gap(wanted, {}));
    // Only a bound: the scan meets the hint itself, or one at least as near.
    const bool bounded = hint.source.valid() && m_penalties.empty();
    best.setCost(bounded ? distance(pixels, stride, hint.source, HUGE_VALF) : HUGE_VALF);
    best.norm = HUGE_VALF;
    auto up = middle, down = middle;
    const auto open = [&](auto entry) {
        const float apart = entry->descriptor[0] - wanted[0];
        return apart * apart <= best.limit;
    };
    const auto scan = [&](const auto& look) {
        bool above = true, below = true;
        while (above || below) {
            above = above && up != m_entries.end() && open(up);
            if (above)
                look(*up++);
            below = below && down != m_entries.begin() && open(down - 1);
            if (below)
                look(*--down);
        }
    };
    // Two scans, so that the one without penalties asks nothing for every patch.
    if (m_penalties.empty())
        scan([&](const Entry& entry) { consider(entry, wanted, pixels, stride, best); });
    else
        scan([&](const Entry& entry) { considerPenalised(entry, wanted, pixels, stride, best); });
    return {m_sources[static_cast<std::size_t>(best.number)], best.distance};
}

} // namespace texloom
