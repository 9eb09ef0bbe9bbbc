#include "core/match/canvas_image.h"

namespace texloom {

Image canvasImage(const Interleaved& canvas, Size size, int channels, int step, JobContext& context) {
    Image picture({(size.width + step - 1) / step, (size.height + step - 1) / step}, channels);
    context.parallel(0, picture.height(), [&](int y) {
        for (int c = 0; c < channels; ++c) {
            float* to = picture.plane(c).row(y);
            for (int x = 0; x < picture.width(); ++x)
                to[x] = canvas.at(x * step, y * step)[c];
        }
    });
    return picture;
}

} // namespace texloom
