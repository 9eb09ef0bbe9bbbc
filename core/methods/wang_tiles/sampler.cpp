#include "core/methods/wang_tiles/sampler.h"

#include "core/base/at.h"
#include "core/match/whole_patches.h"
#include "core/math/zoom.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace texloom::wang_tiles {

namespace {

/// One of so many draws is of all samples.
constexpr int kWhole = 4;
/// How often a sample is drawn that does not suit the others.
constexpr int kRedraws = 32;
/// Samples of which the median liveliness is usual, and how many times more or less lively others may be.
constexpr int kUsual = 64;
constexpr double kMoreLively = 1.5;
/// The share of all samples whose marks are weak enough.
constexpr double kWeaklyMarked = 0.15;
/// Marks are as large as a blur of this deviation leaves them, as a share of a tile's side.
constexpr double kMark = 1.0 / 24;

/// The error of two unlike pixels: twice the variance over all channels and exemplars.
double unlikeError(const Request& request, JobContext& context) {
    const auto check = [&] { context.check(); };
    return 2 *
           pixelVariance(patchSources(request), channelMeans(*request.exemplars.front().image, check), check);
}

/// How far two places lie apart, as the larger of the distances on the axes.
int apart(const PatchPosition& a, const PatchPosition& b) {
    return a.exemplar == b.exemplar ? std::max(std::abs(a.x - b.x), std::abs(a.y - b.y))
                                    : std::numeric_limits<int>::max();
}

double squaredDistance(const Image& image, int x, int y, const std::vector<double>& colour) {
    double sum = 0;
    for (int c = 0; c < image.channels(); ++c) {
        const double difference = static_cast<double>(image(x, y, c)) - colour[at(c)];
        sum += difference * difference;
    }
    return sum;
}

/// The value that this share of all is below.
double quantile(std::vector<double> values, double share) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

} // namespace

SamplePlaces::SamplePlaces(const Request& request, int side, JobContext& context) {
    for (const Exemplar& exemplar : request.exemplars) {
        Own own{{exemplar.image->width() - side + 1, exemplar.image->height() - side + 1}, {}, 0};
        if (exemplar.mask())
            anyWholePatch(
                exemplar.mask()->view().plane(0), side,
                [&](int x, int y) {
                    own.allowed.push_back({0, x, y});
                    return false;
                },
                [&] { context.check(); });
        const auto count = exemplar.mask() ? static_cast<double>(own.allowed.size())
                                           : static_cast<double>(own.positions.area());
        m_whole += count * exemplar.weight;
        own.until = m_whole;
        m_exemplars.push_back(std::move(own));
    }
}

PatchPosition SamplePlaces::drawn(const Random& random, int x, int y, std::uint32_t n) const {
    const double wanted = random.uniform(x, y, n) * m_whole;
    std::size_t e = 0;
    while (e + 1 < m_exemplars.size() && wanted >= m_exemplars[e].until)
        ++e;
    const Own& own = m_exemplars[e];
    PatchPosition position;
    if (!own.allowed.empty())
        position = own.allowed[random.below(static_cast<std::uint32_t>(own.allowed.size()), x, y, n + 1)];
    else {
        position.x =
            static_cast<int>(random.below(static_cast<std::uint32_t>(own.positions.width), x, y, n + 1));
        position.y =
            static_cast<int>(random.below(static_cast<std::uint32_t>(own.positions.height), x, y, n + 2));
    }
    position.exemplar = static_cast<int>(e);
    return position;
}

