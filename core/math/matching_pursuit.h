#pragma once

#include "core/job/job_context.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// Signals in columns of `length` values, made where they are needed, so that they need not all be kept.
struct SignalSource {
    int length = 0;
    int count = 0;
    /// Writes the signals [first, first + columns of `to`); may be called from several threads.
    std::function<void(int first, Eigen::Ref<Eigen::MatrixXf> to)> read;

    /// The columns of a matrix that outlives it.
    static SignalSource of(const Eigen::MatrixXf& columns);
};

/// For each of many signals a few atoms of a dictionary with their weights: the sparse matrix W (atoms ×
/// signals) of p ≈ D w, column by column.
class SparseCode {
public:
    /// @param most atoms of a signal.
    SparseCode(int signals, int most);

    int signals() const { return static_cast<int>(m_counts.size()); }
    int most() const { return m_most; }
    std::span<const int> atoms(int signal) const { return {m_atoms.data() + at(signal), countOf(signal)}; }
    std::span<const float> weights(int signal) const {
        return {m_weights.data() + at(signal), countOf(signal)};
    }
    std::span<float> weights(int signal) { return {m_weights.data() + at(signal), countOf(signal)}; }
    void clear(int signal) { m_counts[static_cast<std::size_t>(signal)] = 0; }
    /// Adds to an atom's weight; the signal has room for the atom, or has it already.
    /// @return whether the atom is new to the signal.
    bool add(int signal, int atom, float weight);
    bool uses(int signal, int atom) const;
    /// How many signals use each of `atoms` atoms.
    std::vector<int> uses(int atoms) const;
    /// The signal that the code stands for: D w.
    void combine(const Eigen::MatrixXf& dictionary, int signal, Eigen::Ref<Eigen::VectorXf> to) const;

    static std::uint64_t bytesFor(std::int64_t signals, int most) {
        return static_cast<std::uint64_t>(signals) * (8 * static_cast<std::uint64_t>(most) + 4);
    }

private:
    std::size_t at(int signal) const {
        return static_cast<std::size_t>(signal) * static_cast<std::size_t>(m_most);
    }
    std::size_t countOf(int signal) const {
        return static_cast<std::size_t>(m_counts[static_cast<std::size_t>(signal)]);
    }

    int m_most;
    std::vector<int> m_counts;
    std::vector<int> m_atoms;
    std::vector<float> m_weights;
};

/// The products of all atoms with all signals, DᵀP: atoms × signals. @param dictionary length × atoms.
Eigen::MatrixXf correlations(const Eigen::MatrixXf& dictionary, const SignalSource& signals,
                             JobContext& context);

/// Orthogonal matching pursuit of each signal by itself, through the Gram matrix of the dictionary with a
/// Cholesky factor that grows atom by atom (Rubinstein, Zibulevsky & Elad 2008). Ends early where the
/// remainder is orthogonal to every atom, or where an atom depends on those already chosen.
/// @param dictionary length × atoms, each of length 1. @param most atoms of a signal, at most `length`.
SparseCode orthogonalPursuit(const Eigen::MatrixXf& dictionary, const SignalSource& signals, int most,
                             JobContext& context);

/// What a step does with the weights of a signal's atoms: it adds to one of them, or finds all of them anew
/// by least squares, so that the remainder is orthogonal to every atom chosen.
enum class Pursuit { Plain, Orthogonal };

/// How often atoms may be used, and how signals are coded with them.
struct PursuitLimits {
    int most = 4; ///< atoms of one signal: S
    /// Signals that may use each atom: F₀. Empty: any number.
    std::vector<int> uses = {};
    Pursuit pursuit = Pursuit::Plain;
};

/// Constrained matching pursuit of all signals together (Tartavel, Gousseau & Peyré 2013, algorithm 2): at
/// most S × signals times the pair (k, n) with the largest |⟨r_k, d_n⟩| gets that product added to its
/// weight, of the pairs that are still available. The set printed below eq. 10 has k' for k in its first
/// sum; here (k, n) is available iff Σ_{n' ≠ n} [w_k^{n'} ≠ 0] < S and Σ_{k' ≠ k} [w_{k'}^n ≠ 0] < F₀^n, so
/// that a pair in use stays available. Ends where the largest product is below 10⁻⁶ of the first. Of equal
/// products the smallest k, then n, goes first. Orthogonal, a pair is chosen once at most, and a signal ends
/// early where an atom depends on those that it has.
///
/// Products are updated through the Gram matrix, and a heap holds the best pair of each signal: O(KN(L + log
/// K)) for K signals of length L and N atoms.
SparseCode constrainedPursuit(const Eigen::MatrixXf& dictionary, const SignalSource& signals,
                              const PursuitLimits& limits, JobContext& context);

/// Whole numbers near `shares` with the sum that is nearest to theirs (largest remainder; of equal
/// remainders the first). Shares of 0 stay 0.
std::vector<int> roundedShares(std::span<const double> shares);

/// Bytes that constrainedPursuit() takes, its result included.
std::uint64_t pursuitBytes(std::int64_t signals, int length, int atoms, int most, int threads);

} // namespace texloom
