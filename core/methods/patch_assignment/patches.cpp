#include "core/methods/patch_assignment/patches.h"

#include "core/base/wide_vectors.h"
#include "core/image/mirror.h"
#include "core/match/patch_set.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace texloom::patch_assignment {

namespace {

/// Patches this near in the order of brightness are searched for similar ones.
constexpr int kWindow = 512;
/// Draws of one cell lie this far apart among the job's random numbers.
constexpr std::uint32_t kDraws = 1000;

struct PlanarShape {
    int area, channels;
};

constexpr int kLanes = 8, kBlock = 64;

/// Pixels and such as fill whole vectors.
int lanes(int count) {
    return (count + kLanes - 1) / kLanes * kLanes;
}

/// Distances between the colours of `count` pixels. Channels is 0 where only known at run time.
template <int Channels>
[[gnu::always_inline]] inline void colourDistances(const float* wanted, const float* own, PlanarShape shape,
                                                   int count, float* to) {
    const auto difference = [&](int c, int i) {
        return wanted[c * shape.area + i] - own[c * shape.area + i];
    };
    if constexpr (Channels == 1) {
        for (int i = 0; i < count; ++i)
            to[i] = std::abs(difference(0, i));
    } else if constexpr (Channels == 3) {
        for (int i = 0; i < count; ++i) {
            const float red = difference(0, i), green = difference(1, i), blue = difference(2, i);
            to[i] = std::sqrt(red * red + green * green + blue * blue);
        }
    } else {
        for (int i = 0; i < count; ++i)
            to[i] = difference(0, i) * difference(0, i);
        for (int c = 1; c < shape.channels; ++c)
            for (int i = 0; i < count; ++i)
                to[i] += difference(c, i) * difference(c, i);
        for (int i = 0; i < count; ++i)
            to[i] = std::sqrt(to[i]);
    }
}

template <int Channels>
[[gnu::always_inline]] inline float distanceOf(const float* wanted, const float* own, PlanarShape shape) {
    float sums[kLanes] = {};
    for (int i = 0; i < shape.area; i += kBlock) {
        float each[kBlock];
        const int count = std::min(kBlock, shape.area - i);
        colourDistances<Channels>(wanted + i, own + i, shape, count, each);
        for (int j = 0; j < count; j += kLanes)
            for (int lane = 0; lane < kLanes; ++lane)
                sums[lane] += each[j + lane];
    }
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

/// Which patches of a list distances are wanted from.
struct Several {
    const int* places; ///< null for the first of the list
    int count;
};

template <int Channels>
[[gnu::always_inline]] inline void distancesOf(const float* wanted, const float* list, Several several,
                                               PlanarShape shape, float* to) {
    const std::ptrdiff_t floats = static_cast<std::ptrdiff_t>(shape.area) * shape.channels;
    constexpr std::ptrdiff_t kFetched = 16;
    for (int n = 0; n < several.count; ++n) {
        if (several.places != nullptr && n + 1 < several.count)
            for (std::ptrdiff_t i = 0; i < floats; i += kFetched)
                __builtin_prefetch(list + several.places[n + 1] * floats + i);
        const float* own = list + (several.places != nullptr ? several.places[n] : n) * floats;
        to[n] = distanceOf<Channels>(wanted, own, shape);
    }
}

/// A place for cell (i, j) that no cell before has taken; there are fewer cells than places.
std::pair<int, int> drawn(Size size, int i, int j, std::vector<std::uint8_t>& taken, JobContext& context) {
    const auto width = static_cast<std::uint32_t>(size.width),
               height = static_cast<std::uint32_t>(size.height);
    for (std::uint32_t draw = 0;; ++draw) {
        if (draw % 256 == 0)
            context.check();
        const std::uint32_t x = context.random().below(width, i, j, 100 + kDraws * draw);
        const std::uint32_t y = context.random().below(height, i, j, 101 + kDraws * draw);
        std::uint8_t& mark = taken[std::size_t{y} * width + x];
        if (mark == 0) {
            mark = 1;
            return {static_cast<int>(x), static_cast<int>(y)};
        }
    }
}

/// The distances of one patch from several of a list.
TEXLOOM_WIDE_VECTORS void distances(const float* wanted, const float* list, Several several,
                                    PlanarShape shape, float* to) {
    if (shape.channels == 1)
        distancesOf<1>(wanted, list, several, shape, to);
    else if (shape.channels == 3)
        distancesOf<3>(wanted, list, several, shape, to);
    else
        distancesOf<0>(wanted, list, several, shape, to);
}

} // namespace

ExemplarPatches::ExemplarPatches(std::span<const PatchSource> sources, const Settings& settings, bool random,
                                 JobContext& context)
    : m_patch(settings.patch), m_stride(settings.stride()), m_channels(sources.front().image.channels),
      m_area(lanes(settings.patch * settings.patch)),
      m_sumArea(lanes((settings.patch + 1) / 2 * ((settings.patch + 1) / 2))), m_pad(settings.patch / 2) {
    for (const PatchSource& source : sources)
        add(source);
    choose(sources, random, context);
    sort(context);
    m_sums.resize(static_cast<std::size_t>(kinds()) * static_cast<std::size_t>(sumFloats()));
    for (int n = 0; n < kinds(); ++n) {
        if (n % 256 == 0)
            context.check();
        sums(own(n), m_sums.data() + static_cast<std::ptrdiff_t>(n) * sumFloats());
    }
}

/// Finds the kinds, and writes their pixels.
void ExemplarPatches::sort(JobContext& context) {
    const auto floats = static_cast<std::size_t>(patchFloats());
    m_planar.reserve(static_cast<std::size_t>(count()) * floats);
    std::unordered_multimap<std::size_t, int> known; // kinds by the hash of their pixels
    std::vector<float> pixels(floats);
    const std::string_view bytes(reinterpret_cast<const char*>(pixels.data()), floats * sizeof(float));
    m_begin.push_back(0);
    for (int n = 0; n < count(); ++n) {
        if (n % 256 == 0)
            context.check();
        const Source& source = m_sources[static_cast<std::size_t>(n)];
        const Interleaved& image = m_images[source.exemplar];
        planar(image.at(source.x, source.y), image.stride(), pixels.data());
        const std::size_t hash = std::hash<std::string_view>()(bytes);
        const auto [begin, end] = known.equal_range(hash);
        const auto equal = std::find_if(begin, end, [&](const auto& other) {
            return std::memcmp(own(other.second), pixels.data(), bytes.size()) == 0;
        });
        m_kind.push_back(equal != end ? equal->second : kinds());
        if (equal != end)
            continue;
        known.emplace(hash, kinds());
        m_begin.push_back(0);
        m_planar.insert(m_planar.end(), pixels.begin(), pixels.end());
    }
    for (const int kind : m_kind)
        ++m_begin[static_cast<std::size_t>(kind) + 1];
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    std::vector<int> next = m_begin;
    m_members.resize(m_kind.size());
    for (int n = 0; n < count(); ++n)
        m_members[static_cast<std::size_t>(next[static_cast<std::size_t>(kindOf(n))]++)] = n;
}

void ExemplarPatches::add(const PatchSource& source) {
    const Size size = source.image.size();
    m_sizes.push_back(size);
    Interleaved& image = m_images.emplace_back(Size{size.width + m_patch, size.height + m_patch}, m_channels);
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x)
            for (int c = 0; c < m_channels; ++c)
                image.data[static_cast<std::size_t>(y * image.stride() + x * image.pixel + c)] =
                    source.image(mirrored(x - m_pad, size.width), mirrored(y - m_pad, size.height), c);
}

