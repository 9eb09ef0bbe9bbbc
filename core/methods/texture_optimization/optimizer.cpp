#include "core/methods/texture_optimization/optimizer.h"

#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/job/pool.h"
#include "core/match/patch_counter.h"
#include "core/methods/patch_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace texloom::texture_optimization {

namespace {

constexpr int kLargestPatch = 32;
constexpr int kMargin = kLargestPatch - 1;
/// Two of the smallest patches must fit side by side, or there is nothing to choose from.
constexpr int kSmallestSide = 2 * Optimizer::kSmallestPatch;
/// Number of scales on which an initial image is processed.
constexpr int kInitialLevels = 2;
constexpr int kBand = 8;
/// Rounds of PatchMatch before the first projection.
constexpr int kFirstRounds = 6;
/// Patches that choose at the same time where they choose in turn.
constexpr std::size_t kTogether = 32;
/// Streams of random numbers: the order of turns, and pairs of patches.
constexpr std::uint32_t kOrderDraw = 300, kPairDraw = 301;
/// Share of the mean distance below which patches count as equally good.
constexpr double kFloor = 1e-3;

double exponent(Aggregation aggregation) {
    return aggregation == Aggregation::Mean ? 2 : aggregation == Aggregation::Median ? 1 : 0.8;
}

} // namespace

struct Optimizer::Pass {
    Pass(std::span<const PatchSource> sources, const PatchLattice& shape, int channels, JobContext& context)
        : lattice(shape), field(shape.count()) {
        for (const PatchSource& source : sources) {
            targets.emplace_back(source, shape.patch);
            context.check();
        }
        for (const PatchTarget& target : targets)
            images.push_back(&target.pixels());
        const auto check = [&context] { context.check(); };
        basis.emplace(images, channels, shape.patch, check);
        set.emplace(
            images, *basis, shape.stride,
            [this](const Source& source) { return targets[source.exemplar].has(source.x, source.y); }, check);
        proposals.images = images;
        proposals.lattice = lattice;
        proposals.field = &field;
    }

    PatchLattice lattice;
    PatchField field;
    std::vector<PatchTarget> targets;
    std::vector<const Interleaved*> images;
    std::optional<PatchBasis> basis;
    std::optional<PatchSet> set;
    std::optional<GridMatcher> matcher; ///< where PatchMatch searches
    std::optional<ColorBalance> balance;
    std::optional<PatchCounter> counter; ///< of the set's patches, where uniformity counts
    float penalty = 0; ///< in norm, of a patch whose pixels are used once more than they should be
    PatchProposals proposals;
};

Size Optimizer::canvasFor(Size output, Wrap wrap) {
    return {wrap.x ? output.width : std::max(output.width, kLargestPatch),
            wrap.y ? output.height : std::max(output.height, kLargestPatch)};
}

int Optimizer::levelsFor(const Request& request, const Settings& settings) {
    const int wanted =
        std::min(settings.scales, ExemplarPyramid::levelsFor(request.exemplarSizes(), kSmallestSide));
    return request.initial() ? std::min(wanted, kInitialLevels) : wanted;
}

Optimizer::Optimizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_pyramid(patchSources(request), levelsFor(request, settings), kSmallestPatch,
                [&context] { context.check(); }) {}

Size Optimizer::canvas(int level) const {
    Size size = canvasFor(m_request.size, m_request.wrap);
    for (; level > 0; --level)
        size = {(size.width + 1) / 2, (size.height + 1) / 2};
    return size;
}

/// Patch widths that the exemplars of a scale hold.
std::vector<int> Optimizer::widths(int level) const {
    int side = m_pyramid.sizes(level).front().shorterSide();
    for (const Size& size : m_pyramid.sizes(level))
        side = std::min(side, size.shorterSide());
    std::vector<int> fitting;
    for (int width = m_settings.largestPatch; width > kSmallestPatch; width /= 2)
        if (2 * width <= side)
            fitting.push_back(width);
    fitting.push_back(kSmallestPatch);
    return fitting;
}

Synthesis Optimizer::run() {
    double whole = 0;
    for (int level = 0; level < m_pyramid.levels(); ++level)
        whole += std::pow(0.4, level) * static_cast<double>(widths(level).size());
    for (int level = m_pyramid.levels() - 1; level >= 0; --level) {
        const bool first = level + 1 == m_pyramid.levels();
        std::optional<Image> coarse;
        if (!first)
            coarse = image(1);
        m_size = canvas(level);
        m_canvas.reset();
        m_canvas.emplace(m_size, m_request.channels(), kMargin);
        if (first)
            startRandom(level);
        else
            m_canvas->load(*coarse, m_context);
        coarse.reset();
        for (const int width : widths(level)) {
            m_context.stage(0.98 * std::pow(0.4, level) / whole,
                            message("Scale 1/{}, patches of {} px", 1 << level, width));
            optimize(level, width);
        }
    }
    return std::move(m_result);
}

