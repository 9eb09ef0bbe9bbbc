#include "core/base/error.h"
#include "core/network/convolution.h"
#include "core/network/kernels_wide.h"
#include "core/network/pooling.h"
#include "tests/core/network/network_job.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace texloom::test {
namespace {

constexpr Padding kPaddings[] = {Padding::None, Padding::Zero, Padding::Reflect, Padding::Circular};

Filters normalFilters(int outputs, int inputs, int side, int seed) {
    Filters filters = Filters::zero(outputs, inputs, side);
    const Random random(static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < filters.weights.size(); ++i)
        filters.weights[i] = static_cast<float>(random.normal(static_cast<int>(i), 1));
    for (std::size_t i = 0; i < filters.bias.size(); ++i)
        filters.bias[i] = static_cast<float>(random.normal(static_cast<int>(i), 2));
    return filters;
}

/// What stands at place `i` of an axis; written independently of the library.
double valueBeyond(const Tensor& in, int c, int y, int x, Edges edges) {
    const auto place = [](int i, int n, Padding padding) {
        while (padding == Padding::Circular && i < 0)
            i += n;
        if (padding == Padding::Circular)
            return i % n;
        if (padding == Padding::Reflect && n == 1)
            return 0;
        while (padding == Padding::Reflect && (i < 0 || i >= n))
            i = i < 0 ? -i : 2 * (n - 1) - i;
        return i >= 0 && i < n ? i : -1;
    };
    const int v = place(y, in.height(), edges.y), u = place(x, in.width(), edges.x);
    return v < 0 || u < 0 ? 0 : static_cast<double>(in.row(c, v)[u]);
}

double directly(const Tensor& in, const Filters& filters, Edges edges, int o, int y, int x) {
    const int r = (filters.side - 1) / 2;
    const int left = edges.x == Padding::None ? 0 : r, top = edges.y == Padding::None ? 0 : r;
    auto sum = static_cast<double>(filters.bias[texloom::at(o)]);
    for (int c = 0; c < filters.inputs; ++c)
        for (int j = 0; j < filters.side; ++j)
            for (int i = 0; i < filters.side; ++i)
                sum += static_cast<double>(filters.at(o, c, j, i)) *
                       valueBeyond(in, c, y + j - top, x + i - left, edges);
    return sum;
}

TEST(Convolution, isTheSumOfItsDefinition) {
    NetworkJob job;
    ConvolutionBuffers buffers;
    for (const auto& [outputs, inputs, side] :
         {std::array{6, 3, 5}, {4, 2, 3}, {3, 5, 3}, {2, 1, 1}, {1, 2, 7}, {13, 3, 3}})
        for (const Padding px : kPaddings)
            for (const Padding py : {Padding::Circular, Padding::Reflect, Padding::None}) {
                const Tensor in = normalTensor(inputs, 11, 19, side);
                const Filters filters = normalFilters(outputs, inputs, side, outputs);
                Tensor out;
                Convolution(filters).forward(in, {px, py}, false, out, buffers, job.context);
                ASSERT_EQ(out.width(), px == Padding::None ? 19 - side + 1 : 19);
                ASSERT_EQ(out.height(), py == Padding::None ? 11 - side + 1 : 11);
                for (int o = 0; o < outputs; ++o)
                    for (int y = 0; y < out.height(); ++y)
                        for (int x = 0; x < out.width(); ++x)
                            ASSERT_NEAR(out.row(o, y)[x], directly(in, filters, {px, py}, o, y, x), 1e-4);
            }
}

TEST(Convolution, worksOnPicturesSmallerThanTheFilter) {
    NetworkJob job;
    ConvolutionBuffers buffers;
    const Filters filters = normalFilters(4, 1, 7, 1);
    for (const Padding padding : {Padding::Zero, Padding::Reflect, Padding::Circular}) {
        const Tensor in = normalTensor(1, 1, 2, 1);
        Tensor out;
        Convolution(filters).forward(in, Edges::all(padding), false, out, buffers, job.context);
        for (int x = 0; x < 2; ++x)
            EXPECT_NEAR(out.row(3, 0)[x], directly(in, filters, Edges::all(padding), 3, 0, x), 1e-4);
    }
    Tensor out;
    EXPECT_THROW(Convolution(filters).forward(normalTensor(1, 6, 9, 1), Edges::all(Padding::None), false, out,
                                              buffers, job.context),
                 Error);
}

/// ⟨g, A x⟩ = ⟨Aᵀ g, x⟩ for every pair: the transpose is the derivative of what is linear.
TEST(Convolution, gradientsAreItsTransposes) {
    NetworkJob job;
    ConvolutionBuffers buffers;
    for (const Padding px : kPaddings)
        for (const Padding py : kPaddings)
            for (const int side : {1, 3, 5}) {
                Filters filters = normalFilters(7, 3, side, 5);
                const Edges edges{px, py};
                const Tensor in = normalTensor(3, 9, 14, 2);
                std::fill(filters.bias.begin(), filters.bias.end(), 0.0F);
                const Convolution convolution(filters);
                Tensor out;
                convolution.forward(in, edges, false, out, buffers, job.context);
                const Tensor g = normalTensor(7, out.height(), out.width(), 3);
                Tensor back(3, 9, 14);
                back.clear();
                convolution.addGradient(g, edges, back, buffers, job.context);
                const double wanted = innerProduct(g, out);
                EXPECT_NEAR(innerProduct(back, in), wanted, 1e-3 + 1e-5 * std::abs(wanted));
                Filters byWeights = Filters::zero(7, 3, side);
                convolution.addWeightGradient(in, g, edges, byWeights, buffers, job.context);
                double sum = 0;
                for (std::size_t i = 0; i < filters.weights.size(); ++i)
                    sum +=
                        static_cast<double>(byWeights.weights[i]) * static_cast<double>(filters.weights[i]);
                EXPECT_NEAR(sum, wanted, 1e-3 + 1e-5 * std::abs(wanted));
            }
}

TEST(Convolution, gradientByTheBiasIsTheSum) {
    NetworkJob job;
    ConvolutionBuffers buffers;
    const Convolution convolution(normalFilters(2, 1, 3, 1));
    const Tensor g = normalTensor(2, 5, 6, 9);
    Filters gradient = Filters::zero(2, 1, 3);
    convolution.addWeightGradient(normalTensor(1, 5, 6, 4), g, Edges{}, gradient, buffers, job.context);
    double sum = 0;
    for (int i = 0; i < 30; ++i)
        sum += static_cast<double>(g.channel(1)[i]);
    EXPECT_NEAR(gradient.bias[1], sum, 1e-5);
}

TEST(Convolution, rectifiesAndGates) {
    NetworkJob job;
    ConvolutionBuffers buffers;
    const Convolution convolution(normalFilters(4, 2, 3, 1));
    const Tensor in = normalTensor(2, 8, 8, 1);
    Tensor plain, rectified;
    convolution.forward(in, Edges{}, false, plain, buffers, job.context);
    convolution.forward(in, Edges{}, true, rectified, buffers, job.context);
    Tensor gradient = normalTensor(4, 8, 8, 2);
    const Tensor before = gradient;
    gateGradient(rectified, gradient, job.context);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_EQ(rectified.data()[i], std::max(0.0F, plain.data()[i]));
        EXPECT_EQ(gradient.data()[i], plain.data()[i] > 0 ? before.data()[i] : 0);
    }
}

