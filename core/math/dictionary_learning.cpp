#include "core/math/dictionary_learning.h"

#include "core/base/at.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace texloom {

namespace {

/// Atoms whose cosine is beyond this count as one.
constexpr float kAlike = 0.99F;
/// Draws for one of the first atoms before one that is like another is taken.
constexpr int kDraws = 20;
/// Atoms that fewer signals use are worth replacing.
constexpr int kFewUses = 2;
constexpr int kPowerIterations = 2;
/// Signals that online learning codes at a time.
constexpr int kBatch = 256;
/// Online learning forgets: what was known t batches ago counts (1 − 1/t)^ρ as much (Mairal et al., 3.4).
constexpr double kForgetting = 3;

using Watch = std::function<void(int, double, const Eigen::MatrixXf&)>;

/// Column by column, since sums over columns are made in a fixed order.
double squaredNorm(const Eigen::MatrixXf& columns) {
    double sum = 0;
    for (Eigen::Index k = 0; k < columns.cols(); ++k)
        sum += static_cast<double>(columns.col(k).squaredNorm());
    return sum;
}

/// Different signals, drawn at random and normalised; one like another is drawn again.
Eigen::MatrixXf firstAtoms(const Eigen::MatrixXf& signals, const DictionaryOptions& options,
                           const JobContext& context) {
    std::vector<int> left;
    for (int k = 0; k < static_cast<int>(signals.cols()); ++k)
        if (signals.col(k).squaredNorm() > 0)
            left.push_back(k);
    const int count = std::min(options.atoms, static_cast<int>(left.size()));
    Eigen::MatrixXf atoms(signals.rows(), count);
    for (int n = 0; n < count; ++n) {
        context.check();
        std::size_t chosen = 0;
        for (int draw = 0; draw < kDraws; ++draw) {
            chosen = context.random().below(static_cast<std::uint32_t>(left.size()), n, options.draw,
                                            static_cast<std::uint32_t>(draw));
            atoms.col(n) = signals.col(left[chosen]).normalized();
            if (n == 0 || (atoms.leftCols(n).transpose() * atoms.col(n)).cwiseAbs().maxCoeff() <= kAlike)
                break;
        }
        left[chosen] = left.back();
        left.pop_back();
    }
    return atoms;
}

/// Where each atom is used: the signals, and the places in their codes.
struct Users {
    struct User {
        int signal;
        std::size_t place;
    };
    explicit Users(const SparseCode& code, int atoms) : of(at(atoms)) {
        for (int k = 0; k < code.signals(); ++k) {
            const std::span<const int> own = code.atoms(k);
            for (std::size_t i = 0; i < own.size(); ++i)
                of[at(own[i])].push_back({k, i});
        }
    }
    std::vector<std::vector<User>> of;
};

/// Which atoms are nearly another one that comes earlier.
std::vector<bool> alikeEarlier(const Eigen::MatrixXf& atoms) {
    const Eigen::MatrixXf cosines = atoms.transpose() * atoms;
    std::vector<bool> like(static_cast<std::size_t>(atoms.cols()), false);
    for (Eigen::Index n = 1; n < atoms.cols(); ++n)
        like[static_cast<std::size_t>(n)] = cosines.col(n).head(n).cwiseAbs().maxCoeff() > kAlike;
    return like;
}

/// K-SVD with the residual P − D W at hand.
class Ksvd {
public:
    Ksvd(const Eigen::MatrixXf& signals, Eigen::MatrixXf& atoms, int sparsity, JobContext& context)
        : m_signals(signals), m_atoms(atoms), m_context(context),
          m_code(static_cast<int>(signals.cols()), sparsity), m_residual(signals) {}

    /// One round. @return the squared error after it.
    double round() {
        code();
        replaceAtoms();
        const Users users(m_code, static_cast<int>(m_atoms.cols()));
        for (int n = 0; n < static_cast<int>(m_atoms.cols()); ++n) {
            m_context.check();
            improve(n, users.of[at(n)]);
        }
        return squaredNorm(m_residual);
    }

private:
    int signals() const { return static_cast<int>(m_signals.cols()); }

