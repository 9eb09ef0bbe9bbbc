#include "core/methods/wang_tiles/corner_tiles.h"

#include "core/base/at.h"
#include "core/match/error_path.h"

#include <algorithm>
#include <utility>

namespace texloom::wang_tiles {

CornerTiles::CornerTiles(const Request& request, const Settings& settings, Samples samples, Size size,
                         JobContext& context)
    : m_request(request), m_colours(settings.colours), m_reach(reachOf(settings)), m_zone(zoneOf(settings)),
      m_depth(depthOf(settings)), m_samples(std::move(samples)), m_size(size),
      m_cuts(at(2 * m_colours * m_colours)) {
    context.parallel(0, m_colours * m_colours, [&](int i) {
        const int one = i / m_colours, two = i % m_colours;
        for (const bool across : {false, true}) {
            context.check();
            m_cuts[indexOf(one, two, across)] = cut(one, two, across);
        }
    });
    for (const Cut& one : m_cuts)
        m_worstError = std::max(m_worstError, one.error);
}

std::size_t CornerTiles::indexOf(int one, int two, bool across) const {
    return at((one * m_colours + two) * 2 + (across ? 1 : 0));
}

/// The pixel of a sample so many pixels right of and below its corner.
Source CornerTiles::sampled(int colour, int dx, int dy) const {
    const PatchPosition& sample = m_samples[at(colour)];
    const int last = 2 * m_reach - 1;
    return {static_cast<std::uint16_t>(sample.x + std::clamp(m_reach + dx, 0, last)),
            static_cast<std::uint16_t>(sample.y + std::clamp(m_reach + dy, 0, last)),
            static_cast<std::uint16_t>(sample.exemplar)};
}

/// The path of least error from one side of an edge to the other, near its middle. It leaves both corners to
/// their samples, if the edge has as many pixels.
CornerTiles::Cut CornerTiles::cut(int one, int two, bool across) const {
    const int length = across ? m_size.width : m_size.height;
    const int first = std::max(1, (length - m_zone) / 2);
    const int last = std::max(first, std::min(length - 1, (length + m_zone) / 2));
    const auto error = [&](int along, int away) {
        const auto of = [&](int colour, int from) {
            return across ? sampled(colour, along - from, away) : sampled(colour, away, along - from);
        };
        return squaredDifference(m_request, of(one, 0), of(two, length));
    };
    Cut cut;
    cut.first = leastErrorPath(
        2 * m_depth, last - first + 1,
        [&](int line, float* errors) {
            for (int i = first; i <= last; ++i)
                errors[i - first] = static_cast<float>(error(i, line - m_depth));
        },
        false);
    for (std::size_t line = 0; line < cut.first.size(); ++line) {
        cut.first[line] += first;
        cut.error += error(cut.first[line], static_cast<int>(line) - m_depth) / (2.0 * m_depth);
    }
    return cut;
}

/// A pixel beside an edge that runs from one corner to another. @param along the edge; @param away from its
/// line to the right or below, negative on the other side.
Source CornerTiles::beside(int one, int two, bool across, int along, int away) const {
    const std::vector<int>& first = m_cuts[indexOf(one, two, across)].first;
    const int line = std::clamp(away + m_depth, 0, static_cast<int>(first.size()) - 1);
    const bool second = along >= first[at(line)];
    const int from = second ? along - (across ? m_size.width : m_size.height) : along;
    return across ? sampled(second ? two : one, from, away) : sampled(second ? two : one, away, from);
}

Source CornerTiles::source(const Colours& colours, int x, int y) const {
    const int right = m_size.width - 1, bottom = m_size.height - 1;
    const bool left = 2 * x <= right, upper = 2 * y <= bottom;
    // The nearest edge, in shares of the sides.
    if (std::min(y, bottom - y) * std::max(1, right) <= std::min(x, right - x) * std::max(1, bottom))
        return upper ? beside(colours.north, colours.east, true, x, y)
                     : beside(colours.west, colours.south, true, x, y - m_size.height);
    return left ? beside(colours.north, colours.west, false, y, x)
                : beside(colours.east, colours.south, false, y, x - m_size.width);
}

} // namespace texloom::wang_tiles
