#include "core/job/random.h"
#include "core/match/patch_proposals.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace texloom::test {

namespace {

/// A lattice whose patches have random matches in one exemplar.
struct Proposed {
    Proposed(Size canvas, int patch, int stride, int channels)
        : exemplar({30, 28}, channels), field(PatchLattice{canvas, patch, stride}.count()) {
        exemplar.load(noise({30, 28}, channels), 0, 0, {30, 28});
        proposals.images = {&exemplar};
        proposals.lattice = {canvas, patch, stride};
        proposals.field = &field;
        const Random random(4);
        for (int y = 0; y < field.size().height; ++y)
            for (int x = 0; x < field.size().width; ++x) {
                const auto columns = static_cast<std::uint32_t>(31 - patch);
                const auto rows = static_cast<std::uint32_t>(29 - patch);
                field.at(x, y).source = {static_cast<std::uint16_t>(random.below(columns, x, y, 0)),
                                         static_cast<std::uint16_t>(random.below(rows, x, y, 1)), 0};
                proposals.weights.push_back(static_cast<float>(0.1 + random.uniform(x, y, 2)));
            }
    }

    Interleaved exemplar;
    PatchField field;
    PatchProposals proposals;
};

/// What all patches propose for one pixel, found without any shortcut.
std::vector<double> meanAt(const Proposed& made, int x, int y) {
    const PatchLattice& lattice = made.proposals.lattice;
    std::vector<double> sum(static_cast<std::size_t>(made.exemplar.pixel), 0);
    double whole = 0;
    for (int row = 0; row < made.field.size().height; ++row)
        for (int column = 0; column < made.field.size().width; ++column)
            for (int v = 0; v < lattice.patch; ++v)
                for (int u = 0; u < lattice.patch; ++u) {
                    if ((column * lattice.stride + u) % lattice.canvas.width != x ||
                        (row * lattice.stride + v) % lattice.canvas.height != y)
                        continue;
                    const auto number = static_cast<std::size_t>(row * made.field.size().width + column);
                    const auto weight = static_cast<double>(made.proposals.weights[number]);
                    const Source& source = made.field.at(column, row).source;
                    whole += weight;
                    for (std::size_t c = 0; c < sum.size(); ++c)
                        sum[c] +=
                            weight * static_cast<double>(made.exemplar.at(source.x + u, source.y + v)[c]);
                }
    for (double& value : sum)
        value /= whole;
    return sum;
}

} // namespace

TEST(PatchProposals, meanIsThatOfAllPatchesRoundTheBorders) {
    for (const int channels : {1, 3, 5})
        for (const Size canvas : {Size{33, 27}, Size{8, 21}, Size{5, 3}}) {
            const Proposed made(canvas, 8, 2, channels);
            ProposalRow row(made.proposals);
            std::vector<float> pixels(static_cast<std::size_t>(canvas.width * made.exemplar.pixel));
            for (int y = 0; y < canvas.height; ++y) {
                row.mean(y, pixels.data());
                for (int x = 0; x < canvas.width; ++x)
                    for (int c = 0; c < channels; ++c)
                        ASSERT_NEAR(pixels[static_cast<std::size_t>(x * made.exemplar.pixel + c)],
                                    meanAt(made, x, y)[static_cast<std::size_t>(c)], 1e-5);
            }
        }
}

TEST(PatchProposals, nearestSourceShowsThePixel) {
    const Proposed made({40, 30}, 8, 2, 3);
    const ProposalRow row(made.proposals);
    // Pixels that one of the patches proposes are found again.
    std::vector<float> pixels(40 * 4);
    for (int x = 0; x < 40; ++x) {
        const Source& source = made.field.at(x / 2, 5).source;
        std::copy_n(made.exemplar.at(source.x + x % 2, source.y), 4, pixels.data() + 4 * x);
    }
    std::vector<Source> sources(40);
    row.nearest(10, pixels.data(), sources.data());
    for (int x = 0; x < 40; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(made.exemplar.at(sources[static_cast<std::size_t>(x)].x,
                                       sources[static_cast<std::size_t>(x)].y)[c],
                      pixels[static_cast<std::size_t>(4 * x + c)]);
}

TEST(PatchProposals, mediansOfBothSolversAgree) {
    const Proposed made({40, 30}, 8, 2, 3);
    ProposalRow row(made.proposals);
    std::vector<float> a(40 * 4), b(40 * 4);
    for (const int y : {0, 13, 29}) {
        row.median(y, ProposalRow::Solver::Weiszfeld, a.data());
        row.median(y, ProposalRow::Solver::DouglasRachford, b.data());
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_NEAR(a[i], b[i], 2e-3);
    }
}

TEST(ColorBalance, holdsBackWhatThereIsTooMuchOf) {
    Interleaved exemplar({10, 10}, 1), canvas({10, 10}, 1);
    for (int i = 0; i < 100; ++i) {
        exemplar.data[static_cast<std::size_t>(i)] = i < 50 ? 0.0F : 1.0F;
        canvas.data[static_cast<std::size_t>(i)] = i < 75 ? 0.0F : 1.0F;
    }
    ColorBalance balance({&exemplar}, 1);
    const float dark = 0, bright = 1;
    EXPECT_EQ(balance.factor(&dark), 1);
    balance.compare(canvas, {10, 10});
    EXPECT_FLOAT_EQ(balance.factor(&dark), 1 / 1.5F);
    EXPECT_EQ(balance.factor(&bright), 1);
}

} // namespace texloom::test
