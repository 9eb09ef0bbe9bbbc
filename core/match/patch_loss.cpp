#include "core/match/patch_loss.h"

#include "core/base/at.h"
#include "core/math/histogram.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

constexpr std::uint32_t kFirstDraw = 1U << 20U; ///< of the directions' numbers

/// The means of 2 × 2 pixels; an odd last row or column is left out.
Image meansOfFour(const ImageView& image) {
    Image half({image.width / 2, image.height / 2}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < half.height(); ++y)
            for (int x = 0; x < half.width(); ++x)
                half(x, y, c) = 0.25F * (image(2 * x, 2 * y, c) + image(2 * x + 1, 2 * y, c) +
                                         image(2 * x, 2 * y + 1, c) + image(2 * x + 1, 2 * y + 1, c));
    return half;
}

/// The transpose of meansOfFour(), added.
void addToFour(const Image& half, Image& image) {
    for (int c = 0; c < half.channels(); ++c)
        for (int y = 0; y < 2 * half.height(); ++y)
            for (int x = 0; x < 2 * half.width(); ++x)
                image(x, y, c) += 0.25F * half(x / 2, y / 2, c);
}

std::vector<float> unitVector(int length, int number, int k, const Random& random) {
    std::vector<double> values;
    double squares = 0;
    for (int i = 0; i < length; ++i) {
        values.push_back(random.normal(i, number, kFirstDraw + static_cast<std::uint32_t>(k)));
        squares += values.back() * values.back();
    }
    std::vector<float> vector;
    for (const double value : values)
        vector.push_back(static_cast<float>(value / std::sqrt(squares)));
    return vector;
}

} // namespace

PatchLoss::PatchLoss(const ImageView& exemplar, int patch, int levels, int directions)
    : m_patch(patch), m_directions(directions) {
    m_exemplars.emplace_back(exemplar);
    while (static_cast<int>(m_exemplars.size()) < levels &&
           m_exemplars.back().size().shorterSide() / 2 >= 2 * patch)
        m_exemplars.push_back(meansOfFour(m_exemplars.back()));
}

double PatchLoss::level(const Image& exemplar, const Image& picture, int number, double weight,
                        Image& gradient, JobContext& context) const {
    const int channels = picture.channels(), length = channels * m_patch * m_patch;
    const PatchProjection view(exemplar.size(), {}, m_patch), projection(picture.size(), {}, m_patch);
    const Size positions = projection.positions();
    Image ways(positions, m_directions);
    std::vector<std::vector<float>> directions(at(m_directions));
    std::vector<double> squares(at(m_directions));
    context.parallel(0, m_directions, [&](int k) {
        context.check();
        std::vector<float>& direction = directions[at(k)];
        direction = unitVector(length, number, k, context.random());
        Image wanted(view.positions(), 1);
        for (int y = 0; y < wanted.height(); ++y)
            view.projectRow(exemplar, direction, y, wanted.plane(0).row(y));
        Image moved(positions, 1);
        for (int y = 0; y < positions.height; ++y) {
            projection.projectRow(picture, direction, y, moved.plane(0).row(y));
            std::copy_n(moved.plane(0).row(y), positions.width, ways.plane(k).row(y));
        }
        SampleRanks ranks;
        squares[at(k)] = Histogram(wanted.view().plane(0)).match(moved.plane(0), ranks, [] {});
        for (int y = 0; y < positions.height; ++y)
            for (int x = 0; x < positions.width; ++x)
                ways(x, y, k) -= moved(x, y, 0);
    });
    std::vector<float> all;
    double sum = 0;
    for (int k = 0; k < m_directions; ++k) {
        all.insert(all.end(), directions[at(k)].begin(), directions[at(k)].end());
        sum += squares[at(k)] / m_directions;
    }
    const auto factor =
        static_cast<float>(2 * weight / (static_cast<double>(positions.area()) * m_directions));
    context.parallel(0, picture.height(), [&](int y) {
        std::vector<float> row(at(picture.width()));
        for (int c = 0; c < channels; ++c) {
            std::fill(row.begin(), row.end(), 0.0F);
            projection.spreadRow(ways, all, c, channels, y, row.data());
            for (int x = 0; x < picture.width(); ++x)
                gradient(x, y, c) += factor * row[at(x)];
        }
    });
    return sum;
}

double PatchLoss::evaluate(const ImageView& picture, int number, double weight, Image& gradient,
                           JobContext& context) const {
    std::vector<Image> pictures{Image(picture)};
    while (pictures.size() < m_exemplars.size() && pictures.back().size().shorterSide() / 2 >= 2 * m_patch)
        pictures.push_back(meansOfFour(pictures.back()));
    std::vector<Image> gradients;
    for (const Image& one : pictures)
        gradients.emplace_back(one.size(), one.channels());
    double sum = 0;
    const auto levels = static_cast<double>(pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        sum += level(m_exemplars[i], pictures[i], number * 8 + static_cast<int>(i), weight / levels,
                     gradients[i], context) /
               levels;
    for (std::size_t i = pictures.size(); --i > 0;)
        addToFour(gradients[i], gradients[i - 1]);
    for (int c = 0; c < gradient.channels(); ++c)
        for (int y = 0; y < gradient.height(); ++y)
            for (int x = 0; x < gradient.width(); ++x)
                gradient(x, y, c) += gradients.front()(x, y, c);
    return sum;
}

} // namespace texloom
