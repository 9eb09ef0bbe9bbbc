#include "core/volume/point_colours.h"

#include "core/color/color_pipeline.h"

namespace texloom {

Image lightOfPoints(std::span<const float> values, std::size_t channels) {
    const auto count = static_cast<int>(values.size() / channels);
    Image light({count, 1}, 3);
    for (int i = 0; i < count; ++i)
        for (int c = 0; c < 3; ++c)
            light(i, 0, c) = values[channels * static_cast<std::size_t>(i) +
                                    (channels < 3 ? 0 : static_cast<std::size_t>(c))];
    if (count > 0)
        color::fromWorking(light, "linear");
    return light;
}

} // namespace texloom
