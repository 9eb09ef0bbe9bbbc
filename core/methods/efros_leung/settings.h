#pragma once

namespace texloom::efros_leung {

/// In which order pixels are made: those with the most known neighbours first, layer by layer, or in rows.
enum class Order { Onion, Raster };
/// How the windows are found that fit.
enum class Search { Exact, Pca };

/// Parameters of the pixel growing of Efros & Leung (ICCV 1999).
struct Settings {
    int window = 21; ///< side n in pixels; an even one counts as the next odd. The source uses 11 to 25;
                     ///< 11 grows garbage from most photos
    double tolerance = 0.1; ///< ε: a window up to (1 + ε) times as far as the nearest may be drawn
    double sigma = 0.156;   ///< of the Gaussian weights, as a share of the window: the source has 1 / 6.4
    int seedSize = 3;       ///< side of the square that growth begins with
    Order order = Order::Onion;
    Search search = Search::Exact;
    int components = 20; ///< principal axes on which windows are compared first
    int radius =
        0; ///< in exemplars of the output's size, how far a window may lie from the pixel; 0: anywhere
};

} // namespace texloom::efros_leung
