#include "core/math/dictionary_learning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom::test {
namespace {

Eigen::MatrixXf planted(int length, int atoms) {
    const Random random(5);
    Eigen::MatrixXf dictionary(length, atoms);
    for (int n = 0; n < atoms; ++n)
        for (int i = 0; i < length; ++i)
            dictionary(i, n) = static_cast<float>(random.normal(i, n));
    dictionary.colwise().normalize();
    return dictionary;
}

/// Sums of `most` different atoms with weights that are not small.
Eigen::MatrixXf sparseSignals(const Eigen::MatrixXf& dictionary, int count, int most) {
    const Random random(6);
    Eigen::MatrixXf signals = Eigen::MatrixXf::Zero(dictionary.rows(), count);
    for (int k = 0; k < count; ++k) {
        std::vector<int> left(static_cast<std::size_t>(dictionary.cols()));
        std::iota(left.begin(), left.end(), 0);
        for (int s = 0; s < most; ++s) {
            const auto chosen = left.begin() + random.below(static_cast<std::uint32_t>(left.size()), k, s);
            const double weight = random.normal(k, 100 + s);
            signals.col(k) +=
                static_cast<float>(weight + std::copysign(0.5, weight)) * dictionary.col(*chosen);
            left.erase(chosen);
        }
    }
    return signals;
}

struct Learnt {
    Dictionary dictionary;
    std::vector<double> errors;
};

Learnt learn(const Eigen::MatrixXf& signals, const DictionaryOptions& options, int threads = 2,
             std::uint64_t seed = 8) {
    JobMonitor monitor;
    JobContext context(
        {seed, threads, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    Learnt learnt;
    learnt.dictionary =
        learnDictionary(signals, options, context,
                        [&](int, double error, const Eigen::MatrixXf&) { learnt.errors.push_back(error); });
    return learnt;
}

int recovered(const Eigen::MatrixXf& truth, const Eigen::MatrixXf& atoms) {
    const Eigen::MatrixXf cosines = (truth.transpose() * atoms).cwiseAbs();
    int count = 0;
    for (Eigen::Index n = 0; n < truth.cols(); ++n)
        count += cosines.row(n).maxCoeff() > 0.99F ? 1 : 0;
    return count;
}

class EveryLearner : public testing::TestWithParam<DictionaryLearner> {};

TEST_P(EveryLearner, findsAPlantedDictionary) {
    const Eigen::MatrixXf truth = planted(20, 20);
    const Learnt learnt = learn(sparseSignals(truth, 1500, 3), {20, 3, 60, GetParam()});
    EXPECT_GE(recovered(truth, learnt.dictionary.atoms), 18);
    EXPECT_LT(learnt.errors.back(), 0.2 * learnt.errors.front());
}

TEST_P(EveryLearner, atomsHaveLengthOne) {
    const Learnt learnt = learn(sparseSignals(planted(16, 30), 400, 3), {24, 3, 6, GetParam()});
    ASSERT_EQ(learnt.dictionary.count(), 24);
    for (Eigen::Index n = 0; n < 24; ++n)
        EXPECT_NEAR(learnt.dictionary.atoms.col(n).norm(), 1, 1e-5);
}

TEST_P(EveryLearner, usesAreThoseOfThePursuitOfTheSynthesis) {
    const Eigen::MatrixXf signals = sparseSignals(planted(16, 30), 300, 3);
    const Dictionary learnt = learn(signals, {24, 3, 5, GetParam()}).dictionary;
    EXPECT_EQ(learnt.signals, 300);
    EXPECT_LE(std::accumulate(learnt.uses.begin(), learnt.uses.end(), std::int64_t{0}), 900);
    const std::vector<int> order = learnt.byUse();
    for (std::size_t i = 1; i < order.size(); ++i)
        EXPECT_GE(learnt.uses[static_cast<std::size_t>(order[i - 1])],
                  learnt.uses[static_cast<std::size_t>(order[i])]);
}

TEST_P(EveryLearner, bitsDoNotDependOnThreadsButOnTheSeed) {
    const Eigen::MatrixXf signals = sparseSignals(planted(16, 30), 500, 3);
    const DictionaryOptions options{24, 3, 4, GetParam()};
    const Dictionary one = learn(signals, options, 1).dictionary;
    const Dictionary many = learn(signals, options, 6).dictionary;
    EXPECT_EQ(one.atoms, many.atoms);
    EXPECT_EQ(one.uses, many.uses);
    EXPECT_NE(one.atoms, learn(signals, options, 1, 9).dictionary.atoms);
}

TEST_P(EveryLearner, learnsWhatThereIs) {
    const Eigen::MatrixXf few = sparseSignals(planted(9, 12), 7, 2);
    EXPECT_EQ(learn(few, {50, 4, 3, GetParam()}).dictionary.count(), 7);
    const Eigen::MatrixXf nothing = Eigen::MatrixXf::Zero(9, 40);
    const Dictionary flat = learn(nothing, {50, 4, 3, GetParam()}).dictionary;
    ASSERT_EQ(flat.count(), 1);
    EXPECT_EQ(flat.uses.front(), 0);
    Eigen::MatrixXf alike(9, 40);
    alike.colwise() = planted(9, 1).col(0).eval();
    EXPECT_TRUE(learn(alike, {8, 4, 3, GetParam()}).dictionary.atoms.allFinite());
}

INSTANTIATE_TEST_SUITE_P(DictionaryLearning, EveryLearner,
                         testing::Values(DictionaryLearner::Ksvd, DictionaryLearner::Online));

TEST(DictionaryLearning, errorOfKsvdNeverRises) {
    for (const int atoms : {10, 40, 150}) {
        const Learnt learnt = learn(sparseSignals(planted(12, 30), 300, 4), {atoms, 3, 15});
        for (std::size_t i = 1; i < learnt.errors.size(); ++i)
            EXPECT_LE(learnt.errors[i], learnt.errors[i - 1] * (1 + 1e-5))
                << "round " << i << " of " << atoms;
    }
}

TEST(DictionaryLearning, ksvdCodesBetterThanPrincipalAxes) {
    // Signals from three lines in a plane: two principal axes with one atom each cannot code them, three
    // atoms can.
    Eigen::MatrixXf lines(2, 3);
    lines << 1, -0.5F, -0.5F, 0, 0.8660254F, -0.8660254F;
    const Learnt learnt = learn(sparseSignals(lines, 300, 1), {3, 1, 20});
    EXPECT_LT(learnt.errors.back(), 1e-6 * 300);
    EXPECT_EQ(recovered(lines, learnt.dictionary.atoms), 3);
}

} // namespace
} // namespace texloom::test
