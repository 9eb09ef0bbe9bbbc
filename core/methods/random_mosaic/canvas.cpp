#include "core/methods/random_mosaic/canvas.h"

#include "core/base/text.h"
#include "core/math/grid_poisson.h"
#include "core/methods/random_mosaic/layout.h"

#include <algorithm>
#include <optional>

namespace texloom::random_mosaic {

namespace {

/// The joints of a canvas, seen as steps between neighbouring pixels.
class Steps {
public:
    Steps(const Canvas& canvas, const Request& request) : m_canvas(canvas), m_request(request) {}

    /// How much less than wanted pixel b lies above pixel a, its neighbour in the direction (dx, dy); 0 where
    /// both are of one piece.
    float missing(int ax, int ay, int bx, int by, int dx, int dy, int channel) const {
        const Source &a = m_canvas.map.at(ax, ay), &b = m_canvas.map.at(bx, by);
        const std::optional<Source> onward = moved(a, m_canvas.turn(ax, ay), dx, dy);
        const std::optional<Source> back = moved(b, m_canvas.turn(bx, by), -dx, -dy);
        if (m_canvas.turn(ax, ay) == m_canvas.turn(bx, by) && onward && *onward == b)
            return 0;
        float wanted = 0;
        if (onward)
            wanted += value(*onward, channel) - value(a, channel);
        if (back)
            wanted += value(b, channel) - value(*back, channel);
        if (onward && back)
            wanted *= 0.5F;
        return wanted - (m_canvas.image(bx, by, channel) - m_canvas.image(ax, ay, channel));
    }

private:
    std::optional<Source> moved(Source from, std::uint8_t turn, int dx, int dy) const {
        const Size size = m_canvas.map.exemplarSizes()[from.exemplar];
        const int x = from.x + ((turn & Turn::kFlipX) != 0 ? -dx : dx);
        const int y = from.y + ((turn & Turn::kFlipY) != 0 ? -dy : dy);
        if (x < 0 || y < 0 || x >= size.width || y >= size.height)
            return std::nullopt;
        return Source{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), from.exemplar};
    }
    float value(const Source& source, int channel) const {
        return (*m_request.exemplars[source.exemplar].image)(source.x, source.y, channel);
    }

    const Canvas& m_canvas;
    const Request& m_request;
};

/// The mean of a channel over all exemplars.
double meanOf(const Request& request, int channel, JobContext& context) {
    double sum = 0, pixels = 0;
    for (const Exemplar& exemplar : request.exemplars) {
        const auto area = static_cast<double>(exemplar.image->size().area());
        sum += area * channelMeans(exemplar.image->view().channelRange(channel, 1), [&] {
                          context.check();
                      }).front();
        pixels += area;
    }
    return sum / pixels;
}

} // namespace

void levelJoints(Canvas& canvas, const Request& request, double weight, JobContext& context) {
    context.stage(weight, TR("Levelling joints"));
    const Size size = canvas.image.size();
    const GridPoisson poisson(size, request.wrap);
    const Steps steps(canvas, request);
    Image change(size, 1);
    const PlaneSpan plane = change.plane(0);
    for (int c = 0; c < canvas.image.channels(); ++c) {
        context.parallel(0, size.height, [&](int y) {
            for (int x = 0; x < size.width; ++x) {
                float divergence = 0;
                const int right = x + 1 < size.width ? x + 1 : 0, left = x > 0 ? x - 1 : size.width - 1;
                const int below = y + 1 < size.height ? y + 1 : 0, above = y > 0 ? y - 1 : size.height - 1;
                if (request.wrap.x || right > 0)
                    divergence += steps.missing(x, y, right, y, 1, 0, c);
                if (request.wrap.x || x > 0)
                    divergence -= steps.missing(left, y, x, y, 1, 0, c);
                if (request.wrap.y || below > 0)
                    divergence += steps.missing(x, y, x, below, 0, 1, c);
                if (request.wrap.y || y > 0)
                    divergence -= steps.missing(x, above, x, y, 0, 1, c);
                plane(x, y) = divergence;
            }
        });
        context.progress((c + 0.3) / canvas.image.channels());
        poisson.solve(plane, context);
        const ImageView pixels = canvas.image.view().channelRange(c, 1);
        const auto lift = static_cast<float>(meanOf(request, c, context) -
                                             channelMeans(pixels, [&] { context.check(); }).front());
        context.parallel(0, size.height, [&](int y) {
            float* row = canvas.image.plane(c).row(y);
            for (int x = 0; x < size.width; ++x)
                row[x] += plane(x, y) + lift;
        });
        context.progress((c + 1.0) / canvas.image.channels());
        context.preview(canvas.image);
    }
}

} // namespace texloom::random_mosaic
