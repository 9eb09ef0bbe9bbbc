#include "core/math/matching_pursuit.h"

#include "core/base/at.h"
#include "core/base/wide_vectors.h"

#include <queue>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom {

namespace {

/// Signals whose products are made at a time: enough for the product to be fast, few enough to be cancelled.
constexpr int kBlock = 64;
/// Products below this share of the largest first one count as none.
constexpr float kNothing = 1e-6F;
/// An atom whose part orthogonal to those chosen is shorter than this depends on them.
constexpr double kDependent = 1e-5;
/// Steps of the pursuit between two moments to be cancelled in.
constexpr int kStepsBetweenChecks = 4096;

/// row −= step × gram.
TEXLOOM_WIDE_VECTORS void subtractTimes(float* row, const float* gram, float step, int count) {
    for (int n = 0; n < count; ++n)
        row[n] -= step * gram[n];
}

/// The largest |row| of the atoms that are open (1, the others 0).
TEXLOOM_WIDE_VECTORS float largestOf(const float* row, const float* open, int count) {
    float largest = 0;
    for (int n = 0; n < count; ++n) {
        const float size = std::fabs(row[n]) * open[n];
        largest = size > largest ? size : largest;
    }
    return largest;
}

/// One signal's orthogonal matching pursuit.
class Orthogonal {
public:
    Orthogonal(const Eigen::MatrixXf& gram, int most)
        : m_gram(gram), m_most(most), m_factor(most, most), m_right(most), m_weights(most) {}

    /// @param first the products of the atoms with the signal. The code of `signal` is to be empty.
    void run(Eigen::Ref<Eigen::VectorXf> first, int signal, SparseCode& code) {
        m_chosen.clear();
        m_start = first;
        float largest = 0;
        while (static_cast<int>(m_chosen.size()) < m_most) {
            Eigen::Index best = 0;
            const float product = first.cwiseAbs().maxCoeff(&best);
            largest = std::max(largest, product);
            if (product <= kNothing * largest || !choose(static_cast<int>(best)))
                break;
            first = m_start;
            for (std::size_t i = 0; i < m_chosen.size(); ++i)
                first -=
                    static_cast<float>(m_weights[static_cast<Eigen::Index>(i)]) * m_gram.col(m_chosen[i]);
        }
        for (std::size_t i = 0; i < m_chosen.size(); ++i)
            code.add(signal, m_chosen[i], static_cast<float>(m_weights[static_cast<Eigen::Index>(i)]));
    }

private:
    /// Takes an atom in and solves for all weights. @return false if it depends on those there are.
    bool choose(int atom) {
        const auto count = static_cast<Eigen::Index>(m_chosen.size());
        if (std::find(m_chosen.begin(), m_chosen.end(), atom) != m_chosen.end())
            return false;
        Eigen::VectorXd below(count);
        for (Eigen::Index i = 0; i < count; ++i)
            below[i] = static_cast<double>(m_gram(m_chosen[static_cast<std::size_t>(i)], atom));
        m_factor.topLeftCorner(count, count).triangularView<Eigen::Lower>().solveInPlace(below);
        const double rest = static_cast<double>(m_gram(atom, atom)) - below.squaredNorm();
        if (rest < kDependent)
            return false;
        m_factor.row(count).head(count) = below.transpose();
        m_factor(count, count) = std::sqrt(rest);
        m_right[count] = static_cast<double>(m_start[atom]);
        m_chosen.push_back(atom);
        const auto factor = m_factor.topLeftCorner(count + 1, count + 1);
        m_weights.head(count + 1) = m_right.head(count + 1);
        factor.triangularView<Eigen::Lower>().solveInPlace(m_weights.head(count + 1));
        factor.transpose().triangularView<Eigen::Upper>().solveInPlace(m_weights.head(count + 1));
        return true;
    }

