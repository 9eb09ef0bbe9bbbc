#pragma once

namespace texloom::wang_tiles {

/// What has colours that must match: the edges of tiles (Cohen et al. 2003), or their corners, which tiles
/// share with those across the corner, too, so that no sample ends there (Ng, Wen, Tan, Zhang & Kim 2005;
/// Lagae & Dutré 2006).
enum class Match { Corners, Edges };

/// Which tiles there are: one for every combination of colours, or two for each way in which a tile can be
/// begun from the left and above, which is the least that does not repeat itself.
enum class Set { Full, Compact };

/// Parameters of Wang tiles (Cohen, Shade, Hiller & Deussen 2003).
struct Settings {
    Match match = Match::Corners;
    int colours = 2; ///< of corners, or of edges on each axis
    int tile = 64;   ///< side of a tile in pixels
    /// Width over the side of the zone in which cuts may run: along a tile's diagonals, or across its edges.
    double overlap = 0.25;
    int tries = 100;         ///< how often samples are drawn, at most
    double threshold = 0.05; ///< the worst cut's error that is good enough, over that of unlike pixels
    Set set = Set::Full;
};

} // namespace texloom::wang_tiles
