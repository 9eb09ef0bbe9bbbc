#pragma once

#include "core/job/job_context.h"
#include "core/math/assignment_costs.h"

#include <limits>
#include <span>
#include <vector>

namespace texloom {

/// How well persons are to be assigned.
struct AssignmentOptions {
    /// The sum of costs is at most this much a person above the smallest possible; 0 for the smallest itself.
    double epsilon = 0;
    /// ρ of the relaxed assignment: what each person too many, or too few, costs at an object (Gutierrez,
    /// thesis 2020, eq. 3.29). Infinite: there are never too many. With less an auction with `epsilon`, or a
    /// small one for 0, finds it.
    double relaxation = std::numeric_limits<double>::infinity();
    /// With a relaxation: begins with the last assignment and its prices. Far fewer bids where costs have
    /// changed little, but the sum may then be more than `epsilon` a person above the smallest.
    bool carryOn = false;
};

/// Gives each of many persons one object, each object to as many persons as it has places, for the smallest
/// sum of costs: the linear assignment problem. The auction algorithm with ε-scaling (Bertsekas 1988), whose
/// bids are made in parallel and taken in order of the persons, so that threads change nothing; for the exact
/// solution shortest augmenting paths (Jonker & Volgenant 1987) mend what the auction left. Prices are kept
/// from one assignment to the next, where costs that changed little need few bids.
class Assigner {
public:
    /// @param places of each object, at least 0.
    explicit Assigner(std::vector<int> places);

    /// @param costs whose rows hold all objects where the relaxation is infinite; then there must be a place
    /// for everybody. Bounds give way to costs where it matters, for the smallest sum everywhere.
    /// @return the object of each person.
    std::vector<int> assign(AssignmentCosts& costs, const AssignmentOptions& options, JobContext& context);

private:
    struct Bid {
        int object = -1;
        double price = 0;
    };
    struct Offers; ///< the best two of a row
    void reset(double price);
    void lowerFree(double lowest, double highest);
    void auction(AssignmentCosts& costs, double epsilon, double ceiling, bool stay, JobContext& context);
    void bid(AssignmentCosts& costs, std::span<const int> bidders, double epsilon, double ceiling,
             std::vector<int>& waiting, JobContext& context);
    std::vector<int> everybody(int persons);
    std::vector<int> discontented(AssignmentCosts& costs, double epsilon, JobContext& context);
    Offers offersTo(AssignmentCosts& costs, int person, double slack) const;
    bool offers(AssignmentCosts& costs, int person, double limit) const;
    Bid bidOf(AssignmentCosts& costs, int person, double epsilon, double ceiling) const;
    void take(int person, const Bid& bid, double ceiling, std::vector<int>& waiting);
    void refreshPrice(int object);
    void sink(int object);
    void solveExactly(const AssignmentCosts& costs, JobContext& context);
    std::vector<int> push(const AssignmentCosts& costs, std::vector<int> waiting, JobContext& context);
    int freePlace(int object) const;
    void augment(const AssignmentCosts& costs, int person, JobContext& context);
    void release(int person);

    std::vector<int> m_places;
    std::vector<int>
        m_begin; ///< first place of each object, and one behind the last; each object's are a heap by price
    std::vector<double> m_placePrice; ///< of each place
    std::vector<int> m_holder;        ///< of each place, or −1
    std::vector<double> m_price;      ///< the lowest of each object's places
    std::vector<double> m_second;     ///< the second lowest
    std::vector<float> m_scanned;     ///< m_price once more, for fast rows
    std::vector<int> m_object;        ///< of each person, or −1
    bool m_warm = false;
};

} // namespace texloom