/// Mean of the mask over a patch; 0 where any of its pixels is masked.
double ExemplarPatches::weightOf(const PatchSource& source, int x, int y) const {
    if (!source.mask.data)
        return 1;
    double sum = 0;
    for (int v = 0; v < m_patch; ++v)
        for (int u = 0; u < m_patch; ++u) {
            const auto value = static_cast<double>(source.mask(mirrored(x + u - m_pad, source.mask.width),
                                                               mirrored(y + v - m_pad, source.mask.height)));
            if (value <= 0)
                return 0;
            sum += value;
        }
    return sum / (m_patch * m_patch);
}

void ExemplarPatches::choose(std::span<const PatchSource> sources, bool random, JobContext& context) {
    for (std::size_t e = 0; e < sources.size(); ++e) {
        const Size cells{(m_sizes[e].width + m_stride - 1) / m_stride,
                         (m_sizes[e].height + m_stride - 1) / m_stride};
        std::vector<int>& nearestCell = m_nearest.emplace_back(static_cast<std::size_t>(cells.area()), -1);
        const int stream = static_cast<int>(e) << 16;
        std::vector<std::uint8_t> taken(random ? static_cast<std::size_t>(m_sizes[e].area()) : 0, 0);
        for (int j = 0; j < cells.height; ++j) {
            context.check();
            for (int i = 0; i < cells.width; ++i) {
                int x = i * m_stride, y = j * m_stride;
                if (random)
                    std::tie(x, y) = drawn(m_sizes[e], i, j + stream, taken, context);
                const double weight = weightOf(sources[e], x, y);
                if (weight <= 0)
                    continue;
                const int cell = y / m_stride * cells.width + x / m_stride;
                nearestCell[static_cast<std::size_t>(cell)] = count();
                m_sources.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                     static_cast<std::uint16_t>(e)});
                m_weights.push_back(weight * sources[e].weight);
            }
        }
    }
}

