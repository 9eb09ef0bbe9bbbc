#include "core/methods/quilting/quilter.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom::quilting {

/// What one thread needs to place a patch.
struct Quilter::Workspace {
    Image known;  ///< the patch as it is on the canvas
    Image error;  ///< squared differences to the chosen patch, where they overlap
    Image weight; ///< share of the old pixel, 0 to 1
    std::vector<PatchDistances::Scratch> scratch;
};

namespace {

/// The source clamps distances below 1 on a scale of 0 to 255 (IPOL 2017, section 3.1); here on the
/// exemplars' own range.
float smallestDistance(const Request& request) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const Exemplar& exemplar : request.exemplars) {
        const ValueRange range = valueRange(*exemplar.image);
        low = std::min(low, static_cast<double>(range.smallest));
        high = std::max(high, static_cast<double>(range.largest));
    }
    const double step = (high - low) / 255;
    return static_cast<float>(step * step);
}

/// Each channel's mean over all exemplars, which distances are taken relative to.
std::vector<double> commonMeans(const Request& request) {
    std::vector<double> means(static_cast<std::size_t>(request.channels()), 0.0);
    for (const Exemplar& exemplar : request.exemplars) {
        const std::vector<double> own = channelMeans(*exemplar.image);
        for (std::size_t c = 0; c < means.size(); ++c)
            means[c] += own[c] / static_cast<double>(request.exemplars.size());
    }
    return means;
}

/// Index into `length` pixels that mirrors at the borders, as often as need be.
int mirrored(int at, int length) {
    const int period = 2 * length;
    const int folded = at % period;
    return folded < length ? folded : period - 1 - folded;
}

} // namespace

Quilter::Quilter(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_horizontal(request.size.width, settings.patch, settings.overlapPixels(), request.wrap.x),
      m_vertical(request.size.height, settings.patch, settings.overlapPixels(), request.wrap.y),
      m_grid(m_horizontal, m_vertical), m_smallest(smallestDistance(request)),
      m_canvas({m_horizontal.canvas(), m_vertical.canvas()}, request.channels()),
      m_map(m_canvas.size(), request.exemplarSizes()),
      m_cutCosts(static_cast<std::size_t>(m_grid.count()), 0.0) {}

Quilter::~Quilter() = default;

void Quilter::prepareExemplars() {
    const std::vector<double> means = commonMeans(m_request);
    for (const Exemplar& exemplar : m_request.exemplars) {
        const PlaneView mask = exemplar.mask ? exemplar.mask->view().plane(0) : PlaneView{};
        PatchDistances& distances =
            m_distances.emplace_back(exemplar.image->view(), mask, means, m_settings.patch);
        m_context.check();
        for (const Cell& cell : m_grid.cells())
            distances.prepare(compared(cell));
    }
}

void Quilter::startFromInitial() {
    const ImageView initial = *m_request.initial;
    for (int c = 0; c < m_canvas.channels(); ++c)
        for (int y = 0; y < m_canvas.height(); ++y) {
            float* row = m_canvas.plane(c).row(y);
            const float* from = initial.plane(c).row(mirrored(y, initial.height));
            for (int x = 0; x < m_canvas.width(); ++x)
                row[x] = from[mirrored(x, initial.width)];
        }
}

std::unique_ptr<Quilter::Workspace> Quilter::borrow() {
    {
        const std::lock_guard lock(m_mutex);
        if (!m_idle.empty()) {
            auto work = std::move(m_idle.back());
            m_idle.pop_back();
            return work;
        }
    }
    const Size patch{m_settings.patch, m_settings.patch};
    auto work = std::make_unique<Workspace>();
    work->known = Image(patch, m_request.channels());
    work->error = Image(patch, 1);
    work->weight = Image(patch, 1);
    for (const PatchDistances& distances : m_distances)
        work->scratch.push_back(distances.scratch());
    return work;
}

void Quilter::giveBack(std::unique_ptr<Workspace> work) {
    const std::lock_guard lock(m_mutex);
    m_idle.push_back(std::move(work));
}

void Quilter::readPatch(const Cell& cell, Image& patch) const {
    for (int c = 0; c < patch.channels(); ++c)
        for (int y = 0; y < patch.height(); ++y) {
            const float* from = m_canvas.plane(c).row((cell.y + y) % m_canvas.height());
            float* to = patch.plane(c).row(y);
            const int straight = std::min(patch.width(), m_canvas.width() - cell.x);
            std::copy_n(from + cell.x, straight, to);
            std::copy_n(from, patch.width() - straight, to + straight);
        }
}

Footprint Quilter::compared(const Cell& cell) const {
    if (!m_request.initial)
        return cell.overlap;
    // The last patches reach beyond the output, where the initial image says nothing.
    const Size left{m_request.wrap.x ? m_settings.patch : m_request.size.width - cell.x,
                    m_request.wrap.y ? m_settings.patch : m_request.size.height - cell.y};
    return Footprint::filled(
        {std::min(m_settings.patch, left.width), std::min(m_settings.patch, left.height)});
}

Quilter::Candidate Quilter::firstPatch(const Cell& cell) const {
    std::int64_t allowed = 0;
    for (const PatchDistances& distances : m_distances)
        allowed += distances.allowed();
    auto left = static_cast<std::int64_t>(m_context.random().uniform(cell.column, cell.row) *
                                          static_cast<double>(allowed));
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y)
            for (int x = 0; x < positions.width; ++x)
                if (m_distances[e].allows(x, y) && left-- == 0)
                    return {static_cast<int>(e), x, y};
    }
    return {};
}

