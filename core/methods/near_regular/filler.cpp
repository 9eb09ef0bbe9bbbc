#include "core/methods/near_regular/filler.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/boundary_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texloom::near_regular {

/// What one thread needs to fill a gap.
struct Filler::Workspace {
    Image known; ///< the border as the sampled blocks make it
    Image error; ///< squared differences to the chosen patch
    BorderMatch::Scratch scratch;
};

namespace {

/// @throws UsageError if the mask leaves nothing.
const BorderMatch& checked(const BorderMatch& match, int patch) {
    if (match.allowed() == 0)
        failUsage("The mask leaves no whole patch of {} px to copy; choose smaller blocks or mask less.",
                  patch);
    return match;
}

} // namespace

Filler::Filler(const Request& request, const Settings& settings, const Plan& plan, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_plan(plan), m_part(request.part()),
      m_layout(request.size, request.wrap, plan.block, plan.border),
      m_match(plan.exemplar, plan.mask, m_layout.patch(), settings.match),
      m_sampler(plan.exemplar.size(), plan.from, plan.to, {settings.originX, settings.originY}, m_layout,
                context.random(), checked(m_match, m_layout.patch())),
      m_image(m_part.size, plan.exemplar.channels), m_map(m_part.size, request.exemplarSizes()) {
    for (const Cell& cell : m_layout.gapsOf(m_part)) {
        m_index.emplace(cell, static_cast<int>(m_gaps.size()));
        m_gaps.push_back({cell, {}, {}, 0});
        m_match.prepare(borderOf(cell));
    }
}

Filler::~Filler() = default;

std::unique_ptr<Filler::Workspace> Filler::borrow() {
    {
        const std::lock_guard lock(m_mutex);
        if (!m_idle.empty()) {
            auto work = std::move(m_idle.back());
            m_idle.pop_back();
            return work;
        }
    }
    const Size patch{m_layout.patch(), m_layout.patch()};
    auto work = std::make_unique<Workspace>();
    work->known = Image(patch, m_plan.exemplar.channels);
    work->error = Image(patch, 1);
    work->scratch = m_match.scratch();
    return work;
}

void Filler::giveBack(std::unique_ptr<Workspace> work) {
    const std::lock_guard lock(m_mutex);
    m_idle.push_back(std::move(work));
}

/// How far the neighbours' patches and this one's overlap: the border's width, or more where blocks differ.
Overlap Filler::borderOf(Cell cell) const {
    const int patch = m_layout.patch();
    const auto width = [patch](int length) { return std::min(patch - length, patch / 2); };
    return {width(m_layout.horizontal().length(cell.column - 1)),
            width(m_layout.vertical().length(cell.row - 1)), width(m_layout.horizontal().length(cell.column)),
            width(m_layout.vertical().length(cell.row))};
}

/// The output pixel at which a block's patch begins.
Point Filler::corner(Cell cell) const {
    return {m_layout.horizontal().start(cell.column) - m_layout.reach(),
            m_layout.vertical().start(cell.row) - m_layout.reach()};
}

Filler::Shift Filler::shiftOf(Cell cell, Point patch) const {
    const Point at = corner(cell);
    return {patch.x - at.x, patch.y - at.y};
}

const Filler::Gap* Filler::gapAt(Cell cell) const {
    const auto found = m_index.find(m_layout.identity(cell));
    return found == m_index.end() ? nullptr : &m_gaps[static_cast<std::size_t>(found->second)];
}

Point Filler::patchAt(Cell cell) const {
    return cell.sampled() ? m_sampler.drawn(cell) : gapAt(cell)->patch;
}

void Filler::readBorder(const Gap& gap, Workspace& work) const {
    const int patch = m_layout.patch();
    const Overlap border = borderOf(gap.cell);
    const Point at = corner(gap.cell);
    const auto shift = [&](int right, int down) {
        const Cell cell{gap.cell.column + right, gap.cell.row + down};
        return shiftOf(cell, m_sampler.drawn(cell));
    };
    const Shift left = shift(-1, 0), right = shift(1, 0), top = shift(0, -1), bottom = shift(0, 1);
    std::vector<int> columns;
    for (int x = 0; x < patch; ++x)
        columns.push_back(m_layout.horizontal().at(at.x + x));
    for (int y = 0; y < patch; ++y) {
        const int ownRow = m_layout.vertical().at(at.y + y);
        for (int x = 0; x < patch; ++x) {
            if (!border.contains(x, y, patch))
                continue;
            const Cell from =
                m_layout.sampledAt(at.x + x, at.y + y, {columns[static_cast<std::size_t>(x)], ownRow});
            const Shift& by = from.column < gap.cell.column   ? left
                              : from.column > gap.cell.column ? right
                              : from.row < gap.cell.row       ? top
                                                              : bottom;
            // Where the blocks beside a gap are far apart, their nearest pixels are used.
            const Point begin = corner(from);
            const int fromX = std::clamp(at.x + x, begin.x, begin.x + patch - 1) + by.x;
            const int fromY = std::clamp(at.y + y, begin.y, begin.y + patch - 1) + by.y;
            for (int c = 0; c < m_plan.exemplar.channels; ++c)
                work.known(x, y, c) = m_plan.exemplar(fromX, fromY, c);
        }
    }
}

/// Updates the known corners with gaps of even rows that are already filled.
void Filler::readCutsAround(const Gap& gap, Workspace& work) const {
    const Point at = corner(gap.cell);
    const int patch = m_layout.patch();
    for (const int down : {-1, 1})
        for (const int right : {-1, 1}) {
            const Cell cell{gap.cell.column + right, gap.cell.row + down};
            const Gap* other = gapAt(cell);
            if (!other)
                continue;
            const Point begin = corner(cell);
            for (int y = std::max(at.y, begin.y); y < std::min(at.y, begin.y) + patch; ++y)
                for (int x = std::max(at.x, begin.x); x < std::min(at.x, begin.x) + patch; ++x) {
                    const int inOther = (y - begin.y) * patch + x - begin.x;
                    if (other->keep[static_cast<std::size_t>(inOther)] != 0)
                        continue;
                    for (int c = 0; c < m_plan.exemplar.channels; ++c)
                        work.known(x - at.x, y - at.y, c) =
                            m_plan.exemplar(other->patch.x + x - begin.x, other->patch.y + y - begin.y, c);
                }
        }
}

void Filler::cutGap(Gap& gap, Workspace& work) const {
    const Overlap border = borderOf(gap.cell);
    for (int y = 0; y < m_layout.patch(); ++y)
        for (int x = 0; x < m_layout.patch(); ++x) {
            float sum = 0;
            if (border.contains(x, y, m_layout.patch()))
                for (int c = 0; c < m_plan.exemplar.channels; ++c) {
                    const float difference =
                        work.known(x, y, c) - m_plan.exemplar(gap.patch.x + x, gap.patch.y + y, c);
                    sum += difference * difference;
                }
            work.error(x, y, 0) = sum;
        }
    addCornerSeams(gap, work);
    BoundaryCut cut = minimumErrorCut(work.error.view().plane(0), border);
    gap.cutCost = cut.cost;
    gap.keep = std::move(cut.keep);
}

/// In a corner of the border two sampled blocks meet along the diagonal. The part of that seam that the cut
/// leaves uncovered counts as part of the cut: it is added where the cut would cross the diagonal.
void Filler::addCornerSeams(const Gap& gap, Workspace& work) const {
    const Overlap border = borderOf(gap.cell);
    const Point at = corner(gap.cell);
    const int last = m_layout.patch() - 1;
    constexpr float kStraight = 4;
    for (const int down : {-1, 1})
        for (const int right : {-1, 1}) {
            const Cell beside{gap.cell.column + right, gap.cell.row},
                over{gap.cell.column, gap.cell.row + down};
            const Shift a = shiftOf(beside, m_sampler.drawn(beside)),
                        b = shiftOf(over, m_sampler.drawn(over));
            const Cell across{gap.cell.column + right, gap.cell.row + down};
            const Gap* other = (gap.cell.row & 1) != 0 ? gapAt(across) : nullptr;
            const Point begin = corner(across);
            const int width =
                std::min(right < 0 ? border.left : border.right, down < 0 ? border.top : border.bottom);
            float open = 0;
            for (int i = 0; i < width; ++i) {
                const int px = right < 0 ? i : last - i, py = down < 0 ? i : last - i;
                const int x = at.x + px, y = at.y + py;
                work.error(px, py, 0) += open;
                const int inOther = (y - begin.y) * m_layout.patch() + x - begin.x;
                const bool within =
                    x >= begin.x && y >= begin.y && x - begin.x <= last && y - begin.y <= last;
                if (other && within && other->keep[static_cast<std::size_t>(inOther)] == 0)
                    continue;
                for (int c = 0; c < m_plan.exemplar.channels; ++c) {
                    const float difference =
                        m_plan.exemplar(x + a.x, y + a.y, c) - m_plan.exemplar(x + b.x, y + b.y, c);
                    open += kStraight * difference * difference;
                }
            }
        }
}

void Filler::fillGap(int index) {
    Gap& gap = m_gaps[static_cast<std::size_t>(index)];
    auto work = borrow();
    readBorder(gap, *work);
    const std::vector<Point> points = m_sampler.free() ? std::vector<Point>{} : m_sampler.alike(gap.cell);
    const bool anywhere = m_sampler.free();
    gap.patch = !anywhere && points.empty()
                    ? m_sampler.drawn(gap.cell)
                    : m_match.choose(work->known, borderOf(gap.cell), points, m_settings.tolerance,
                                     work->scratch, [this] { m_context.check(); });
    if (m_settings.join == Join::Cut) {
        if ((gap.cell.row & 1) != 0)
            readCutsAround(gap, *work);
        cutGap(gap, *work);
        paintGap(gap);
    }
    giveBack(std::move(work));
}

void Filler::paint(int x, int y, Shift shift) {
    const int toX = x - m_part.x, toY = y - m_part.y;
    for (int c = 0; c < m_plan.exemplar.channels; ++c)
        m_image(toX, toY, c) = m_plan.exemplar(x + shift.x, y + shift.y, c);
    m_map.at(toX, toY) = {static_cast<std::uint16_t>(x + shift.x), static_cast<std::uint16_t>(y + shift.y),
                          0};
}

/// Paints one block's own pixels from sampled blocks: a gap in wedges from its neighbours, as far as they
/// reach.
void Filler::paintSampled(Cell cell) {
    const int left = std::max(m_part.x, m_layout.horizontal().start(cell.column));
    const int right = std::min(m_part.right(), m_layout.horizontal().start(cell.column + 1));
    const int top = std::max(m_part.y, m_layout.vertical().start(cell.row));
    const int bottom = std::min(m_part.bottom(), m_layout.vertical().start(cell.row + 1));
    std::map<Cell, Shift> shifts;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const Cell from = m_layout.sampledAt(x, y, cell);
            auto known = shifts.find(from);
            if (known == shifts.end())
                known = shifts.emplace(from, shiftOf(from, m_sampler.drawn(from))).first;
            const Point at = corner(from);
            if (x - at.x >= 0 && y - at.y >= 0 && x - at.x < m_layout.patch() && y - at.y < m_layout.patch())
                paint(x, y, known->second);
        }
}

