#include "core/match/patch_canvas.h"

#include <algorithm>
#include <utility>

namespace texloom {

PatchCanvas::PatchCanvas(Size output, Wrap wrap, int channels, int patch, int overlap)
    : m_output(output), m_wrap(wrap), m_patch(patch),
      m_grid(PatchAxis(output.width, patch, overlap, wrap.x),
             PatchAxis(output.height, patch, overlap, wrap.y)),
      m_image({PatchAxis(output.width, patch, overlap, wrap.x).canvas(),
               PatchAxis(output.height, patch, overlap, wrap.y).canvas()},
              channels) {}

Size PatchCanvas::visible(const PatchCell& cell) const {
    const Size left{m_wrap.x ? m_patch : m_output.width - cell.x,
                    m_wrap.y ? m_patch : m_output.height - cell.y};
    return {std::min(m_patch, left.width), std::min(m_patch, left.height)};
}

void PatchCanvas::fill(const ImageView& image, JobContext& context) {
    const int straight = std::min(image.width, m_image.width());
    context.parallel(0, m_image.height(), [&](int y) {
        for (int c = 0; c < m_image.channels(); ++c) {
            const float* from = image.plane(c).row(mirrored(y, image.height));
            float* row = std::copy_n(from, straight, m_image.plane(c).row(y));
            for (int x = straight; x < m_image.width(); ++x)
                *row++ = from[mirrored(x, image.width)];
        }
    });
}

void PatchCanvas::read(const PatchCell& cell, Image& patch) const {
    for (int c = 0; c < patch.channels(); ++c)
        for (int y = 0; y < patch.height(); ++y) {
            const float* from = m_image.plane(c).row((cell.y + y) % m_image.height());
            float* to = patch.plane(c).row(y);
            const int straight = std::min(patch.width(), m_image.width() - cell.x);
            std::copy_n(from + cell.x, straight, to);
            std::copy_n(from, patch.width() - straight, to + straight);
        }
}

void PatchCanvas::place(const PatchCell& cell, const ImageView& old, const ImageView& fresh,
                        const PlaneView& weight) {
    for (int y = 0; y < m_patch; ++y) {
        const int toY = (cell.y + y) % m_image.height();
        for (int x = 0; x < m_patch; ++x) {
            const float share = weight(x, y);
            if (share == 1)
                continue;
            const int toX = (cell.x + x) % m_image.width();
            for (int c = 0; c < fresh.channels; ++c)
                m_image(toX, toY, c) =
                    share == 0 ? fresh(x, y, c) : share * old(x, y, c) + (1 - share) * fresh(x, y, c);
        }
    }
}

void PatchCanvas::place(const PatchCell& cell, const ImageView& fresh) {
    for (int c = 0; c < fresh.channels; ++c)
        for (int y = 0; y < m_patch; ++y) {
            const float* from = fresh.plane(c).row(y);
            float* to = m_image.plane(c).row((cell.y + y) % m_image.height());
            const int straight = std::min(m_patch, m_image.width() - cell.x);
            std::copy_n(from, straight, to + cell.x);
            std::copy_n(from + straight, m_patch - straight, to);
        }
}

void PatchCanvas::grow(JobContext& context, const std::function<void(int)>& body,
                       const std::function<void()>& show) const {
    context.parallelAfter(
        m_grid.count(), [this](int index) { return m_grid.before(index); }, body,
        [&](int done) {
            context.progress(static_cast<double>(done) / m_grid.count());
            show();
        });
}

Image PatchCanvas::take() {
    m_image.shrink(m_output);
    return std::move(m_image);
}

std::uint64_t PatchCanvas::bytesFor(Size output, Wrap wrap, int channels, int patch, int overlap) {
    constexpr double kCellBytes = 160;
    const Size canvas{PatchAxis(output.width, patch, overlap, wrap.x).canvas(),
                      PatchAxis(output.height, patch, overlap, wrap.y).canvas()};
    return Image::bytesFor(canvas, channels) +
           static_cast<std::uint64_t>(kCellBytes * countFor(output, wrap, patch, overlap));
}

double PatchCanvas::countFor(Size output, Wrap wrap, int patch, int overlap) {
    return static_cast<double>(PatchAxis(output.width, patch, overlap, wrap.x).count()) *
           PatchAxis(output.height, patch, overlap, wrap.y).count();
}

} // namespace texloom
