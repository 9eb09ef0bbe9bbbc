#pragma once

#include "core/image/image.h"
#include "core/job/job_context.h"
#include "core/math/matching_pursuit.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// The square patches of an image on a grid, as columns of values, and pictures put together from such
/// columns: Π, Π⁺ and Π_NL⁺ of Tartavel, Gousseau & Peyré (2013), sections 2 and 4.1. A column has the values
/// of the first channel row by row, then those of the next.
///
/// On an axis that wraps patches are periodic and divide the length evenly, at most `spacing` apart. On
/// another they lie `spacing` apart, and one more ends with the border.
class PatchColumns {
public:
    /// Writes column `number`.
    using Make = std::function<void(int number, Eigen::Ref<Eigen::VectorXf> to)>;

    /// @param size at least `patch` on axes that do not wrap. @param spacing at most `patch`.
    PatchColumns(Size size, Wrap wrap, int patch, int spacing);

    int patch() const { return m_patch; }
    int count() const { return static_cast<int>(m_xs.size() * m_ys.size()); }
    static int countFor(Size size, Wrap wrap, int patch, int spacing);
    int length(int channels) const { return channels * m_patch * m_patch; }
    /// ρ: how many patches lie over a pixel.
    int covering(int x, int y) const {
        return m_coverX[static_cast<std::size_t>(x)] * m_coverY[static_cast<std::size_t>(y)];
    }
    /// The largest ρ.
    int mostCovering() const;

    /// Π(u). The image must outlive what is returned.
    SignalSource of(const Image& image) const;
    /// Π⁺(P): every pixel the mean of the patches over it. @param to has the grid's size.
    void average(const Make& make, JobContext& context, Image& to) const;
    /// Π_NL⁺(P): patches are joined along cuts (see seamPath()), each with those before it in its row, then
    /// each row with those above it along cuts over the full width. @param delta of the cuts.
    void cut(const Make& make, float delta, JobContext& context, Image& to) const;

    /// Bytes that average() and cut() take.
    static std::uint64_t joinBytes(Size size, int channels, int patch, int spacing);

private:
    Image averagedRow(int row, int channels, const Make& make) const;
    Image cutRow(int row, int channels, float delta, const Make& make) const;
    std::vector<Image> strips(JobContext& context, const std::function<Image(int row)>& make) const;

    Size m_size;
    Wrap m_wrap;
    int m_patch;
    std::vector<int> m_xs, m_ys;         ///< where patches begin
    std::vector<int> m_coverX, m_coverY; ///< how many patches lie over each column and row
};

} // namespace texloom
