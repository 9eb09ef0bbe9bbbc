#include "core/methods/patch_assignment/optimizer.h"

#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/job/pool.h"
#include "core/methods/patch_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texloom::patch_assignment {

namespace {

/// Number of scales on which an initial image is processed.
constexpr int kInitialLevels = 2;
constexpr int kBandRows = 8;
/// Where choices are narrowed: ε, and the cost of each use too many, as shares of the mean cost.
constexpr double kNarrowEpsilon = 0.05, kNarrowRho = 1;
/// Where choices are narrowed, iterations end when no more than this share of the patches changes.
constexpr double kNarrowChange = 0.02;
/// The share of Settings::settle that counts on scales on which others build.
constexpr double kCoarseSettle = 0.125;
/// Share of the mean cost below which patches count as equally good, and r of robust weights.
constexpr double kFloor = 1e-3, kRobust = 0.8;
/// On the finest scale ε falls by this factor with each iteration, down to this share: when costs are low,
/// the same ε would be too large a part of them, and few patches still change.
constexpr double kFinerEpsilon = 0.5, kLeastEpsilon = 0.1;
/// The share of ε by which a patch may move while its costs are kept, which may then be off by as much.
constexpr float kKeptShare = 0.05F;

double sampledMean(const AssignmentCosts& costs) {
    double sum = 0;
    std::int64_t seen = 0;
    for (std::size_t i = 0; i < costs.costs.size(); i += 997, ++seen)
        sum += static_cast<double>(std::abs(costs.costs[i]));
    return std::max(sum / static_cast<double>(seen), 1e-12);
}

} // namespace

struct Optimizer::Band {
    int top, bottom;         ///< rows of the lattice; bottom excluded
    std::vector<int> places; ///< of each of the exemplar's patches
    Assigner assigner;       ///< of kinds of patches, or where choices are narrowed of patches
};

struct Optimizer::Pass {
    Pass(std::span<const PatchSource> sources, const Settings& settings, bool random, Size canvas,
         JobContext& context)
        : patches(sources, settings, random, context), lattice{canvas, settings.patch, settings.stride()},
          field(lattice.count()), chosen(static_cast<std::size_t>(lattice.count().area()), -1) {
        proposals.images = patches.images();
        proposals.lattice = lattice;
        proposals.field = &field;
        proposals.weights.assign(chosen.size(), 1);
    }

    ExemplarPatches patches;
    PatchLattice lattice;
    PatchField field;        ///< sources in the mirrored exemplars, and costs
    std::vector<int> chosen; ///< the exemplar patch of each patch of the lattice
    std::vector<Band> bands;
    bool narrowed = false;
    bool begun = false;   ///< whether there has been an assignment
    CostTable all;        ///< of every patch for every one of the exemplar's
    AssignmentCosts some; ///< where choices are narrowed
    double meanCost = 0;
    double epsilon = 0; ///< of the next assignment
    PatchProposals proposals;
};

Size Optimizer::canvasFor(Size output, Wrap wrap, int patch) {
    return {wrap.x ? output.width : std::max(output.width, 4 * patch),
            wrap.y ? output.height : std::max(output.height, 4 * patch)};
}

int Optimizer::levelsFor(const Request& request, const Settings& settings) {
    const int wanted =
        std::min(settings.scales, ExemplarPyramid::levelsFor(request.exemplarSizes(), 2 * settings.patch));
    return request.initial() ? std::min(wanted, kInitialLevels) : wanted;
}

bool Optimizer::narrows(double rows, double columns, int iterations, Solve solve) {
    if (solve != Solve::Automatic)
        return solve == Solve::Narrowed;
    return rows * columns * iterations > kMostWork || (rows > 2 * columns && rows > kMostSharing);
}

double Optimizer::exemplarPatches(const Request& request, const Settings& settings) {
    double count = 0;
    for (const Size& size : request.exemplarSizes())
        count += static_cast<double>(size.area()) / (settings.stride() * settings.stride());
    return count;
}

Optimizer::Optimizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_pyramid(patchSources(request), levelsFor(request, settings), settings.patch,
                [&context] { context.check(); }) {
    ValueRange range = valueRange(*request.exemplars.front().image);
    for (const Exemplar& exemplar : request.exemplars) {
        const ValueRange own = valueRange(*exemplar.image);
        range = {std::min(range.smallest, own.smallest), std::max(range.largest, own.largest)};
    }
    m_range = static_cast<double>(range.largest - range.smallest);
}

