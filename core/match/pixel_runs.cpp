#include "core/match/pixel_runs.h"

#include <algorithm>

namespace texloom {

PixelRuns causalRuns(int side) {
    const int reach = side / 2;
    PixelRuns runs;
    for (int dy = -reach; dy < 0; ++dy)
        runs.push_back({-reach, dy, side});
    if (reach > 0)
        runs.push_back({-reach, 0, reach});
    return runs;
}

PixelRuns followingRuns(int side) {
    const int reach = side / 2;
    PixelRuns runs;
    if (reach > 0)
        runs.push_back({1, 0, reach});
    for (int dy = 1; dy <= reach; ++dy)
        runs.push_back({-reach, dy, side});
    return runs;
}

PixelRuns aroundRuns(int side) {
    PixelRuns runs = causalRuns(side);
    for (const PixelRun& run : followingRuns(side))
        runs.push_back(run);
    return runs;
}

PixelRuns squareRuns(int side) {
    const int reach = side / 2;
    PixelRuns runs;
    for (int dy = -reach; dy <= reach; ++dy)
        runs.push_back({-reach, dy, side});
    return runs;
}

PixelRuns clippedRuns(const PixelRuns& runs, int x, int y, Size size, Wrap wrap) {
    PixelRuns clipped;
    for (PixelRun run : runs) {
        if (!wrap.y && (y + run.dy < 0 || y + run.dy >= size.height))
            continue;
        if (!wrap.x) {
            const int from = std::max(run.dx, -x);
            const int to = std::min(run.dx + run.count, size.width - x);
            run = {from, run.dy, to - from};
        }
        if (run.count > 0)
            clipped.push_back(run);
    }
    return clipped;
}

int pixelCount(const PixelRuns& runs) {
    int count = 0;
    for (const PixelRun& run : runs)
        count += run.count;
    return count;
}

} // namespace texloom
