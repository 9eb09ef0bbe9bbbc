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
    Steps(Canvas& canvas, const Request& request, JobContext& context)
        : m_canvas(canvas), m_request(request), m_size(canvas.image.size()), m_joints(canvas.joints) {
        context.parallel(0, m_size.height, [this](int y) {
            const int below = next(y, m_size.height);
            for (int x = 0; x < m_size.width; ++x) {
                const int right = next(x, m_size.width);
                if ((right > 0 || m_request.wrap.x) && !goesOn(x, y, right, y, 1, 0))
                    joints(x, y) |= kRight;
                if ((below > 0 || m_request.wrap.y) && !goesOn(x, y, x, below, 0, 1))
                    joints(x, y) |= kBelow;
            }
        });
    }

    /// The divergence of what the steps at a pixel lack; 0 where all around is of one piece.
    float divergence(int x, int y, int channel) const {
        const int left = x > 0 ? x - 1 : m_size.width - 1, above = y > 0 ? y - 1 : m_size.height - 1;
        float sum = 0;
        if ((joints(x, y) & kRight) != 0)
            sum += missing(x, y, next(x, m_size.width), y, 1, 0, channel);
        if ((joints(left, y) & kRight) != 0)
            sum -= missing(left, y, x, y, 1, 0, channel);
        if ((joints(x, y) & kBelow) != 0)
            sum += missing(x, y, x, next(y, m_size.height), 0, 1, channel);
        if ((joints(x, above) & kBelow) != 0)
            sum -= missing(x, above, x, y, 0, 1, channel);
        return sum;
    }

private:
    static constexpr std::uint8_t kRight = 1, kBelow = 2;

    static int next(int at, int length) { return at + 1 < length ? at + 1 : 0; }
    std::uint8_t& joints(int x, int y) {
        return m_joints[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                        static_cast<std::size_t>(x)];
    }
    std::uint8_t joints(int x, int y) const {
        return m_joints[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
                        static_cast<std::size_t>(x)];
    }
    /// Whether pixel b, the neighbour of a in the direction (dx, dy), is that in the exemplar, too.
    bool goesOn(int ax, int ay, int bx, int by, int dx, int dy) const {
        if (m_canvas.turn(ax, ay) != m_canvas.turn(bx, by))
            return false;
        const std::optional<Source> onward = moved(m_canvas.map.at(ax, ay), m_canvas.turn(ax, ay), dx, dy);
        return onward && *onward == m_canvas.map.at(bx, by);
    }
    /// How much less than wanted pixel b lies above pixel a.
    float missing(int ax, int ay, int bx, int by, int dx, int dy, int channel) const {
        const Source &a = m_canvas.map.at(ax, ay), &b = m_canvas.map.at(bx, by);
        const std::optional<Source> onward = moved(a, m_canvas.turn(ax, ay), dx, dy);
        const std::optional<Source> back = moved(b, m_canvas.turn(bx, by), -dx, -dy);
        float wanted = 0;
        if (onward)
            wanted += value(*onward, channel) - value(a, channel);
        if (back)
            wanted += value(b, channel) - value(*back, channel);
        if (onward && back)
            wanted *= 0.5F;
        return wanted - (m_canvas.image(bx, by, channel) - m_canvas.image(ax, ay, channel));
    }
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
    Size m_size;
    std::vector<std::uint8_t>& m_joints;
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

void levelJoints(Canvas& canvas, const Request& request, double reach, double weight, JobContext& context) {
    context.stage(weight, TR("Levelling joints"));
    const Size size = canvas.image.size();
    const GridPoisson poisson(size, request.wrap, reach);
    const Steps steps(canvas, request, context);
    const PlaneSpan plane = canvas.change.plane(0);
    for (int c = 0; c < canvas.image.channels(); ++c) {
        context.parallel(0, size.height, [&](int y) {
            for (int x = 0; x < size.width; ++x)
                plane(x, y) = steps.divergence(x, y, c);
        });
        context.progress((c + 0.3) / canvas.image.channels());
        context.preview(canvas.image);
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

std::uint64_t levellingBytes(Size size, int threads) {
    return GridPoisson::bytesFor(size, threads);
}

} // namespace texloom::random_mosaic