void Optimizer::startRandom(int level) {
    if (m_request.initial()) {
        Image initial(*m_request.initial());
        for (int i = 0; i < level; ++i)
            initial = halved(initial, [this] { m_context.check(); });
        return m_canvas->load(initial, m_context);
    }
    // Squares of the exemplar at random places: the right colours from the start.
    const GridMatcher matcher(m_pyramid.level(level), {m_size, kSmallestPatch, kSmallestPatch}, m_context);
    for (int y = 0; y < m_size.height; ++y) {
        m_context.check();
        for (int x = 0; x < m_size.width; ++x) {
            const Source corner = matcher.any(x / kSmallestPatch, y / kSmallestPatch);
            const float* from = matcher.target(corner.exemplar)
                                    .pixels()
                                    .at(corner.x + x % kSmallestPatch, corner.y + y % kSmallestPatch);
            const int pixel = m_canvas->pixels().pixel;
            std::copy_n(from, pixel, m_canvas->row(y) + x * pixel);
        }
    }
    m_canvas->close(m_context);
}

void Optimizer::optimize(int level, int patch) {
    Pass pass(m_pyramid.level(level), {m_size, patch, patch / 4}, m_request.channels(), m_context);
    if (pass.set->count() == 0)
        return;
    if (m_settings.search == Search::PatchMatch && m_settings.uniformity <= 0) {
        pass.matcher.emplace(m_pyramid.level(level), pass.lattice, m_context);
        for (int y = 0; y < pass.field.size().height; ++y)
            for (int x = 0; x < pass.field.size().width; ++x)
                pass.field.at(x, y).source = pass.matcher->any(x, y);
    }
    if (m_settings.aggregation == Aggregation::RobustFalloff)
        pass.proposals.falloff = gaussianFalloff(patch);
    if (m_settings.histogram)
        pass.proposals.balance = &pass.balance.emplace(pass.images, m_request.channels());
    for (int iteration = 0; iteration < m_settings.iterations; ++iteration) {
        const bool changed = project(pass, iteration);
        weigh(pass);
        if (m_settings.bidirectional)
            addInverse(pass);
        if (pass.balance)
            pass.balance->compare(m_canvas->pixels(), m_size);
        aggregate(pass);
        offer();
        m_context.progress((iteration + 1.0) / m_settings.iterations);
        if (!changed)
            break;
        discourage(pass);
    }
    if (level == 0 && patch == kSmallestPatch)
        finish(pass);
}

/// @return whether the neighbour of any patch has changed.
bool Optimizer::project(Pass& pass, int iteration) {
    const PatchField before = pass.field;
    if (pass.counter) {
        projectInTurn(pass, iteration);
    } else if (!pass.matcher) {
        project(pass, pass.field);
    } else {
        const auto pixels = [&](int x, int y, Size extent, Interleaved& to) {
            for (int row = 0; row < extent.height; ++row)
                for (int column = 0; column < extent.width; ++column)
                    std::copy_n(m_canvas->pixels().at((x + column) % m_size.width, (y + row) % m_size.height),
                                to.pixel, to.data.begin() + row * to.stride() + column * to.pixel);
        };
        const int rounds = iteration == 0 ? kFirstRounds : 2;
        for (int round = 0; round < rounds; ++round)
            pass.matcher->improve(pass.field, pixels, 8 * iteration + round, 1 << 16);
    }
    const Size count = pass.field.size();
    std::vector<double> energies(static_cast<std::size_t>(count.height), 0);
    std::atomic<bool> changed = false;
    const double area = static_cast<double>(pass.lattice.patch) * pass.lattice.patch;
    const double power = exponent(m_settings.aggregation) / 2;
    m_context.parallel(0, count.height, [&](int y) {
        for (int x = 0; x < count.width; ++x) {
            const PatchMatch& match = pass.field.at(x, y);
            energies[static_cast<std::size_t>(y)] +=
                std::pow(static_cast<double>(match.distance) / area, power);
            if (!(match.source == before.at(x, y).source))
                changed = true;
        }
    });
    double energy = 0;
    for (const double row : energies)
        energy += row;
    m_context.curve(TR("Energy of a patch"), energy / static_cast<double>(count.area()));
    return changed;
}

