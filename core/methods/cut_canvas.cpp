#include "core/methods/cut_canvas.h"

#include <algorithm>

namespace texloom::graph_cut {

namespace {

constexpr Step kRight{1, 0}, kDown{0, 1};

} // namespace

Canvas::Canvas(const Request& request, const SeamCost& cost)
    : m_request(request), m_cost(cost), m_image(request.size, request.channels()),
      m_map(request.size, request.exemplarSizes()), m_seams(request.size, 1) {}

bool Canvas::settle(int& x, int& y) const {
    const Size whole = size();
    if (m_request.wrap.x)
        x = (x % whole.width + whole.width) % whole.width;
    if (m_request.wrap.y)
        y = (y % whole.height + whole.height) % whole.height;
    return x >= 0 && y >= 0 && x < whole.width && y < whole.height;
}

void Canvas::collect(const Patch& patch) {
    const Exemplar& exemplar = m_request.exemplars[static_cast<std::size_t>(patch.exemplar)];
    const Image* const mask = exemplar.mask();
    m_window = patch.window.size;
    m_pixels.assign(static_cast<std::size_t>(m_window.area()), {});
    for (int y = 0; y < m_window.height; ++y)
        for (int x = 0; x < m_window.width; ++x) {
            Pixel& one = pixel(x, y);
            one.x = patch.window.x + x;
            one.y = patch.window.y + y;
            const int u = one.x - patch.x, v = one.y - patch.y;
            one.fresh = {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
                         static_cast<std::uint16_t>(patch.exemplar)};
            one.inside = settle(one.x, one.y) && (!mask || (*mask)(u, v, 0) != 0);
        }
}

/// Two pixels where the patch overlaps. Where an old seam runs between them, a node of its own stands for it,
/// tied to the new terminal by what the seam costs.
void Canvas::linkPixels(const Pixel& a, const Pixel& b, Step step, GridFlow& flow) const {
    const auto side = step.x > 0 ? GridFlow::Right : GridFlow::Down;
    const Source &oldA = m_map.at(a.x, a.y), &oldB = m_map.at(b.x, b.y);
    const std::int32_t costA = m_cost.capacity(oldA, b.fresh, step);
    const std::int32_t seam = m_cost.capacity(oldA, oldB, step);
    if (seam == 0) {
        flow.link(a.node, side, b.node, costA, costA);
        return;
    }
    // The new picture begins on the other side of the link.
    const std::int32_t costB = m_cost.capacity(a.fresh, oldB, step);
    const int node = flow.add();
    flow.link(a.node, side, node, costA, costA);
    flow.link(node, side, b.node, costB, costB);
    flow.tieToSecond(node, seam);
}

/// A pixel where the patch overlaps beside one where it does not: an old one, or one that only the patch
/// covers. @param ahead whether the neighbour lies in the step's direction.
void Canvas::tieBorder(const Pixel& a, const Pixel* neighbour, Step step, bool ahead, GridFlow& flow) const {
    const Source& old = m_map.at(a.x, a.y);
    const auto cost = [&](const Source& own, const Source& other) {
        return ahead ? m_cost.capacity(own, other, step) : m_cost.capacity(other, own, step);
    };
    int x = a.x + (ahead ? step.x : -step.x), y = a.y + (ahead ? step.y : -step.y);
    if (!settle(x, y))
        return;
    if (known(x, y)) {
        flow.tieToFirst(a.node, cost(a.fresh, m_map.at(x, y)));
        flow.tieToSecond(a.node, cost(old, m_map.at(x, y)));
    } else if (neighbour && neighbour->inside)
        flow.tieToSecond(a.node, cost(old, neighbour->fresh));
}

/// The first terminal stands for what is there, the second for the patch.
GridFlow Canvas::graph(const std::function<bool(int, int)>& core, JobContext& context) {
    GridFlow flow(m_pixels.size() + m_pixels.size() / 4);
    for (Pixel& one : m_pixels)
        if (one.inside && known(one.x, one.y))
            one.node = flow.add();
    const auto at = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < m_window.width && y < m_window.height ? &pixel(x, y) : nullptr;
    };
    for (int y = 0; y < m_window.height; ++y) {
        context.check();
        for (int x = 0; x < m_window.width; ++x) {
            const Pixel& one = pixel(x, y);
            if (one.node < 0)
                continue;
            for (const Step step : {kRight, kDown}) {
                const Pixel* next = at(x + step.x, y + step.y);
                const Pixel* before = at(x - step.x, y - step.y);
                if (next && next->node >= 0)
                    linkPixels(one, *next, step, flow);
                else
                    tieBorder(one, next, step, true, flow);
                if (!before || before->node < 0)
                    tieBorder(one, before, step, false, flow);
            }
            if (core && core(one.x, one.y))
                flow.tieToSecond(one.node, GridFlow::kForbidden);
        }
    }
    return flow;
}