Quilter::Candidate Quilter::choose(const Cell& cell, Workspace& work) const {
    if (cell.overlap.none() && !m_request.initial)
        return firstPatch(cell);
    const Footprint footprint = compared(cell);
    for (std::size_t e = 0; e < m_distances.size(); ++e)
        m_distances[e].compute(work.known, footprint, m_smallest, work.scratch[e],
                               [this] { m_context.check(); });
    return drawn(cell, work);
}

Quilter::Candidate Quilter::drawn(const Cell& cell, const Workspace& work) const {
    float nearest = HUGE_VALF;
    for (const PatchDistances::Scratch& scratch : work.scratch)
        nearest = std::min(nearest, *std::min_element(scratch.rowMinima.begin(), scratch.rowMinima.end()));
    const float limit = nearest * static_cast<float>(1 + m_settings.tolerance);
    std::vector<Candidate> candidates;
    for (std::size_t e = 0; e < m_distances.size(); ++e) {
        const Size positions = m_distances[e].positions();
        for (int y = 0; y < positions.height; ++y) {
            if (work.scratch[e].rowMinima[static_cast<std::size_t>(y)] > limit)
                continue;
            const float* row = m_distances[e].distanceRow(work.scratch[e], y);
            for (int x = 0; x < positions.width; ++x)
                if (row[x] <= limit)
                    candidates.push_back({static_cast<int>(e), x, y});
        }
    }
    const auto count = static_cast<std::uint32_t>(candidates.size());
    return candidates[m_context.random().below(count, cell.column, cell.row)];
}

void Quilter::measureError(const Cell& cell, const Candidate& source, Workspace& work) const {
    const ImageView exemplar = *m_request.exemplars[static_cast<std::size_t>(source.exemplar)].image;
    for (int y = 0; y < m_settings.patch; ++y) {
        float* row = work.error.plane(0).row(y);
        for (int x = 0; x < m_settings.patch; ++x) {
            row[x] = 0;
            if (!cell.overlap.contains(x, y, m_settings.patch))
                continue;
            for (int c = 0; c < exemplar.channels; ++c) {
                const float difference = work.known(x, y, c) - exemplar(source.x + x, source.y + y, c);
                row[x] += difference * difference;
            }
        }
    }
}

