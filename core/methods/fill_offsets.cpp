#include "core/methods/fill_offsets.h"

#include "core/match/masked_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace texloom {

namespace {

/// A square of the picture: its pixels, and which of them were not made.
struct BorderSquare {
    int x, y;
    Image pixels, counts;
};

/// Calls visit(i, j, x, y) for every pixel of a square that lies in the picture.
template <class Visit> void everyPixel(Size picture, int x, int y, int side, const Visit& visit) {
    for (int v = std::max(0, y); v < std::min(picture.height, y + side); ++v)
        for (int u = std::max(0, x); u < std::min(picture.width, x + side); ++u)
            visit(u - x, v - y, u, v);
}

/// Whether a square shows enough of what was not made to be compared, and anything that was.
bool liesOnBorder(const CopiedPixels& copied, Size picture, int x, int y, int side) {
    int known = 0, missing = 0;
    everyPixel(picture, x, y, side, [&](int, int, int u, int v) {
        const bool made = copied.isMade(u, v, picture.width);
        known += made ? 0 : 1;
        missing += made ? 1 : 0;
    });
    return missing > 0 && 8 * known >= side * side;
}

BorderSquare squareAt(const CopiedPixels& copied, const ImageView& picture, int x, int y, int side) {
    BorderSquare square{x, y, Image({side, side}, picture.channels), Image({side, side}, 1)};
    everyPixel(picture.size(), x, y, side, [&](int i, int j, int u, int v) {
        if (copied.isMade(u, v, picture.width))
            return;
        square.counts(i, j, 0) = 1;
        for (int c = 0; c < picture.channels; ++c)
            square.pixels(i, j, c) = picture(u, v, c);
    });
    return square;
}

/// The places of the least distances that are `apart` pixels from each other; the distances there are lost.
std::vector<std::pair<int, int>> leastPlaces(std::vector<float>& distances, Size positions, int best,
                                             int apart) {
    std::vector<std::pair<int, int>> places;
    while (static_cast<int>(places.size()) < best) {
        const auto least = std::min_element(distances.begin(), distances.end());
        if (least == distances.end() || !std::isfinite(*least))
            break;
        const int at = static_cast<int>(least - distances.begin());
        const int x = at % positions.width, y = at / positions.width;
        places.emplace_back(x, y);
        for (int v = std::max(0, y - apart + 1); v < std::min(positions.height, y + apart); ++v)
            for (int u = std::max(0, x - apart + 1); u < std::min(positions.width, x + apart); ++u)
                distances[static_cast<std::size_t>(v) * static_cast<std::size_t>(positions.width) +
                          static_cast<std::size_t>(u)] = std::numeric_limits<float>::infinity();
    }
    return places;
}

} // namespace

std::vector<OffsetProposal> borderOffsets(const CopiedPixels& copied, const ImageView& picture, int side,
                                          int best, JobContext& context) {
    std::vector<BorderSquare> squares;
    const int step = std::max(1, side / 2);
    for (int y = -step; y < picture.height; y += step)
        for (int x = -step; x < picture.width; x += step)
            if (liesOnBorder(copied, picture.size(), x, y, side))
                squares.push_back(squareAt(copied, picture, x, y, side));
    std::vector<OffsetProposal> proposals;
    for (std::size_t e = 0; e < copied.exemplars.size(); ++e) {
        if (copied.exemplars[e].image.size().shorterSide() < side)
            continue;
        context.check();
        const MaskedDistances distances(copied.exemplars[e], side, [&context] { context.check(); });
        std::vector<std::vector<std::pair<int, int>>> places(squares.size());
        context.parallel(0, static_cast<int>(squares.size()), [&](int number) {
            const BorderSquare& square = squares[static_cast<std::size_t>(number)];
            std::vector<float> found;
            distances.compute(square.pixels, square.counts.view().plane(0), found,
                              [&context] { context.check(); });
            distances.balance(found);
            places[static_cast<std::size_t>(number)] =
                leastPlaces(found, distances.positions(), best, std::max(1, side / 4));
        });
        for (std::size_t n = 0; n < squares.size(); ++n)
            for (const auto& [x, y] : places[n])
                proposals.push_back({static_cast<int>(e), x - squares[n].x, y - squares[n].y, squares[n].x,
                                     squares[n].y, side});
    }
    return proposals;
}

std::uint64_t offsetBytes(std::span<const Size> exemplars, int channels, int threads) {
    std::uint64_t most = 0;
    for (const Size& size : exemplars)
        most = std::max(most, MaskedDistances::bytesFor(size, channels) +
                                  static_cast<std::uint64_t>(threads) *
                                      static_cast<std::uint64_t>(size.area()) * 6 * sizeof(float));
    return most + (4U << 20U);
}

} // namespace texloom
