#include "core/network/descriptor_learning.h"
#include "core/network/descriptor_network.h"
#include "core/network/filter_banks.h"
#include "tests/core/network/network_job.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

/// Stripes of two directions.
Tensor stripedPicture(int side) {
    Tensor to(1, side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            to.row(0, y)[x] = static_cast<float>(0.5 + 0.25 * std::sin(0.8 * x) + 0.25 * std::sin(1.1 * y));
    return to;
}

TEST(DescriptorLearning, unitsFireOnThreeOfTenPatchesWithAMeanSquareOfOne) {
    NetworkJob job;
    const Tensor picture = stripedPicture(64);
    const LearningOptions options{{{8, 5}, {12, 3}}, 4000, 5};
    const Descriptor descriptor = learnDescriptor({&picture, 1}, options, job.context);
    EXPECT_EQ(descriptor.taps(), (std::vector<std::string>{"relu1", "relu2"}));
    Tensor input = picture;
    for (std::size_t i = 0; i < input.size(); ++i)
        input.data()[i] = (input.data()[i] - descriptor.offset) * descriptor.scale;
    const DescriptorNetwork network(descriptor, Pooling::Average, 0, 9);
    DescriptorNetwork::Workspace work;
    network.forward(input, Edges{}, work, job.context);
    for (int tap = 0; tap < 2; ++tap) {
        const Tensor& features = network.features(tap, work);
        for (int c = 0; c < features.channels(); ++c) {
            double square = 0;
            int fires = 0;
            for (std::size_t i = 0; i < features.area(); ++i) {
                const auto value = static_cast<double>(features.channel(c)[i]);
                square += value * value;
                fires += value > 0 ? 1 : 0;
            }
            EXPECT_NEAR(fires / static_cast<double>(features.area()), 0.3, 0.06);
            EXPECT_NEAR(square / static_cast<double>(features.area()), 1, 0.25);
        }
    }
}

TEST(DescriptorLearning, hasTheSameBitsForAnyNumberOfThreads) {
    const Tensor picture = stripedPicture(48);
    const LearningOptions options{{{6, 3}, {8, 3}}, 500, 3};
    NetworkJob one(1), four(4);
    const Descriptor a = learnDescriptor({&picture, 1}, options, one.context);
    const Descriptor b = learnDescriptor({&picture, 1}, options, four.context);
    EXPECT_EQ(a.model(), b.model());
}

TEST(DescriptorLearning, takesPicturesWithoutTexture) {
    NetworkJob job;
    Tensor picture(3, 20, 20);
    picture.clear();
    const Descriptor descriptor = learnDescriptor({&picture, 1}, {{{4, 3}}, 100, 2}, job.context);
    for (const float weight : descriptor.chains.front().front().filters.weights)
        EXPECT_TRUE(std::isfinite(weight));
}

TEST(OwnDescriptor, isTheNetworkOfItsRecipe) {
    const Descriptor own = Descriptor::from(ownDescriptor());
    EXPECT_EQ(own.parameters(), 155936U);
    EXPECT_EQ(own.licence, "CC0-1.0");
    EXPECT_EQ(own.model(), ownDescriptor());
}

TEST(FilterBanks, waveletsHaveMeanZeroAndPhasesAreOpposite) {
    const Descriptor wavelets = waveletDescriptor(1);
    const Filters& filters = wavelets.chains.front().front().filters;
    ASSERT_EQ(filters.outputs, 64) << "8 directions, 4 phases, 2 scales";
    for (int o = 0; o < filters.outputs; o += 4) {
        double sum = 0;
        for (int y = 0; y < filters.side; ++y)
            for (int x = 0; x < filters.side; ++x) {
                sum += static_cast<double>(filters.at(o, 0, y, x));
                EXPECT_NEAR(filters.at(o, 0, y, x), -filters.at(o + 2, 0, y, x), 1e-6);
            }
        EXPECT_NEAR(sum, 0, 1e-6);
    }
}

TEST(FilterBanks, seeAnyNumberOfChannels) {
    for (const int channels : {1, 2, 3, 7})
        for (const Descriptor& bank : {randomDescriptor(channels), waveletDescriptor(channels)})
            EXPECT_EQ(Descriptor::from(bank.model()).channels, channels);
}

} // namespace
} // namespace texloom::test