void Quilter::weigh(const Cell& cell, const BoundaryCut& cut, Workspace& work) const {
    const int patch = m_settings.patch;
    const int reach = m_settings.stitch == Stitch::SmoothCut ? m_settings.softness : 0;
    // The mean over a square, by rows and then by columns; the error is not needed any more and lends its
    // room.
    const PlaneSpan rowSums = work.error.plane(0);
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x) {
            rowSums(x, y) = 0;
            for (int dx = -reach; dx <= reach; ++dx)
                rowSums(x, y) += cut.keeps(std::clamp(x + dx, 0, patch - 1), y) ? 1.0F : 0.0F;
        }
    const auto area = static_cast<float>((2 * reach + 1) * (2 * reach + 1));
    for (int y = 0; y < patch; ++y)
        for (int x = 0; x < patch; ++x) {
            float kept = 0;
            for (int dy = -reach; dy <= reach; ++dy)
                kept += rowSums(x, std::clamp(y + dy, 0, patch - 1));
            work.weight(x, y, 0) = cell.overlap.contains(x, y, patch) ? kept / area : 0.0F;
        }
}

void Quilter::stitch(const Cell& cell, const Candidate& source, const Workspace& work) {
    const ImageView exemplar = *m_request.exemplars[static_cast<std::size_t>(source.exemplar)].image;
    for (int y = 0; y < m_settings.patch; ++y) {
        const int toY = (cell.y + y) % m_canvas.height();
        for (int x = 0; x < m_settings.patch; ++x) {
            const float old = work.weight(x, y, 0);
            if (old == 1)
                continue;
            const int toX = (cell.x + x) % m_canvas.width();
            for (int c = 0; c < exemplar.channels; ++c) {
                const float fresh = exemplar(source.x + x, source.y + y, c);
                m_canvas(toX, toY, c) = old == 0 ? fresh : old * work.known(x, y, c) + (1 - old) * fresh;
            }
            if (old < 0.5F)
                m_map.at(toX, toY) = {static_cast<std::uint16_t>(source.x + x),
                                      static_cast<std::uint16_t>(source.y + y),
                                      static_cast<std::uint16_t>(source.exemplar)};
        }
    }
}

void Quilter::place(int index) {
    const Cell& cell = m_grid.cell(index);
    auto work = borrow();
    readPatch(cell, work->known);
    const Candidate source = choose(cell, *work);
    measureError(cell, source, *work);
    const BoundaryCut cut = minimumErrorCut(work->error.view().plane(0), cell.overlap);
    m_cutCosts[static_cast<std::size_t>(index)] = cut.cost;
    weigh(cell, cut, *work);
    stitch(cell, source, *work);
    giveBack(std::move(work));
}

Synthesis Quilter::run(Order order) {
    m_context.stage(0.05, TR("Preparing the exemplar"));
    prepareExemplars();
    if (m_request.initial)
        startFromInitial();
    m_context.stage(0.95, TR("Placing patches"));
    const auto before = [&](int index) {
        if (order == Order::Raster)
            return index > 0 ? std::vector<int>{index - 1} : std::vector<int>{};
        return m_grid.before(index);
    };
    m_context.parallelAfter(
        m_grid.count(), before, [this](int index) { place(index); },
        [this](int done) {
            m_context.progress(static_cast<double>(done) / m_grid.count());
            m_context.preview(m_canvas, &m_map);
        });
    Synthesis result;
    m_canvas.shrink(m_request.size);
    m_map.shrink(m_request.size);
    result.image = std::move(m_canvas);
    result.map = std::move(m_map);
    result.mapKind = m_settings.stitch == Stitch::Cut ? MapKind::Exact : MapKind::Dominant;
    const double cost = std::accumulate(m_cutCosts.begin(), m_cutCosts.end(), 0.0);
    result.figures = {{TR("Patches"), static_cast<double>(m_grid.count())},
                      {TR("Mean error along a cut"), cost / m_grid.count()}};
    return result;
}

} // namespace texloom::quilting
