#include "core/methods/patch_distribution/matcher.h"

#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::patch_distribution {

namespace {

/// Adam's usual rates, the second one faster, since scales have few iterations.
constexpr double kMeanKept = 0.9, kSquareKept = 0.99;
/// Wants that are as small a share of the reach are rounding, and hardly followed.
constexpr double kRounding = 1e-3;

/// Values with weights as as many values that count alike, by quantiles.
std::vector<float> resampled(std::vector<std::pair<float, double>> values) {
    std::sort(values.begin(), values.end());
    double whole = 0;
    for (const auto& [value, weight] : values)
        whole += weight;
    std::vector<float> all;
    double sum = values.front().second;
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double wanted = whole * (static_cast<double>(i) + 0.5) / static_cast<double>(values.size());
        while (sum < wanted && at + 1 < values.size())
            sum += values[++at].second;
        all.push_back(values[at].first);
    }
    return all;
}

} // namespace

Matcher::Matcher(std::span<const PatchSource> exemplars, Size size, Wrap wrap, const Settings& settings,
                 std::vector<double> reach, JobContext& context)
    : m_exemplars(exemplars.begin(), exemplars.end()), m_settings(settings), m_context(context),
      m_projection(size, wrap, settings.patch),
      m_padded(m_projection.padded(), exemplars.front().image.channels),
      m_numbers(m_projection.positions(), settings.directions), m_reach(std::move(reach)),
      m_means(size, m_padded.channels()), m_squares(size, m_padded.channels()),
      m_alike(std::all_of(exemplars.begin(), exemplars.end(),
                          [&](const PatchSource& one) { return one.weight == exemplars.front().weight; })) {
    for (const PatchSource& exemplar : m_exemplars) {
        m_context.check();
        m_images.emplace_back(exemplar.image);
        m_views.emplace_back(exemplar.image.size(), Wrap{}, settings.patch);
        std::vector<bool>& allowed = m_allowed.emplace_back();
        if (!exemplar.mask.data)
            continue;
        const Size positions = m_views.back().positions();
        allowed.assign(static_cast<std::size_t>(positions.area()), false);
        anyWholePatch(
            exemplar.mask, settings.patch,
            [&](int x, int y) {
                allowed[static_cast<std::size_t>(y) * static_cast<std::size_t>(positions.width) +
                        static_cast<std::size_t>(x)] = true;
                return false;
            },
            [&] { m_context.check(); });
    }
}

/// Normal vectors, made orthogonal as far as there is room for that, of length 1.
std::vector<float> Matcher::drawDirections(int number) const {
    const int length = m_padded.channels() * m_settings.patch * m_settings.patch;
    std::vector<std::vector<double>> directions;
    for (int k = 0; k < m_settings.directions; ++k) {
        m_context.check();
        std::vector<double> one;
        for (int i = 0; i < length; ++i)
            one.push_back(m_context.random().normal(i, number, static_cast<std::uint32_t>(k)));
        const int before = k % length;
        for (int j = k - before; j < k; ++j) {
            double product = 0;
            for (std::size_t i = 0; i < one.size(); ++i)
                product += one[i] * directions[static_cast<std::size_t>(j)][i];
            for (std::size_t i = 0; i < one.size(); ++i)
                one[i] -= product * directions[static_cast<std::size_t>(j)][i];
        }
        double squares = 0;
        for (const double value : one)
            squares += value * value;
        for (double& value : one)
            value /= std::sqrt(squares);
        directions.push_back(std::move(one));
    }
    std::vector<float> all;
    for (const auto& one : directions)
        for (const double value : one)
            all.push_back(static_cast<float>(value));
    return all;
}

/// How the exemplars' patches are distributed along a direction.
Histogram Matcher::wantedAlong(std::span<const float> direction, Workspace& work) const {
    std::vector<std::pair<float, double>> weighed;
    work.wanted.clear();
    std::vector<float> row;
    for (std::size_t e = 0; e < m_exemplars.size(); ++e) {
        const Size positions = m_views[e].positions();
        row.resize(static_cast<std::size_t>(positions.width));
        for (int y = 0; y < positions.height; ++y) {
            if (y % 32 == 0)
                m_context.check();
            m_views[e].projectRow(m_images[e], direction, y, row.data());
            for (std::size_t x = 0; x < row.size(); ++x) {
                if (!m_allowed[e].empty() && !m_allowed[e][static_cast<std::size_t>(y) * row.size() + x])
                    continue;
                if (m_alike)
                    work.wanted.push_back(row[x]);
                else
                    weighed.emplace_back(row[x], m_exemplars[e].weight);
            }
        }
    }
    if (!m_alike)
        work.wanted = resampled(std::move(weighed));
    const int count = static_cast<int>(work.wanted.size());
    return Histogram({work.wanted.data(), count, 1, count}, [this] { m_context.check(); });
}

