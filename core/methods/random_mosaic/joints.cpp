#include "core/methods/random_mosaic/joints.h"

#include "core/match/error_path.h"

#include <algorithm>

namespace texloom::random_mosaic {

Joints::Joints(const Layout& layout, const Request& request, int overlap)
    : m_layout(layout), m_request(request), m_overlap(overlap),
      m_columnCuts(static_cast<std::size_t>(layout.rows().count()) *
                   static_cast<std::size_t>(layout.columns().count())),
      m_rowCuts(static_cast<std::size_t>(layout.rows().count())) {}

Joints::Place Joints::place(const Axis& axis, bool wraps, int at) const {
    Place place;
    const int within = settled(axis, wraps, at);
    place.cell = axis.cellOf(within);
    place.at = within - axis.start(place.cell);
    const int above = m_overlap / 2, below = m_overlap - above, length = axis.length(place.cell);
    const bool first = place.cell == 0, last = place.cell + 1 == axis.count();
    if (place.at < below && (!first || wraps)) {
        place.zone = place.cell;
        place.offset = place.at + above;
    } else if (length - place.at <= above && (!last || wraps)) {
        place.zone = last ? 0 : place.cell + 1;
        place.offset = place.at - length + above;
    }
    if (place.zone >= 0)
        place.before = (place.zone + axis.count() - 1) % axis.count();
    return place;
}

/// The owner within a row of cells. @param y from the row's start.
Share Joints::ownerInRow(const Place& column, int row, int y) const {
    if (!m_cut || column.zone < 0)
        return {column.cell, row, column.at, y, 1};
    const auto cut = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_layout.columns().count()) +
                     static_cast<std::size_t>(column.zone);
    const int start = column.offset - m_overlap / 2, along = y + m_overlap / 2;
    if (column.offset >= m_columnCuts[cut][static_cast<std::size_t>(along)])
        return {column.zone, row, start, y, 1};
    return {column.before, row, m_layout.columns().length(column.before) + start, y, 1};
}

Share Joints::owner(int x, int y) const {
    const Place column = place(m_layout.columns(), m_request.wrap.x, x);
    const Place row = place(m_layout.rows(), m_request.wrap.y, y);
    if (!m_cut || row.zone < 0)
        return ownerInRow(column, row.cell, row.at);
    const bool after =
        row.offset >= m_rowCuts[static_cast<std::size_t>(row.zone)][static_cast<std::size_t>(x)];
    const int start = row.offset - m_overlap / 2;
    return after ? ownerInRow(column, row.zone, start)
                 : ownerInRow(column, row.before, m_layout.rows().length(row.before) + start);
}

int Joints::shares(int x, int y, std::array<Share, 4>& shares) const {
    struct Part {
        int cell = 0, at = 0;
        float weight = 1;
    };
    const auto partsAlong = [this](const Axis& axis, const Place& place, std::array<Part, 2>& parts) {
        if (place.zone < 0) {
            parts[0] = {place.cell, place.at, 1};
            return 1;
        }
        const int start = place.offset - m_overlap / 2;
        const float share = (static_cast<float>(place.offset) + 1) / (static_cast<float>(m_overlap) + 1);
        parts[0] = {place.before, axis.length(place.before) + start, 1 - share};
        parts[1] = {place.zone, start, share};
        return 2;
    };
    std::array<Part, 2> across, down;
    const int columns =
        partsAlong(m_layout.columns(), place(m_layout.columns(), m_request.wrap.x, x), across);
    const int rows = partsAlong(m_layout.rows(), place(m_layout.rows(), m_request.wrap.y, y), down);
    int count = 0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Part &column = across[static_cast<std::size_t>(i)],
                       &row = down[static_cast<std::size_t>(j)];
            shares[static_cast<std::size_t>(count++)] = {column.cell, row.cell, column.at, row.at,
                                                         column.weight * row.weight};
        }
    return count;
}

float Joints::pixel(const Share& share, int channel) const {
    const Source from = source(share);
    return (*m_request.exemplars[from.exemplar].image)(from.x, from.y, channel);
}

float Joints::difference(const Share& a, const Share& b) const {
    const Source one = source(a), two = source(b);
    const Image &first = *m_request.exemplars[one.exemplar].image,
                &second = *m_request.exemplars[two.exemplar].image;
    float sum = 0;
    for (int c = 0; c < first.channels(); ++c) {
        const float difference = first(one.x, one.y, c) - second(two.x, two.y, c);
        sum += difference * difference;
    }
    return sum;
}

void Joints::cutColumns(int row, const Region& part, JobContext& context) {
    const Axis& columns = m_layout.columns();
    const int length = m_layout.rows().length(row) + m_overlap;
    for (int zone = m_request.wrap.x ? 0 : 1; zone < columns.count(); ++zone) {
        const int before = (zone + columns.count() - 1) % columns.count();
        // Rows of cells meet along cuts over the full width, which need all pieces of both; a part within one
        // row of cells does not.
        const bool wanted =
            m_layout.rows().count() > 1 || m_request.wrap.x || m_request.wrap.y ||
            (columns.start(zone) + m_overlap >= part.x && columns.start(zone) - m_overlap < part.right());
        if (!wanted)
            continue;
        m_columnCuts[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns.count()) +
                     static_cast<std::size_t>(zone)] =
            leastErrorPath(
                length, m_overlap,
                [&](int along, float* errors) {
                    const int y = along - m_overlap / 2;
                    for (int i = 0; i < m_overlap; ++i) {
                        const int start = i - m_overlap / 2;
                        errors[i] = difference({before, row, columns.length(before) + start, y, 1},
                                               {zone, row, start, y, 1});
                    }
                },
                false, [&] { context.check(); });
    }
}

void Joints::cutRows(int zone, JobContext& context) {
    const Axis& rows = m_layout.rows();
    const int before = (zone + rows.count() - 1) % rows.count();
    m_rowCuts[static_cast<std::size_t>(zone)] = leastErrorPath(
        m_layout.columns().whole(), m_overlap,
        [&](int x, float* errors) {
            const Place column = place(m_layout.columns(), m_request.wrap.x, x);
            for (int i = 0; i < m_overlap; ++i) {
                const int start = i - m_overlap / 2;
                errors[i] = difference(ownerInRow(column, before, rows.length(before) + start),
                                       ownerInRow(column, zone, start));
            }
        },
        m_request.wrap.x, [&] { context.check(); });
}

void Joints::cut(const Region& part, JobContext& context) {
    const Axis& rows = m_layout.rows();
    const int count = rows.count();
    m_cut = m_overlap > 0;
    if (!m_cut)
        return;
    std::vector<char> needed(static_cast<std::size_t>(count), 0);
    for (int y = part.y; y < part.bottom(); ++y) {
        const Place row = place(rows, m_request.wrap.y, y);
        needed[static_cast<std::size_t>(row.cell)] = 1;
        if (row.zone >= 0)
            needed[static_cast<std::size_t>(row.zone)] = needed[static_cast<std::size_t>(row.before)] = 1;
    }
    context.parallel(0, count, [&](int row) {
        if (needed[static_cast<std::size_t>(row)] != 0)
            cutColumns(row, part, context);
    });
    context.parallel(m_request.wrap.y ? 0 : 1, count, [&](int zone) {
        const int before = (zone + count - 1) % count;
        if (needed[static_cast<std::size_t>(zone)] != 0 && needed[static_cast<std::size_t>(before)] != 0)
            cutRows(zone, context);
    });
}

} // namespace texloom::random_mosaic
