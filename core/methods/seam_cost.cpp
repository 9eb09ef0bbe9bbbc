#include "core/methods/seam_cost.h"

#include <algorithm>
#include <cmath>

namespace texloom::graph_cut {

namespace {

/// Capacities are whole: costs in steps of 1/1024 of a seam's usual cost, up to a thousand times that.
constexpr double kSteps = 1024, kLargest = 1000;
/// δ as a share of the exemplars' range.
constexpr double kFlat = 0.02;

} // namespace

SeamCost::SeamCost(const Request& request, bool gradient) : m_request(request), m_gradient(gradient) {
    ValueRange all = valueRange(*request.exemplars.front().image);
    for (const Exemplar& exemplar : request.exemplars) {
        const ValueRange own = valueRange(*exemplar.image);
        all = {std::min(all.smallest, own.smallest), std::max(all.largest, own.largest)};
    }
    const double range = static_cast<double>(all.largest) - static_cast<double>(all.smallest);
    m_delta = range > 0 ? kFlat * range : 1;
}

SeamCost::Place SeamCost::at(const Source& source, int dx, int dy) const {
    const Image& image = *m_request.exemplars[source.exemplar].image;
    return {&image, std::clamp(source.x + dx, 0, image.width() - 1),
            std::clamp(source.y + dy, 0, image.height() - 1)};
}

double SeamCost::distance(const Place& p, const Place& q) const {
    float sum = 0;
    for (int c = 0; c < p.image->channels(); ++c) {
        const float difference = (*p.image)(p.x, p.y, c) - (*q.image)(q.x, q.y, c);
        sum += difference * difference;
    }
    return static_cast<double>(std::sqrt(sum));
}

double SeamCost::between(const Source& a, const Source& b, Step step) const {
    if (a.exemplar == b.exemplar && a.x + step.x == b.x && a.y + step.y == b.y)
        return 0;
    const Place firstA = at(a, 0, 0), firstB = at(a, step.x, step.y);
    const Place secondA = at(b, -step.x, -step.y), secondB = at(b, 0, 0);
    const double error = distance(firstA, secondA) + distance(firstB, secondB);
    if (!m_gradient)
        return error / (2 * m_delta);
    const double slopes = distance(firstA, firstB) + distance(firstB, at(a, 2 * step.x, 2 * step.y)) +
                          distance(secondA, secondB) + distance(secondB, at(b, step.x, step.y));
    return error / (slopes + m_delta);
}

std::int32_t SeamCost::capacity(const Source& a, const Source& b, Step step) const {
    return static_cast<std::int32_t>(std::lround(kSteps * std::min(between(a, b, step), kLargest)));
}

} // namespace texloom::graph_cut
