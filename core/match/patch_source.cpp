#include "core/match/patch_source.h"

namespace texloom {

double pixelVariance(std::span<const PatchSource> exemplars, std::span<const double> means,
                     const std::function<void()>& check) {
    double squares = 0, pixels = 0;
    for (const PatchSource& exemplar : exemplars) {
        const ImageView& image = exemplar.image;
        for (int c = 0; c < image.channels; ++c)
            for (int y = 0; y < image.height; ++y) {
                check();
                for (int x = 0; x < image.width; ++x) {
                    const double value =
                        static_cast<double>(image(x, y, c)) - means[static_cast<std::size_t>(c)];
                    squares += value * value;
                }
            }
        pixels += static_cast<double>(image.size().area());
    }
    return squares / pixels;
}

} // namespace texloom
