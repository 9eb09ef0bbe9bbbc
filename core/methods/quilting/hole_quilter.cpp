#include "core/methods/quilting/hole_quilter.h"

#include "core/base/text.h"
#include "core/image/mirror.h"
#include "core/math/grid_flow.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace texloom::quilting {

namespace {

/// Smaller patches hold no structure, so that they are kept even in a narrow hole.
constexpr int kLeastPatch = 24;
/// A cost of the graph for a difference over the whole range.
constexpr double kCapacity = 1e5;
constexpr std::int32_t kMostCapacity = 1 << 24;
/// Share of the run that it takes to move seams, and to even tone.
constexpr double kJoin = 0.1;
/// Draw of a cell's tie, beside that of its candidate.
constexpr std::uint32_t kCellTie = 1;

struct Box {
    int left, top, right, bottom;
    int shorterSide() const { return std::min(right - left, bottom - top); }
};

/// Around all pixels that `inside` says yes to.
template <class Inside> Box boxOf(Size size, const Inside& inside) {
    Box box{size.width, size.height, 0, 0};
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (inside(x, y))
                box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
                       std::max(box.bottom, y + 1)};
    return box;
}

Box holeOf(const Request& request) {
    const Image& known = *knownOf(request);
    return boxOf(known.size(), [&](int x, int y) { return known(x, y, 0) == 0; });
}

} // namespace

int HoleQuilter::patchFor(const Request& request, const Settings& settings) {
    return std::min(settings.patch, std::max(kLeastPatch, holeOf(request).shorterSide() / 2));
}

HoleQuilter::HoleQuilter(const FillWindow& window, const Settings& settings, JobContext& context)
    : m_window(window), m_request(window.request()), m_settings(settings), m_context(context),
      m_patch(patchFor(m_request, settings)), m_overlap(overlapFor(m_patch, settings.overlap)),
      m_picture(*m_request.initial(), *knownOf(m_request), m_request, context),
      m_made(m_picture.known.size(), 0) {}

Synthesis HoleQuilter::run() {
    m_context.stage(0.1, TR("Preparing the exemplar"));
    measure();
    findParts();
    divide();
    m_context.stage(0.6 + (m_settings.movesSeams() ? 0 : kJoin) + (m_settings.evensTone() ? 0 : kJoin),
                    TR("Placing patches"));
    int laid = 0;
    while (Cell* const cell = next()) {
        m_context.check();
        cell->laid = true;
        lay(*cell, choose(*cell));
        for (Cell& other : m_cells)
            if (m_request.wrap.x || m_request.wrap.y ||
                (std::abs(other.x - cell->x) < m_patch && std::abs(other.y - cell->y) < m_patch))
                other.known = countKnown(other);
        m_context.progress(++laid / static_cast<double>(m_cells.size()));
        offer();
    }
    Synthesis result = finish();
    result.figures = {{TR("Patches"), static_cast<double>(laid)}};
    if (m_patch < m_settings.patch)
        result.notes.push_back(
            message("The hole is filled with patches of {} px: larger ones would cover most "
                    "of it.",
                    m_patch));
    m_context.progress(1);
    return result;
}

/// Joins the patches to each other and to what is around, as far as the stitch leaves them copies.
Synthesis HoleQuilter::finish() {
    if (m_settings.movesSeams()) {
        m_context.stage(kJoin, TR("Moving seams"));
        joinCopies(m_request, kJoinSide, m_settings.radius, m_picture.map, m_context);
    }
    m_context.stage(0.1, TR("Copying pixels"));
    Synthesis result = m_window.filled(m_picture.map, m_context);
    if (m_settings.stitch == PatchStitch::SmoothCut)
        keepBlends(result);
    if (m_settings.evensTone())
        evenFilledTone(m_window.whole(), kJoin, m_context, result);
    return result;
}

/// Takes over what a cut that is smoothed makes of several patches.
void HoleQuilter::keepBlends(Synthesis& result) const {
    const Region part = m_window.part();
    result.mapKind = MapKind::Dominant;
    for (int y = 0; y < part.size.height; ++y)
        for (int x = 0; x < part.size.width; ++x)
            for (int c = 0; m_made[index(x, y)] != 0 && c < result.image.channels(); ++c)
                result.image(part.x + x, part.y + y, c) = m_picture.image(x, y, c);
}