void Canvas::cover(const Pixel& pixel) {
    const Image& exemplar = *m_request.exemplars[pixel.fresh.exemplar].image;
    m_covered += known(pixel.x, pixel.y) ? 0 : 1;
    m_map.at(pixel.x, pixel.y) = pixel.fresh;
    for (int c = 0; c < m_image.channels(); ++c)
        m_image(pixel.x, pixel.y, c) = exemplar(pixel.fresh.x, pixel.fresh.y, c);
}

std::int64_t Canvas::paste(const Patch& patch, const std::function<bool(int, int)>& core,
                           JobContext& context) {
    collect(patch);
    GridFlow flow = graph(core, context);
    const std::int64_t value = flow.solve([&] { context.check(); });
    for (const Pixel& one : m_pixels)
        if (one.inside && (one.node < 0 || !flow.first(one.node)))
            cover(one);
    measureSeams(patch.window);
    return value;
}

bool Canvas::mend(const Patch& patch, const std::function<bool(int, int)>& core, JobContext& context) {
    collect(patch);
    std::vector<Source> before;
    for (const Pixel& one : m_pixels)
        before.push_back(one.inside ? m_map.at(one.x, one.y) : Source{});
    const double cost = windowCost(patch.window);
    paste(patch, core, context);
    if (windowCost(patch.window) < cost)
        return true;
    for (std::size_t i = 0; i < m_pixels.size(); ++i)
        if (m_pixels[i].inside) {
            m_pixels[i].fresh = before[i];
            cover(m_pixels[i]);
        }
    measureSeams(patch.window);
    return false;
}

/// Of the seams to the right of and below a pixel.
double Canvas::seamCost(int x, int y) const {
    double sum = 0;
    if (!known(x, y))
        return 0;
    for (const Step step : {kRight, kDown}) {
        int u = x + step.x, v = y + step.y;
        if (settle(u, v) && known(u, v))
            sum += m_cost.between(m_map.at(x, y), m_map.at(u, v), step);
    }
    return sum;
}

/// Of all seams that pasting a patch may change.
double Canvas::windowCost(const Region& window) const {
    double sum = 0;
    for (int y = window.y - 1; y < window.bottom(); ++y)
        for (int x = window.x - 1; x < window.right(); ++x) {
            int u = x, v = y;
            if (settle(u, v))
                sum += seamCost(u, v);
        }
    return sum;
}

void Canvas::measureSeams(const Region& window) {
    for (int y = window.y - 1; y < window.bottom(); ++y)
        for (int x = window.x - 1; x < window.right(); ++x) {
            int u = x, v = y;
            if (settle(u, v))
                m_seams(u, v, 0) = static_cast<float>(seamCost(u, v));
        }
}

double Canvas::totalCost(JobContext& context) const {
    double sum = 0;
    for (int y = 0; y < m_seams.height(); ++y) {
        context.check();
        for (int x = 0; x < m_seams.width(); ++x)
            sum += seamAt(x, y);
    }
    return sum;
}

std::uint64_t Canvas::bytesFor(Size size, Size exemplar, int channels) {
    const auto pixels = static_cast<std::uint64_t>(exemplar.area());
    return Image::bytesFor(size, channels + 1) + PositionMap::bytesFor(size) +
           pixels * (sizeof(Pixel) + sizeof(Source)) + GridFlow::bytesFor(2 * pixels);
}

} // namespace texloom::graph_cut