std::vector<const Interleaved*> ExemplarPatches::images() const {
    std::vector<const Interleaved*> images;
    for (const Interleaved& image : m_images)
        images.push_back(&image);
    return images;
}

Source ExemplarPatches::unmirrored(const Source& source) const {
    const Size size = m_sizes[source.exemplar];
    return {static_cast<std::uint16_t>(mirrored(source.x - m_pad, size.width)),
            static_cast<std::uint16_t>(mirrored(source.y - m_pad, size.height)), source.exemplar};
}

int ExemplarPatches::nearest(int exemplar, int x, int y) const {
    const auto e = static_cast<std::size_t>(exemplar);
    if (x < 0 || y < 0 || x >= m_sizes[e].width || y >= m_sizes[e].height)
        return -1;
    const int columns = (m_sizes[e].width + m_stride - 1) / m_stride;
    const int cell = y / m_stride * columns + x / m_stride;
    return m_nearest[e][static_cast<std::size_t>(cell)];
}

std::vector<int> ExemplarPatches::supply(int wanted, Supply kind, JobContext& context) const {
    const double whole = std::accumulate(m_weights.begin(), m_weights.end(), 0.0);
    std::vector<int> list;
    if (kind == Supply::Bootstrap) {
        std::vector<double> until(m_weights.size());
        std::partial_sum(m_weights.begin(), m_weights.end(), until.begin());
        for (int n = 0; n < wanted; ++n) {
            const double draw = context.random().uniform(n, 0, 102) * whole;
            const auto found = std::upper_bound(until.begin(), until.end(), draw) - until.begin();
            list.push_back(std::min(static_cast<int>(found), count() - 1));
        }
        return list;
    }
    struct Copy {
        std::uint32_t key;
        int patch;
    };
    // In each round, every patch is handed out as often as its share of one round.
    std::vector<std::vector<Copy>> rounds(static_cast<std::size_t>(wanted / count() + 3));
    for (int n = 0; n < count(); ++n) {
        const double share = wanted * m_weights[static_cast<std::size_t>(n)] / whole;
        const double phase = context.random().uniform(n, 0, 104);
        for (int k = 0; k < share + 1; ++k) {
            const double round = std::floor((k + phase) / share * wanted / count());
            rounds[static_cast<std::size_t>(std::min(round, static_cast<double>(rounds.size() - 1)))]
                .push_back({context.random().bits(n, k, 103), n});
        }
        context.check();
    }
    for (std::vector<Copy>& round : rounds) {
        context.check();
        std::sort(round.begin(), round.end(), [](const Copy& a, const Copy& b) {
            return a.key != b.key ? a.key < b.key : a.patch < b.patch;
        });
        for (const Copy& copy : round)
            if (static_cast<int>(list.size()) < wanted)
                list.push_back(copy.patch);
    }
    return list;
}