    /// Codes every signal; each keeps the code that it has where that is better.
    void code() {
        const SparseCode fresh =
            orthogonalPursuit(m_atoms, SignalSource::of(m_signals), m_code.most(), m_context);
        constexpr int kCodedAtOnce = 64;
        m_context.parallel(0, (signals() + kCodedAtOnce - 1) / kCodedAtOnce, [&](int chunk) {
            Eigen::VectorXf made(m_signals.rows());
            for (int k = chunk * kCodedAtOnce; k < std::min(signals(), (chunk + 1) * kCodedAtOnce); ++k) {
                fresh.combine(m_atoms, k, made);
                made = m_signals.col(k) - made;
                if (made.squaredNorm() > m_residual.col(k).squaredNorm())
                    continue;
                m_residual.col(k) = made;
                m_code.clear(k);
                for (std::size_t i = 0; i < fresh.atoms(k).size(); ++i)
                    m_code.add(k, fresh.atoms(k)[i], fresh.weights(k)[i]);
            }
        });
    }

    /// The best atom for those that use it, with the best weights: the first singular vectors of their
    /// residual without it.
    void improve(int n, const std::vector<Users::User>& users) {
        if (users.empty())
            return;
        Eigen::VectorXf atom = m_atoms.col(n);
        const auto count = static_cast<Eigen::Index>(users.size());
        Eigen::MatrixXf rest(m_atoms.rows(), count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto& [signal, place] = users[static_cast<std::size_t>(i)];
            rest.col(i) = m_residual.col(signal) + m_code.weights(signal)[place] * atom;
        }
        Eigen::VectorXf weights(count);
        for (int i = 0; i < kPowerIterations; ++i) {
            weights.noalias() = rest.transpose() * atom;
            const Eigen::VectorXf moved = rest * weights;
            const float length = moved.norm();
            if (!(length > 0))
                return;
            atom = moved / length;
        }
        weights.noalias() = rest.transpose() * atom;
        m_atoms.col(n) = atom;
        for (Eigen::Index i = 0; i < count; ++i) {
            const auto& [signal, place] = users[static_cast<std::size_t>(i)];
            m_code.weights(signal)[place] = weights[i];
            m_residual.col(signal) = rest.col(i) - weights[i] * atom;
        }
    }

    /// Atoms that few use, or that are like an earlier one, become the signals that are coded worst.
    void replaceAtoms() {
        const std::vector<bool> like = alikeEarlier(m_atoms);
        const std::vector<int> uses = m_code.uses(static_cast<int>(m_atoms.cols()));
        std::vector<float> errors;
        for (int k = 0; k < signals(); ++k)
            errors.push_back(m_residual.col(k).squaredNorm());
        for (int n = 0; n < static_cast<int>(m_atoms.cols()); ++n) {
            m_context.check();
            if (like[at(n)] || uses[at(n)] < kFewUses)
                replace(n, errors);
        }
    }

    /// Only where the signal gains more than the atom's users lose. @param errors of each signal.
    void replace(int n, std::vector<float>& errors) {
        const auto worst = static_cast<int>(std::max_element(errors.begin(), errors.end()) - errors.begin());
        const float length = m_signals.col(worst).norm();
        if (!(errors[at(worst)] > 0) || !(length > 0))
            return;
        double loss = 0;
        std::vector<int> users;
        for (int k = 0; k < signals(); ++k)
            if (k != worst && m_code.uses(k, n)) {
                users.push_back(k);
                loss += static_cast<double>(
                    (m_residual.col(k) + weightOf(k, n) * m_atoms.col(n)).squaredNorm() - errors[at(k)]);
            }
        if (loss >= static_cast<double>(errors[at(worst)]))
            return;
        for (const int k : users) {
            m_residual.col(k) += weightOf(k, n) * m_atoms.col(n);
            errors[at(k)] = m_residual.col(k).squaredNorm();
            drop(k, n);
        }
        m_atoms.col(n) = m_signals.col(worst) / length;
        m_code.clear(worst);
        m_code.add(worst, n, length);
        m_residual.col(worst).setZero();
        errors[at(worst)] = 0;
    }

    float weightOf(int signal, int atom) const {
        const std::span<const int> own = m_code.atoms(signal);
        return m_code.weights(
            signal)[static_cast<std::size_t>(std::find(own.begin(), own.end(), atom) - own.begin())];
    }

