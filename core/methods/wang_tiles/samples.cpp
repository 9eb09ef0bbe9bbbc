#include "core/methods/wang_tiles/samples.h"

#include "core/image/image.h"

#include <algorithm>
#include <cmath>

namespace texloom::wang_tiles {

int sampleCount(const Settings& settings) {
    return settings.match == Match::Corners ? settings.colours : 2 * settings.colours;
}

int zoneOf(const Settings& settings) {
    return std::max(2, static_cast<int>(std::lround(settings.overlap * settings.tile)));
}

int depthOf(const Settings& settings) {
    return std::max(1, 3 * zoneOf(settings) / 4);
}

int reachOf(const Settings& settings) {
    return (settings.tile + zoneOf(settings)) / 2 + 2;
}

int sampleSide(const Settings& settings) {
    return 2 * reachOf(settings);
}

double squaredDifference(const Request& request, const Source& a, const Source& b) {
    const Image &one = *request.exemplars[a.exemplar].image, &two = *request.exemplars[b.exemplar].image;
    float sum = 0;
    for (int c = 0; c < one.channels(); ++c) {
        const float difference = one(a.x, a.y, c) - two(b.x, b.y, c);
        sum += difference * difference;
    }
    return static_cast<double>(sum);
}

} // namespace texloom::wang_tiles