Size Optimizer::canvas(int level) const {
    Size size = canvasFor(m_request.size, m_request.wrap, m_settings.patch);
    for (; level > 0; --level)
        size = {(size.width + 1) / 2, (size.height + 1) / 2};
    return size;
}

Synthesis Optimizer::run() {
    double whole = 0;
    for (int level = 0; level < m_pyramid.levels(); ++level)
        whole += iterations(level) * std::pow(0.25, level);
    for (int level = m_pyramid.levels() - 1; level >= 0; --level) {
        m_context.stage(0.98 * iterations(level) * std::pow(0.25, level) / whole,
                        message("Scale 1/{}", 1 << level));
        start(level);
        optimize(level);
    }
    return std::move(m_result);
}

/// The canvas of a scale as its iterations find it: the coarser one enlarged, the initial image, or noise
/// with the exemplar's mean and spread.
void Optimizer::start(int level) {
    std::optional<Image> coarse;
    if (level + 1 < m_pyramid.levels())
        coarse = image(1);
    m_size = canvas(level);
    m_canvas.reset();
    m_canvas.emplace(m_size, m_request.channels(), m_settings.patch - 1);
    if (coarse)
        return m_canvas->load(*coarse, m_context);
    if (m_request.initial()) {
        Image initial(*m_request.initial());
        for (int i = 0; i < level; ++i)
            initial = halved(initial, [this] { m_context.check(); });
        return m_canvas->load(initial, m_context);
    }
    const ImageView exemplar = m_pyramid.level(level).front().image;
    const std::vector<double> means = channelMeans(exemplar);
    for (int c = 0; c < exemplar.channels; ++c) {
        double square = 0;
        for (int y = 0; y < exemplar.height; ++y)
            for (int x = 0; x < exemplar.width; ++x)
                square +=
                    std::pow(static_cast<double>(exemplar(x, y, c)) - means[static_cast<std::size_t>(c)], 2);
        const double deviation = std::sqrt(square / static_cast<double>(exemplar.size().area()));
        m_context.parallel(0, m_size.height, [&](int y) {
            float* row = m_canvas->row(y) + c;
            for (int x = 0; x < m_size.width; ++x)
                row[x * m_canvas->pixels().pixel] = static_cast<float>(
                    means[static_cast<std::size_t>(c)] +
                    deviation * m_context.random().normal(x, y, static_cast<std::uint32_t>(c)));
        });
    }
    m_canvas->close(m_context);
}

/// Whether patches may be used too often. From some ρ on it never pays: another patch is then used too
/// little, both of which costs 2ρ, and no change of patches saves more than the largest cost there is.
bool Optimizer::relaxed() const {
    const double most = m_settings.patch * m_settings.patch * std::sqrt(m_request.channels());
    return m_settings.relaxed && 2 * m_settings.rho < most;
}

void Optimizer::optimize(int level) {
    const bool random = m_settings.grid == Grid::Random || (m_settings.grid == Grid::Hybrid && level > 0);
    Pass pass(m_pyramid.level(level), m_settings, random, m_size, m_context);
    plan(pass, level);
    if (m_settings.aggregation == Aggregation::RobustFalloff)
        pass.proposals.falloff = gaussianFalloff(m_settings.patch);
    if (pass.narrowed && level == 0)
        m_result.notes.emplace_back(
            m_settings.solve == Solve::Narrowed
                ? TR("Every patch chose among a few that suit it, as asked, so some are used a little more "
                     "often "
                     "than others.")
                : TR("At this size every patch chose among a few that suit it, so some are used a little "
                     "more "
                     "often than others; the setting “Solved” = Whole takes much longer and uses all as they "
                     "should be."));
    const int count = iterations(level);
    for (int iteration = 0; iteration < count; ++iteration) {
        pass.epsilon = toleranceAt(level, iteration);
        const double changed = project(pass);
        aggregate(pass);
        offer();
        m_context.progress((iteration + 1.0) / count);
        if (changed <= (pass.narrowed ? kNarrowChange : 0))
            break;
        const double settle = (level == 0 ? 1 : kCoarseSettle) * m_settings.settle;
        if (settle > 0 && nearOptimal() && iteration > 0 &&
            m_costs.back() > (1 - settle) * m_costs[m_costs.size() - 2])
            break;
    }
    if (level == 0)
        finish(pass);
}

