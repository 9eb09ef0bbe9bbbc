#include "core/methods/jump_map/walker.h"

#include "core/base/text.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <limits>

namespace texloom::jump_map {

namespace {

/// Draws at one place: for a start, and for a jump.
constexpr std::uint32_t kStart = 0, kWhether = 1;
/// Where an output closes, so many rows about its border are mended so often.
constexpr int kClosingRows = 16, kClosings = 4;

NeighbourhoodSet squaresOf(const PixelPyramid& pyramid, int side, const std::function<void()>& check) {
    std::vector<NeighbourhoodSource> sources;
    for (int e = 0; e < pyramid.exemplars(); ++e) {
        const PatchSource& source = pyramid.level(0)[static_cast<std::size_t>(e)];
        sources.push_back({{&pyramid.pixels(0, e)}, source.mask, 1});
    }
    return {Neighbourhood({{squareRuns(side), false, {}}}, {pyramid.pixels(0, 0).pixel}), std::move(sources),
            check};
}

} // namespace

Walker::Walker(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_pyramid(request, 1, oddSide(settings.neighbourhood), [&context] { context.check(); }),
      m_set(squaresOf(m_pyramid, oddSide(settings.neighbourhood), [&context] { context.check(); })),
      m_canvas(request.size, request.channels(), request.exemplarSizes()) {}

Synthesis Walker::run(ScanOrder::Order order) {
    m_context.stage(0.5, TR("Finding what looks alike"));
    m_lists = std::make_unique<JumpLists>(m_set, m_settings.jumps, m_settings.apart, m_context);
    m_context.stage(0.48, TR("Walking through the exemplar"));
    const Size size = m_request.size;
    scan(ScanOrder(size, 1, m_request.wrap), false, order);
    if (m_request.wrap.y) {
        // Walks only go on downwards, so that those of the last rows end where the first rows begin, in a
        // straight line.
        const int rows = std::min(size.height, kClosingRows);
        const ScanOrder border(size, 1, m_request.wrap, {size.height - rows / 2, rows});
        for (int closing = 0; closing < kClosings; ++closing)
            scan(border, true, order);
    }
    m_context.stage(0.02, TR("Copying pixels"));
    Synthesis result;
    result.map = std::move(m_canvas.map);
    result.image = copied(result.map, m_request, m_context);
    m_context.progress(1);
    result.mapKind = MapKind::Exact;
    return result;
}

/// @param closes whether all that surrounds these rows is made.
void Walker::scan(const ScanOrder& rows, bool closes, ScanOrder::Order order) {
    const auto body = [&](int y, int begin, int count) {
        for (int x = begin; x < begin + count; ++x) {
            const Source source = step(x, y, closes);
            m_canvas.put(x, y, source, m_pyramid.pixels(0, source.exemplar));
        }
    };
    const auto between = [&](double done) {
        m_context.progress(closes ? 1 : done);
        previewMap(m_canvas.map, m_pyramid.level(0), 0, m_request, m_context);
    };
    rows.run(m_context, body, between, order);
}

Walker::Neighbours Walker::around(int x, int y) const {
    // In raster order the last four are known only where the output closes on itself.
    Neighbours near{{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
    const Size size = m_request.size;
    for (Neighbour& one : near) {
        int column = x + one.dx, row = y + one.dy;
        if ((column < 0 || column >= size.width) && m_request.wrap.x)
            column = (column + size.width) % size.width;
        if ((row < 0 || row >= size.height) && m_request.wrap.y)
            row = (row + size.height) % size.height;
        if (column < 0 || column >= size.width || row < 0 || row >= size.height)
            continue;
        one.source = m_canvas.map.at(column, row);
        one.known = one.source.valid();
        one.pixel = m_canvas.pixels.at(column, row);
    }
    return near;
}

/// How much the surroundings of an exemplar's pixel differ from what the neighbours show.
float Walker::misfit(const Neighbours& near, const Source& source, float limit) const {
    const Interleaved& pixels = m_pyramid.pixels(0, source.exemplar);
    float sum = 0;
    for (const Neighbour& one : near) {
        if (!one.known)
            continue;
        const float* other = pixels.at(source.x + one.dx, source.y + one.dy);
        for (int c = 0; c < pixels.pixel; ++c)
            sum += (one.pixel[c] - other[c]) * (one.pixel[c] - other[c]);
        if (sum >= limit)
            break;
    }
    return sum;
}

/// A place that looks like this one, now and then; the more alike, the likelier.
Source Walker::jumped(const Source& source, int x, int y) const {
    const std::span<const Jump> jumps = m_lists->of(source);
    double left = m_context.random().uniform(x, y, kWhether);
    for (const Jump& jump : jumps) {
        left -= m_settings.jump * static_cast<double>(jump.likeness) / static_cast<double>(jumps.size());
        if (left < 0)
            return jump.to;
    }
    return source;
}

/// Where no walk can go on: the jump of a neighbour after which one can that fits best, or anywhere.
Source Walker::restart(const Neighbours& near, int x, int y) const {
    Source best;
    float least = std::numeric_limits<float>::infinity();
    for (const Neighbour& one : near) {
        if (!one.known)
            continue;
        for (const Jump& jump : m_lists->of(one.source)) {
            const Continuation next(jump.to, -one.dx, -one.dy);
            if (!m_set.has(next.x, next.y, next.exemplar))
                continue;
            const float found = misfit(near, next.source(), least);
            if (found < least) {
                least = found;
                best = next.source();
            }
        }
    }
    return best.valid() ? best : m_set.drawn(m_context.random().uniform(x, y, kStart));
}

Source Walker::step(int x, int y, bool closes) const {
    const Neighbours near = around(x, y);
    Source best;
    float least = std::numeric_limits<float>::infinity();
    for (const Neighbour& one : near) {
        if (!one.known)
            continue;
        const Continuation next(one.source, -one.dx, -one.dy);
        if (!m_set.has(next.x, next.y, next.exemplar) || next.source() == best)
            continue;
        const float found = misfit(near, next.source(), least);
        if (found < least) {
            least = found;
            best = next.source();
        }
    }
    if (!best.valid())
        return restart(near, x, y);
    return closes ? best : jumped(best, x, y);
}

} // namespace texloom::jump_map