/// Puts the ways of all patches along a direction in the place of their products. @return their mean square.
double Matcher::moveAlong(int k, std::span<const float> direction) {
    const auto work = m_pool.borrow([] { return Workspace{}; });
    const Histogram wanted = wantedAlong(direction, *work);
    const PlaneSpan numbers = m_numbers.plane(k);
    for (int y = 0; y < numbers.height; ++y) {
        if (y % 32 == 0)
            m_context.check();
        m_projection.projectRow(m_padded, direction, y, numbers.row(y));
    }
    Image moved({numbers.width, numbers.height}, 1);
    const auto everyRow = [&](const auto& visit) {
        for (int y = 0; y < numbers.height; ++y) {
            if (y % 32 == 0)
                m_context.check();
            visit(numbers.row(y), moved.plane(0).row(y));
        }
    };
    everyRow([&](const float* number, float* to) { std::copy_n(number, numbers.width, to); });
    const double square = wanted.match(moved.plane(0), work->ranks, [this] { m_context.check(); });
    everyRow([&](float* number, const float* to) {
        for (int x = 0; x < numbers.width; ++x)
            number[x] = to[x] - number[x];
    });
    return square;
}

/// One step of Adam towards what the patches over each pixel want of it.
void Matcher::move(Image& image, std::span<const float> directions, double pace) {
    ++m_moves;
    const double early = std::sqrt(1 - std::pow(kSquareKept, m_moves)) / (1 - std::pow(kMeanKept, m_moves));
    m_context.parallel(0, image.height(), [&](int y) {
        std::vector<float> wanted(static_cast<std::size_t>(image.width()));
        for (int c = 0; c < image.channels(); ++c) {
            std::fill(wanted.begin(), wanted.end(), 0.0F);
            m_projection.spreadRow(m_numbers, directions, c, image.channels(), y, wanted.data());
            const double reach = m_reach[static_cast<std::size_t>(c)];
            const auto rate = static_cast<float>(pace * early * reach);
            const auto least = static_cast<float>(kRounding * reach) + 1e-9F;
            float* row = image.plane(c).row(y);
            float* mean = m_means.plane(c).row(y);
            float* square = m_squares.plane(c).row(y);
            for (int x = 0; x < image.width(); ++x) {
                const float way =
                    wanted[static_cast<std::size_t>(x)] / static_cast<float>(m_projection.covering(x, y));
                mean[x] += static_cast<float>(1 - kMeanKept) * (way - mean[x]);
                square[x] += static_cast<float>(1 - kSquareKept) * (way * way - square[x]);
                row[x] += rate * mean[x] / (std::sqrt(square[x]) + least);
            }
        }
    });
}

double Matcher::step(Image& image, int number, double pace) {
    const std::vector<float> directions = drawDirections(number);
    const std::size_t length = directions.size() / static_cast<std::size_t>(m_settings.directions);
    m_context.parallel(0, image.height(), [&](int y) {
        for (int c = 0; c < image.channels(); ++c)
            std::copy_n(image.plane(c).row(y), image.width(), m_padded.plane(c).row(y));
    });
    m_projection.pad(m_padded);
    std::vector<double> squares(static_cast<std::size_t>(m_settings.directions));
    m_context.parallel(0, m_settings.directions, [&](int k) {
        squares[static_cast<std::size_t>(k)] = moveAlong(
            k, std::span<const float>(directions).subspan(static_cast<std::size_t>(k) * length, length));
    });
    move(image, directions, pace);
    double sum = 0;
    for (const double square : squares)
        sum += square / m_settings.directions;
    return sum;
}

std::uint64_t Matcher::bytesFor(std::span<const Size> exemplars, Size size, int channels,
                                const Settings& settings, int threads) {
    const Size padded{size.width + settings.patch, size.height + settings.patch};
    std::uint64_t bytes =
        3 * Image::bytesFor(padded, channels) + Image::bytesFor(padded, settings.directions) +
        static_cast<std::uint64_t>(threads) * (SampleRanks::bytesFor(padded) + Image::bytesFor(padded, 1));
    for (const Size& exemplar : exemplars)
        bytes += Image::bytesFor(exemplar, channels) +
                 static_cast<std::uint64_t>(exemplar.area()) * (1 + 64 * static_cast<std::uint64_t>(threads));
    return bytes;
}

} // namespace texloom::patch_distribution