/// ε in the exemplar's values.
double Optimizer::toleranceAt(int level, int iteration) const {
    const double share = level > 0 || m_settings.constantEpsilon ? 1 : std::pow(kFinerEpsilon, iteration);
    return m_settings.epsilon * m_range * std::max(kLeastEpsilon, share);
}

/// Divides the lattice and the exemplar's patches among bands that are assigned one after another.
void Optimizer::plan(Pass& pass, int level) const {
    const Size count = pass.lattice.count();
    const double offered = pass.patches.count();
    pass.narrowed = narrows(static_cast<double>(count.area()), offered, iterations(level), m_settings.solve);
    if (pass.narrowed)
        pass.patches.findSimilar(m_context);
    const double perRow = pass.narrowed ? kChoices : pass.patches.kinds();
    const int rows = m_settings.solve == Solve::Whole
                         ? count.height
                         : std::clamp(static_cast<int>(kMostCosts / (perRow * count.width)), 1, count.height);
    const int bands = (count.height + rows - 1) / rows;
    const std::vector<int> supply =
        pass.patches.supply(static_cast<int>(count.area()), m_settings.supply, m_context);
    for (int band = 0; band < bands; ++band) {
        const int top = count.height * band / bands, bottom = count.height * (band + 1) / bands;
        std::vector<int> places(static_cast<std::size_t>(pass.patches.count()), 0);
        for (int n = top * count.width; n < bottom * count.width; ++n)
            ++places[static_cast<std::size_t>(supply[static_cast<std::size_t>(n)])];
        std::vector<int> ofKinds(static_cast<std::size_t>(pass.patches.kinds()), 0);
        for (int n = 0; n < pass.patches.count(); ++n)
            ofKinds[static_cast<std::size_t>(pass.patches.kindOf(n))] += places[static_cast<std::size_t>(n)];
        pass.bands.push_back({top, bottom, places, Assigner(pass.narrowed ? places : ofKinds)});
    }
}

AssignmentOptions Optimizer::options(const Pass& pass) const {
    AssignmentOptions options;
    options.epsilon = (1 - 2 * static_cast<double>(kKeptShare)) * pass.epsilon;
    if (relaxed())
        options.relaxation = m_settings.rho * m_range;
    if (pass.narrowed) {
        options.epsilon = std::max(options.epsilon, kNarrowEpsilon * pass.meanCost);
        options.relaxation = std::min(options.relaxation, kNarrowRho * pass.meanCost);
        options.carryOn = true;
    }
    return options;
}

/// @return the share of the lattice's patches whose assignment has changed.
double Optimizer::project(Pass& pass) {
    const std::vector<int> before = pass.chosen;
    double cost = 0;
    for (Band& band : pass.bands)
        cost += assign(pass, band);
    m_costs.push_back(cost / static_cast<double>(pass.chosen.size()));
    m_context.curve(TR("Mean cost of a patch"), m_costs.back());
    std::int64_t changed = 0;
    for (std::size_t n = 0; n < before.size(); ++n)
        changed += pass.chosen[n] != before[n];
    return static_cast<double>(changed) / static_cast<double>(before.size());
}

double Optimizer::assign(Pass& pass, Band& band) {
    const int columns = pass.lattice.count().width, stride = pass.lattice.stride;
    const auto wanted = [&](int row, float* to) {
        const int n = band.top * columns + row;
        pass.patches.planar(m_canvas->pixels().at(n % columns * stride, n / columns * stride),
                            m_canvas->pixels().stride(), to);
    };
    AssignmentCosts& costs = pass.narrowed ? pass.some : pass.all.costs();
    if (pass.narrowed) {
        costSome(pass, band);
    } else {
        if (pass.bands.size() > 1)
            pass.all.forget();
        const auto epsilon = static_cast<float>(pass.epsilon);
        pass.all.update(
            (band.bottom - band.top) * columns, pass.patches, wanted,
            {kKeptShare * epsilon, nearOptimal(), static_cast<float>(m_settings.epsilon * m_range)},
            m_context);
    }
    pass.meanCost = sampledMean(costs);
    std::vector<int> assigned = band.assigner.assign(costs, options(pass), m_context);
    if (!pass.narrowed)
        assigned = membersFor(pass, band, assigned);
    std::vector<float> patch(static_cast<std::size_t>(pass.patches.patchFloats()));
    double total = 0;
    for (int row = 0; row < costs.rows; ++row) {
        if (row % 4096 == 0)
            m_context.check();
        const int best = assigned[static_cast<std::size_t>(row)], n = band.top * columns + row;
        wanted(row, patch.data());
        const float cost = pass.patches.cost(patch.data(), pass.patches.kindOf(best));
        total += static_cast<double>(cost);
        pass.chosen[static_cast<std::size_t>(n)] = best;
        pass.field.at(n % columns, n / columns) = {pass.patches.sources()[static_cast<std::size_t>(best)],
                                                   cost};
    }
    return total;
}