void HoleQuilter::offer() {
    offerFilled(
        m_window, 0,
        [this](int x, int y, float* values) {
            for (int c = 0; m_made[index(x, y)] != 0 && c < m_picture.image.channels(); ++c)
                values[c] = m_picture.image(x, y, c);
            return m_made[index(x, y)] != 0;
        },
        m_context);
}

void HoleQuilter::measure() {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const Exemplar& exemplar : m_request.exemplars) {
        const ValueRange range = valueRange(*exemplar.image);
        low = std::min(low, range.smallest);
        high = std::max(high, range.largest);
    }
    const float range = high > low ? high - low : 1;
    m_unit = range * range;
}

/// Of each exemplar the part that may be copied, which is a little about the hole where a context limits it.
void HoleQuilter::findParts() {
    const std::vector<PatchSource> sources = patchSources(m_request);
    for (std::size_t e = 0; e < sources.size(); ++e) {
        const PatchSource& source = sources[e];
        Box box{0, 0, source.image.width, source.image.height};
        if (source.mask.data)
            box = boxOf(source.image.size(), [&](int x, int y) { return source.mask(x, y) != 0; });
        if (box.right - box.left < m_patch || box.bottom - box.top < m_patch)
            continue;
        const Size size{box.right - box.left, box.bottom - box.top};
        PatchSource part{source.image.crop(box.left, box.top, size), {}, source.weight};
        if (source.mask.data)
            part.mask = {source.mask.row(box.top) + box.left, size.width, size.height, source.mask.stride};
        m_parts.push_back({static_cast<int>(e), box.left, box.top,
                           MaskedDistances(part, m_patch, [this] { m_context.check(); })});
    }
    m_distances.resize(m_parts.size());
}

/// The squares that are laid, on a grid that reaches over the hole by an overlap on every side.
void HoleQuilter::divide() {
    const Box hole = holeOf(m_request);
    const int step = m_patch - m_overlap;
    for (int y = hole.top - m_overlap;; y += step) {
        for (int x = hole.left - m_overlap;; x += step) {
            m_cells.push_back({x, y, 0, false});
            if (x + m_patch >= hole.right + m_overlap)
                break;
        }
        if (y + m_patch >= hole.bottom + m_overlap)
            break;
    }
    for (Cell& cell : m_cells)
        cell.known = countKnown(cell);
}

/// A pixel on the axes that wrap. @return whether it lies in the picture.
bool HoleQuilter::place(int& x, int& y) const {
    const Size size = m_picture.image.size();
    if (m_request.wrap.x)
        x = repeated(x, size.width);
    if (m_request.wrap.y)
        y = repeated(y, size.height);
    return x >= 0 && y >= 0 && x < size.width && y < size.height;
}

/// How many pixels of a cell are there already, or −1 if there is nothing left to make.
int HoleQuilter::countKnown(const Cell& cell) const {
    int known = 0, missing = 0;
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            int x = cell.x + i, y = cell.y + j;
            if (!place(x, y))
                continue;
            known += there(x, y) ? 1 : 0;
            missing += there(x, y) ? 0 : 1;
        }
    return missing > 0 ? known : -1;
}

/// The cell of which most is there, or null if all is made; a random number of the place settles ties.
HoleQuilter::Cell* HoleQuilter::next() {
    Cell* best = nullptr;
    const auto key = [&](const Cell& cell) {
        return std::tuple(cell.known, m_context.random().bits(cell.x, cell.y, kCellTie));
    };
    for (Cell& cell : m_cells)
        if (!cell.laid && cell.known >= 0 && (!best || key(cell) > key(*best)))
            best = &cell;
    return best;
}

bool HoleQuilter::near(const Cell& cell, const Candidate& candidate) const {
    const Size exemplar =
        m_request.exemplars[static_cast<std::size_t>(candidate.part->exemplar)].image->size();
    return m_settings.radius == 0 || exemplar != m_request.size ||
           (std::abs(candidate.x - cell.x) <= m_settings.radius &&
            std::abs(candidate.y - cell.y) <= m_settings.radius);
}

