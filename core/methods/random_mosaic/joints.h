#pragma once

#include "core/job/job_context.h"
#include "core/methods/random_mosaic/layout.h"

#include <array>
#include <vector>

namespace texloom::random_mosaic {

/// A cell that has a share in a pixel.
struct Share {
    int column = 0, row = 0;
    int x = 0, y = 0; ///< the pixel as counted from the cell's top left
    float weight = 1;
};

/// Who owns the pixels where neighbouring pieces overlap. Around every border of cells lies a zone that both
/// pieces cover; in it they meet along a cut of least error, or fade into each other. Pieces of a row of
/// cells are joined first, then the rows.
class Joints {
public:
    /// @param overlap width of the zones, at most the shortest side of a cell.
    Joints(const Layout& layout, const Request& request, int overlap);

    /// Finds the cuts, of `part` of the output only where that is less.
    void cut(const Region& part, JobContext& context);

    /// The cell whose pixel is taken along the cuts; before cut(), along the borders of cells.
    Share owner(int x, int y) const;
    /// The up to four cells that fade into each other at a pixel, weights adding to 1. @return how many.
    int shares(int x, int y, std::array<Share, 4>& shares) const;
    float pixel(const Share& share, int channel) const;
    Source source(const Share& share) const {
        return m_layout.source(share.column, share.row, share.x, share.y);
    }

private:
    /// Where an output's place lies along an axis of the layout. Where the output closes, its border lies in
    /// the middle of a piece, so that it is not a joint.
    static int settled(const Axis& axis, bool wraps, int at) {
        return wraps ? (at + axis.length(0) / 2) % axis.whole() : at;
    }
    /// A place along an axis: the cell it belongs to by the borders, and the zone it lies in.
    struct Place {
        int cell = 0, at = 0;                  ///< and how far from the cell's start
        int zone = -1, before = 0, offset = 0; ///< number of the cell after the border, or −1 for none
    };
    Place place(const Axis& axis, bool wraps, int at) const;
    Share ownerInRow(const Place& column, int row, int y) const;
    void cutColumns(int row, const Region& part, JobContext& context);
    void cutRows(int zone, JobContext& context);
    float difference(const Share& a, const Share& b) const;

    const Layout& m_layout;
    const Request& m_request;
    int m_overlap;
    bool m_cut = false;
    /// By row and zone: for each pixel row of the strip, from half an overlap above it, where the piece
    /// begins.
    std::vector<std::vector<int>> m_columnCuts;
    std::vector<std::vector<int>> m_rowCuts; ///< by zone: for each pixel column, where the row begins
};

} // namespace texloom::random_mosaic
