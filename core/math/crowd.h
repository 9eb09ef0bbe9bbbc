#pragma once

#include "core/math/assignment_costs.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// The rows that hold a column of many places, seen as one: for every other column, the row among them that
/// would change to it most cheaply. Kept by blocks of about √n places, so that after one row has left and
/// another has come, two blocks are looked at again and not all n rows.
class Crowd {
public:
    /// Fewer places than this are as quickly gone through one by one.
    static constexpr int kLeast = 256;

    /// @param begin the first of the column's `places` in the list given to refresh().
    Crowd(int column, int begin, int places, int columns);

    /// The row at a place, counted in the whole list, is no longer what it was.
    void changed(int place);
    /// Brings changes() and rows() up to date. @param assigned the row of each place, none of them free.
    void refresh(const AssignmentCosts& costs, const std::vector<int>& assigned);

    /// For each column the lowest of cost there minus cost here among the rows, and the row it belongs to: a
    /// whole number, of the same type for the sake of SIMD.
    const double* changes() const { return m_lowest.data(); }
    const double* rows() const { return m_row.data(); }

private:
    std::size_t at(int block) const {
        return static_cast<std::size_t>(block) * static_cast<std::size_t>(m_columns);
    }

    int m_column, m_begin, m_places, m_columns, m_side, m_blocks;
    std::vector<std::uint8_t> m_stale;   ///< by block
    std::vector<double> m_lowest, m_row; ///< of all places, then of each block
};

} // namespace texloom
