#include "core/match/patch_quilter.h"

#include "core/base/text.h"

#include <cmath>
#include <numeric>

namespace texloom {

namespace {

/// Cells to either side and above in which the same piece is noticed again.
constexpr int kNear = 4;
/// How fast flat patches become farther where there are more of them than there should be, in usual distances
/// for as many again.
constexpr double kFlatPressure = 32;

std::vector<Size> sizesOf(const std::vector<PatchSource>& exemplars) {
    std::vector<Size> sizes;
    for (const PatchSource& exemplar : exemplars)
        sizes.push_back(exemplar.image.size());
    return sizes;
}

} // namespace

PatchQuilter::PatchQuilter(const std::vector<PatchSource>& exemplars, const QuiltOptions& options,
                           JobContext& context)
    : m_options(options), m_context(context),
      m_search(
          exemplars, options.patch, [&context] { context.check(); }, options.contrast),
      m_canvas(options.size, options.wrap, exemplars.front().image.channels, options.patch, options.overlap),
      m_map(options.traced ? PositionMap(m_canvas.image().size(), sizesOf(exemplars)) : PositionMap()),
      m_sources(static_cast<std::size_t>(m_canvas.grid().count())),
      m_cutCosts(static_cast<std::size_t>(m_canvas.grid().count()), 0.0) {
    if (options.stitch != PatchStitch::Cut && options.stitch != PatchStitch::SmoothCut)
        m_stitcher.emplace(options.stitch, options.patch);
    if (options.contrast > 0 && !options.initial && !options.guide)
        findFlat(exemplars);
    if (!options.guide || !(options.guide->weight > 0))
        return;
    const QuiltGuide& guide = *options.guide;
    m_guide.emplace(
        Guide{PatchSearch(guide.exemplars, options.patch, [&context] { context.check(); }),
              PatchCanvas(options.size, options.wrap, guide.output.channels, options.patch, options.overlap),
              guide.weight});
    m_guide->canvas.fill(guide.output, context);
}

void PatchQuilter::prepareExemplars() {
    for (const PatchCell& cell : m_canvas.grid().cells()) {
        m_search.prepare(compared(cell));
        if (m_stitcher)
            m_stitcher->prepare(cell.overlap);
    }
    if (m_guide)
        for (const PatchCell& cell : m_canvas.grid().cells())
            m_guide->search.prepare(Footprint::filled(m_canvas.visible(cell)));
}

Footprint PatchQuilter::compared(const PatchCell& cell) const {
    // The last patches reach beyond the output, where the initial image says nothing.
    return m_options.initial ? Footprint::filled(m_canvas.visible(cell)) : Footprint(cell.overlap);
}

/// Fills the guide's distances: those of what lies within the output, beyond which it says nothing.
void PatchQuilter::follow(const PatchCell& cell, Workspace& work) const {
    m_guide->canvas.read(cell, work.guide);
    m_guide->search.compute(work.guide, Footprint::filled(m_canvas.visible(cell)), work.guideScratch,
                            [this] { m_context.check(); });
}

/// The distances to choose by: of what is known, of the guide, or of both as means over their pixels, up to a
/// factor.
PatchSearch::Scratch& PatchQuilter::distances(const PatchCell& cell, bool known, Workspace& work) const {
    if (m_guide)
        follow(cell, work);
    if (m_guide && (!known || std::isinf(m_guide->weight)))
        return work.guideScratch;
    m_search.compute(work.known, compared(cell), work.scratch, [this] { m_context.check(); });
    if (!m_guide)
        return work.scratch;
    const auto guided = static_cast<double>(m_canvas.visible(cell).area());
    m_search.add(work.guideScratch, guided / (compared(cell).pixels(m_options.patch) * m_guide->weight),
                 work.scratch);
    return work.scratch;
}

/// Makes patches farther whose pixels were copied near by, the more so the nearer.
void PatchQuilter::vary(int index, PatchSearch::Scratch& distances) const {
    const PatchGrid& grid = m_canvas.grid();
    for (const int other : grid.nearby(index, kNear))
        m_search.discourage(m_sources[static_cast<std::size_t>(other)],
                            m_options.variety / grid.away(index, other), distances);
}

void PatchQuilter::findFlat(const std::vector<PatchSource>& exemplars) {
    m_flat.emplace(exemplars, m_options.patch, [this] { m_context.check(); });
    if (!m_flat->any())
        m_flat.reset();
    for (const PatchSource& exemplar : exemplars)
        m_flatReach = std::max(m_flatReach, std::max(exemplar.image.width, exemplar.image.height) /
                                                (m_options.patch - m_options.overlap));
}

/// Makes flat patches farther where there are more of them than the exemplars have: among the patches laid so
/// far within an exemplar's length to the left, to the right and above, which are as much as two exemplars;
/// of fewer, near the borders, the flat patches of one exemplar are allowed.
void PatchQuilter::leaveFlat(int index, PatchSearch::Scratch& distances) const {
    double flat = 0, laid = 0;
    for (const int other : m_canvas.grid().nearby(index, m_flatReach)) {
        ++laid;
        const PatchPosition& source = m_sources[static_cast<std::size_t>(other)];
        flat += static_cast<double>(
            m_flat->shares()[static_cast<std::size_t>(source.exemplar)](source.x, source.y, 0));
    }
    const double expected = std::max(laid, 1.0 * m_flatReach * m_flatReach) * m_flat->usual();
    if (flat > expected)
        m_search.raise(m_flat->shares(),
                       kFlatPressure * m_options.contrast * (flat / expected - 1) *
                           m_search.usualDistance(compared(m_canvas.grid().cell(index))),
                       distances);
}

PatchPosition PatchQuilter::choose(int index, Workspace& work) const {
    const PatchCell& cell = m_canvas.grid().cell(index);
    const bool known = !cell.overlap.none() || m_options.initial;
    if (!known && !m_guide)
        return m_search.drawn(m_context.random().uniform(cell.column, cell.row));
    PatchSearch::Scratch& compared = distances(cell, known, work);
    if (m_options.variety > 0)
        vary(index, compared);
    if (m_flat)
        leaveFlat(index, compared);
    return m_search.drawn(m_search.within(m_options.tolerance, compared), m_context.random(), cell.column,
                          cell.row);
}

void PatchQuilter::trace(const PatchCell& cell, const PatchPosition& source, const PlaneView& weight) {
    for (int y = 0; y < m_options.patch; ++y) {
        const int toY = (cell.y + y) % m_map.height();
        for (int x = 0; x < m_options.patch; ++x)
            if (weight(x, y) < 0.5F)
                m_map.at((cell.x + x) % m_map.width(), toY) = {static_cast<std::uint16_t>(source.x + x),
                                                               static_cast<std::uint16_t>(source.y + y),
                                                               static_cast<std::uint16_t>(source.exemplar)};
    }
}

PatchQuilter::Workspace PatchQuilter::workspace() const {
    const Size patch{m_options.patch, m_options.patch};
    Workspace work{Image(patch, m_canvas.image().channels()),
                   Image(patch, 1),
                   Image(patch, 1),
                   m_search.scratch(),
                   {},
                   {},
                   {}};
    if (m_stitcher)
        work.stitch = m_stitcher->scratch();
    if (m_guide) {
        work.guide = Image(patch, m_guide->canvas.image().channels());
        work.guideScratch = m_guide->search.scratch();
    }
    return work;
}

void PatchQuilter::place(int index) {
    const PatchCell& cell = m_canvas.grid().cell(index);
    const auto work = m_pool.borrow([this] { return workspace(); });
    m_canvas.read(cell, work->known);
    const PatchPosition source = choose(index, *work);
    m_sources[static_cast<std::size_t>(index)] = source;
    const ImageView fresh = m_search.pixels(source);
    const PlaneSpan weight = work->weight.plane(0);
    if (cuts()) {
        m_cutCosts[static_cast<std::size_t>(index)] =
            cutWeights(work->known, fresh, cell.overlap, m_options.softness, work->error.plane(0), weight);
        m_canvas.place(cell, work->known, fresh, weight);
    } else {
        Image joined(fresh);
        m_stitcher->join(work->known, cell.overlap, joined, *work->stitch);
        m_stitcher->shares(cell.overlap, weight);
        m_canvas.place(cell, joined);
    }
    if (m_options.traced)
        trace(cell, source, weight);
}

Quilt PatchQuilter::run(double weight, Order order) {
    m_context.stage(0.05 * weight, TR("Preparing the exemplar"));
    prepareExemplars();
    if (m_options.initial)
        m_canvas.fill(*m_options.initial, m_context);
    m_context.stage(0.95 * weight, TR("Placing patches"));
    const auto body = [this](int index) { place(index); };
    const auto show = [this] { m_context.preview(m_canvas.image(), m_options.traced ? &m_map : nullptr); };
    const int count = m_canvas.grid().count();
    if (order == Order::Wavefront)
        m_canvas.grow(m_context, body, show);
    else
        for (int index = 0; index < count; ++index)
            body(index);
    Quilt quilt;
    quilt.image = m_canvas.take();
    if (m_options.traced)
        m_map.shrink(m_options.size);
    quilt.map = std::move(m_map);
    quilt.patches = count;
    if (cuts())
        quilt.meanCutError = std::accumulate(m_cutCosts.begin(), m_cutCosts.end(), 0.0) / count;
    return quilt;
}

std::uint64_t PatchQuilter::mapBytesFor(Size size, int patch) {
    return PositionMap::bytesFor({size.width + patch, size.height + patch});
}

} // namespace texloom
