#include "core/image/hidden_colour.h"

#include "core/base/large_memory.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

using Check = std::function<void()>;

/// Colours at one scale, and whether each is known.
struct Level {
    explicit Level(Size extent, std::size_t colours)
        : size(extent), known(static_cast<std::size_t>(extent.area())), values(known.size() * colours) {}

    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    }

    Size size;
    bool whole = true; ///< whether all are known
    ZeroedBuffer<unsigned char> known;
    ZeroedBuffer<float> values; ///< one after another for each pixel
};

/// Means of the known colours in blocks of 2 × 2.
Level halved(const Level& fine, std::size_t colours, const Check& check) {
    Level coarse({(fine.size.width + 1) / 2, (fine.size.height + 1) / 2}, colours);
    for (int y = 0; y < coarse.size.height; ++y) {
        check();
        for (int x = 0; x < coarse.size.width; ++x) {
            float* const mean = &coarse.values[coarse.at(x, y) * colours];
            int count = 0;
            for (int v = 2 * y; v < std::min(2 * y + 2, fine.size.height); ++v)
                for (int u = 2 * x; u < std::min(2 * x + 2, fine.size.width); ++u)
                    if (fine.known[fine.at(u, v)] != 0) {
                        ++count;
                        for (std::size_t c = 0; c < colours; ++c)
                            mean[c] += fine.values[fine.at(u, v) * colours + c];
                    }
            coarse.known[coarse.at(x, y)] = count > 0 ? 1 : 0;
            coarse.whole = coarse.whole && count > 0;
            for (std::size_t c = 0; c < colours; ++c)
                mean[c] /= static_cast<float>(std::max(count, 1));
        }
    }
    return coarse;
}

/// A coarse level's colour at a place of the finer one, between the centres of its pixels.
float between(const Level& coarse, int x, int y, std::size_t colour, std::size_t colours) {
    const float u = (static_cast<float>(x) - 0.5F) / 2, v = (static_cast<float>(y) - 0.5F) / 2;
    const int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    const float right = u - static_cast<float>(left), below = v - static_cast<float>(top);
    const auto value = [&](int column, int row) {
        const int inX = std::clamp(column, 0, coarse.size.width - 1);
        const int inY = std::clamp(row, 0, coarse.size.height - 1);
        return coarse.values[coarse.at(inX, inY) * colours + colour];
    };
    return (1 - below) * ((1 - right) * value(left, top) + right * value(left + 1, top)) +
           below * ((1 - right) * value(left, top + 1) + right * value(left + 1, top + 1));
}

void fillFrom(const Level& coarse, Level& fine, std::size_t colours, const Check& check) {
    for (int y = 0; y < fine.size.height; ++y) {
        check();
        for (int x = 0; x < fine.size.width; ++x)
            if (fine.known[fine.at(x, y)] == 0)
                for (std::size_t c = 0; c < colours; ++c)
                    fine.values[fine.at(x, y) * colours + c] = between(coarse, x, y, c, colours);
    }
}

Level visible(const Image& image, int alpha, const std::vector<int>& colours, const Check& check) {
    Level level(image.size(), colours.size());
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x)
            if (image(x, y, alpha) > 0) {
                level.known[level.at(x, y)] = 1;
                for (std::size_t c = 0; c < colours.size(); ++c)
                    level.values[level.at(x, y) * colours.size() + c] = image(x, y, colours[c]);
            } else {
                level.whole = false;
            }
    }
    return level;
}

/// Whether some pixels are visible, and others are not.
bool isPartlyHidden(const Image& image, int alpha, const Check& check) {
    bool anyHidden = false, anyVisible = false;
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x)
            (image(x, y, alpha) > 0 ? anyVisible : anyHidden) = true;
    }
    return anyHidden && anyVisible;
}

} // namespace

void fillHidden(Image& image, int alpha, const std::vector<int>& colours, const Check& check) {
    if (!isPartlyHidden(image, alpha, check))
        return;
    std::vector<Level> levels;
    levels.push_back(visible(image, alpha, colours, check));
    while (!levels.back().whole)
        levels.push_back(halved(levels.back(), colours.size(), check));
    for (std::size_t i = levels.size() - 1; i > 0; --i)
        fillFrom(levels[i], levels[i - 1], colours.size(), check);
    const Level& filled = levels.front();
    for (int y = 0; y < image.height(); ++y) {
        check();
        for (int x = 0; x < image.width(); ++x)
            if (!(image(x, y, alpha) > 0))
                for (std::size_t c = 0; c < colours.size(); ++c)
                    image(x, y, colours[c]) = filled.values[filled.at(x, y) * colours.size() + c];
    }
}

} // namespace texloom