/// Whether the processor has the vectors of the wide kernels, whatever these say themselves.
bool hasWideVectors() {
#ifdef __x86_64__
    return __builtin_cpu_supports("avx2") != 0;
#else
    return false;
#endif
}

TEST(Kernels, haveTheSameBitsForAllWidths) {
    if (!hasWideVectors())
        GTEST_SKIP() << "skipped: this processor has no wide vectors";
    ASSERT_TRUE(hasWideKernels());
    const Tensor in = normalTensor(5, 20, 30, 1);
    const std::ptrdiff_t offsets[] = {0, 1, 2, 30, 31, 32, 60, 61, 62};
    for (const int block : kConvolutionBlocks) {
        const Tensor weights = normalTensor(1, 5 * 9, block, 2), bias = normalTensor(1, 1, block, 3);
        Tensor wide(block, 18, 30), plain(block, 18, 30);
        FlatConvolution what{in.data(),   600,         5,   offsets, 9,   weights.data(),
                             bias.data(), wide.data(), 540, 0,       472, block};
        convolveFlatWide(what);
        what.out = plain.data();
        convolveFlatPlain(what);
        for (int o = 0; o < block; ++o)
            EXPECT_TRUE(std::equal(wide.channel(o), wide.channel(o) + 472, plain.channel(o)));
    }
    std::vector<double> wide(25), plain(25);
    RowProducts products{in.data(), 600, 5, in.data(), 600, 5, 599, wide.data(), 5};
    addRowProductsWide(products);
    products.sums = plain.data();
    addRowProductsPlain(products);
    EXPECT_EQ(wide, plain);
    double sum = 0;
    for (int i = 0; i < 599; ++i)
        sum += static_cast<double>(in.channel(1)[i]) * static_cast<double>(in.channel(4)[i]);
    EXPECT_NEAR(wide[9], sum, 1e-4);
}

