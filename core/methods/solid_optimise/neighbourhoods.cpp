// Neighbourhoods that agree in three directions (Kopf et al. 2007), each voxel a copy of an exemplar's pixel:
// the use of neighbourhoods and of pixels is kept even (Chen & Wang, "High quality solid texture synthesis
// using position and index histogram matching", The Visual Computer 2010), without which the search gathers
// in a few smooth places and the mean of what overlaps is soft.

#include "core/base/at.h"
#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/job/voxel_random.h"
#include "core/match/tap_sums.h"
#include "core/math/histogram.h"
#include "core/methods/solid_optimise/exemplar_patches.h"
#include "core/methods/solid_optimise/padded.h"
#include "core/methods/solid_optimise/problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace texloom::solid_optimise {

namespace {

constexpr double kExponent = 0.8; ///< r of Kopf et al., equation 2
constexpr int kEveryOther = 2;    ///< of the neighbourhoods that cover a voxel
constexpr int kBins = 16;         ///< of the histograms of channels
constexpr int kPhases = 4;        ///< in which planes are made; counts are brought up to date after each
constexpr float kIndexSlack = 1.0F, kPositionSlack = 1.0F;

/// How much too often something is used, in multiples of its share.
float excess(std::int32_t count, float share) {
    return std::max(0.0F, static_cast<float>(count) / share - 1);
}

/// What the slices square to one axis are made of.
struct Match {
    ExemplarPatches patches;
    Axis axis;
    float weight;
    std::vector<std::int32_t> index, next; ///< of each voxel the number of its patch
    std::vector<float> distance;           ///< of each voxel the distance to it
    std::vector<std::int32_t> indexUse;    ///< of each patch
    std::vector<std::int32_t> pixelUse;    ///< of each pixel of the exemplar
};

class NeighbourhoodMatcher {
public:
    NeighbourhoodMatcher(const Problem& problem, int scale, Progress& progress);
    /// One search and one making of all voxels. @return the mean distance of neighbourhoods.
    double step(int number, bool exhaustive);
    void keepMatches();

private:
    struct Chosen {
        std::size_t goal = 0;
        int pixel = 0;
    };
    struct Candidate {
        std::size_t goal;
        int pixel;
        float weight;
        const float* colour;
    };

    int voxels() const { return m_side * m_side * m_side; }
    std::size_t voxelAt(int x, int y, int z) const {
        const auto wrapped = [this](int place) { return at(((place % m_side) + m_side) % m_side); };
        return (wrapped(z) * at(m_side) + wrapped(y)) * at(m_side) + wrapped(x);
    }
    void takeUp(Match& match, const std::vector<std::int32_t>& coarse, std::size_t goal, int number);
    void countUse();
    void search(Match& match, int number, bool exhaustive);
    void searchRow(Match& match, int y, int z, int number, bool exhaustive);
    std::int32_t nearest(const Match& match, const float* wanted, int x, int y, int z, int number,
                         float& best) const;
    void make();
    Chosen made(int x, int y, int z, std::vector<Candidate>& found) const;
    int binOf(int channel, float value) const;
    void learnColours();
    void matchContrast();

