// Seams between copies and their tone.
#include "core/match/masked_distances.h"
#include "core/methods/fill_seams.h"
#include "core/methods/fill_tone.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texloom::test::fill_tests {
namespace {

constexpr Size kPicture{24, 20};

/// Columns 9 to 12 and rows 8 to 10 were made.
bool isMade(int x, int y) {
    return x >= 9 && x < 13 && y >= 8 && y < 11;
}

std::vector<std::uint8_t> madePixels() {
    std::vector<std::uint8_t> made;
    for (int y = 0; y < kPicture.height; ++y)
        for (int x = 0; x < kPicture.width; ++x)
            made.push_back(isMade(x, y) ? 1 : 0);
    return made;
}

Source shiftedBy(int x, int y, int dx, int dy) {
    return {static_cast<std::uint16_t>(x + dx), static_cast<std::uint16_t>(y + dy), 0};
}

/// Σ |e(s) − e(t + p − q)| + |e(s + q − p) − e(t)| over neighbours p, q, where the source of what was not
/// made is the pixel itself, and its own value counts for both.
double seamCost(const Image& exemplar, const Image& picture, const PositionMap& map) {
    const auto value = [&](int x, int y) {
        return static_cast<double>(
            exemplar(std::clamp(x, 0, exemplar.width() - 1), std::clamp(y, 0, exemplar.height() - 1), 0));
    };
    double sum = 0;
    for (int y = 0; y < kPicture.height; ++y)
        for (int x = 0; x < kPicture.width; ++x)
            for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
                const int u = x + dx, v = y + dy;
                if (!isMade(x, y))
                    continue;
                const Source& s = map.at(x, y);
                if (!isMade(u, v)) {
                    sum += 2 * std::abs(value(s.x + dx, s.y + dy) - static_cast<double>(picture(u, v, 0)));
                } else if (dx + dy > 0) {
                    const Source& t = map.at(u, v);
                    sum += std::abs(value(s.x, s.y) - value(t.x - dx, t.y - dy)) +
                           std::abs(value(s.x + dx, s.y + dy) - value(t.x, t.y));
                }
            }
    return sum;
}

PositionMap mapOf(const Image& exemplar, int choices) {
    PositionMap map(kPicture, {exemplar.size()});
    int bit = 0;
    for (int y = 0; y < kPicture.height; ++y)
        for (int x = 0; x < kPicture.width; ++x)
            if (isMade(x, y))
                map.at(x, y) = (choices >> bit++ & 1) != 0 ? shiftedBy(x, y, 7, 5) : shiftedBy(x, y, -4, 6);
    return map;
}

SeamCosts moved(const Image& exemplar, const Image& picture, const SeamMoves& moves, PositionMap& map) {
    const std::vector<PatchSource> sources{{exemplar.view(), {}, 1}};
    const std::vector<std::uint8_t> made = madePixels();
    return moveSeams({sources, made, {}}, picture, moves, map, [] {});
}

TEST(Seams, ofTwoOffsetsLieWhereNoOthersCostLess) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Image exemplar = blobs({40, 36}, 1, seed), picture = noise(kPicture, 1, seed + 7);
        double least = 1e9;
        for (int choices = 0; choices < 1 << 12; ++choices)
            least = std::min(least, seamCost(exemplar, picture, mapOf(exemplar, choices)));
        SeamMoves moves;
        moves.least = 1;
        moves.rounds = 5;
        PositionMap map = mapOf(exemplar, 0b101101110010);
        const double before = seamCost(exemplar, picture, map);
        const SeamCosts costs = moved(exemplar, picture, moves, map);
        EXPECT_NEAR(costs.before, before, 1e-2);
        EXPECT_NEAR(costs.after, seamCost(exemplar, picture, map), 1e-2);
        EXPECT_NEAR(costs.after, least, 1e-2) << "seed " << seed;
    }
}

TEST(Seams, neverCostMoreThanBefore) {
    const Image exemplar = blobs({40, 36}, 1, 5), picture = blobs(kPicture, 1, 6);
    for (int offset = 0; offset < 8; ++offset) {
        PositionMap map(kPicture, {exemplar.size()});
        for (int y = 8; y < 11; ++y)
            for (int x = 9; x < 13; ++x)
                map.at(x, y) = shiftedBy(x, y, (x * y + offset) % 5, x % 3);
        const double before = seamCost(exemplar, picture, map);
        SeamMoves moves;
        moves.least = 1;
        moved(exemplar, picture, moves, map);
        EXPECT_LE(seamCost(exemplar, picture, map), before + 1e-3);
    }
}