    const Eigen::MatrixXf& m_gram;
    int m_most;
    Eigen::MatrixXd m_factor;
    Eigen::VectorXd m_right, m_weights;
    Eigen::VectorXf m_start;
    std::vector<int> m_chosen;
};

/// The serial part of the constrained pursuit: the products, the limits, and the heap.
class Constrained {
public:
    Constrained(const Eigen::MatrixXf& gram, Eigen::MatrixXf& products, const PursuitLimits& limits)
        : m_gram(gram), m_products(products), m_atoms(static_cast<int>(gram.cols())),
          m_code(static_cast<int>(products.cols()), limits.most), m_left(limits.uses),
          m_open(at(m_atoms), 1.0F), m_best(at(m_code.signals())),
          m_orthogonal(limits.pursuit == Pursuit::Orthogonal) {
        for (int n = 0; n < m_atoms && !m_left.empty(); ++n)
            m_open[at(n)] = m_left[at(n)] > 0 ? 1.0F : 0.0F;
    }

    /// Finds the best atom of a signal; those of different signals may be found at the same time.
    void measure(int signal) {
        const float* row = m_products.col(signal).data();
        const bool full = static_cast<int>(m_code.atoms(signal).size()) == m_code.most();
        Best best;
        if (!full) {
            const float largest = largestOf(row, m_open.data(), m_atoms);
            best = {largest, largest > 0 ? findOpen(row, largest) : -1};
            if (m_orthogonal && best.atom >= 0 && m_code.uses(signal, best.atom))
                best = {}; // nothing is left but rounding
        }
        for (const int atom : m_code.atoms(signal)) {
            if (m_orthogonal)
                break; // the remainder is orthogonal to it
            const float size = std::fabs(row[atom]);
            if (size > best.size || (size == best.size && size > 0 && atom < best.atom))
                best = {size, atom};
        }
        m_best[at(signal)] = best;
    }

    SparseCode run(const JobContext& context) {
        fill(context);
        const std::int64_t steps = static_cast<std::int64_t>(m_code.most()) * m_code.signals();
        std::int64_t made = 0, looked = 0;
        while (!m_heap.empty() && made < steps) {
            if (++looked % kStepsBetweenChecks == 0)
                context.check();
            const Entry top = m_heap.top();
            m_heap.pop();
            if (top.size <= m_least)
                break;
            if (available(top.signal, m_best[at(top.signal)].atom)) {
                ++made;
                if (!(m_orthogonal ? stepOrthogonally(top.signal) : step(top.signal)))
                    continue;
            }
            measure(top.signal);
            push(top.signal);
        }
        return std::move(m_code);
    }

private:
    struct Best {
        float size = 0;
        int atom = -1;
    };
    /// There is one for each signal that has a pair left. Its size may be too large once atoms were closed,
    /// never too small.
    struct Entry {
        float size;
        int signal;
        bool operator<(const Entry& other) const {
            return size < other.size || (size == other.size && signal > other.signal);
        }
    };

    int findOpen(const float* row, float size) const {
        for (int n = 0; n < m_atoms; ++n)
            if (std::fabs(row[n]) == size && m_open[at(n)] > 0)
                return n;
        return -1;
    }

    void push(int signal) {
        if (m_best[at(signal)].atom >= 0)
            m_heap.push({m_best[at(signal)].size, signal});
    }

    void fill(const JobContext& context) {
        std::vector<Entry> entries;
        entries.reserve(at(m_code.signals()));
        for (int k = 0; k < m_code.signals(); ++k)
            if (m_best[at(k)].atom >= 0)
                entries.push_back({m_best[at(k)].size, k});
        context.check();
        m_heap = std::priority_queue<Entry>(std::less<Entry>{}, std::move(entries));
        m_least = m_heap.empty() ? 0 : kNothing * m_heap.top().size;
    }

    bool available(int signal, int atom) const { return m_open[at(atom)] > 0 || m_code.uses(signal, atom); }

    void use(int signal, int atom, float weight) {
        if (m_code.add(signal, atom, weight) && !m_left.empty() && --m_left[at(atom)] == 0)
            m_open[at(atom)] = 0;
    }

