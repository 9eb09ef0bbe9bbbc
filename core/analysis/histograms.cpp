#include "core/analysis/histograms.h"

#include "core/math/pca.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom {

namespace {

constexpr int kHistogramPatch = 8;
constexpr int kHistogramPatches = 6000;
/// Patches that the principal axes are learnt from.
constexpr int kHistogramLearnt = 1500;
constexpr int kHistogramChannels = 3;

/// Counts values into bins.
class Counter {
public:
    Counter(double low, double high, int bins)
        : m_low(low), m_scale(bins / std::max(1e-12, high - low)), m_shares(static_cast<std::size_t>(bins)) {}

    void add(double value) {
        const double bin = std::floor((value - m_low) * m_scale);
        const double last = static_cast<double>(m_shares.size()) - 1;
        m_shares[static_cast<std::size_t>(std::clamp(bin, 0.0, last))] += 1;
        m_count += 1;
    }
    std::vector<double> shares() const {
        std::vector<double> all = m_shares;
        for (double& share : all)
            share /= std::max(1.0, m_count);
        return all;
    }

private:
    double m_low, m_scale;
    double m_count = 0;
    std::vector<double> m_shares;
};

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

void takeRange(const PlaneView& plane, Range& range, const JobContext& context) {
    for (int y = 0; y < plane.height; ++y) {
        context.check();
        for (int x = 0; x < plane.width; ++x)
            range.take(static_cast<double>(plane(x, y)));
    }
}

void count(const PlaneView& plane, Counter& counter, const JobContext& context) {
    for (int y = 0; y < plane.height; ++y) {
        context.check();
        for (int x = 0; x < plane.width; ++x)
            counter.add(static_cast<double>(plane(x, y)));
    }
}

/// Patches at random places of the images, one after another.
std::vector<double> patches(std::span<const ImageView> images, int channels, std::uint32_t stream,
                            const JobContext& context) {
    std::vector<double> values;
    for (int n = 0; n < kHistogramPatches; ++n) {
        if (n % 256 == 0)
            context.check();
        const auto draw = [&](int limit, int which) {
            return static_cast<int>(
                context.random().below(static_cast<std::uint32_t>(limit), n, which, stream));
        };
        const int number = draw(static_cast<int>(images.size()), 0);
        const ImageView& image = images[static_cast<std::size_t>(number)];
        const int left = draw(image.width - kHistogramPatch + 1, 1),
                  top = draw(image.height - kHistogramPatch + 1, 2);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < kHistogramPatch; ++y)
                for (int x = 0; x < kHistogramPatch; ++x)
                    values.push_back(static_cast<double>(image(left + x, top + y, c)));
    }
    return values;
}

std::vector<double> projected(const std::vector<double>& vectors, const PrincipalAxes& axes, int index) {
    const auto length = static_cast<std::size_t>(axes.dimension);
    const std::span<const double> axis = axes.axis(index);
    std::vector<double> values;
    for (std::size_t begin = 0; begin < vectors.size(); begin += length) {
        double sum = 0;
        for (std::size_t i = 0; i < length; ++i)
            sum += (vectors[begin + i] - axes.mean[i]) * axis[i];
        values.push_back(sum);
    }
    return values;
}

HistogramPair pairOf(const std::vector<double>& exemplar, const std::vector<double>& result, int bins) {
    Range range;
    for (const auto* values : {&exemplar, &result})
        for (const double value : *values)
            range.take(value);
    const auto shares = [&](const std::vector<double>& values) {
        Counter counter(range.low, range.high, bins);
        for (const double value : values)
            counter.add(value);
        return counter.shares();
    };
    return {range.low, range.high, shares(exemplar), shares(result)};
}

} // namespace

double HistogramPair::distance() const {
    double sum = 0;
    for (std::size_t i = 0; i < exemplar.size(); ++i)
        sum += std::abs(result[i] - exemplar[i]);
    return sum / 2;
}

std::vector<HistogramPair> colorHistograms(const ImageView& result, std::span<const ImageView> exemplars,
                                           int bins, JobContext& context) {
    std::vector<HistogramPair> pairs;
    for (int c = 0; c < result.channels; ++c) {
        Range range;
        takeRange(result.plane(c), range, context);
        for (const ImageView& exemplar : exemplars)
            takeRange(exemplar.plane(c), range, context);
        Counter theirs(range.low, range.high, bins), own = theirs;
        count(result.plane(c), own, context);
        for (const ImageView& exemplar : exemplars)
            count(exemplar.plane(c), theirs, context);
        pairs.push_back({range.low, range.high, theirs.shares(), own.shares()});
        context.progress((c + 1.0) / result.channels);
    }
    return pairs;
}

std::vector<HistogramPair> componentHistograms(const ImageView& result, std::span<const ImageView> exemplars,
                                               int bins, JobContext& context) {
    const auto tooSmall = [](const ImageView& image) { return image.size().shorterSide() < kHistogramPatch; };
    if (tooSmall(result) || std::any_of(exemplars.begin(), exemplars.end(), tooSmall))
        return {};
    const int channels = std::min(result.channels, kHistogramChannels);
    const int dimension = kHistogramPatch * kHistogramPatch * channels;
    const std::vector<double> theirs = patches(exemplars, channels, 0, context);
    const std::vector<double> own = patches({&result, 1}, channels, 1, context);
    context.progress(0.4);
    const auto learnt = static_cast<std::size_t>(kHistogramLearnt) * static_cast<std::size_t>(dimension);
    const PrincipalAxes axes = principalAxes(std::span(theirs).first(learnt), dimension, 2);
    context.check();
    std::vector<HistogramPair> pairs;
    for (int i = 0; i < axes.count(); ++i)
        pairs.push_back(pairOf(projected(theirs, axes, i), projected(own, axes, i), bins));
    context.progress(1);
    return pairs;
}

} // namespace texloom
