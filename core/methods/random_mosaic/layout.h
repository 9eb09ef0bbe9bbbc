#pragma once

#include "core/image/position_map.h"
#include "core/job/random.h"
#include "core/methods/random_mosaic/settings.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace texloom::random_mosaic {

/// How a piece is laid: as it is, or mirrored left to right, upside down, or both, which turns it by 180°.
struct Turn {
    static constexpr std::uint8_t kFlipX = 1, kFlipY = 2;
};

/// A piece in a cell of the output: the exemplar's pixel (x, y) is its top left as it lies there unturned.
struct Tile {
    int exemplar = 0, x = 0, y = 0;
    std::uint8_t turn = 0;
};

/// The cells of the output along one axis.
class Axis {
public:
    Axis() = default;
    explicit Axis(const std::vector<int>& lengths);

    int count() const { return static_cast<int>(m_starts.size()) - 1; }
    int start(int cell) const { return m_starts[static_cast<std::size_t>(cell)]; }
    int length(int cell) const { return start(cell + 1) - start(cell); }
    int whole() const { return m_starts.back(); }
    int shortest() const;
    int longest() const;
    /// The cell that a place lies in.
    int cellOf(int at) const { return m_cells[static_cast<std::size_t>(at)]; }

private:
    std::vector<int> m_starts, m_cells;
};

/// Which piece lies in which cell of the output.
class Layout {
public:
    /// Draws one: every exemplar is cut into pieces that differ by a pixel at most, and the output into cells
    /// alike; pieces are taken in rounds, each a fresh permutation of all, so that uses differ by one at
    /// most. Where output and exemplar have one size, each piece is used once and fits its cell.
    /// @param margin pixels around a piece that may be used too, which masks must allow.
    /// @throws UsageError if the masks leave no piece.
    Layout(const Request& request, const Settings& settings, int margin, const Random& random);
    /// Every piece of an exemplar in its place.
    static Layout identity(const Request& request, const Settings& settings);

    const Axis& columns() const { return m_columns; }
    const Axis& rows() const { return m_rows; }
    const Tile& tile(int column, int row) const { return m_tiles[index(column, row)]; }
    /// Pieces that the exemplars were cut into.
    int pieces() const { return static_cast<int>(m_pieces.size()); }
    /// Where pixel (x, y) of a cell comes from, counted from the cell's top left; what lies outside is the
    /// piece's surrounding in its exemplar, mirrored at the exemplar's borders.
    Source source(int column, int row, int x, int y) const;

private:
    struct Piece {
        Tile tile;
        Size size;
    };
    Layout() = default;
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns.count()) +
               static_cast<std::size_t>(column);
    }
    void cut(const Request& request, const Settings& settings, Size cell, int margin);
    void deal(bool turn, const Random& random);
    void beginRound(const Random& random);
    int takePiece(Size cell, const Random& random);
    bool continues(int column, int row, Wrap wrap) const;
    void partNeighbours(Wrap wrap, const Random& random);

    std::vector<Size> m_sizes;
    std::vector<Piece> m_pieces;
    Axis m_columns, m_rows;
    std::vector<Tile> m_tiles;
    /// Pieces of this round that are not laid yet, by size, the next one last.
    std::map<std::pair<int, int>, std::vector<int>> m_left;
    int m_round = 0;
};

/// How many parts an exemplar's side is cut into.
int partsOf(int side, int size);

/// Sides of cells: columns span the exemplar's height, rows its width.
Size pieceSize(Size exemplar, const Settings& settings);

} // namespace texloom::random_mosaic