void ExemplarPatches::planar(const float* pixels, std::ptrdiff_t stride, float* to) const {
    const int pixel = m_images.front().pixel;
    for (int c = 0; c < m_channels; ++c) {
        float* plane = to + static_cast<std::ptrdiff_t>(c) * m_area;
        for (int y = 0; y < m_patch; ++y)
            for (int x = 0; x < m_patch; ++x)
                plane[y * m_patch + x] = pixels[y * stride + x * pixel + c];
        std::fill(plane + m_patch * m_patch, plane + m_area, 0.0F);
    }
}

float ExemplarPatches::distance(const float* planar, const float* other) const {
    float distance = 0;
    distances(planar, other, {nullptr, 1}, {m_area, m_channels}, &distance);
    return distance;
}

void ExemplarPatches::costs(const float* planar, int first, int last, float* to) const {
    distances(planar, own(first), {nullptr, last - first}, {m_area, m_channels}, to);
}

void ExemplarPatches::costs(const float* planar, std::span<const int> kinds, float* to) const {
    distances(planar, own(0), {kinds.data(), static_cast<int>(kinds.size())}, {m_area, m_channels}, to);
}

void ExemplarPatches::sums(const float* planar, float* to) const {
    std::fill_n(to, sumFloats(), 0.0F);
    const int columns = (m_patch + 1) / 2;
    for (int c = 0; c < m_channels; ++c)
        for (int y = 0; y < m_patch; ++y)
            for (int x = 0; x < m_patch; ++x)
                to[c * m_sumArea + y / 2 * columns + x / 2] += planar[c * m_area + y * m_patch + x];
}

void ExemplarPatches::bounds(const float* sums, int first, int last, float* to) const {
    distances(sums, m_sums.data() + static_cast<std::ptrdiff_t>(first) * sumFloats(), {nullptr, last - first},
              {m_sumArea, m_channels}, to);
    for (int n = 0; n < last - first; ++n)
        to[n] *= kRounding - 1;
}

void ExemplarPatches::findSimilar(JobContext& context) {
    const std::vector<const Interleaved*> all = images();
    const PatchBasis basis(all, m_channels, m_patch, [&context] { context.check(); });
    std::vector<PatchBasis::Descriptor> descriptors;
    std::vector<int> order(static_cast<std::size_t>(count()));
    std::iota(order.begin(), order.end(), 0);
    for (const Source& source : m_sources) {
        if (descriptors.size() % 256 == 0)
            context.check();
        const Interleaved& image = m_images[source.exemplar];
        descriptors.push_back(basis.describe(image.at(source.x, source.y), image.stride()));
    }
    const auto key = [&](int n) { return descriptors[static_cast<std::size_t>(n)][0]; };
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    m_similar.assign(static_cast<std::size_t>(count()) * kSimilar, -1);
    constexpr int kChunk = 64;
    context.parallel(0, (count() + kChunk - 1) / kChunk, [&](int chunk) {
        std::vector<std::pair<float, int>> near;
        for (int i = chunk * kChunk; i < std::min(count(), (chunk + 1) * kChunk); ++i) {
            context.check();
            near.clear();
            const int own = order[static_cast<std::size_t>(i)];
            for (int j = std::max(0, i - kWindow); j < std::min(count(), i + kWindow); ++j) {
                const int other = order[static_cast<std::size_t>(j)];
                float apart = 0;
                for (std::size_t a = 0; a < PatchBasis::kAxes; ++a) {
                    const float d = descriptors[static_cast<std::size_t>(own)][a] -
                                    descriptors[static_cast<std::size_t>(other)][a];
                    apart += d * d;
                }
                if (other != own)
                    near.emplace_back(apart, other);
            }
            const auto kept = std::min<std::size_t>(kSimilar, near.size());
            std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
            for (std::size_t k = 0; k < kept; ++k)
                m_similar[static_cast<std::size_t>(own) * kSimilar + k] = near[k].second;
        }
    });
}

} // namespace texloom::patch_assignment
