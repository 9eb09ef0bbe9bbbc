#include "core/methods/random_mosaic/layout.h"

#include "core/base/error.h"
#include "core/match/patch_canvas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom::random_mosaic {

namespace {

/// Streams of random numbers, by what they are for.
constexpr std::uint32_t kLengths = 100, kRound = 101, kTurn = 102, kSwap = 103;

/// `length` in `count` parts that differ by 1 at most, the longer first.
std::vector<int> parts(int length, int count) {
    std::vector<int> lengths;
    for (int i = 0; i < count; ++i)
        lengths.push_back(length / count + (i < length % count ? 1 : 0));
    return lengths;
}

/// Fisher and Yates's shuffle, with numbers kept apart by x and n.
template <class T> void shuffle(std::vector<T>& values, const Random& random, int x, std::uint32_t n) {
    for (std::size_t i = values.size(); i > 1; --i)
        std::swap(values[i - 1],
                  values[random.below(static_cast<std::uint32_t>(i), x, static_cast<int>(i), n)]);
}

/// Whether a mask allows every pixel of a rectangle that lies in it.
bool allows(const Exemplar& exemplar, int x, int y, Size size, int margin) {
    if (!exemplar.mask())
        return true;
    const PlaneView mask = exemplar.mask()->view().plane(0);
    for (int v = std::max(0, y - margin); v < std::min(mask.height, y + size.height + margin); ++v)
        for (int u = std::max(0, x - margin); u < std::min(mask.width, x + size.width + margin); ++u)
            if (mask(u, v) == 0)
                return false;
    return true;
}

int inside(int at, int length) {
    return at >= 0 && at < length ? at : mirrored(at, length);
}

} // namespace

int partsOf(int side, int size) {
    return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) / size)));
}

Size pieceSize(Size exemplar, const Settings& settings) {
    return {settings.pieces == Pieces::Rows ? exemplar.width : settings.size,
            settings.pieces == Pieces::Columns ? exemplar.height : settings.size};
}

Axis::Axis(const std::vector<int>& lengths) : m_starts{0} {
    for (const int length : lengths) {
        m_cells.insert(m_cells.end(), static_cast<std::size_t>(length), count());
        m_starts.push_back(m_starts.back() + length);
    }
}

int Axis::longest() const {
    int most = 0;
    for (int cell = 0; cell < count(); ++cell)
        most = std::max(most, length(cell));
    return most;
}

int Axis::shortest() const {
    int least = whole();
    for (int cell = 0; cell < count(); ++cell)
        least = std::min(least, length(cell));
    return least;
}

Layout::Layout(const Request& request, const Settings& settings, int margin, const Random& random)
    : m_sizes(request.exemplarSizes()) {
    const Size exemplar = m_sizes.front(), piece = pieceSize(exemplar, settings);
    const auto axis = [&](int output, int side, int size, int which) {
        const std::int64_t wanted = static_cast<std::int64_t>(output) * partsOf(side, size);
        std::vector<int> lengths = parts(output, static_cast<int>((wanted + side - 1) / side));
        shuffle(lengths, random, which, kLengths);
        return Axis(lengths);
    };
    m_columns = axis(request.size.width, exemplar.width, piece.width, 0);
    m_rows = axis(request.size.height, exemplar.height, piece.height, 1);
    cut(request, settings, {m_columns.longest(), m_rows.longest()}, margin);
    deal(settings.turn && settings.pieces == Pieces::Both, random);
    partNeighbours(request.wrap, random);
}

Layout Layout::identity(const Request& request, const Settings& settings) {
    Layout layout;
    layout.m_sizes = request.exemplarSizes();
    layout.cut(request, settings, {}, 0);
    const Size exemplar = layout.m_sizes.front(), piece = pieceSize(exemplar, settings);
    layout.m_columns = Axis(parts(exemplar.width, partsOf(exemplar.width, piece.width)));
    layout.m_rows = Axis(parts(exemplar.height, partsOf(exemplar.height, piece.height)));
    for (const Piece& one : layout.m_pieces)
        layout.m_tiles.push_back(one.tile);
    return layout;
}

void Layout::cut(const Request& request, const Settings& settings, Size cell, int margin) {
    for (std::size_t e = 0; e < m_sizes.size(); ++e) {
        const Size piece = pieceSize(m_sizes[e], settings);
        const std::vector<int> widths = parts(m_sizes[e].width, partsOf(m_sizes[e].width, piece.width));
        const std::vector<int> heights = parts(m_sizes[e].height, partsOf(m_sizes[e].height, piece.height));
        int y = 0;
        for (const int height : heights) {
            int x = 0;
            for (const int width : widths) {
                const Size used{std::max(width, cell.width), std::max(height, cell.height)};
                if (allows(request.exemplars[e], x, y, used, margin))
                    m_pieces.push_back({{static_cast<int>(e), x, y, 0}, {width, height}});
                x += width;
            }
            y += height;
        }
    }
    if (m_pieces.empty())
        failUsage("The mask leaves no whole piece of {} px to lay; choose smaller pieces or mask less.",
                  settings.size);
}