TEST(Seams, copyOnlyWhatMasksAllow) {
    const Image exemplar = blobs({40, 36}, 1, 5), picture = blobs(kPicture, 1, 6);
    Image mask = constant(exemplar.size(), 1, 1);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 7; ++x)
            mask(x, y, 0) = 0; // what the offset (−4, 6) shows of the hole's first two columns
    PositionMap map = mapOf(exemplar, 0);
    for (int y = 8; y < 11; ++y)
        for (int x = 9; x < 11; ++x)
            map.at(x, y) = shiftedBy(x, y, 7, 5);
    const std::vector<PatchSource> sources{{exemplar.view(), mask.view().plane(0), 1}};
    const std::vector<std::uint8_t> made = madePixels();
    SeamMoves moves;
    moves.least = 1;
    moveSeams({sources, made, {}}, picture, moves, map, [] {});
    for (int y = 8; y < 11; ++y)
        for (int x = 9; x < 13; ++x)
            EXPECT_GE(map.at(x, y).x, 7);
}

/// So that a patch of half the contrast must fit nearly twice as well.
TEST(Offsets, distancesAreDividedByThePatchesContrasts) {
    constexpr int kPatch = 5;
    Image exemplar = noise(kPicture, 2, 4);
    for (int c = 0; c < 2; ++c)
        for (int y = 0; y < kPicture.height; ++y)
            for (int x = 0; x < kPicture.width / 2; ++x)
                exemplar(x, y, c) *= 0.2F;
    const MaskedDistances distances({exemplar.view(), {}, 1}, kPatch, [] {});
    std::vector<double> variances;
    double mean = 0;
    for (int y = 0; y + kPatch <= kPicture.height; ++y)
        for (int x = 0; x + kPatch <= kPicture.width; ++x) {
            double variance = 0;
            for (int c = 0; c < 2; ++c) {
                double sum = 0, squares = 0;
                for (int j = 0; j < kPatch; ++j)
                    for (int i = 0; i < kPatch; ++i) {
                        const auto value = static_cast<double>(exemplar(x + i, y + j, c));
                        sum += value;
                        squares += value * value;
                    }
                variance += squares - sum * sum / (kPatch * kPatch);
            }
            variances.push_back(variance);
            mean += variance;
        }
    mean /= static_cast<double>(variances.size());
    std::vector<float> balanced(variances.size(), 1.0F);
    distances.balance(balanced);
    for (std::size_t i = 0; i < variances.size(); ++i)
        EXPECT_NEAR(balanced[i], 1.25 / (variances[i] / mean + 0.25), 1e-4);
}

TEST(Tone, ofACopyThatIsBrighterBecomesThatOfWhatIsAround) {
    const Image picture = blobs(kPicture, 1, 6);
    Image exemplar = picture, image = picture;
    for (int y = 0; y < kPicture.height; ++y)
        for (int x = 0; x < kPicture.width; ++x) {
            exemplar(x, y, 0) += 0.3F;
            if (isMade(x, y))
                image(x, y, 0) = exemplar(x, y, 0);
        }
    PositionMap map(kPicture, {exemplar.size()});
    for (int y = 8; y < 11; ++y)
        for (int x = 9; x < 13; ++x)
            map.at(x, y) = shiftedBy(x, y, 0, 0);
    const std::vector<PatchSource> sources{{exemplar.view(), {}, 1}};
    const std::vector<std::uint8_t> made = madePixels();
    evenTone({sources, made, {}}, map, image, [](double) {});
    for (int y = 0; y < kPicture.height; ++y)
        for (int x = 0; x < kPicture.width; ++x)
            EXPECT_NEAR(image(x, y, 0), picture(x, y, 0), isMade(x, y) ? 1e-5 : 0);
}

TEST(Tone, whatElseLiesAtTheBorderDoesNotStain) {
    Image picture = constant(kPicture, 1, 0.5F);
    picture(10, 7, 0) = 1; // 1 of the 14 pixels along the border
    Image image = picture;
    PositionMap map(kPicture, {kPicture});
    for (int y = 8; y < 11; ++y)
        for (int x = 9; x < 13; ++x)
            map.at(x, y) = shiftedBy(x, y, 0, 8);
    const std::vector<PatchSource> sources{{picture.view(), {}, 1}};
    const std::vector<std::uint8_t> made = madePixels();
    evenTone({sources, made, {}}, map, image, [](double) {});
    for (int y = 8; y < 11; ++y)
        for (int x = 9; x < 13; ++x)
            EXPECT_NEAR(image(x, y, 0), 0.5F, 0.01);
}

} // namespace
} // namespace texloom::test::fill_tests