void Filler::paintGap(const Gap& gap) {
    const int patch = m_layout.patch();
    const Point at = corner(gap.cell);
    const Size whole = m_request.size;
    for (int y = 0; y < patch; ++y) {
        const int toY =
            m_request.wrap.y ? ((at.y + y) % whole.height + whole.height) % whole.height : at.y + y;
        if (toY < m_part.y || toY >= m_part.bottom())
            continue;
        for (int x = 0; x < patch; ++x) {
            const std::size_t index =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(patch) + static_cast<std::size_t>(x);
            const int toX =
                m_request.wrap.x ? ((at.x + x) % whole.width + whole.width) % whole.width : at.x + x;
            if (toX < m_part.x || toX >= m_part.right() || gap.keep[index] != 0)
                continue;
            paint(toX, toY, {gap.patch.x + x - toX, gap.patch.y + y - toY});
        }
    }
}

namespace {

/// The two blocks that a pixel's band lies between along one axis, and α of the first (eq. 4.9).
struct Share {
    int first = 0, second = 0;
    float alpha = 1;
};

Share shareOf(const Axis& axis, int pixel, int width) {
    const int index = axis.at(pixel);
    const int begin = axis.start(index), end = axis.start(index + 1);
    const int before = width / 2; // of the band, on the first block
    const auto alpha = [&](int edge) {
        return 1 - static_cast<float>(pixel - edge + before + 1) / static_cast<float>(width + 1);
    };
    if (pixel < begin + width - before)
        return {index - 1, index, alpha(begin)};
    if (pixel >= end - before)
        return {index, index + 1, alpha(end)};
    return {index, index, 1};
}

} // namespace