void Optimizer::project(Pass& pass, PatchField& field) const {
    const int stride = pass.lattice.stride;
    m_context.parallel(0, field.size().height, [&](int y) {
        for (int x = 0; x < field.size().width; ++x) {
            m_context.check();
            field.at(x, y) = pass.set->nearest(m_canvas->pixels().at(x * stride, y * stride),
                                               m_canvas->pixels().stride(), field.at(x, y));
        }
    });
}

/// Lets every exemplar patch propose itself where the image has its nearest neighbour (eq. 3.9).
void Optimizer::addInverse(Pass& pass) {
    const int stride = pass.lattice.stride;
    const auto check = [this] { m_context.check(); };
    const PatchSet made(
        {&m_canvas->pixels()}, *pass.basis, stride,
        [this](const Source& at) { return at.x < m_size.width && at.y < m_size.height; }, check);
    const std::vector<Source>& ours = pass.set->sources();
    std::vector<int> chosen(ours.size());
    const int columns = pass.field.size().width;
    constexpr int kChunk = 64;
    const int count = static_cast<int>(ours.size());
    m_context.parallel(0, (count + kChunk - 1) / kChunk, [&](int chunk) {
        for (int n = chunk * kChunk; n < std::min(count, (chunk + 1) * kChunk); ++n) {
            m_context.check();
            const Source& source = ours[static_cast<std::size_t>(n)];
            const Interleaved& image = *pass.images[source.exemplar];
            const Source at = made.nearest(image.at(source.x, source.y), image.stride(), {}).source;
            chosen[static_cast<std::size_t>(n)] = at.y / stride * columns + at.x / stride;
        }
    });
    PatchProposals& proposals = pass.proposals;
    proposals.extraBegin.assign(static_cast<std::size_t>(pass.field.size().area()) + 1, 0);
    for (const int at : chosen)
        ++proposals.extraBegin[static_cast<std::size_t>(at) + 1];
    for (std::size_t i = 1; i < proposals.extraBegin.size(); ++i)
        proposals.extraBegin[i] += proposals.extraBegin[i - 1];
    std::vector<int> next = proposals.extraBegin;
    proposals.extra.resize(ours.size());
    for (std::size_t n = 0; n < ours.size(); ++n)
        proposals.extra[static_cast<std::size_t>(next[static_cast<std::size_t>(chosen[n])]++)] = ours[n];
    const double share = (1 - m_settings.alpha) / m_settings.alpha;
    proposals.extraWeight = static_cast<float>(share * static_cast<double>(pass.field.size().area()) /
                                               static_cast<double>(count));
}

/// The weights ω of iteratively reweighted least squares (eq. 3.6), with the mean distance as the unit.
void Optimizer::weigh(Pass& pass) {
    const Size count = pass.field.size();
    std::vector<float>& weights = pass.proposals.weights;
    weights.assign(static_cast<std::size_t>(count.area()), 1);
    const double mean = pass.field.meanDistance();
    const bool robust =
        m_settings.aggregation == Aggregation::Robust || m_settings.aggregation == Aggregation::RobustFalloff;
    if (!robust || mean <= 0)
        return;
    const double power = (exponent(m_settings.aggregation) - 2) / 2;
    m_context.parallel(0, count.height, [&](int y) {
        for (int x = 0; x < count.width; ++x)
            weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(count.width) +
                    static_cast<std::size_t>(x)] =
                static_cast<float>(
                    std::pow(kFloor + static_cast<double>(pass.field.at(x, y).distance) / mean, power));
    });
}

/// Spatial uniformity (eq. 3.12), from the second projection of a pass on. The unit of the penalty stays the
/// same over the pass, and is no more than patches at random differ: if it followed the distances, these
/// would grow with it until the penalties were all that counts, and everything one colour.
void Optimizer::discourage(Pass& pass) {
    if (m_settings.uniformity <= 0 || pass.counter)
        return;
    std::vector<Size> sizes;
    for (const Interleaved* image : pass.images)
        sizes.push_back(image->size);
    const Size count = pass.field.size();
    pass.counter.emplace(pass.set->sources(), sizes, pass.lattice.patch, count.area());
    for (int y = 0; y < count.height; ++y) {
        m_context.check();
        for (int x = 0; x < count.width; ++x)
            pass.counter->count(pass.counter->numberOf(pass.field.at(x, y).source), 1, [](int) {});
    }
    const double unit = std::min(std::sqrt(pass.field.meanDistance()), randomDistance(pass));
    pass.penalty = static_cast<float>(m_settings.uniformity * unit);
    std::vector<float> penalties;
    for (int n = 0; n < pass.set->count(); ++n)
        penalties.push_back(penaltyOf(pass, n));
    pass.set->setPenalties(std::move(penalties));
}

