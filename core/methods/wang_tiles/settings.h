#pragma once

namespace texloom::wang_tiles {

/// Which tiles there are: one for every combination of edge colours, or two for each of the colours above and
/// to the left, which is the least that does not repeat itself.
enum class Set { Full, Compact };

/// Parameters of Wang tiles (Cohen, Shade, Hiller & Deussen 2003).
struct Settings {
    int colours = 2; ///< of edges, on each axis
    int tile = 64;   ///< side of a tile in pixels
    double overlap =
        0.25;        ///< width of the zone along a tile's diagonals in which cuts may run, over the side
    int tries = 100; ///< how often samples are drawn, at most
    double threshold = 0.05; ///< the worst cut's error that is good enough, over that of unlike pixels
    Set set = Set::Full;
};

} // namespace texloom::wang_tiles
