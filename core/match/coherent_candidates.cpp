#include "core/match/coherent_candidates.h"

#include "core/image/mirror.h"

#include <algorithm>

namespace texloom {

namespace {

/// Neighbours mostly belong to the last copies that were met.
void addOnce(const Continuation& one, std::vector<Continuation>& found) {
    if (std::find(found.rbegin(), found.rend(), one) == found.rend())
        found.push_back(one);
}

} // namespace

void coherentCandidates(const PositionMap& map, const PixelRuns& runs, int x, int y, Wrap wrap,
                        std::vector<Continuation>& found) {
    found.clear();
    const int width = map.width(), height = map.height();
    for (const PixelRun& run : runs) {
        if (!wrap.y && (y + run.dy < 0 || y + run.dy >= height))
            continue;
        const int row = repeated(y + run.dy, height);
        const int begin = wrap.x ? run.dx : std::max(run.dx, -x);
        const int end = wrap.x ? run.dx + run.count : std::min(run.dx + run.count, width - x);
        int column = repeated(x + begin, width);
        for (int dx = begin; dx < end; ++dx) {
            const Source& source = map.at(column, row);
            if (source.valid())
                addOnce({source, -dx, -run.dy}, found);
            column = column + 1 == width ? 0 : column + 1;
        }
    }
}

} // namespace texloom