/// All patches at most (1 + tolerance) times as far as the nearest. @param limited to those within the
/// radius; none if there are none.
std::vector<HoleQuilter::Candidate> HoleQuilter::within(const Cell& cell, bool limited) const {
    const auto everyPatch = [&](const auto& visit) {
        for (std::size_t p = 0; p < m_parts.size(); ++p) {
            const Size count = m_parts[p].distances.positions();
            std::size_t at = 0;
            for (int y = 0; y < count.height; ++y)
                for (int x = 0; x < count.width; ++x, ++at) {
                    const Candidate one{&m_parts[p], m_parts[p].x + x, m_parts[p].y + y};
                    if (std::isfinite(m_distances[p][at]) && (!limited || near(cell, one)))
                        visit(one, m_distances[p][at]);
                }
        }
    };
    float least = std::numeric_limits<float>::infinity();
    everyPatch([&](const Candidate&, float distance) { least = std::min(least, distance); });
    const float limit = std::max(least, m_unit / (255 * 255)) * static_cast<float>(1 + m_settings.tolerance);
    std::vector<Candidate> candidates;
    everyPatch([&](const Candidate& one, float distance) {
        if (distance <= limit)
            candidates.push_back(one);
    });
    return candidates;
}

HoleQuilter::Candidate HoleQuilter::choose(const Cell& cell) {
    const Size side{m_patch, m_patch};
    Image known(side, m_picture.image.channels()), counts(side, 1);
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            int x = cell.x + i, y = cell.y + j;
            if (!place(x, y) || !there(x, y))
                continue;
            counts(i, j, 0) = 1;
            for (int c = 0; c < known.channels(); ++c)
                known(i, j, c) = m_picture.image(x, y, c);
        }
    for (std::size_t p = 0; p < m_parts.size(); ++p)
        m_parts[p].distances.compute(known, counts.view().plane(0), m_distances[p],
                                     [this] { m_context.check(); });
    std::vector<Candidate> candidates = within(cell, true);
    if (candidates.empty())
        candidates = within(cell, false);
    const auto weight = [&](const Candidate& one) {
        return m_request.exemplars[static_cast<std::size_t>(one.part->exemplar)].weight;
    };
    double whole = 0;
    for (const Candidate& one : candidates)
        whole += weight(one);
    double left = m_context.random().uniform(cell.x, cell.y) * whole;
    for (const Candidate& one : candidates)
        if ((left -= weight(one)) < 0)
            return one;
    return candidates.back();
}

/// What it costs to have a seam at a pixel: how far the patch is from what is there.
std::int32_t HoleQuilter::cost(const Cell& cell, const ImageView& fresh, int x, int y) const {
    int u = cell.x + x, v = cell.y + y;
    if (!place(u, v))
        return 0;
    double sum = 0;
    for (int c = 0; c < fresh.channels; ++c) {
        const auto difference = static_cast<double>(fresh(x, y, c) - m_picture.image(u, v, c));
        sum += difference * difference;
    }
    const double share = sum / (static_cast<double>(m_unit) * fresh.channels);
    return 1 + static_cast<std::int32_t>(std::min(static_cast<double>(kMostCapacity), kCapacity * share));
}

/// Which pixels of a cell stay as they are: what was known from the beginning, and of what patches made that
/// on their side of the cut.
std::vector<std::uint8_t> HoleQuilter::keptOf(const Cell& cell, const ImageView& fresh) const {
    enum class Is { Outside, Known, Made, Missing };
    const auto what = [&](int i, int j) {
        int x = cell.x + i, y = cell.y + j;
        if (!place(x, y))
            return Is::Outside;
        return m_picture.known[index(x, y)] != 0 ? Is::Known
               : m_made[index(x, y)] != 0        ? Is::Made
                                                 : Is::Missing;
    };
    const auto side = static_cast<std::size_t>(m_patch);
    std::vector<std::uint8_t> kept(side * side, 0);
    std::vector<int> nodes(side * side, -1);
    GridFlow flow(nodes.size());
    const auto at = [&](int i, int j) {
        return static_cast<std::size_t>(j) * side + static_cast<std::size_t>(i);
    };
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            const Is is = what(i, j);
            kept[at(i, j)] = is == Is::Missing || is == Is::Made ? 0 : 1;
            if (is == Is::Made && m_settings.stitch != PatchStitch::None)
                nodes[at(i, j)] = flow.add();
        }
    if (flow.count() == 0)
        return kept;
    struct Step {
        int dx, dy;
        GridFlow::Side side;
    };
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            const int node = nodes[at(i, j)];
            if (node < 0)
                continue;
            const std::int32_t own = cost(cell, fresh, i, j);
            for (const Step& step : {Step{1, 0, GridFlow::Right}, Step{0, 1, GridFlow::Down},
                                     Step{-1, 0, GridFlow::Left}, Step{0, -1, GridFlow::Up}}) {
                const int u = i + step.dx, v = j + step.dy;
                const bool within = u >= 0 && v >= 0 && u < m_patch && v < m_patch;
                const Is is = what(u, v);
                if (within && is == Is::Made) {
                    const std::int32_t both = own + cost(cell, fresh, u, v);
                    if (step.dx + step.dy > 0)
                        flow.link(node, step.side, nodes[at(u, v)], both, both);
                } else if (within && is == Is::Missing)
                    flow.tieToSecond(node, 2 * own);
                else if (is == Is::Known || is == Is::Made)
                    flow.tieToFirst(node, within ? own + cost(cell, fresh, u, v) : 2 * own);
            }
        }
    flow.solve([this] { m_context.check(); });
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i] >= 0)
            kept[i] = flow.first(nodes[i]) ? 1 : 0;
    return kept;
}