    const Problem& m_problem;
    JobContext& m_context;
    Progress& m_progress;
    int m_side, m_patch, m_channels;
    std::vector<Match> m_matches;
    std::vector<Padded> m_padded;
    std::vector<float> m_lowest, m_scale; ///< of the bins of each channel
    std::vector<std::int32_t> m_binUse;   ///< of the solid
    std::vector<float> m_binShare;        ///< of the exemplars, in voxels of the solid
    std::vector<Chosen> m_chosen;
    std::vector<Histogram> m_colours; ///< of each channel at this scale
};

NeighbourhoodMatcher::NeighbourhoodMatcher(const Problem& problem, int scale, Progress& progress)
    : m_problem(problem), m_context(problem.context()), m_progress(progress),
      m_side(sideAt(problem.settings(), scale)), m_patch(problem.settings().patch),
      m_channels(problem.channels()), m_padded(at(m_channels), Padded(m_side, 0, m_patch - 1)),
      m_lowest(at(m_channels), std::numeric_limits<float>::max()), m_scale(at(m_channels), 0),
      m_binUse(at(m_channels) * kBins, 0), m_binShare(at(m_channels) * kBins, 0), m_chosen(at(voxels())) {
    for (const SliceGoal& goal : problem.goals()) {
        Image exemplar = goal.exemplar;
        for (int n = 0; n < scale; ++n)
            exemplar = halved(exemplar);
        m_matches.push_back({ExemplarPatches(std::move(exemplar), m_patch, m_context),
                             goal.axis,
                             static_cast<float>(goal.weight / problem.wholeWeight()),
                             {},
                             {},
                             std::vector<float>(at(voxels()), 1.0F),
                             {},
                             {}});
    }
    for (int c = 0; c < m_channels; ++c) {
        float highest = std::numeric_limits<float>::lowest();
        for (const Match& match : m_matches) {
            const ValueRange range = valueRange(match.patches.exemplar().channelRange(c, 1));
            m_lowest[at(c)] = std::min(m_lowest[at(c)], range.smallest);
            highest = std::max(highest, range.largest);
        }
        m_scale[at(c)] = kBins / std::max(1e-12F, highest - m_lowest[at(c)]);
    }
    for (const Match& match : m_matches) {
        const ImageView image = match.patches.exemplar();
        const auto share =
            static_cast<float>(voxels()) * match.weight / static_cast<float>(image.size().area());
        for (int c = 0; c < m_channels; ++c)
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    m_binShare[at(c * kBins + binOf(c, image(x, y, c)))] += share;
    }
    const std::vector<std::int32_t> coarse = std::move(progress.matches);
    for (std::size_t goal = 0; goal < m_matches.size(); ++goal)
        takeUp(m_matches[goal], coarse, goal, scale);
    if (progress.solid.width() != m_side)
        progress.solid = Volume({m_side, m_side, m_side}, m_channels);
    countUse();
    learnColours();
}

void NeighbourhoodMatcher::learnColours() {
    for (int c = 0; c < m_channels; ++c) {
        std::vector<float> all;
        for (const Match& match : m_matches)
            for (int y = 0; y < match.patches.exemplar().height; ++y) {
                const float* row = match.patches.exemplar().plane(c).row(y);
                all.insert(all.end(), row, row + match.patches.exemplar().width);
            }
        const int count = static_cast<int>(all.size());
        m_colours.emplace_back(PlaneView{all.data(), count, 1, count}, [this] { m_context.check(); });
    }
}

/// The pixels nearest to a mean are those of the middle of the exemplar's colours: without this, one search
/// after the other finds flatter neighbourhoods.
void NeighbourhoodMatcher::matchContrast() {
    m_context.parallel(0, m_channels, [&](int c) {
        SampleRanks ranks;
        m_colours[at(c)].match({m_progress.solid.row(0, 0, c), m_side, m_side * m_side, m_side}, ranks,
                               [this] { m_context.check(); });
    });
}

int NeighbourhoodMatcher::binOf(int channel, float value) const {
    return std::clamp(static_cast<int>((value - m_lowest[at(channel)]) * m_scale[at(channel)]), 0, kBins - 1);
}

/// The matches of this scale, or of the coarser one, or random ones. Places are kept as columns and rows.
void NeighbourhoodMatcher::takeUp(Match& match, const std::vector<std::int32_t>& coarse, std::size_t goal,
                                  int number) {
    const VoxelRandom random(m_context.random().bits(number, 0, 2));
    const std::size_t each = coarse.size() / std::max<std::size_t>(1, m_matches.size());
    const int from = static_cast<int>(std::lround(std::cbrt(static_cast<double>(each))));
    const Size positions = match.patches.positions();
    match.index.resize(at(voxels()));
    for (int z = 0; z < m_side; ++z, m_context.check())
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x) {
                std::int32_t& index = match.index[voxelAt(x, y, z)];
                if (from == 0) {
                    index = static_cast<std::int32_t>(
                        random.below(static_cast<std::uint32_t>(match.patches.count()), {x, y, z},
                                     static_cast<std::uint32_t>(goal)));
                    continue;
                }
                const auto place = [&](int here) { return at(here * from / m_side); };
                const std::int32_t packed =
                    coarse[goal * each + (place(z) * at(from) + place(y)) * at(from) + place(x)];
                const int scale = from == m_side ? 1 : 2;
                // The middles of both neighbourhoods lie at the same place of the exemplar.
                const auto moved = [&](int was, int limit) {
                    const int middle = scale * (was + m_patch / 2) + (scale == 2 ? 1 : 0);
                    return std::clamp(scale == 1 ? was : middle - m_patch / 2, 0, limit - 1);
                };
                index = moved(packed >> 16, positions.height) * positions.width +
                        moved(packed & 0xFFFF, positions.width);
            }
    match.next = match.index;
}

