#include "core/methods/wang_tiles/tile_colours.h"

#include "core/base/at.h"

namespace texloom::wang_tiles {

namespace {

/// All combinations of corner colours, so that neighbours share corners. In each column of corners there are
/// all pairs of colours one below the other once, and the column after it is the same, moved up by one more
/// row than the one before was; so no two columns of tiles join pairs alike.
std::vector<Colours> fullCorners(int k) {
    const int count = k * k;
    std::vector<int> pairs(at(count));
    for (int a = 0; a < k; ++a)
        for (int b = 0; b < k; ++b)
            pairs[at(sheetPlace(a, b))] = a;
    const auto corner = [&](int column, int row) {
        return pairs[at((row + column * (column - 1) / 2) % count)];
    };
    std::vector<Colours> all;
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column)
            all.push_back({corner(column, row), corner(column + 1, row), corner(column + 1, row + 1),
                           corner(column, row + 1)});
    return all;
}

std::vector<Colours> compactCorners(int k) {
    std::vector<Colours> all;
    for (int northWest = 0; northWest < k; ++northWest)
        for (int northEast = 0; northEast < k; ++northEast)
            for (int southWest = 0; southWest < k; ++southWest)
                for (int choice = 0; choice < 2; ++choice)
                    all.push_back({northWest, northEast,
                                   compactCorner(k, northWest, northEast, southWest, choice), southWest});
    return all;
}

std::vector<Colours> fullEdges(int k) {
    const int pairs = k * k;
    std::vector<Colours> all(at(pairs * pairs));
    for (int north = 0; north < k; ++north)
        for (int south = 0; south < k; ++south)
            for (int west = 0; west < k; ++west)
                for (int east = 0; east < k; ++east)
                    all[at(sheetPlace(north, south) * pairs + sheetPlace(west, east))] = {north, east, south,
                                                                                          west};
    return all;
}

std::vector<Colours> compactEdges(int k) {
    std::vector<Colours> all;
    for (int north = 0; north < k; ++north)
        for (int west = 0; west < k; ++west) {
            all.push_back({north, north, (west + 1) % k, west});
            all.push_back({north, (north + 1) % k, west, west});
        }
    return all;
}

} // namespace

int sheetPlace(int first, int second) {
    if (first == 0 && second == 0)
        return 0;
    if (first == second)
        return (first + 1) * (first + 1) - 2;
    if (second > first)
        return 2 * first + second * second;
    return second > 0 ? first * first + 2 * second - 1 : (first + 1) * (first + 1) - 1;
}

int compactCorner(int colours, int northWest, int northEast, int southWest, int choice) {
    return (northEast + southWest + colours - northWest + choice) % colours;
}

int tilesInRow(const Settings& settings) {
    return settings.set == Set::Full ? settings.colours * settings.colours : 2 * settings.colours;
}

std::vector<Colours> coloursOf(const Settings& settings) {
    const bool full = settings.set == Set::Full;
    if (settings.match == Match::Corners)
        return full ? fullCorners(settings.colours) : compactCorners(settings.colours);
    return full ? fullEdges(settings.colours) : compactEdges(settings.colours);
}

} // namespace texloom::wang_tiles