    /// @return whether the signal may go on.
    bool step(int signal) {
        const int atom = m_best[at(signal)].atom;
        float* row = m_products.col(signal).data();
        const float weight = row[atom];
        use(signal, atom, weight);
        subtractTimes(row, m_gram.col(atom).data(), weight, m_atoms);
        return true;
    }

    /// The same with all weights by least squares: G w = products of the atoms with the signal itself.
    bool stepOrthogonally(int signal) {
        const std::span<const int> before = m_code.atoms(signal);
        std::vector<int> chosen(before.begin(), before.end());
        std::vector<float> old(m_code.weights(signal).begin(), m_code.weights(signal).end());
        chosen.push_back(m_best[at(signal)].atom);
        old.push_back(0);
        float* row = m_products.col(signal).data();
        const int count = static_cast<int>(chosen.size());
        Eigen::MatrixXd gram(count, count);
        Eigen::VectorXd right(count);
        for (int i = 0; i < count; ++i) {
            right[i] = static_cast<double>(row[chosen[at(i)]]);
            for (int j = 0; j < count; ++j) {
                gram(i, j) = static_cast<double>(m_gram(chosen[at(i)], chosen[at(j)]));
                right[i] += gram(i, j) * static_cast<double>(old[at(j)]);
            }
        }
        const Eigen::LLT<Eigen::MatrixXd> factor(gram);
        const double rest = factor.matrixLLT()(count - 1, count - 1);
        if (factor.info() != Eigen::Success || rest * rest < kDependent)
            return false;
        const Eigen::VectorXd weights = factor.solve(right);
        use(signal, chosen.back(), 0);
        for (int i = 0; i < count; ++i) {
            const auto weight = static_cast<float>(weights[i]);
            m_code.weights(signal)[at(i)] = weight;
            subtractTimes(row, m_gram.col(chosen[at(i)]).data(), weight - old[at(i)], m_atoms);
        }
        return true;
    }

    const Eigen::MatrixXf& m_gram;
    Eigen::MatrixXf& m_products;
    int m_atoms;
    SparseCode m_code;
    std::vector<int> m_left;   ///< uses of each atom that are left
    std::vector<float> m_open; ///< 1 for atoms that more signals may use, else 0
    std::vector<Best> m_best;
    std::priority_queue<Entry> m_heap;
    float m_least = 0;
    bool m_orthogonal;
};

int blocksOf(int count) {
    return (count + kBlock - 1) / kBlock;
}

/// DᵀD: half of it is computed, the rest is its mirror image.
Eigen::MatrixXf gramOf(const Eigen::MatrixXf& dictionary, JobContext& context) {
    const auto atoms = static_cast<int>(dictionary.cols());
    Eigen::MatrixXf gram(atoms, atoms);
    context.parallel(0, blocksOf(atoms), [&](int block) {
        const int first = block * kBlock, count = std::min(kBlock, atoms - first), end = first + count;
        gram.block(0, first, end, count).noalias() =
            dictionary.leftCols(end).transpose() * dictionary.middleCols(first, count);
    });
    gram.triangularView<Eigen::StrictlyLower>() = gram.transpose();
    return gram;
}

} // namespace

SignalSource SignalSource::of(const Eigen::MatrixXf& columns) {
    return {
        static_cast<int>(columns.rows()), static_cast<int>(columns.cols()),
        [&columns](int first, Eigen::Ref<Eigen::MatrixXf> to) { to = columns.middleCols(first, to.cols()); }};
}

SparseCode::SparseCode(int signals, int most)
    : m_most(most), m_counts(texloom::at(signals)), m_atoms(texloom::at(signals) * texloom::at(most)),
      m_weights(texloom::at(signals) * texloom::at(most)) {}

bool SparseCode::uses(int signal, int atom) const {
    const std::span<const int> own = atoms(signal);
    return std::find(own.begin(), own.end(), atom) != own.end();
}