void NeighbourhoodMatcher::keepMatches() {
    m_progress.matches.clear();
    for (const Match& match : m_matches) {
        const int width = match.patches.positions().width;
        for (const std::int32_t index : match.index)
            m_progress.matches.push_back(((index / width) << 16) | (index % width));
    }
}

void NeighbourhoodMatcher::countUse() {
    for (Match& match : m_matches) {
        match.indexUse.assign(at(match.patches.count()), 0);
        match.pixelUse.assign(static_cast<std::size_t>(match.patches.exemplar().size().area()), 0);
        for (const std::int32_t index : match.index)
            ++match.indexUse[at(index)];
    }
}

void NeighbourhoodMatcher::search(Match& match, int number, bool exhaustive) {
    for (int phase = 0; phase < kPhases; ++phase) {
        const int planes = (m_side - phase + kPhases - 1) / kPhases;
        m_context.parallel(0, planes * m_side, [&](int i) {
            searchRow(match, i % m_side, i / m_side * kPhases + phase, number, exhaustive);
        });
        for (int z = phase; z < m_side; z += kPhases)
            for (std::size_t i = voxelAt(0, 0, z), end = i + at(m_side) * at(m_side); i < end; ++i) {
                --match.indexUse[at(match.index[i])];
                ++match.indexUse[at(match.next[i])];
            }
    }
    match.index = match.next;
}

void NeighbourhoodMatcher::searchRow(Match& match, int y, int z, int number, bool exhaustive) {
    std::vector<const float*> taps;
    for (const Padded& channel : m_padded)
        channel.taps(match.axis, m_patch, 1, y, z, taps);
    const int axes = match.patches.axes();
    std::vector<float> products(at(axes) * at(m_side));
    for (int k = 0; k < axes; ++k) {
        sumTaps(taps.data(), match.patches.axis(k), static_cast<int>(taps.size()), m_side,
                products.data() + at(k) * at(m_side));
        for (int x = 0; x < m_side; ++x)
            products[at(k) * at(m_side) + at(x)] -= match.patches.offset(k);
    }
    std::vector<float> wanted(at(axes));
    for (int x = 0; x < m_side; ++x) {
        for (int k = 0; k < axes; ++k)
            wanted[at(k)] = products[at(k) * at(m_side) + at(x)];
        const std::size_t voxel = voxelAt(x, y, z);
        if (exhaustive)
            match.next[voxel] = match.patches.nearest(wanted.data(), match.distance[voxel]);
        else
            match.next[voxel] = nearest(match, wanted.data(), x, y, z, number, match.distance[voxel]);
    }
}