    void drop(int signal, int atom) {
        const std::vector<int> own(m_code.atoms(signal).begin(), m_code.atoms(signal).end());
        const auto weights = std::as_const(m_code).weights(signal);
        const std::vector<float> kept(weights.begin(), weights.end());
        m_code.clear(signal);
        for (std::size_t i = 0; i < own.size(); ++i)
            if (own[i] != atom)
                m_code.add(signal, own[i], kept[i]);
    }

    const Eigen::MatrixXf& m_signals;
    Eigen::MatrixXf& m_atoms;
    JobContext& m_context;
    SparseCode m_code;
    Eigen::MatrixXf m_residual;
};

/// Online learning: A = Σ w wᵀ and B = Σ p wᵀ stand for all signals so far.
class Online {
public:
    Online(const Eigen::MatrixXf& signals, Eigen::MatrixXf& atoms, int sparsity, JobContext& context)
        : m_signals(signals), m_atoms(atoms), m_sparsity(sparsity), m_context(context),
          m_codes(Eigen::MatrixXf::Zero(atoms.cols(), atoms.cols())),
          m_products(Eigen::MatrixXf::Zero(atoms.rows(), atoms.cols())),
          m_order(static_cast<std::size_t>(signals.cols())), m_errors(m_order.size()) {
        std::iota(m_order.begin(), m_order.end(), 0);
    }

    /// One round over all signals, in an order of its own. @return the squared error of each as it was met.
    double round(int number, int draw) {
        for (std::size_t i = m_order.size() - 1; i > 0; --i)
            std::swap(m_order[i],
                      m_order[m_context.random().below(static_cast<std::uint32_t>(i + 1), static_cast<int>(i),
                                                       -1 - number, static_cast<std::uint32_t>(draw))]);
        m_uses.assign(static_cast<std::size_t>(m_atoms.cols()), 0);
        double error = 0;
        for (std::size_t first = 0; first < m_order.size(); first += kBatch)
            error += batch(
                std::span(m_order).subspan(first, std::min<std::size_t>(kBatch, m_order.size() - first)));
        replaceAtoms();
        return error;
    }

private:
    double batch(std::span<const int> chosen) {
        Eigen::MatrixXf columns(m_signals.rows(), static_cast<Eigen::Index>(chosen.size()));
        for (std::size_t i = 0; i < chosen.size(); ++i)
            columns.col(static_cast<Eigen::Index>(i)) = m_signals.col(chosen[i]);
        const SparseCode code = orthogonalPursuit(m_atoms, SignalSource::of(columns), m_sparsity, m_context);
        const auto kept = static_cast<float>(std::pow(1 - 1.0 / ++m_batches, kForgetting));
        m_codes *= kept;
        m_products *= kept;
        Eigen::VectorXf made(m_signals.rows());
        double error = 0;
        for (int k = 0; k < code.signals(); ++k) {
            code.combine(m_atoms, k, made);
            const float own = (columns.col(k) - made).squaredNorm();
            m_errors[at(chosen[at(k)])] = own;
            error += static_cast<double>(own);
            for (const int atom : code.atoms(k))
                ++m_uses[at(atom)];
            add(columns.col(k), code.atoms(k), code.weights(k));
        }
        for (Eigen::Index n = 0; n < m_atoms.cols(); ++n) {
            if (n % 16 == 0)
                m_context.check();
            move(n);
        }
        return error;
    }

    void add(const Eigen::Ref<const Eigen::VectorXf>& signal, std::span<const int> atoms,
             std::span<const float> weights) {
        for (std::size_t i = 0; i < atoms.size(); ++i) {
            m_products.col(atoms[i]) += weights[i] * signal;
            for (std::size_t j = 0; j < atoms.size(); ++j)
                m_codes(atoms[i], atoms[j]) += weights[i] * weights[j];
        }
    }

    /// Atoms that few used in this round, or that are like an earlier one, become the signals that were coded
    /// worst, and what was known of them is forgotten.
    void replaceAtoms() {
        const std::vector<bool> like = alikeEarlier(m_atoms);
        for (Eigen::Index n = 0; n < m_atoms.cols(); ++n) {
            if (!like[static_cast<std::size_t>(n)] && m_uses[static_cast<std::size_t>(n)] >= kFewUses)
                continue;
            const auto worst = std::max_element(m_errors.begin(), m_errors.end());
            const auto signal = m_signals.col(worst - m_errors.begin());
            if (!(*worst > 0))
                return;
            *worst = 0;
            m_atoms.col(n) = signal.normalized();
            m_codes.col(n).setZero();
            m_codes.row(n).setZero();
            m_products.col(n).setZero();
        }
    }