/// The patch of each row, given its kind: the one that it has, if it is of that kind and has a place left,
/// else the kind's next that has; where the kind is used too often, all of its patches by turns.
std::vector<int> Optimizer::membersFor(const Pass& pass, const Band& band, std::vector<int> kinds) {
    const ExemplarPatches& patches = pass.patches;
    const std::size_t first =
        static_cast<std::size_t>(band.top) * static_cast<std::size_t>(pass.lattice.count().width);
    std::vector<int> left = band.places, next(static_cast<std::size_t>(patches.kinds()), 0);
    std::vector<int> chosen(kinds.size(), -1);
    for (std::size_t row = 0; row < kinds.size(); ++row) {
        const int before = pass.chosen[first + row];
        if (before >= 0 && patches.kindOf(before) == kinds[row] &&
            left[static_cast<std::size_t>(before)] > 0) {
            --left[static_cast<std::size_t>(before)];
            chosen[row] = before;
        }
    }
    for (std::size_t row = 0; row < kinds.size(); ++row) {
        if (chosen[row] >= 0)
            continue;
        const std::span<const int> members = patches.members(kinds[row]);
        int& turn = next[static_cast<std::size_t>(kinds[row])];
        const auto member = [&] { return members[static_cast<std::size_t>(turn) % members.size()]; };
        for (int count = static_cast<int>(members.size());
             turn < count && left[static_cast<std::size_t>(member())] <= 0;)
            ++turn;
        chosen[row] = member();
        if (--left[static_cast<std::size_t>(chosen[row])] <= 0)
            ++turn;
    }
    return chosen;
}

void Optimizer::costSome(Pass& pass, const Band& band) const {
    AssignmentCosts& costs = pass.some;
    costs.rows = (band.bottom - band.top) * pass.lattice.count().width;
    costs.columns = pass.patches.count();
    costs.perRow = std::min(kChoices, costs.columns);
    const auto size = static_cast<std::size_t>(costs.rows) * static_cast<std::size_t>(costs.perRow);
    costs.costs.resize(size);
    costs.choices.resize(size);
    const int columns = pass.lattice.count().width, stride = pass.lattice.stride;
    m_context.parallel(band.top, band.bottom, [&](int y) {
        std::vector<float> wanted(static_cast<std::size_t>(pass.patches.patchFloats()));
        for (int x = 0; x < columns; ++x) {
            if (x % 64 == 0)
                m_context.check();
            const auto begin = static_cast<std::size_t>((y - band.top) * columns + x) *
                               static_cast<std::size_t>(costs.perRow);
            choices(pass, x, y, costs.choices.data() + begin);
            pass.patches.planar(m_canvas->pixels().at(x * stride, y * stride), m_canvas->pixels().stride(),
                                wanted.data());
            for (int i = 0; i < costs.perRow; ++i)
                costs.costs[begin + static_cast<std::size_t>(i)] = pass.patches.cost(
                    wanted.data(), pass.patches.kindOf(costs.choices[begin + static_cast<std::size_t>(i)]));
        }
    });
}

