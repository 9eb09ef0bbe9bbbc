#include "core/math/matching_pursuit.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace texloom::test {
namespace {

/// Runs `body` with a context of so many threads.
template <class Body> auto inJob(int threads, const Body& body) {
    JobMonitor monitor;
    JobContext context(
        {3, threads, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    return body(context);
}

Eigen::MatrixXf randomColumns(int length, int count, int stream) {
    const Random random(17, static_cast<std::uint32_t>(stream));
    Eigen::MatrixXf columns(length, count);
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < length; ++i)
            columns(i, k) = static_cast<float>(random.normal(i, k));
    return columns;
}

Eigen::MatrixXf unitColumns(int length, int count, int stream) {
    Eigen::MatrixXf columns = randomColumns(length, count, stream);
    columns.colwise().normalize();
    return columns;
}

SparseCode orthogonal(const Eigen::MatrixXf& atoms, const Eigen::MatrixXf& signals, int most,
                      int threads = 2) {
    return inJob(threads, [&](JobContext& context) {
        return orthogonalPursuit(atoms, SignalSource::of(signals), most, context);
    });
}

SparseCode constrained(const Eigen::MatrixXf& atoms, const Eigen::MatrixXf& signals,
                       const PursuitLimits& limits, int threads = 2) {
    return inJob(threads, [&](JobContext& context) {
        return constrainedPursuit(atoms, SignalSource::of(signals), limits, context);
    });
}

double errorOf(const Eigen::MatrixXf& atoms, const Eigen::MatrixXf& signals, const SparseCode& code, int k) {
    Eigen::VectorXf made(atoms.rows());
    code.combine(atoms, k, made);
    return static_cast<double>((signals.col(k) - made).squaredNorm());
}

void expectSameCode(const SparseCode& a, const SparseCode& b) {
    ASSERT_EQ(a.signals(), b.signals());
    for (int k = 0; k < a.signals(); ++k) {
        ASSERT_TRUE(std::equal(a.atoms(k).begin(), a.atoms(k).end(), b.atoms(k).begin(), b.atoms(k).end()));
        ASSERT_TRUE(
            std::equal(a.weights(k).begin(), a.weights(k).end(), b.weights(k).begin(), b.weights(k).end()));
    }
}

TEST(MatchingPursuit, correlationsAreTheProductsOfAllWithAll) {
    const Eigen::MatrixXf atoms = unitColumns(13, 21, 0), signals = randomColumns(13, 150, 1);
    const Eigen::MatrixXf products = inJob(
        3, [&](JobContext& context) { return correlations(atoms, SignalSource::of(signals), context); });
    for (int k = 0; k < 150; ++k)
        for (int n = 0; n < 21; ++n) {
            double sum = 0;
            for (int i = 0; i < 13; ++i)
                sum += static_cast<double>(atoms(i, n)) * static_cast<double>(signals(i, k));
            ASSERT_NEAR(products(n, k), sum, 1e-4);
        }
}

TEST(MatchingPursuit, orthogonalWeightsAreTheLeastSquaresOfTheChosenAtoms) {
    const Eigen::MatrixXf atoms = unitColumns(20, 60, 2), signals = randomColumns(20, 70, 3);
    const SparseCode code = orthogonal(atoms, signals, 5);
    for (int k = 0; k < 70; ++k) {
        ASSERT_EQ(code.atoms(k).size(), 5U);
        EXPECT_EQ(std::set<int>(code.atoms(k).begin(), code.atoms(k).end()).size(), 5U);
        Eigen::VectorXf made(20);
        code.combine(atoms, k, made);
        const Eigen::VectorXf rest = signals.col(k) - made;
        for (const int atom : code.atoms(k))
            EXPECT_NEAR(rest.dot(atoms.col(atom)), 0, 1e-4);
    }
}

TEST(MatchingPursuit, orthogonalChoosesTheAtomMostLikeTheRemainder) {
    const Eigen::MatrixXf atoms = unitColumns(12, 30, 4), signals = randomColumns(12, 40, 5);
    const SparseCode code = orthogonal(atoms, signals, 4);
    for (int k = 0; k < 40; ++k) {
        Eigen::VectorXf rest = signals.col(k);
        for (std::size_t step = 0; step < 4; ++step) {
            Eigen::Index best = 0;
            (atoms.transpose() * rest).cwiseAbs().maxCoeff(&best);
            ASSERT_EQ(code.atoms(k)[step], best);
            Eigen::MatrixXf chosen(12, static_cast<Eigen::Index>(step) + 1);
            for (std::size_t i = 0; i <= step; ++i)
                chosen.col(static_cast<Eigen::Index>(i)) = atoms.col(code.atoms(k)[i]);
            const Eigen::MatrixXf normal = chosen.transpose() * chosen;
            rest = signals.col(k) - chosen * normal.inverse() * chosen.transpose() * signals.col(k);
        }
    }
}

TEST(MatchingPursuit, orthogonalEndsWhereNothingIsLeftToCode) {
    const Eigen::MatrixXf atoms = Eigen::MatrixXf::Identity(6, 6);
    Eigen::MatrixXf signals = Eigen::MatrixXf::Zero(6, 2);
    signals(2, 1) = 5;
    const SparseCode code = orthogonal(atoms, signals, 4);
    EXPECT_TRUE(code.atoms(0).empty());
    ASSERT_EQ(code.atoms(1).size(), 1U);
    EXPECT_EQ(code.atoms(1)[0], 2);
    EXPECT_EQ(code.weights(1)[0], 5);
}

TEST(MatchingPursuit, twinAtomsAreNotBothChosen) {
    Eigen::MatrixXf atoms = unitColumns(8, 5, 6);
    atoms.col(4) = atoms.col(0);
    const SparseCode code = orthogonal(atoms, randomColumns(8, 30, 7), 5);
    for (int k = 0; k < 30; ++k)
        EXPECT_FALSE(code.uses(k, 0) && code.uses(k, 4));
}

/// Algorithm 2 as it is written, with all residuals at hand.
SparseCode bruteForce(const Eigen::MatrixXf& atoms, const Eigen::MatrixXf& signals,
                      const PursuitLimits& limits, std::vector<double>* norms = nullptr) {
    Eigen::MatrixXf rest = signals;
    const int count = static_cast<int>(signals.cols()), n = static_cast<int>(atoms.cols());
    SparseCode code(count, limits.most);
    float first = 0;
    for (int step = 0; step < limits.most * count; ++step) {
        const std::vector<int> uses = code.uses(n);
        float largest = 0;
        int signal = -1, atom = -1;
        for (int k = 0; k < count; ++k)
            for (int a = 0; a < n; ++a) {
                const bool own = code.uses(k, a);
                const bool room = static_cast<int>(code.atoms(k).size()) - (own ? 1 : 0) < limits.most;
                const bool left = limits.uses.empty() || uses[static_cast<std::size_t>(a)] - (own ? 1 : 0) <
                                                             limits.uses[static_cast<std::size_t>(a)];
                const float size = std::fabs(atoms.col(a).dot(rest.col(k)));
                if (room && left && size > largest) {
                    largest = size;
                    signal = k;
                    atom = a;
                }
            }
        first = std::max(first, largest);
        if (largest <= 1e-6F * first)
            break;
        const float weight = atoms.col(atom).dot(rest.col(signal));
        code.add(signal, atom, weight);
        rest.col(signal) -= weight * atoms.col(atom);
        if (norms)
            norms->push_back(static_cast<double>(rest.squaredNorm()));
    }
    return code;
}

std::vector<int> someUses(int atoms) {
    std::vector<int> uses;
    for (int n = 0; n < atoms; ++n)
        uses.push_back(n % 5);
    return uses;
}

TEST(MatchingPursuit, constrainedDoesWhatTheAlgorithmSays) {
    const Eigen::MatrixXf atoms = unitColumns(16, 24, 8), signals = randomColumns(16, 30, 9);
    for (const PursuitLimits& limits :
         {PursuitLimits{1, {}}, PursuitLimits{3, {}}, PursuitLimits{3, someUses(24)},
          PursuitLimits{4, std::vector<int>(24, 2)}}) {
        const SparseCode fast = constrained(atoms, signals, limits);
        const SparseCode plain = bruteForce(atoms, signals, limits);
        for (int k = 0; k < 30; ++k) {
            ASSERT_TRUE(std::equal(fast.atoms(k).begin(), fast.atoms(k).end(), plain.atoms(k).begin(),
                                   plain.atoms(k).end()))
                << "signal " << k;
            for (std::size_t i = 0; i < fast.weights(k).size(); ++i)
                EXPECT_NEAR(fast.weights(k)[i], plain.weights(k)[i], 1e-4);
        }
    }
}

/// The weights of a signal's atoms by least squares.
Eigen::VectorXf leastSquares(const Eigen::MatrixXf& atoms, const Eigen::MatrixXf& signals,
                             const SparseCode& code, int signal) {
    const std::span<const int> chosen = code.atoms(signal);
    Eigen::MatrixXf own(atoms.rows(), static_cast<Eigen::Index>(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i)
        own.col(static_cast<Eigen::Index>(i)) = atoms.col(chosen[i]);
    return own.colPivHouseholderQr().solve(signals.col(signal));
}

TEST(MatchingPursuit, orthogonalAndConstrainedIsOrthogonalWhereNothingIsLimited) {
    const Eigen::MatrixXf atoms = unitColumns(16, 24, 8), signals = randomColumns(16, 30, 9);
    const SparseCode one = orthogonal(atoms, signals, 4);
    const SparseCode other = constrained(atoms, signals, {4, {}, Pursuit::Orthogonal});
    for (int k = 0; k < 30; ++k) {
        ASSERT_TRUE(std::equal(one.atoms(k).begin(), one.atoms(k).end(), other.atoms(k).begin(),
                               other.atoms(k).end()))
            << "signal " << k;
        for (std::size_t i = 0; i < one.weights(k).size(); ++i)
            EXPECT_NEAR(one.weights(k)[i], other.weights(k)[i], 1e-4);
    }
}

TEST(MatchingPursuit, orthogonalWeightsAreLeastSquaresWithinTheLimits) {
    const Eigen::MatrixXf atoms = unitColumns(16, 24, 8), signals = randomColumns(16, 60, 9);
    const PursuitLimits limits{4, someUses(24), Pursuit::Orthogonal};
    const SparseCode code = constrained(atoms, signals, limits);
    const std::vector<int> uses = code.uses(24);
    for (std::size_t n = 0; n < 24; ++n) {
        EXPECT_LE(uses[n], limits.uses[n]) << "atom " << n;
    }
    const auto before = static_cast<double>(signals.squaredNorm());
    double whole = 0;
    for (int k = 0; k < 60; ++k) {
        ASSERT_LE(code.atoms(k).size(), 4U);
        whole += errorOf(atoms, signals, code, k);
        if (code.atoms(k).empty())
            continue;
        const Eigen::VectorXf best = leastSquares(atoms, signals, code, k);
        for (std::size_t i = 0; i < code.weights(k).size(); ++i)
            EXPECT_NEAR(code.weights(k)[i], best[static_cast<Eigen::Index>(i)], 1e-4);
    }
    EXPECT_LT(whole, before);
}

TEST(MatchingPursuit, orthogonalEndsWhereAtomsDepend) {
    Eigen::MatrixXf atoms = unitColumns(8, 6, 7);
    atoms.col(4) = atoms.col(0);
    const SparseCode code = constrained(atoms, randomColumns(8, 30, 7), {5, {}, Pursuit::Orthogonal});
    for (int k = 0; k < 30; ++k)
        EXPECT_FALSE(code.uses(k, 0) && code.uses(k, 4));
}

TEST(MatchingPursuit, noSignalHasMoreAtomsAndNoAtomMoreUsesThanAllowed) {
    const Eigen::MatrixXf atoms = unitColumns(30, 40, 10), signals = randomColumns(30, 200, 11);
    const PursuitLimits limits{4, someUses(40)};
    const SparseCode code = constrained(atoms, signals, limits);
    const std::vector<int> uses = code.uses(40);
    for (int k = 0; k < 200; ++k)
        EXPECT_LE(code.atoms(k).size(), 4U);
    for (std::size_t n = 0; n < 40; ++n) {
        EXPECT_LE(uses[n], limits.uses[n]) << "atom " << n;
    }
    EXPECT_EQ(std::accumulate(uses.begin(), uses.end(), 0), 80) << "all that is allowed finds a signal";
}

TEST(MatchingPursuit, anAtomOfNoUseIsNeverUsedAndClosesNothingElse) {
    const Eigen::MatrixXf atoms = unitColumns(10, 12, 12), signals = randomColumns(10, 50, 13);
    std::vector<int> uses(12, 50);
    uses[3] = 0;
    const SparseCode code = constrained(atoms, signals, {2, uses});
    EXPECT_EQ(code.uses(12)[3], 0);
    for (int k = 0; k < 50; ++k)
        EXPECT_GE(code.atoms(k).size(), 1U);
}

TEST(MatchingPursuit, theRemainderNeverRises) {
    const Eigen::MatrixXf atoms = unitColumns(16, 24, 14), signals = randomColumns(16, 25, 15);
    std::vector<double> norms;
    bruteForce(atoms, signals, {3, someUses(24)}, &norms);
    EXPECT_TRUE(std::is_sorted(norms.rbegin(), norms.rend()));
    // Each further atom of a signal leaves less, so more are never worse.
    double before = static_cast<double>(signals.squaredNorm());
    for (int most = 1; most <= 6; ++most) {
        const SparseCode code = constrained(atoms, signals, {most, {}});
        double error = 0;
        for (int k = 0; k < 25; ++k) {
            const double own = errorOf(atoms, signals, code, k);
            EXPECT_LE(own, static_cast<double>(signals.col(k).squaredNorm()) + 1e-4);
            error += own;
        }
        EXPECT_LT(error, before);
        before = error;
    }
}

TEST(MatchingPursuit, bitsDoNotDependOnThreads) {
    const Eigen::MatrixXf atoms = unitColumns(24, 50, 16), signals = randomColumns(24, 333, 17);
    expectSameCode(orthogonal(atoms, signals, 4, 1), orthogonal(atoms, signals, 4, 5));
    for (const Pursuit pursuit : {Pursuit::Plain, Pursuit::Orthogonal})
        expectSameCode(constrained(atoms, signals, {4, someUses(50), pursuit}, 1),
                       constrained(atoms, signals, {4, someUses(50), pursuit}, 5));
}

TEST(MatchingPursuit, sharesAreRoundedToTheirSum) {
    const std::vector<double> shares = {0, 1.5, 2.25, 0.75, 3.5, 0};
    const std::vector<int> whole = roundedShares(shares);
    EXPECT_EQ(whole, (std::vector<int>{0, 2, 2, 1, 3, 0}));
    EXPECT_EQ(roundedShares(std::vector<double>{0.4, 0.4, 0.4}), (std::vector<int>{1, 0, 0}));
}

} // namespace
} // namespace texloom::test
