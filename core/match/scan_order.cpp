#include "core/match/scan_order.h"

#include <algorithm>

namespace texloom {

namespace {

/// Rows of a band and pixels along a tile: tiles of about a thousand pixels cost little to hand out.
constexpr int kMostRows = 16;
constexpr int kLeastWidth = 16, kMostWidth = 128;

} // namespace

ScanOrder::ScanOrder(Size size, int reach, Wrap wrap) : ScanOrder(size, reach, wrap, {0, size.height}) {}

ScanOrder::ScanOrder(Size size, int reach, Wrap wrap, const Rows& rows)
    : m_size(size), m_rows(rows), m_shift(wrap.x ? reach + 1 : 0),
      m_slant(wrap.x ? 2 * reach + 2 : reach + 1),
      m_tileWidth(std::clamp(size.width / 8, kLeastWidth, kMostWidth)) {
    int high = std::clamp(size.width / (4 * m_slant), 1, kMostRows);
    // The last rows meet the first ones round the border: they wait for all of these, or, where they are so
    // few that some are both, every row for the one before it.
    const bool closes = wrap.y && rows.count + reach > size.height;
    m_awaited = std::min(reach - 1, rows.count - 1) / high;
    m_waiting = closes ? std::max(0, rows.count - reach) / high : rows.count;
    m_inTurn = m_waiting <= m_awaited;
    high = m_inTurn ? 1 : high;
    int tiles = 0;
    for (int row = 0; row < rows.count; row += high) {
        Band& band = m_bands.emplace_back(Band{row, std::min(high, rows.count - row), tiles, 0});
        band.tiles = (slantedLength(band) + m_tileWidth - 1) / m_tileWidth;
        tiles += band.tiles;
    }
}

int ScanOrder::bandOf(int task) const {
    const auto after = std::upper_bound(m_bands.begin(), m_bands.end(), task,
                                        [](int wanted, const Band& band) { return wanted < band.firstTile; });
    return static_cast<int>(after - m_bands.begin()) - 1;
}

std::vector<int> ScanOrder::before(int task) const {
    if (m_inTurn)
        return task > 0 ? std::vector<int>{task - 1} : std::vector<int>{};
    const int number = bandOf(task);
    const Band& band = m_bands[static_cast<std::size_t>(number)];
    const int tile = task - band.firstTile;
    std::vector<int> needed;
    if (tile > 0)
        needed.push_back(task - 1);
    if (number > 0) {
        const Band& above = m_bands[static_cast<std::size_t>(number) - 1];
        const int until = (tile + 1) * m_tileWidth + above.rows * m_slant;
        needed.push_back(above.firstTile + std::min(above.tiles, (until + m_tileWidth - 1) / m_tileWidth) -
                         1);
    }
    if (number >= m_waiting && tile == 0) {
        const Band& first = m_bands[static_cast<std::size_t>(m_awaited)];
        needed.push_back(first.firstTile + first.tiles - 1);
    }
    return needed;
}

void ScanOrder::visit(int task, const Body& body) const {
    const Band& band = m_bands[static_cast<std::size_t>(bandOf(task))];
    const int begin = (task - band.firstTile) * m_tileWidth;
    for (int row = 0; row < band.rows; ++row) {
        const int from = std::max(0, begin - row * m_slant);
        const int to = std::min(m_size.width, begin + m_tileWidth - row * m_slant);
        if (from >= to)
            continue;
        const int y = (m_rows.first + band.firstRow + row) % m_size.height;
        const auto turned = static_cast<std::int64_t>(band.firstRow + row) * m_shift + from;
        const int x = static_cast<int>(turned % m_size.width);
        const int straight = std::min(to - from, m_size.width - x);
        body(y, x, straight);
        if (straight < to - from)
            body(y, 0, to - from - straight);
    }
}

void ScanOrder::run(JobContext& context, const Body& body, const std::function<void(double)>& between,
                    Order order) const {
    const int tasks = m_bands.back().firstTile + m_bands.back().tiles;
    if (order == Order::Raster) {
        for (int row = 0; row < m_rows.count; ++row) {
            const int x = static_cast<int>(static_cast<std::int64_t>(row) * m_shift % m_size.width);
            const int y = (m_rows.first + row) % m_size.height;
            body(y, x, m_size.width - x);
            if (x > 0)
                body(y, 0, x);
            between((row + 1.0) / m_rows.count);
        }
        return;
    }
    context.parallelAfter(
        tasks, [this](int task) { return before(task); }, [&](int task) { visit(task, body); },
        [&](int done) { between(static_cast<double>(done) / tasks); });
}

std::uint64_t ScanOrder::bytesFor(Size size) {
    const ScanOrder narrow(size, 1, {true, true});
    return 4 * 128 *
           static_cast<std::uint64_t>(narrow.m_bands.back().firstTile + narrow.m_bands.back().tiles);
}

} // namespace texloom