bool SparseCode::add(int signal, int atom, float weight) {
    const std::size_t first = at(signal), count = countOf(signal);
    for (std::size_t i = first; i < first + count; ++i)
        if (m_atoms[i] == atom) {
            m_weights[i] += weight;
            return false;
        }
    m_atoms[first + count] = atom;
    m_weights[first + count] = weight;
    ++m_counts[static_cast<std::size_t>(signal)];
    return true;
}

std::vector<int> SparseCode::uses(int atoms) const {
    std::vector<int> counts(texloom::at(atoms), 0);
    for (int k = 0; k < signals(); ++k)
        for (const int atom : this->atoms(k))
            ++counts[texloom::at(atom)];
    return counts;
}

void SparseCode::combine(const Eigen::MatrixXf& dictionary, int signal,
                         Eigen::Ref<Eigen::VectorXf> to) const {
    to.setZero();
    const std::span<const int> own = atoms(signal);
    const std::span<const float> factors = weights(signal);
    for (std::size_t i = 0; i < own.size(); ++i)
        to += factors[i] * dictionary.col(own[i]);
}

Eigen::MatrixXf correlations(const Eigen::MatrixXf& dictionary, const SignalSource& signals,
                             JobContext& context) {
    Eigen::MatrixXf products(dictionary.cols(), signals.count);
    context.parallel(0, blocksOf(signals.count), [&](int block) {
        const int first = block * kBlock, count = std::min(kBlock, signals.count - first);
        Eigen::MatrixXf columns(signals.length, count);
        signals.read(first, columns);
        products.middleCols(first, count).noalias() = dictionary.transpose() * columns;
    });
    return products;
}

SparseCode orthogonalPursuit(const Eigen::MatrixXf& dictionary, const SignalSource& signals, int most,
                             JobContext& context) {
    const Eigen::MatrixXf gram = gramOf(dictionary, context);
    SparseCode code(signals.count, most);
    context.parallel(0, blocksOf(signals.count), [&](int block) {
        const int first = block * kBlock, count = std::min(kBlock, signals.count - first);
        Eigen::MatrixXf columns(signals.length, count);
        signals.read(first, columns);
        Eigen::MatrixXf products(dictionary.cols(), count);
        products.noalias() = dictionary.transpose() * columns;
        Orthogonal pursuit(gram, most);
        for (int k = 0; k < count; ++k) {
            context.check();
            pursuit.run(products.col(k), first + k, code);
        }
    });
    return code;
}

SparseCode constrainedPursuit(const Eigen::MatrixXf& dictionary, const SignalSource& signals,
                              const PursuitLimits& limits, JobContext& context) {
    const Eigen::MatrixXf gram = gramOf(dictionary, context);
    Eigen::MatrixXf products = correlations(dictionary, signals, context);
    Constrained pursuit(gram, products, limits);
    context.parallel(0, blocksOf(signals.count), [&](int block) {
        for (int k = block * kBlock; k < std::min(signals.count, (block + 1) * kBlock); ++k)
            pursuit.measure(k);
    });
    return pursuit.run(context);
}

std::vector<int> roundedShares(std::span<const double> shares) {
    std::vector<int> whole;
    std::vector<std::size_t> order;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        whole.push_back(static_cast<int>(std::floor(shares[i])));
        sum += whole.back();
        if (shares[i] > 0)
            order.push_back(i);
    }
    const auto wanted = std::llround(std::accumulate(shares.begin(), shares.end(), 0.0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return shares[a] - std::floor(shares[a]) > shares[b] - std::floor(shares[b]);
    });
    for (std::size_t i = 0; i < order.size() && sum < wanted; ++i, ++sum)
        ++whole[order[i]];
    return whole;
}

std::uint64_t pursuitBytes(std::int64_t signals, int length, int atoms, int most, int threads) {
    const auto wide = static_cast<std::uint64_t>(atoms), tall = static_cast<std::uint64_t>(length);
    return static_cast<std::uint64_t>(signals) * (4 * wide + 24) + SparseCode::bytesFor(signals, most) +
           4 * wide * wide + static_cast<std::uint64_t>(threads) * kBlock * 4 * (tall + wide) * 2;
}

} // namespace texloom