/// The nearest of what continues the matches around a voxel, and of what is like these; patches that are used
/// too often count as further away.
std::int32_t NeighbourhoodMatcher::nearest(const Match& match, const float* wanted, int x, int y, int z,
                                           int number, float& best) const {
    static constexpr std::array<std::array<int, 3>, 7> kAround = {
        {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    const Size positions = match.patches.positions();
    const auto share = static_cast<float>(voxels()) / static_cast<float>(match.patches.count());
    std::int32_t found = match.index[voxelAt(x, y, z)];
    float least = std::numeric_limits<float>::max();
    const auto test = [&](std::int32_t index) {
        const float distance = match.patches.distance(wanted, index);
        const float judged =
            (distance + 1e-6F) * (1 + kIndexSlack * excess(match.indexUse[at(index)], share));
        if (judged < least) {
            least = judged;
            best = distance;
            found = index;
        }
    };
    for (const auto& [right, down, normal] : kAround) {
        const SliceVoxel v = sliceVoxel(match.axis, right, down, normal);
        const std::int32_t there = match.index[voxelAt(x + v.x, y + v.y, z + v.z)];
        const int column = there % positions.width - right, row = there / positions.width - down;
        if (column < 0 || row < 0 || column >= positions.width || row >= positions.height)
            continue;
        const std::int32_t index = row * positions.width + column;
        test(index);
        for (const std::int32_t alike : match.patches.alike(index))
            test(alike);
    }
    const VoxelRandom random(m_context.random().bits(number, 1, 2));
    test(static_cast<std::int32_t>(
        random.below(static_cast<std::uint32_t>(match.patches.count()), {x, y, z})));
    return found;
}

/// The colour that those neighbourhoods want on the weighted mean which cover a voxel, and of their pixels
/// the nearest to it. Colours and pixels that there are too many of count less.
NeighbourhoodMatcher::Chosen NeighbourhoodMatcher::made(int x, int y, int z,
                                                        std::vector<Candidate>& found) const {
    found.clear();
    for (std::size_t goal = 0; goal < m_matches.size(); ++goal) {
        const Match& match = m_matches[goal];
        const Size positions = match.patches.positions();
        for (int j = m_patch / 2 % kEveryOther; j < m_patch; j += kEveryOther)
            for (int i = m_patch / 2 % kEveryOther; i < m_patch; i += kEveryOther) {
                const SliceVoxel v = sliceVoxel(match.axis, i, j, 0);
                const std::size_t voxel = voxelAt(x - v.x, y - v.y, z - v.z);
                const std::int32_t index = match.index[voxel];
                const int pixel = (index / positions.width + j) * match.patches.exemplar().size().width +
                                  index % positions.width + i;
                const float* colour = match.patches.colour(pixel);
                float over = 1;
                for (int c = 0; c < m_channels; ++c) {
                    const auto bin = at(c * kBins + binOf(c, colour[c]));
                    over += std::max(0.0F,
                                     static_cast<float>(m_binUse[bin]) / std::max(1.0F, m_binShare[bin]) - 1);
                }
                const auto weight = static_cast<float>(
                    std::pow(static_cast<double>(match.distance[voxel]) + 1e-6, (kExponent - 2) / 2));
                found.push_back({goal, pixel, match.weight * weight / over, colour});
            }
    }
    std::array<float, 16> mean{};
    float whole = 0;
    for (const Candidate& one : found) {
        whole += one.weight;
        for (int c = 0; c < m_channels; ++c)
            mean[at(c)] += one.weight * one.colour[c];
    }
    float least = std::numeric_limits<float>::max();
    Chosen chosen;
    for (const Candidate& one : found) {
        float distance = 1e-6F;
        for (int c = 0; c < m_channels; ++c) {
            const float difference = one.colour[c] - mean[at(c)] / whole;
            distance += difference * difference;
        }
        const Match& match = m_matches[one.goal];
        const float share =
            static_cast<float>(voxels()) * match.weight / static_cast<float>(match.pixelUse.size());
        distance *= 1 + kPositionSlack * excess(match.pixelUse[at(one.pixel)], share);
        if (distance < least) {
            least = distance;
            chosen = {one.goal, one.pixel};
        }
    }
    return chosen;
}

void NeighbourhoodMatcher::make() {
    const auto count = [&](std::size_t voxel, int change) {
        const Chosen& chosen = m_chosen[voxel];
        Match& match = m_matches[chosen.goal];
        match.pixelUse[at(chosen.pixel)] += change;
        for (int c = 0; c < m_channels; ++c)
            m_binUse[at(c * kBins + binOf(c, match.patches.colour(chosen.pixel)[c]))] += change;
    };
    std::vector<Chosen> next(m_chosen.size());
    const bool first = std::all_of(m_binUse.begin(), m_binUse.end(), [](std::int32_t n) { return n == 0; });
    for (int phase = 0; phase < kPhases; ++phase) {
        const int planes = (m_side - phase + kPhases - 1) / kPhases;
        m_context.parallel(0, planes * m_side, [&](int i) {
            const int y = i % m_side, z = i / m_side * kPhases + phase;
            std::vector<Candidate> found;
            for (int x = 0; x < m_side; ++x)
                next[voxelAt(x, y, z)] = made(x, y, z, found);
        });
        for (int z = phase; z < m_side; z += kPhases) {
            m_context.check();
            for (std::size_t i = voxelAt(0, 0, z), end = i + at(m_side) * at(m_side); i < end; ++i) {
                if (!first)
                    count(i, -1);
                m_chosen[i] = next[i];
                count(i, 1);
            }
        }
    }
    Volume& solid = m_progress.solid;
    for (int c = 0; c < m_channels; ++c)
        for (std::size_t i = 0; i < m_chosen.size(); ++i)
            solid.row(0, 0, c)[i] = m_matches[m_chosen[i].goal].patches.colour(m_chosen[i].pixel)[c];
    matchContrast();
}

double NeighbourhoodMatcher::step(int number, bool exhaustive) {
    if (number == 0)
        make();
    m_context.parallel(0, m_side, [&](int z) {
        for (int c = 0; c < m_channels; ++c)
            for (int y = 0; y < m_side; ++y) {
                std::copy_n(m_progress.solid.row(y, z, c), m_side, m_padded[at(c)].begin(y, z));
                m_padded[at(c)].wrap(y, z);
            }
    });
    for (Match& match : m_matches)
        search(match, number, exhaustive);
    make();
    double sum = 0;
    for (const Match& match : m_matches)
        for (const float distance : match.distance)
            sum += static_cast<double>(distance) / voxels() * static_cast<double>(match.weight);
    return sum;
}

} // namespace

Volume matchNeighbourhoods(const Problem& problem, int scales) {
    JobContext& context = problem.context();
    Progress progress{scales - 1, 0, Volume(), {}};
    if (const std::string* earlier = context.resumed())
        progress = Progress::from(*earlier);
    const int iterations = problem.settings().iterations;
    const double whole = 0.9 * (1 - 0.125) / (1 - std::pow(0.125, scales));
    for (int scale = scales - 1; scale >= 0; --scale) {
        context.stage(whole * std::pow(0.125, scale), TR("Matching neighbourhoods"));
        if (scale > progress.scale)
            continue;
        NeighbourhoodMatcher matcher(problem, scale, progress);
        for (int n = 0; n < iterations; ++n) {
            context.curve(TR("Distance of neighbourhoods"), matcher.step(n, scale == scales - 1 && n < 3));
            context.progress((n + 1.0) / iterations);
            problem.show(progress.solid);
        }
        matcher.keepMatches();
        progress.iteration = 0;
        progress.scale = scale - 1; // with what is counted and chosen a scale would be kept in its middle
        if (scale > 0)
            context.checkpoint(std::chrono::milliseconds(0), [&] { return progress.bytes(); });
    }
    return std::move(progress.solid);
}

} // namespace texloom::solid_optimise
