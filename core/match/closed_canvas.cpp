#include "core/match/closed_canvas.h"

#include "core/image/half_scale.h"

#include <algorithm>
#include <vector>

namespace texloom {

ClosedCanvas::ClosedCanvas(Size size, int channels, int margin)
    : m_size(size), m_channels(channels), m_margin(margin),
      m_pixels({size.width + margin, size.height + margin}, channels) {}

void ClosedCanvas::load(const ImageView& image, JobContext& context) {
    context.parallel(0, m_size.height, [&](int y) {
        std::vector<float> values(static_cast<std::size_t>(m_size.width));
        float* to = row(y);
        for (int c = 0; c < image.channels; ++c) {
            enlargeRow(image.plane(c), m_size, y, values.data());
            for (int x = 0; x < m_size.width; ++x)
                to[x * m_pixels.pixel + c] = values[static_cast<std::size_t>(x)];
        }
    });
    close(context);
}

void ClosedCanvas::close(JobContext& context) {
    const int pixel = m_pixels.pixel;
    context.parallel(0, m_size.height, [&](int y) {
        float* first = row(y);
        for (int x = 0; x < m_margin; ++x) // a small canvas may repeat in its margin
            std::copy_n(first + (x % m_size.width) * pixel, pixel, first + (m_size.width + x) * pixel);
    });
    for (int y = 0; y < m_margin; ++y)
        std::copy_n(row(y % m_size.height), m_pixels.stride(), row(m_size.height + y));
}

Image ClosedCanvas::image(int step, JobContext& context) const {
    Image picture({(m_size.width + step - 1) / step, (m_size.height + step - 1) / step}, m_channels);
    context.parallel(0, picture.height(), [&](int y) {
        for (int c = 0; c < m_channels; ++c) {
            float* to = picture.plane(c).row(y);
            for (int x = 0; x < picture.width(); ++x)
                to[x] = m_pixels.at(x * step, y * step)[c];
        }
    });
    return picture;
}

} // namespace texloom
