#pragma once

namespace texloom::random_mosaic {

/// What exemplars are cut into: slices across one axis, pieces across both, or blocks that chaos moves.
enum class Pieces { Columns, Rows, Both, Chaos };

/// How pieces are joined.
enum class Stitch { Poisson, Cut, Feather, None };

/// Parameters of random mosaics (Raad, thesis 2016, section 5.6; chaos: Xu, Guo & Shum 2000).
struct Settings {
    Pieces pieces = Pieces::Both;
    int size = 32; ///< of a piece, in pixels
    Stitch stitch = Stitch::Poisson;
    double reach = 1;      ///< of Poisson's levelling, in pieces' sides; 0: without limit
    double overlap = 0.25; ///< of neighbours, as a share of the piece; for cuts and feathering
    bool turn = false;     ///< flips pieces and turns them by 180° at random
};

} // namespace texloom::random_mosaic