/// Different exemplar patches for one patch of the output: its own, those that continue its neighbours', ones
/// that are like these, and random ones for the rest.
void Optimizer::choices(const Pass& pass, int x, int y, std::int32_t* list) const {
    const Size count = pass.lattice.count();
    const int wanted = std::min(kChoices, pass.patches.count());
    int have = 0;
    const auto add = [&](int patch) {
        if (patch >= 0 && have < wanted && std::find(list, list + have, patch) == list + have)
            list[have++] = patch;
    };
    const auto chosen = [&](int column, int row) {
        const int u = (column + count.width) % count.width, v = (row + count.height) % count.height;
        return pass.chosen[static_cast<std::size_t>(v) * static_cast<std::size_t>(count.width) +
                           static_cast<std::size_t>(u)];
    };
    add(chosen(x, y));
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (const int near = chosen(x + dx, y + dy); near >= 0) {
                const Source& source = pass.patches.sources()[static_cast<std::size_t>(near)];
                add(pass.patches.nearest(source.exemplar, source.x - dx * pass.lattice.stride,
                                         source.y - dy * pass.lattice.stride));
            }
    const int first = have;
    for (int k = 0; k < ExemplarPatches::kSimilar; ++k)
        for (int i = 0; i < first && have < wanted - 2; ++i)
            add(pass.patches.similar(list[i])[k]);
    const auto all = static_cast<std::uint32_t>(pass.patches.count());
    for (std::uint32_t draw = 200; have < wanted && draw < 400; ++draw)
        add(static_cast<int>(m_context.random().below(all, x, y, draw)));
    for (int patch = 0; have < wanted; ++patch)
        add(patch);
}

/// The weights of iteratively reweighted least squares (eq. 3.6), with the mean cost as the unit.
void Optimizer::weigh(Pass& pass) const {
    std::vector<float>& weights = pass.proposals.weights;
    const int columns = pass.lattice.count().width;
    for (std::size_t n = 0; n < weights.size(); ++n) {
        const int place = static_cast<int>(n);
        const double cost = static_cast<double>(pass.field.at(place % columns, place / columns).distance) /
                            std::max(m_costs.back(), 1e-12);
        weights[n] = static_cast<float>(std::pow(kFloor + cost * cost, (kRobust - 2) / 2));
    }
}

void Optimizer::aggregate(Pass& pass) {
    if (m_settings.aggregation == Aggregation::Robust || m_settings.aggregation == Aggregation::RobustFalloff)
        weigh(pass);
    const auto solver = m_settings.median == Median::Weiszfeld ? ProposalRow::Solver::Weiszfeld
                                                               : ProposalRow::Solver::DouglasRachford;
    Pool<ProposalRow> rows;
    m_context.parallel(0, (m_size.height + kBandRows - 1) / kBandRows, [&](int band) {
        const auto row = rows.borrow([&] { return ProposalRow(pass.proposals); });
        for (int y = band * kBandRows; y < std::min(m_size.height, (band + 1) * kBandRows); ++y) {
            m_context.check();
            if (m_settings.aggregation == Aggregation::Median)
                row->median(y, solver, m_canvas->row(y));
            else
                row->mean(y, m_canvas->row(y));
        }
    });
    m_canvas->close(m_context);
}

/// How many of the output's patches are beyond the share of the exemplar's patch that they have.
double Optimizer::usesTooMany(const Pass& pass) {
    std::vector<int> left(static_cast<std::size_t>(pass.patches.count()), 0);
    for (const Band& band : pass.bands)
        for (std::size_t n = 0; n < left.size(); ++n)
            left[n] += band.places[n];
    for (const int chosen : pass.chosen)
        --left[static_cast<std::size_t>(chosen)];
    double tooMany = 0;
    for (const int places : left)
        tooMany += std::max(0, -places);
    return tooMany;
}

void Optimizer::finish(Pass& pass) {
    m_result.figures.push_back({TR("Patches used beyond their share"), usesTooMany(pass)});
    m_context.stage(0.02, TR("Tracing the pixels"));
    PositionMap map =
        nearestProposed(pass.proposals, m_canvas->pixels(), m_request.exemplarSizes(), m_context);
    m_context.parallel(0, map.height(), [&](int y) {
        for (int x = 0; x < map.width(); ++x)
            map.at(x, y) = pass.patches.unmirrored(map.at(x, y));
    });
    finishPatches(
        m_settings.finish, std::move(map), [this] { return image(1); }, m_request, m_context, m_result);
    m_context.progress(1);
}

/// Every `step`-th pixel of the canvas.
Image Optimizer::image(int step) const {
    return m_canvas->image(step, m_context);
}

void Optimizer::offer() const {
    m_context.preview(m_size, [this](Size, int step) { return image(step); });
}

} // namespace texloom::patch_assignment
