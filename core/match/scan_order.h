#pragma once

#include "core/image/size.h"
#include "core/job/job_context.h"

#include <functional>
#include <vector>

namespace texloom {

/// The pixels of an output row by row, each of which may depend on those that its neighbourhood reaches: the
/// order of methods that make one pixel after another. Rows follow each other as a wavefront on the
/// context's threads, which gives the same bits as one pixel after the other in raster order.
///
/// Where the x axis wraps, the first pixels of a row would wait for the last ones of the row above. So there
/// each row begins reach + 1 pixels further right than the row above, in raster order too.
class ScanOrder {
public:
    /// Whole rows of the output from one on, round the border.
    struct Rows {
        int first = 0, count = 0;
    };
    enum class Order { Wavefront, Raster };
    /// Makes pixels x to x + count − 1 of row y, from left to right; called from several threads.
    using Body = std::function<void(int y, int x, int count)>;

    /// @param reach pixels from the centre of a neighbourhood to its border. @param wrap axes on which
    /// neighbourhoods reach round the border.
    ScanOrder(Size size, int reach, Wrap wrap);
    /// The same for some of the rows; what lies outside of them is only read.
    ScanOrder(Size size, int reach, Wrap wrap, const Rows& rows);

    /// Visits every pixel once. @param between called now and then with the share done, from 0 to 1, while no
    /// body runs: the place for progress() and preview().
    void run(JobContext& context, const Body& body, const std::function<void(double)>& between,
             Order order = Order::Wavefront) const;

    /// Bytes that a run takes.
    static std::uint64_t bytesFor(Size size);

private:
    /// Consecutive rows, cut into tiles that lean to the left, so that a tile waits for no more than the one
    /// before it and one of the band above. Columns are counted from the beginning of the band's first row.
    struct Band {
        int firstRow, rows;
        int firstTile, tiles;
    };
    std::vector<int> before(int task) const;
    int bandOf(int task) const;
    int slantedLength(const Band& band) const { return m_size.width + (band.rows - 1) * m_slant; }
    void visit(int task, const Body& body) const;

    Size m_size;
    Rows m_rows;
    int m_shift;   ///< how much further right a row begins than the one above
    int m_slant;   ///< how much a row lags behind the one above
    bool m_inTurn; ///< every tile waits for the one before it
    int m_waiting; ///< bands from this one on read, round the border, the first ones
    int m_awaited; ///< the last band that these read
    int m_tileWidth;
    std::vector<Band> m_bands;
};

} // namespace texloom
