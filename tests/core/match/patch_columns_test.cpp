#include "core/match/patch_columns.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

namespace texloom::test {
namespace {

template <class Body> auto inJob(const Body& body, int threads = 2) {
    JobMonitor monitor;
    JobContext context(
        {3, threads, false}, [] { return false; }, monitor);
    context.stage(1, "testing");
    return body(context);
}

Eigen::MatrixXf columnsOf(const PatchColumns& grid, const Image& image) {
    const SignalSource source = grid.of(image);
    Eigen::MatrixXf columns(source.length, source.count);
    source.read(0, columns);
    return columns;
}

PatchColumns::Make fromColumns(const Eigen::MatrixXf& columns) {
    return [&columns](int number, Eigen::Ref<Eigen::VectorXf> to) { to = columns.col(number); };
}

Image joined(const PatchColumns& grid, const Eigen::MatrixXf& columns, Size size, int channels, bool cut,
             int threads = 2) {
    return inJob(
        [&](JobContext& context) {
            Image to(size, channels);
            if (cut)
                grid.cut(fromColumns(columns), 1e-4F, context, to);
            else
                grid.average(fromColumns(columns), context, to);
            return to;
        },
        threads);
}

constexpr Wrap kWraps[] = {{false, false}, {true, false}, {false, true}, {true, true}};
constexpr Size kSizes[] = {{24, 24}, {31, 40}, {53, 12}, {12, 29}};
struct Grid {
    int patch, spacing;
};
constexpr Grid kGrids[] = {{12, 6}, {12, 12}, {8, 3}, {7, 6}, {4, 1}};

template <class Visit> void forEveryGrid(const Visit& visit) {
    for (const Wrap wrap : kWraps)
        for (const Size size : kSizes)
            for (const Grid& grid : kGrids) {
                SCOPED_TRACE(testing::Message()
                             << size.width << " × " << size.height << ", wraps " << wrap.x << wrap.y
                             << ", patch " << grid.patch << " every " << grid.spacing);
                visit(PatchColumns(size, wrap, grid.patch, grid.spacing), size, grid);
            }
}

TEST(PatchColumns, coverEveryPixelNoMoreThanTheyMay) {
    forEveryGrid([](const PatchColumns& grid, Size size, const Grid& shape) {
        std::int64_t sum = 0;
        int most = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                EXPECT_GE(grid.covering(x, y), 1);
                most = std::max(most, grid.covering(x, y));
                sum += grid.covering(x, y);
            }
        EXPECT_EQ(most, grid.mostCovering());
        EXPECT_EQ(sum, static_cast<std::int64_t>(grid.count()) * shape.patch * shape.patch);
    });
}

TEST(PatchColumns, joiningAnImagesOwnPatchesGivesIt) {
    forEveryGrid([](const PatchColumns& grid, Size size, const Grid&) {
        const Image image = noise(size, 2);
        const Eigen::MatrixXf columns = columnsOf(grid, image);
        EXPECT_TRUE(samePixels(joined(grid, columns, size, 2, true), image));
        const Image mean = joined(grid, columns, size, 2, false);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                ASSERT_NEAR(mean(x, y, 1), image(x, y, 1), 1e-5);
    });
}

TEST(PatchColumns, averageIsTheAdjointOverTheCovering) {
    forEveryGrid([](const PatchColumns& grid, Size size, const Grid& shape) {
        // ⟨Π u, P⟩ = Σ ρ u Π⁺P for every u and P.
        const Image image = noise(size, 1, 2);
        const Eigen::MatrixXf own = columnsOf(grid, image);
        Eigen::MatrixXf other(own.rows(), own.cols());
        const Random random(9);
        for (Eigen::Index k = 0; k < other.cols(); ++k)
            for (Eigen::Index i = 0; i < other.rows(); ++i)
                other(i, k) = static_cast<float>(random.uniform(static_cast<int>(i), static_cast<int>(k)));
        const Image mean = joined(grid, other, size, 1, false);
        double sum = 0;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                sum += grid.covering(x, y) * static_cast<double>(image(x, y, 0)) *
                       static_cast<double>(mean(x, y, 0));
        const double wanted = (own.cast<double>().array() * other.cast<double>().array()).sum();
        EXPECT_NEAR(sum, wanted, 1e-4 * wanted) << shape.patch;
    });
}

TEST(PatchColumns, cutsTakeEveryPixelFromAPatchThatLiesOverIt) {
    // Patches of one value each: every pixel of the result is the number of a patch that covers it.
    forEveryGrid([](const PatchColumns& grid, Size size, const Grid& shape) {
        Eigen::MatrixXf numbers(shape.patch * shape.patch, grid.count());
        Image indices(size, 1);
        for (int k = 0; k < grid.count(); ++k)
            numbers.col(k).setConstant(static_cast<float>(k));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                indices(x, y, 0) = static_cast<float>(y * size.width + x);
        const Eigen::MatrixXf places = columnsOf(grid, indices);
        const Image result = joined(grid, numbers, size, 1, true);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const auto k = static_cast<Eigen::Index>(result(x, y, 0));
                ASSERT_LT(k, grid.count());
                EXPECT_TRUE((places.col(k).array() == indices(x, y, 0)).any()) << x << ", " << y;
            }
    });
}

TEST(PatchColumns, bitsDoNotDependOnThreads) {
    const Size size{61, 47};
    const PatchColumns grid(size, {true, false}, 12, 6);
    const Eigen::MatrixXf columns = Eigen::MatrixXf::Random(12 * 12 * 2, grid.count());
    for (const bool cut : {false, true})
        EXPECT_TRUE(
            samePixels(joined(grid, columns, size, 2, cut, 1), joined(grid, columns, size, 2, cut, 5)));
}

} // namespace
} // namespace texloom::test