    /// A step of block coordinate descent, and back into the unit ball. What no one used stays.
    void move(Eigen::Index n) {
        const float own = m_codes(n, n);
        if (!(own > std::numeric_limits<float>::min()))
            return;
        Eigen::VectorXf moved = m_products.col(n);
        for (Eigen::Index j = 0; j < m_codes.rows(); ++j)
            if (m_codes(j, n) != 0)
                moved -= m_codes(j, n) * m_atoms.col(j);
        moved = moved / own + m_atoms.col(n);
        const float length = moved.norm();
        if (length > 0 && std::isfinite(length))
            m_atoms.col(n) = moved / std::max(1.0F, length);
    }

    const Eigen::MatrixXf& m_signals;
    Eigen::MatrixXf& m_atoms;
    int m_sparsity;
    JobContext& m_context;
    Eigen::MatrixXf m_codes, m_products;
    std::vector<int> m_order;
    std::vector<float> m_errors; ///< of each signal when it was last met
    std::vector<int> m_uses;     ///< of each atom in this round
    int m_batches = 0;
};

/// Pursuits want atoms of length 1, and weights make up for it.
void normaliseAtoms(Eigen::MatrixXf& atoms) {
    for (Eigen::Index n = 0; n < atoms.cols(); ++n)
        if (const float length = atoms.col(n).norm(); length > 0)
            atoms.col(n) /= length;
}

void learnAtoms(const Eigen::MatrixXf& signals, const DictionaryOptions& options, Eigen::MatrixXf& atoms,
                JobContext& context, const Watch& watch) {
    const int sparsity =
        std::min({options.sparsity, static_cast<int>(signals.rows()), static_cast<int>(atoms.cols())});
    if (options.learner == DictionaryLearner::Ksvd) {
        Ksvd learner(signals, atoms, sparsity, context);
        for (int i = 0; i < options.iterations; ++i) {
            const double error = learner.round();
            watch(i + 1, error, atoms);
        }
        return;
    }
    Online learner(signals, atoms, sparsity, context);
    for (int i = 0; i < options.iterations; ++i) {
        const double error = learner.round(i, options.draw);
        normaliseAtoms(atoms);
        watch(i + 1, error, atoms);
    }
}

} // namespace

std::vector<int> Dictionary::byUse() const {
    std::vector<int> order(static_cast<std::size_t>(count()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](int a, int b) { return uses[at(a)] > uses[at(b)]; });
    return order;
}

Dictionary
learnDictionary(const Eigen::MatrixXf& signals, const DictionaryOptions& options, JobContext& context,
                const std::function<void(int rounds, double error, const Eigen::MatrixXf& atoms)>& watch) {
    Dictionary learnt;
    learnt.signals = signals.cols();
    learnt.atoms = firstAtoms(signals, options, context);
    if (learnt.count() == 0) {
        learnt.atoms =
            Eigen::MatrixXf::Constant(signals.rows(), 1, 1 / std::sqrt(static_cast<float>(signals.rows())));
        learnt.uses = {0};
        return learnt;
    }
    learnAtoms(signals, options, learnt.atoms, context, watch);
    const int sparsity = std::min(options.sparsity, learnt.length());
    const std::vector<int> uses =
        constrainedPursuit(learnt.atoms, SignalSource::of(signals), {sparsity, {}, options.pursuit}, context)
            .uses(learnt.count());
    learnt.uses.assign(uses.begin(), uses.end());
    return learnt;
}

std::uint64_t dictionaryBytes(std::int64_t signals, int length, const DictionaryOptions& options,
                              int threads) {
    const auto atoms = static_cast<std::uint64_t>(options.atoms), rows = static_cast<std::uint64_t>(length);
    return 4 * rows * (static_cast<std::uint64_t>(signals) + 4 * atoms) + 12 * atoms * atoms +
           3 * SparseCode::bytesFor(signals, options.sparsity) +
           pursuitBytes(signals, length, options.atoms, options.sparsity, threads);
}

} // namespace texloom
