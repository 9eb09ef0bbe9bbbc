#include "core/image/labels.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texloom::labels {

namespace {

constexpr float kHalf = 0.5F;

void colourAt(const ImageView& picture, int x, int y, Colour& colour) {
    for (int c = 0; c < picture.channels; ++c)
        colour[static_cast<std::size_t>(c)] = picture(x, y, c);
}

/// A stretch of a row that is to be looked at.
struct Stretch {
    int begin, end, y;
};

} // namespace

std::optional<Palette> flatColours(const ImageView& picture, std::size_t most) {
    Palette colours;
    Colour own(static_cast<std::size_t>(picture.channels)), last;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            colourAt(picture, x, y, own);
            if (own == last)
                continue;
            last = own;
            if (std::find(colours.begin(), colours.end(), own) != colours.end())
                continue;
            if (colours.size() == most)
                return std::nullopt;
            colours.push_back(own);
        }
    return colours;
}

Palette usualColours(int channels) {
    constexpr std::array<std::array<int, 3>, 8> kColours = {{{230, 159, 0},
                                                             {0, 114, 178},
                                                             {0, 158, 115},
                                                             {213, 94, 0},
                                                             {240, 228, 66},
                                                             {86, 180, 233},
                                                             {204, 121, 167},
                                                             {51, 51, 51}}};
    constexpr float kWhole = 255;
    Palette palette;
    for (std::size_t i = 0; i < kColours.size(); ++i) {
        Colour colour(static_cast<std::size_t>(channels), 1.0F);
        if (channels == 1)
            colour[0] = static_cast<float>(i) / static_cast<float>(kColours.size() - 1);
        for (std::size_t c = 0; channels > 1 && c < std::min<std::size_t>(colour.size(), 3); ++c)
            colour[c] = static_cast<float>(kColours[i][c]) / kWhole;
        palette.push_back(std::move(colour));
    }
    return palette;
}

Palette joined(Palette first, const Palette& more, std::size_t most) {
    for (const Colour& colour : more)
        if (first.size() < most && std::find(first.begin(), first.end(), colour) == first.end())
            first.push_back(colour);
    return first;
}

Image indicesOf(const ImageView& picture, const Palette& palette) {
    Image indices(picture.size(), 1);
    Colour own(static_cast<std::size_t>(picture.channels));
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            colourAt(picture, x, y, own);
            const auto found = std::find(palette.begin(), palette.end(), own);
            indices(x, y, 0) = found == palette.end() ? 0.0F : static_cast<float>(found - palette.begin());
        }
    return indices;
}

Image pictureOf(const ImageView& indices, const Palette& palette) {
    const auto channels = static_cast<int>(palette.front().size());
    Image picture(indices.size(), channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < indices.height; ++y) {
            const float* const row = indices.plane(0).row(y);
            std::transform(row, row + indices.width, picture.plane(c).row(y), [&palette, c](float index) {
                return palette[static_cast<std::size_t>(index)][static_cast<std::size_t>(c)];
            });
        }
    return picture;
}

Image painted(const ImageView& indices, const ImageView& shape, int label) {
    Image made(indices);
    for (int y = 0; y < made.height(); ++y) {
        float* const row = made.plane(0).row(y);
        std::transform(
            row, row + made.width(), shape.plane(0).row(y), row,
            [label](float now, float inShape) { return inShape >= kHalf ? static_cast<float>(label) : now; });
    }
    return made;
}

Image filled(const ImageView& indices, int x, int y, int label, const std::function<void()>& check) {
    Image made(indices);
    const float before = made(x, y, 0), after = static_cast<float>(label);
    if (before == after)
        return made;
    std::vector<Stretch> waiting = {{x, x + 1, y}};
    while (!waiting.empty()) {
        const Stretch seed = waiting.back();
        waiting.pop_back();
        check();
        float* const row = made.plane(0).row(seed.y);
        for (int at = seed.begin; at < seed.end; ++at) {
            if (row[at] != before)
                continue;
            int begin = at, end = at + 1;
            while (begin > 0 && row[begin - 1] == before)
                --begin;
            while (end < made.width() && row[end] == before)
                ++end;
            std::fill(row + begin, row + end, after);
            for (const int beside : {seed.y - 1, seed.y + 1})
                if (beside >= 0 && beside < made.height())
                    waiting.push_back({begin, end, beside});
            at = end;
        }
    }
    return made;
}

} // namespace texloom::labels