/// Only what is used more than it should be is avoided, as with colours (eq. 3.8): what everyone could have
/// costs nothing, however large λ_occ is.
float Optimizer::penaltyOf(const Pass& pass, int number) {
    return pass.penalty * static_cast<float>(std::max(0.0, pass.counter->share(number) - 1));
}

/// Mean distance, as a norm, of two patches of the exemplars drawn at random.
double Optimizer::randomDistance(const Pass& pass) const {
    constexpr int kPairs = 256;
    const auto all = static_cast<std::uint32_t>(pass.set->count());
    double sum = 0;
    for (int pair = 0; pair < kPairs; ++pair) {
        const auto drawn = [&](std::uint32_t which) {
            return pass.set->sources()[m_context.random().below(all, pair, 0, kPairDraw + which)];
        };
        const Source a = drawn(0), b = drawn(1);
        const Interleaved &from = *pass.images[a.exemplar], &to = *pass.images[b.exemplar];
        sum += std::sqrt(static_cast<double>(squaredDistance(from.at(a.x, a.y), from.stride(),
                                                             to.at(b.x, b.y), to.stride(), pass.lattice.patch,
                                                             pass.lattice.patch * from.pixel, HUGE_VALF)));
    }
    return sum / kPairs;
}

/// A projection in which patches choose one after another, in random order, and each sees what those before
/// it have taken; in truth a few at a time, far from each other, so that they can choose in parallel.
void Optimizer::projectInTurn(Pass& pass, int iteration) {
    const Size count = pass.field.size();
    std::vector<std::pair<std::uint32_t, int>> order;
    for (int n = 0; n < static_cast<int>(count.area()); ++n)
        order.emplace_back(m_context.random().bits(n, iteration, kOrderDraw), n);
    std::sort(order.begin(), order.end());
    const int stride = pass.lattice.stride;
    const auto match = [&](std::size_t turn) -> PatchMatch& {
        return pass.field.at(order[turn].second % count.width, order[turn].second / count.width);
    };
    const auto counted = [&](std::size_t turn, int times) {
        pass.counter->count(pass.counter->numberOf(match(turn).source), times,
                            [&](int number) { pass.set->setPenalty(number, penaltyOf(pass, number)); });
    };
    for (std::size_t begin = 0; begin < order.size(); begin += kTogether) {
        m_context.check();
        const std::size_t end = std::min(order.size(), begin + kTogether);
        for (std::size_t turn = begin; turn < end; ++turn)
            counted(turn, -1);
        m_context.parallel(static_cast<int>(begin), static_cast<int>(end), [&](int turn) {
            PatchMatch& own = match(static_cast<std::size_t>(turn));
            const int number = order[static_cast<std::size_t>(turn)].second;
            own = pass.set->nearest(
                m_canvas->pixels().at(number % count.width * stride, number / count.width * stride),
                m_canvas->pixels().stride(), own);
        });
        for (std::size_t turn = begin; turn < end; ++turn)
            counted(turn, 1);
    }
}

void Optimizer::aggregate(Pass& pass) {
    Pool<ProposalRow> rows;
    m_context.parallel(0, (m_size.height + kBand - 1) / kBand, [&](int band) {
        const auto row = rows.borrow([&] { return ProposalRow(pass.proposals); });
        for (int y = band * kBand; y < std::min(m_size.height, (band + 1) * kBand); ++y) {
            m_context.check();
            float* pixels = m_canvas->row(y);
            if (m_settings.aggregation == Aggregation::Median)
                row->median(y, ProposalRow::Solver::Weiszfeld, pixels);
            else
                row->mean(y, pixels);
        }
    });
    m_canvas->close(m_context);
}

void Optimizer::finish(Pass& pass) {
    m_context.stage(0.02, TR("Tracing the pixels"));
    finishPatches(
        m_settings.finish,
        nearestProposed(pass.proposals, m_canvas->pixels(), m_request.exemplarSizes(), m_context),
        [this] { return image(1); }, m_request, m_context, m_result);
    m_context.progress(1);
}

/// Every `step`-th pixel of the canvas.
Image Optimizer::image(int step) const {
    return m_canvas->image(step, m_context);
}

void Optimizer::offer() const {
    m_context.preview(m_size, [this](Size, int step) { return image(step); });
}

} // namespace texloom::texture_optimization
