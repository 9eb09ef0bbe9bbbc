#include "core/analysis/layout_quality.h"

#include "core/analysis/correlation.h"
#include "core/analysis/correlation_peaks.h"
#include "core/analysis/lattice_rating.h"
#include "core/analysis/lattice_views.h"
#include "core/base/at.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace texloom {

namespace {

/// Squares whose use is counted, as a share of the exemplar's shorter side.
constexpr int kSquares = 8;

/// Variance of a sample about its channel's mean, the mean over channels and images.
double varianceOf(std::span<const ImageView> images, const std::function<void()>& check) {
    double squares = 0, count = 0;
    for (const ImageView& image : images) {
        const std::vector<double> means = channelMeans(image);
        for (int c = 0; c < image.channels; ++c)
            for (int y = 0; y < image.height; ++y) {
                check();
                const float* row = image.plane(c).row(y);
                for (int x = 0; x < image.width; ++x) {
                    const double difference = static_cast<double>(row[x]) - means[at(c)];
                    squares += difference * difference;
                }
            }
        count += static_cast<double>(image.size().area()) * image.channels;
    }
    return squares / count;
}

/// Sums of squared jumps over pairs of neighbours.
struct Jumps {
    double squares = 0, count = 0;

    /// @param p the neighbour whose source is continued by (dx, dy) to what should lie at (x, y).
    void add(const ImageView& result, std::span<const ImageView> exemplars, const Source& p, int dx, int dy,
             int x, int y) {
        if (!p.valid())
            return;
        const ImageView& exemplar = exemplars[p.exemplar];
        const int u = p.x + dx, v = p.y + dy;
        if (u < 0 || v < 0 || u >= exemplar.width || v >= exemplar.height)
            return;
        for (int c = 0; c < result.channels; ++c) {
            const double jump = static_cast<double>(result(x, y, c) - exemplar(u, v, c));
            squares += jump * jump;
        }
        count += result.channels;
    }
};

/// Sum of one channel over the square at (x, y).
double squareSum(const Image& image, int x, int y, int side) {
    double sum = 0;
    for (int v = y; v < std::min(y + side, image.height()); ++v)
        for (int u = x; u < std::min(x + side, image.width()); ++u)
            sum += static_cast<double>(image(u, v, 0));
    return sum;
}

} // namespace

ImageView middlePart(const ImageView& image) {
    constexpr int kMostSide = 512;
    const Size size{std::min(image.width, kMostSide), std::min(image.height, kMostSide)};
    return image.crop((image.width - size.width) / 2, (image.height - size.height) / 2, size);
}

double contrastKept(const ImageView& result, std::span<const ImageView> exemplars,
                    const std::function<void()>& check) {
    const double wanted = varianceOf(exemplars, check);
    return wanted > 0 ? std::sqrt(varianceOf({&result, 1}, check) / wanted) : 1;
}

double seamJump(const ImageView& result, std::span<const ImageView> exemplars, const PositionMap& map,
                const std::function<void()>& check) {
    Jumps jumps;
    for (int y = 0; y < map.height(); ++y) {
        check();
        for (int x = 0; x < map.width(); ++x) {
            const Source& here = map.at(x, y);
            if (x > 0) {
                jumps.add(result, exemplars, map.at(x - 1, y), 1, 0, x, y);
                jumps.add(result, exemplars, here, -1, 0, x - 1, y);
            }
            if (y > 0) {
                jumps.add(result, exemplars, map.at(x, y - 1), 0, 1, x, y);
                jumps.add(result, exemplars, here, 0, -1, x, y - 1);
            }
        }
    }
    const double unit = varianceOf(exemplars, check);
    return unit > 0 && jumps.count > 0 ? std::sqrt(jumps.squares / jumps.count / unit) : 0;
}

double mostUsedShare(const std::vector<Image>& occurrences) {
    double most = 0, whole = 0;
    for (const Image& image : occurrences) {
        const int side = std::max(1, image.size().shorterSide() / kSquares), step = std::max(1, side / 2);
        for (int y = 0; y < image.height(); y += step)
            for (int x = 0; x < image.width(); x += step)
                most = std::max(most, squareSum(image, x, y, side));
        whole += squareSum(image, 0, 0, image.size().longerSide());
    }
    return whole > 0 ? most / whole : 0;
}

double correlationApart(const ImageView& result, std::span<const ImageView> exemplars,
                        const std::function<void()>& check) {
    const Correlation own = autocorrelation(middlePart(result), check);
    std::vector<Correlation> theirs;
    int reach = own.size().shorterSide() / 2;
    for (const ImageView& exemplar : exemplars) {
        theirs.push_back(autocorrelation(middlePart(exemplar), check));
        reach = std::min(reach, theirs.back().size().shorterSide() / 2);
    }
    double squares = 0, count = 0;
    for (int dy = 0; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const double wanted =
                std::accumulate(theirs.begin(), theirs.end(), 0.0, [&](double sum, const Correlation& gamma) {
                    return sum + static_cast<double>(gamma.at(dx, dy));
                });
            const double apart =
                static_cast<double>(own.at(dx, dy)) - wanted / static_cast<double>(theirs.size());
            squares += apart * apart;
            ++count;
        }
    return std::sqrt(squares / count);
}

double latticeKept(const ImageView& result, const ImageView& exemplar, const Lattice& lattice,
                   const std::function<void()>& check) {
    constexpr double kFaint = 0.15; // here chance counts as much as the lattice
    const auto correlationIn = [&](const ImageView& image) {
        const Correlation gamma = autocorrelation(image, check);
        return rated(CorrelationPeaks(gamma, check, {}), lattice).correlation;
    };
    const ImageView made = middlePart(result), given = middlePart(exemplar);
    const double wanted = correlationIn(given);
    if (wanted > kFaint)
        return std::max(0.0, correlationIn(made) / wanted);
    const double inEdges = correlationIn(edgesOf(given, check));
    return inEdges > 0 ? std::max(0.0, correlationIn(edgesOf(made, check)) / inEdges) : 0;
}

} // namespace texloom
