#include "core/math/channel_pca.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texloom::test {
namespace {

Image projected(const ChannelPca& pca, const Image& image) {
    Image components(image.size(), pca.components());
    pca.project(image, channelMeans(image), 0, image.height(), components);
    return components;
}

/// Three channels of which the last is a mix of the others.
Image dependent(Size size) {
    Image image = blobs(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            image(x, y, 2) = 7 + 2 * image(x, y, 0) - image(x, y, 1);
    return image;
}

TEST(ChannelPca, componentsAreUncorrelatedWithVarianceOne) {
    const Image image = blobs({40, 50}, 4);
    const ChannelPca pca(channelCovariance(image));
    ASSERT_EQ(pca.components(), 4);
    const Eigen::MatrixXd covariance = channelCovariance(projected(pca, image));
    EXPECT_LT((covariance - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ChannelPca, wayBackGivesTheImage) {
    for (const Image& image : {blobs({40, 30}, 3), dependent({40, 30}), blobs({9, 9}, 1)}) {
        const ChannelPca pca(channelCovariance(image));
        Image back(image.size(), image.channels());
        pca.unproject(projected(pca, image), channelMeans(image), 0, image.height(), back);
        for (int c = 0; c < image.channels(); ++c)
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    ASSERT_NEAR(back(x, y, c), image(x, y, c), 1e-4);
    }
}

TEST(ChannelPca, leadingChannelsComeFirstAndTheOthersAddWhatTheyHaveBeyond) {
    Image image = blobs({40, 50}, 4);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 40; ++x)
            image(x, y, 3) = 5 - image(x, y, 0) + 0.5F * image(x, y, 1);
    const ChannelPca pca(channelCovariance(image), 2);
    EXPECT_EQ(pca.leadingComponents(), 2);
    ASSERT_EQ(pca.components(), 3);
    const Image components = projected(pca, image);
    const Eigen::MatrixXd covariance = channelCovariance(components);
    EXPECT_LT((covariance - Eigen::MatrixXd::Identity(3, 3)).cwiseAbs().maxCoeff(), 1e-3);
    Image other = image;
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 40; ++x)
            other(x, y, 2) = 0;
    Image unmoved(image.size(), 3);
    pca.project(other, channelMeans(image), 0, 50, unmoved);
    for (int c = 0; c < 2; ++c)
        EXPECT_NEAR(unmoved(7, 9, c), components(7, 9, c), 1e-5);
    Image back(image.size(), 4);
    pca.unproject(components, channelMeans(image), 0, 50, back);
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(back(11, 30, c), image(11, 30, c), 1e-4);
}

TEST(ChannelPca, leavesOutDirectionsWithoutVariance) {
    EXPECT_EQ(ChannelPca(channelCovariance(dependent({30, 30}))).components(), 2);
    EXPECT_EQ(ChannelPca(channelCovariance(constant({30, 30}, 3, 0.7F))).components(), 0);
}

} // namespace
} // namespace texloom::test