TEST(Pooling, takesMeansAndLargest) {
    NetworkJob job;
    const Tensor in = normalTensor(2, 5, 7, 1);
    for (const Pooling pooling : {Pooling::Average, Pooling::Maximum}) {
        Tensor out;
        pool(in, pooling, out, job.context);
        ASSERT_EQ(out.height(), 3);
        ASSERT_EQ(out.width(), 4);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 4; ++x) {
                std::vector<float> group;
                for (int v = 2 * y; v < std::min(5, 2 * y + 2); ++v)
                    for (int u = 2 * x; u < std::min(7, 2 * x + 2); ++u)
                        group.push_back(in.row(1, v)[u]);
                float sum = 0;
                for (const float value : group)
                    sum += value;
                const float wanted = pooling == Pooling::Average
                                         ? sum / static_cast<float>(group.size())
                                         : *std::max_element(group.begin(), group.end());
                EXPECT_NEAR(out.row(1, y)[x], wanted, 1e-6);
            }
        // Both are linear where nothing changes places: the transpose once more.
        const Tensor g = normalTensor(2, 3, 4, 5);
        Tensor back(2, 5, 7);
        back.clear();
        addPoolGradient(in, pooling, g, back, job.context);
        EXPECT_NEAR(innerProduct(back, in), innerProduct(g, out), 1e-4);
    }
}

TEST(Convolution, hasTheSameBitsForAnyNumberOfThreads) {
    const Tensor in = normalTensor(3, 70, 90, 1);
    const Convolution convolution(normalFilters(24, 3, 5, 1));
    std::vector<Tensor> outs(2), backs(2);
    std::vector<Filters> byWeights(2, Filters::zero(24, 3, 5));
    for (const int threads : {1, 4}) {
        NetworkJob job(threads);
        ConvolutionBuffers buffers;
        const std::size_t i = threads == 1 ? 0 : 1;
        convolution.forward(in, Edges{}, true, outs[i], buffers, job.context);
        backs[i].resize(3, 70, 90);
        backs[i].clear();
        convolution.addGradient(outs[i], Edges{}, backs[i], buffers, job.context);
        convolution.addWeightGradient(in, outs[i], Edges{}, byWeights[i], buffers, job.context);
    }
    EXPECT_TRUE(sameBits(outs[0], outs[1]));
    EXPECT_TRUE(sameBits(backs[0], backs[1]));
    EXPECT_EQ(byWeights[0].weights, byWeights[1].weights);
}

} // namespace
} // namespace texloom::test