/// Eq. 4.6 to 4.8: along an edge two blocks are mixed, at a corner four. The map names the largest share.
void Filler::blendCell(Cell cell) {
    const int left = std::max(m_part.x, m_layout.horizontal().start(cell.column));
    const int right = std::min(m_part.right(), m_layout.horizontal().start(cell.column + 1));
    const int top = std::max(m_part.y, m_layout.vertical().start(cell.row));
    const int bottom = std::min(m_part.bottom(), m_layout.vertical().start(cell.row + 1));
    std::map<Cell, Shift> shifts;
    for (int row = cell.row - 1; row <= cell.row + 1; ++row)
        for (int column = cell.column - 1; column <= cell.column + 1; ++column)
            shifts[{column, row}] = shiftOf({column, row}, patchAt({column, row}));
    // Where blocks are small, so are their borders, and beyond those a patch has no pixels.
    const int width = std::min(m_settings.blend, 2 * m_layout.reach());
    for (int y = top; y < bottom; ++y) {
        const Share down = shareOf(m_layout.vertical(), y, width);
        for (int x = left; x < right; ++x) {
            const Share across = shareOf(m_layout.horizontal(), x, width);
            const std::array<std::pair<Cell, float>, 4> mixed = {
                {{{across.first, down.first}, across.alpha * down.alpha},
                 {{across.second, down.first}, (1 - across.alpha) * down.alpha},
                 {{across.first, down.second}, across.alpha * (1 - down.alpha)},
                 {{across.second, down.second}, (1 - across.alpha) * (1 - down.alpha)}}};
            const auto largest = std::max_element(
                mixed.begin(), mixed.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
            paint(x, y, shifts.at(largest->first));
            if (largest->second == 1)
                continue;
            for (int c = 0; c < m_plan.exemplar.channels; ++c) {
                float sum = 0;
                for (const auto& [from, share] : mixed)
                    if (share > 0) {
                        const Shift shift = shifts.at(from);
                        sum += share * m_plan.exemplar(x + shift.x, y + shift.y, c);
                    }
                m_image(x - m_part.x, y - m_part.y, c) = sum;
            }
        }
    }
}

std::vector<Cell> Filler::cellsOfPart() const {
    const Cell from = m_layout.at(m_part.x, m_part.y),
               to = m_layout.at(m_part.right() - 1, m_part.bottom() - 1);
    std::vector<Cell> cells;
    for (int row = from.row; row <= to.row; ++row)
        for (int column = from.column; column <= to.column; ++column)
            cells.push_back({column, row});
    return cells;
}

void Filler::fill(Synthesis& result, double weight) {
    const std::vector<Cell> cells = cellsOfPart();
    const int count = static_cast<int>(cells.size());
    const auto show = [&](int done, int all) {
        m_context.progress(static_cast<double>(done) / all);
        m_context.preview(m_image, &m_map);
    };
    const auto none = [](int) { return std::vector<int>{}; };
    const bool cut = m_settings.join == Join::Cut;
    m_context.stage(0.2 * weight, TR("Sampling blocks"));
    m_context.parallelAfter(
        count, none, [&](int i) { paintSampled(cells[static_cast<std::size_t>(i)]); },
        [&](int done) { show(done, count); });

    m_context.stage((cut ? 0.8 : 0.5) * weight, TR("Filling gaps"));
    const auto before = [&](int index) {
        std::vector<int> earlier;
        const Cell cell = m_gaps[static_cast<std::size_t>(index)].cell;
        if (cut && (cell.row & 1) != 0)
            for (const int down : {-1, 1})
                for (const int right : {-1, 1})
                    if (const auto found =
                            m_index.find(m_layout.identity({cell.column + right, cell.row + down}));
                        found != m_index.end() &&
                        std::find(earlier.begin(), earlier.end(), found->second) == earlier.end())
                        earlier.push_back(found->second);
        return earlier;
    };
    const int gaps = static_cast<int>(m_gaps.size());
    m_context.parallelAfter(
        gaps, before, [this](int i) { fillGap(i); }, [&](int done) { show(done, gaps); });
    if (!cut) {
        m_context.stage(0.3 * weight, TR("Blending"));
        m_context.parallelAfter(
            count, none, [&](int i) { blendCell(cells[static_cast<std::size_t>(i)]); },
            [&](int done) { show(done, count); });
    }
    double cost = 0;
    for (const Gap& gap : m_gaps)
        cost += gap.cutCost / static_cast<double>(gaps);
    result.figures.push_back({TR("Gaps filled"), static_cast<double>(gaps)});
    if (cut)
        result.figures.push_back({TR("Mean error along a cut"), cost});
    result.image = std::move(m_image);
    result.map = std::move(m_map);
}

} // namespace texloom::near_regular
