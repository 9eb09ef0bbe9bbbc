#pragma once

#include "core/math/matching_pursuit.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// How the atoms of a dictionary are learnt.
enum class DictionaryLearner {
    Ksvd,  ///< all signals are coded, then each atom is made the best for those that use it
    Online ///< signals are coded few at a time, and what is known of all before them moves every atom
};

struct DictionaryOptions {
    int atoms = 384;     ///< N; fewer where there are fewer signals
    int sparsity = 4;    ///< S: atoms of a signal, at most their length
    int iterations = 20; ///< rounds over all signals
    DictionaryLearner learner = DictionaryLearner::Ksvd;
    int draw = 0; ///< of the context's random numbers: dictionaries with different ones are independent
    Pursuit pursuit = Pursuit::Plain; ///< by which uses are counted
};

/// Atoms for sparse codes of signals, and how often signals use them.
struct Dictionary {
    Eigen::MatrixXf atoms;          ///< length × N, each of length 1
    std::vector<std::int64_t> uses; ///< for each atom, the signals that it was learnt from that use it
    std::int64_t signals = 0;       ///< how many it was learnt from
    int count() const { return static_cast<int>(atoms.cols()); }
    int length() const { return static_cast<int>(atoms.rows()); }
    /// The atoms' numbers, those used most first; of equal ones the smaller number first.
    std::vector<int> byUse() const;
};

/// The dictionary that codes signals best with few atoms each (Tartavel, Gousseau & Peyré 2013, eq. 1 and
/// 2): min |P − D W|² with at most S atoms for each signal and |d_n| ≤ 1, approximately, by K-SVD (Aharon,
/// Elad & Bruckstein 2006; atoms by two power iterations each) or online (Mairal, Bach, Ponce & Sapiro 2010).
/// The uses are those of constrainedPursuit() without limits of uses, plain or orthogonal as is asked.
///
/// With K-SVD the error never rises: a signal keeps its code where a new one is worse, and an atom that few
/// use, or that is nearly another one, becomes the worst signal only where that pays.
/// @param signals one per column, as they are: nothing is subtracted. Where all are 0 there is one atom of
/// equal values, which none uses.
/// @param watch told after each round how many there were and the squared error of all signals; the place
/// for progress and previews. @param context its random numbers choose the first atoms.
Dictionary
learnDictionary(const Eigen::MatrixXf& signals, const DictionaryOptions& options, JobContext& context,
                const std::function<void(int rounds, double error, const Eigen::MatrixXf& atoms)>& watch);

/// Bytes that learning takes beyond the signals.
std::uint64_t dictionaryBytes(std::int64_t signals, int length, const DictionaryOptions& options,
                              int threads);

} // namespace texloom