void Layout::beginRound(const Random& random) {
    std::vector<int> order(m_pieces.size());
    std::iota(order.begin(), order.end(), 0);
    shuffle(order, random, m_round++, kRound);
    for (const int piece : order) {
        const Size size = m_pieces[static_cast<std::size_t>(piece)].size;
        m_left[{size.width, size.height}].push_back(piece);
    }
}

/// The next piece of this round that fits the cell, or one of the sizes that are left most if none does.
int Layout::takePiece(Size cell, const Random& random) {
    if (m_left.empty())
        beginRound(random);
    auto from = m_left.find({cell.width, cell.height});
    if (from == m_left.end())
        from = std::max_element(m_left.begin(), m_left.end(), [](const auto& a, const auto& b) {
            return a.second.size() < b.second.size();
        });
    const int piece = from->second.back();
    from->second.pop_back();
    if (from->second.empty())
        m_left.erase(from);
    return piece;
}

void Layout::deal(bool turn, const Random& random) {
    for (int row = 0; row < m_rows.count(); ++row)
        for (int column = 0; column < m_columns.count(); ++column) {
            const int piece = takePiece({m_columns.length(column), m_rows.length(row)}, random);
            Tile tile = m_pieces[static_cast<std::size_t>(piece)].tile;
            if (turn)
                tile.turn = static_cast<std::uint8_t>(random.below(4, column, row, kTurn));
            m_tiles.push_back(tile);
        }
}

/// Whether the piece in a cell goes on where the one to the left or above ends, as in the exemplar.
bool Layout::continues(int column, int row, Wrap wrap) const {
    const auto follows = [&](int otherColumn, int otherRow, int dx, int dy) {
        const Tile& one = tile(otherColumn, otherRow);
        const Tile& two = tile(column, row);
        return one.exemplar == two.exemplar && one.turn == 0 && two.turn == 0 && one.x + dx == two.x &&
               one.y + dy == two.y;
    };
    const int left = (column + m_columns.count() - 1) % m_columns.count();
    const int above = (row + m_rows.count() - 1) % m_rows.count();
    return ((column > 0 || wrap.x) && follows(left, row, m_columns.length(left), 0)) ||
           ((row > 0 || wrap.y) && follows(column, above, 0, m_rows.length(above)));
}

/// Swaps pieces that lie beside their exemplar's neighbours with others that fit, once for each.
void Layout::partNeighbours(Wrap wrap, const Random& random) {
    const int columns = m_columns.count(), count = static_cast<int>(m_tiles.size());
    const auto conflicts = [&](int cell) {
        const int column = cell % columns, row = cell / columns;
        return (continues(column, row, wrap) ? 1 : 0) +
               (continues((column + 1) % columns, row, wrap) ? 1 : 0) +
               (continues(column, (row + 1) % m_rows.count(), wrap) ? 1 : 0);
    };
    const auto sizeOf = [&](int cell) {
        return Size{m_columns.length(cell % columns), m_rows.length(cell / columns)};
    };
    const auto swap = [&](int a, int b) {
        std::swap(m_tiles[static_cast<std::size_t>(a)], m_tiles[static_cast<std::size_t>(b)]);
    };
    constexpr int kTries = 16;
    for (int cell = 0; cell < count; ++cell)
        for (int n = 0; n < kTries && conflicts(cell) > 0; ++n) {
            const int other =
                static_cast<int>(random.below(static_cast<std::uint32_t>(count), cell, n, kSwap));
            if (other == cell || sizeOf(other) != sizeOf(cell))
                continue;
            const int before = conflicts(cell) + conflicts(other);
            swap(cell, other);
            if (conflicts(cell) + conflicts(other) >= before)
                swap(cell, other);
        }
}

Source Layout::source(int column, int row, int x, int y) const {
    const Tile& from = tile(column, row);
    const Size size = m_sizes[static_cast<std::size_t>(from.exemplar)];
    const int u = (from.turn & Turn::kFlipX) != 0 ? m_columns.length(column) - 1 - x : x;
    const int v = (from.turn & Turn::kFlipY) != 0 ? m_rows.length(row) - 1 - y : y;
    return {static_cast<std::uint16_t>(inside(from.x + u, size.width)),
            static_cast<std::uint16_t>(inside(from.y + v, size.height)),
            static_cast<std::uint16_t>(from.exemplar)};
}

} // namespace texloom::random_mosaic