Sampler::Sampler(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_places(request, sampleSide(settings), context),
      m_means(channelMeans(*request.exemplars.front().image, [&] { context.check(); })),
      m_unlike(unlikeError(request, context)), m_apart(m_settings.tile / 2) {
    if (settings.match == Match::Edges)
        return;
    for (const Size& size : request.exemplarSizes())
        m_apart = std::min(m_apart, (size.shorterSide() - sampleSide(settings) + 1) / (2 * settings.colours));
    for (const Exemplar& exemplar : request.exemplars)
        m_blurred.push_back(
            blurred(exemplar.image->view(), kMark * settings.tile, {}, [&] { context.check(); }));
    std::vector<double> lively, marked;
    for (int i = 0; i < kUsual; ++i) {
        context.check();
        const PatchPosition sample = m_places.drawn(context.random(), -1, kUsual + i, 0);
        lively.push_back(liveliness(sample));
        marked.push_back(strongestMark(sample));
    }
    m_usual = quantile(lively, 0.5);
    m_mostMarked = quantile(marked, kWeaklyMarked);
}

/// Visits pixels where tiles show the sample: around their corner and along their edges.
template <class Visit> void Sampler::forShown(const PatchPosition& sample, Visit visit) const {
    const int reach = reachOf(m_settings), depth = depthOf(m_settings), step = std::max(1, depth / 8);
    for (int dy = -reach; dy < reach; dy += step)
        for (int dx = -reach; dx < reach; dx += step)
            if (std::min(std::abs(dx), std::abs(dy)) < depth)
                visit(sample.x + reach + dx, sample.y + reach + dy);
}

/// The mean square of the distance from the exemplar's mean.
double Sampler::liveliness(const PatchPosition& sample) const {
    const Image& image = *m_request.exemplars[static_cast<std::size_t>(sample.exemplar)].image;
    double sum = 0;
    int count = 0;
    forShown(sample, [&](int x, int y) {
        sum += squaredDistance(image, x, y, m_means);
        ++count;
    });
    return sum / count;
}

/// The largest square of the blurred exemplar's distance from its mean.
double Sampler::strongestMark(const PatchPosition& sample) const {
    const Image& image = m_blurred[static_cast<std::size_t>(sample.exemplar)];
    double most = 0;
    forShown(sample, [&](int x, int y) { most = std::max(most, squaredDistance(image, x, y, m_means)); });
    return most;
}

Samples Sampler::draw(double weight, const std::function<double(const Samples&)>& worstError) {
    m_context.stage(weight, TR("Cutting tiles"));
    Samples best;
    for (int n = 0; n < m_settings.tries; ++n) {
        Samples samples = n * kWhole < m_settings.tries ? drawn(n) : withAnother(best, n);
        ++m_tries;
        const double error = m_unlike > 0 ? worstError(samples) / m_unlike : 0;
        if (best.empty() || error < m_error) {
            m_error = error;
            best = std::move(samples);
        }
        m_context.progress(static_cast<double>(n + 1) / m_settings.tries);
        if (m_error <= m_settings.threshold)
            break;
    }
    return best;
}

Samples Sampler::drawn(int n) const {
    Samples samples;
    for (int i = 0; i < sampleCount(m_settings); ++i)
        samples.push_back(another(samples, n, i));
    return samples;
}

/// These samples but for one, each in its turn.
Samples Sampler::withAnother(Samples samples, int n) const {
    const int turn = n % sampleCount(m_settings);
    Samples others = samples;
    others.erase(others.begin() + turn);
    samples[at(turn)] = another(others, n, turn);
    return samples;
}

bool Sampler::suits(const PatchPosition& place, const Samples& others) const {
    const bool clear = std::all_of(others.begin(), others.end(), [&](const PatchPosition& other) {
        return apart(place, other) >= m_apart;
    });
    if (!clear)
        return false;
    const double own = liveliness(place);
    return own <= kMoreLively * m_usual && m_usual <= kMoreLively * own &&
           strongestMark(place) <= m_mostMarked;
}

// The tiling's numbers are drawn at places that are not negative.
PatchPosition Sampler::another(const Samples& others, int n, int i) const {
    const Random& random = m_context.random();
    if (m_settings.match == Match::Edges)
        return m_places.drawn(random, -1 - n, i / 2, 3 * static_cast<std::uint32_t>(i % 2));
    PatchPosition place;
    for (std::uint32_t k = 0; k < kRedraws; ++k) {
        place = m_places.drawn(random, -1 - n, i, 3 * k);
        if (suits(place, others))
            break;
    }
    return place;
}

} // namespace texloom::wang_tiles
