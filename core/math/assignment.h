#pragma once

#include "core/job/job_context.h"
#include "core/math/assignment_costs.h"
#include "core/math/crowd.h"

#include <limits>
#include <map>
#include <span>
#include <vector>

namespace texloom {

/// How well columns are to be assigned to rows.
struct AssignmentOptions {
    /// The sum of costs is at most this much per row above the minimum; 0 for the minimum itself.
    double epsilon = 0;
    /// ρ of the relaxed assignment: what each row too many, or too few, costs at a column (Gutierrez, thesis
    /// 2020, eq. 3.29). Infinite: there are never too many. If finite, the assignment is found by an auction
    /// with `epsilon`, or a small value for 0.
    double relaxation = std::numeric_limits<double>::infinity();
    /// With a relaxation: starts from the last assignment and its prices. This takes far fewer bids where
    /// costs have changed little, but the sum may exceed the minimum by more than `epsilon` per row.
    bool carryOn = false;
};

/// Assigns one column to each row of a matrix of costs, each column to as many rows as it has places, so that
/// the sum of costs is smallest: the linear assignment problem. The auction algorithm with ε-scaling
/// (Bertsekas 1988), in which rows bid for columns; bids are made in parallel and taken in the order of the
/// rows, so that the number of threads changes nothing. For the exact solution, shortest augmenting paths
/// (Jonker & Volgenant 1987) settle what the auction left open. Prices are kept from one assignment to the
/// next, which takes few bids where costs have changed little.
class Assigner {
public:
    /// @param places of each column, at least 0.
    explicit Assigner(std::vector<int> places);

    /// @param costs whose rows hold all columns where the relaxation is infinite; then there must be a place
    /// for every row. Bounds are replaced by costs where it matters; for the minimum, everywhere.
    /// @return the column of each row.
    std::vector<int> assign(AssignmentCosts& costs, const AssignmentOptions& options, JobContext& context);

private:
    struct Bid {
        int column = -1;
        double price = 0;
    };
    struct Offers; ///< the best two of a row
    void reset(double price);
    void lowerFree(double lowest, double highest);
    void auction(AssignmentCosts& costs, double epsilon, double ceiling, bool stay, JobContext& context);
    void bid(AssignmentCosts& costs, std::span<const int> bidders, double epsilon, double ceiling,
             std::vector<int>& waiting, JobContext& context);
    std::vector<int> releaseAll(int rows);
    std::vector<int> releaseWorse(AssignmentCosts& costs, double epsilon, JobContext& context);
    Offers offersTo(AssignmentCosts& costs, int row, double slack) const;
    bool offers(AssignmentCosts& costs, int row, double limit) const;
    Bid bidOf(AssignmentCosts& costs, int row, double epsilon, double ceiling) const;
    void take(int row, const Bid& bid, double ceiling, std::vector<int>& waiting);
    void refreshPrice(int column);
    void sink(int column);
    void solveExactly(const AssignmentCosts& costs, JobContext& context);
    std::vector<int> push(const AssignmentCosts& costs, std::vector<int> waiting, JobContext& context);
    int freePlace(int column) const;
    const Crowd& crowdOf(int column, const AssignmentCosts& costs);
    void augment(const AssignmentCosts& costs, int row, JobContext& context);
    void release(int row);

    std::vector<int> m_places;
    std::vector<int>
        m_begin; ///< first place of each column, and one behind the last; each column's are a heap by price
    std::vector<double> m_placePrice; ///< of each place
    std::vector<int> m_assigned;      ///< the row of each place, or −1
    std::vector<double> m_price;      ///< the lowest of each column's places
    std::vector<float> m_scanned;     ///< m_price once more, for fast rows
    std::vector<int> m_column;        ///< of each row, or −1
    std::map<int, Crowd> m_crowds;    ///< of columns with many places, by column, while paths are sought
    bool m_warm = false;
};

} // namespace texloom