/// How much of what is there is kept at a pixel of a smoothed cut: the mean over a square of the cut's.
float HoleQuilter::keptShare(const std::vector<std::uint8_t>& kept, int x, int y) const {
    const int reach = m_settings.stitch == PatchStitch::SmoothCut ? m_settings.softness : 0;
    int sum = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const int u = std::clamp(x + dx, 0, m_patch - 1), v = std::clamp(y + dy, 0, m_patch - 1);
            sum += kept[static_cast<std::size_t>(v) * static_cast<std::size_t>(m_patch) +
                        static_cast<std::size_t>(u)];
        }
    return static_cast<float>(sum) / static_cast<float>((2 * reach + 1) * (2 * reach + 1));
}

void HoleQuilter::lay(const Cell& cell, const Candidate& candidate) {
    const Image& exemplar = *m_request.exemplars[static_cast<std::size_t>(candidate.part->exemplar)].image;
    const ImageView fresh = exemplar.view().crop(candidate.x, candidate.y, {m_patch, m_patch});
    const std::vector<std::uint8_t> kept = keptOf(cell, fresh);
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            int x = cell.x + i, y = cell.y + j;
            if (!place(x, y) || m_picture.known[index(x, y)] != 0)
                continue;
            const bool missing = m_made[index(x, y)] == 0;
            const float share = missing ? 0 : keptShare(kept, i, j);
            if (share == 1)
                continue;
            for (int c = 0; c < fresh.channels; ++c) {
                float& to = m_picture.image(x, y, c);
                to = share == 0 ? fresh(i, j, c) : share * to + (1 - share) * fresh(i, j, c);
            }
            m_made[index(x, y)] = 1;
            if (share < 0.5F)
                m_picture.map.at(x, y) = {static_cast<std::uint16_t>(candidate.x + i),
                                          static_cast<std::uint16_t>(candidate.y + j),
                                          static_cast<std::uint16_t>(candidate.part->exemplar)};
        }
}

Estimate HoleQuilter::estimate(const Request& request, const Settings& settings, int threads) {
    const int patch = patchFor(request, settings), overlap = overlapFor(patch, settings.overlap);
    const Box hole = holeOf(request);
    const double step = patch - overlap;
    const double cells = (2 + (hole.right - hole.left) / step) * (2 + (hole.bottom - hole.top) / step);
    const auto square = static_cast<std::uint64_t>(patch) * static_cast<std::uint64_t>(patch);
    const auto area = static_cast<std::uint64_t>(request.size.area());
    Estimate need;
    need.bytes = 2 * Image::bytesFor(request.size, request.channels()) + PositionMap::bytesFor(request.size) +
                 area * 2 + fillMaskBytes(request) + static_cast<std::uint64_t>(cells) * sizeof(Cell) * 2 +
                 GridFlow::bytesFor(square) +
                 square * static_cast<std::uint64_t>(request.channels() + 4) * 8 + (8U << 20U);
    for (const Size& size : request.exemplarSizes()) {
        need.bytes += MaskedDistances::bytesFor(size, request.channels());
        need.seconds += cells * 6e-8 * static_cast<double>(size.area()) * (request.channels() + 2);
    }
    need.bytes += FillWindow::bytesFor(request) + 2 * PositionMap::bytesFor(request.size);
    if (settings.movesSeams())
        need.bytes += joinBytes(request, threads);
    if (settings.evensTone())
        need.bytes += toneBytes(request);
    return need;
}

} // namespace texloom::quilting
