#include "core/network/texture_loss.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/network/colour_tap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom {

namespace {

constexpr int kLeastSide = 16;
/// Smooths the total variation where neighbours are alike, as a share of the exemplar's.
constexpr double kSmoothing = 0.05;

int mostPools(const Descriptor& descriptor) {
    std::ptrdiff_t most = 0;
    for (const auto& chain : descriptor.chains)
        most = std::max(most, std::count_if(chain.begin(), chain.end(), [](const DescriptorLayer& layer) {
                            return layer.kind == DescriptorLayer::Kind::Pool;
                        }));
    return static_cast<int>(most);
}

std::string levelName(const std::string& tap, int level) {
    return level == 0 ? tap : tap + " 1/" + std::to_string(1 << level);
}

/// The L1 norm, in a fixed order.
double absoluteSum(const Tensor& tensor) {
    double sum = 0;
    for (std::size_t i = 0; i < tensor.size(); ++i)
        sum += static_cast<double>(std::abs(tensor.data()[i]));
    return sum;
}

} // namespace

TextureLoss::TextureLoss(const Descriptor& descriptor, const TextureLossOptions& options,
                         std::span<const LossExemplar> exemplars, JobContext& context)
    : m_options(options),
      m_network(descriptor, options.pooling.value_or(descriptor.pooling), options.firstTap, options.lastTap),
      m_pictureChannels(exemplars.front().picture->channels()) {
    const int least = leastSide(descriptor, options.levels);
    for (const LossExemplar& exemplar : exemplars) {
        const Tensor& picture = *exemplar.picture;
        if (picture.channels() != 1 && picture.channels() != descriptor.channels)
            failUsage(TR("The descriptor {} sees {} channels, and the exemplar has {}."), descriptor.name,
                      descriptor.channels, picture.channels());
        if (std::min(picture.width(), picture.height()) < least)
            failUsage(TR("The exemplar of {}×{} px is too small for the network, which needs {} px a side."),
                      picture.width(), picture.height(), least);
    }
    m_offset.assign(at(descriptor.channels), descriptor.offset);
    m_scale.assign(at(descriptor.channels), descriptor.scale);
    setRange(exemplars);
    learn(exemplars, context);
}

/// Learns the values of each channel, and maps them to 0 to 1 for the network where they are not there yet.
void TextureLoss::setRange(std::span<const LossExemplar> exemplars) {
    m_smallest.assign(at(m_pictureChannels), std::numeric_limits<float>::infinity());
    m_largest.assign(at(m_pictureChannels), -std::numeric_limits<float>::infinity());
    for (const LossExemplar& exemplar : exemplars)
        for (int c = 0; c < m_pictureChannels; ++c) {
            const float* const from = exemplar.picture->channel(c);
            const auto [low, high] = std::minmax_element(from, from + exemplar.picture->area());
            m_smallest[at(c)] = std::min(m_smallest[at(c)], *low);
            m_largest[at(c)] = std::max(m_largest[at(c)], *high);
        }
    const float allLow = *std::min_element(m_smallest.begin(), m_smallest.end());
    const float allHigh = *std::max_element(m_largest.begin(), m_largest.end());
    const bool colours = m_network.channels() == 3;
    for (int k = 0; k < m_network.channels(); ++k) {
        const int c = m_pictureChannels == 1 ? 0 : k;
        const float low = colours ? allLow : m_smallest[at(c)], high = colours ? allHigh : m_largest[at(c)];
        if ((low >= 0 && high <= 1) || high <= low)
            continue;
        m_offset[at(k)] = low + m_offset[at(k)] * (high - low);
        m_scale[at(k)] /= high - low;
    }
}

/// The picture's values as the network wants them.
void TextureLoss::seen(const Tensor& picture, Tensor& to, JobContext& context) const {
    to.resize(m_network.channels(), picture.height(), picture.width());
    context.parallel(0, to.channels(), [&](int k) {
        const float* const from = picture.channel(m_pictureChannels == 1 ? 0 : k);
        float* const values = to.channel(k);
        const float offset = m_offset[at(k)], scale = m_scale[at(k)];
        for (std::size_t i = 0; i < picture.area(); ++i)
            values[i] = (from[i] - offset) * scale;
    });
}

void TextureLoss::fillLevels(const Tensor& picture, JobContext& context) {
    m_levels.resize(at(m_options.levels));
    seen(picture, m_levels.front().picture, context);
    for (std::size_t level = 1; level < m_levels.size(); ++level)
        pool(m_levels[level - 1].picture, Pooling::Average, m_levels[level].picture, context);
}

/// Learns what the exemplars' taps are.
void TextureLoss::learn(std::span<const LossExemplar> exemplars, JobContext& context) {
    std::vector<Tensor> pictures(exemplars.size());
    std::vector<const Tensor*> pointers;
    double whole = 0;
    for (std::size_t e = 0; e < exemplars.size(); ++e) {
        seen(*exemplars[e].picture, pictures[e], context);
        pointers.push_back(&pictures[e]);
        whole += exemplars[e].weight;
    }
    if (m_options.colours)
        if (const Descriptor colours = colourDescriptor(pointers); !colours.chains.empty())
            m_colours.emplace(colours, Pooling::Average, 0, 0);
    const std::size_t taps = m_network.taps().size(), count = taps * at(m_options.levels);
    std::vector<TapMoments> moments(count + (m_colours ? 1 : 0));
    m_variance.assign(at(m_pictureChannels), 0.0);
    const Edges edges = Edges::all(Padding::Reflect);
    for (const LossExemplar& exemplar : exemplars) {
        const double weight = exemplar.weight / whole;
        fillLevels(*exemplar.picture, context);
        for (std::size_t level = 0; level < m_levels.size(); ++level) {
            m_network.forward(m_levels[level].picture, edges, m_work, context);
            for (std::size_t t = 0; t < taps; ++t)
                moments[level * taps + t].add(
                    momentsOf(m_network.features(static_cast<int>(t), m_work), m_tapWork, context), weight);
        }
        if (m_colours) {
            m_colours->forward(m_levels.front().picture, edges, m_work, context);
            moments.back().add(momentsOf(m_colours->features(0, m_work), m_tapWork, context), weight);
        }
        const TapMoments own = momentsOf(*exemplar.picture, m_tapWork, context);
        for (int c = 0; c < m_pictureChannels; ++c)
            m_variance[at(c)] += weight * std::max(0.0, own.products(c, c) - own.means[c] * own.means[c]);
        m_exemplarVariation += weight * variation(*exemplar.picture, edges, nullptr, context);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const int level = static_cast<int>(i / taps);
        if (!moments[i].products.allFinite())
            fail(TR("The descriptor gives values that are not numbers at its tap {}: its weights are too "
                    "large."),
                 m_network.taps()[i % taps].name);
        m_targets.push_back({level, TapTarget(moments[i], m_options.statistic)});
        m_termNames.push_back(levelName(m_network.taps()[i % taps].name, level));
    }
    if (m_colours) {
        m_targets.push_back({0, TapTarget(moments.back(), Statistic::Normalised)});
        m_termNames.emplace_back("colours");
    }
    m_terms.assign(m_targets.size(), 0.0);
}

/// The terms of one network on one level, and their derivative by the level's picture.
double TextureLoss::networkTerms(const DescriptorNetwork& network, int level, std::size_t firstTerm,
                                 Edges edges, bool gradient, JobContext& context) {
    Level& on = m_levels[at(level)];
    network.forward(on.picture, edges, m_work, context);
    const double share = 1 / static_cast<double>(m_targets.size());
    double sum = 0;
    std::vector<TapMoments> moments;
    for (std::size_t t = 0; t < network.taps().size(); ++t) {
        moments.push_back(momentsOf(network.features(static_cast<int>(t), m_work), m_tapWork, context));
        m_terms[firstTerm + t] = share * m_targets[firstTerm + t].target.distance(moments.back());
        sum += m_terms[firstTerm + t];
    }
    if (!gradient)
        return sum;
    const auto addTapGradient = [&](int tap, Tensor& to) {
        const Tensor& features = network.features(tap, m_work);
        const Convolution mix(
            m_targets[firstTerm + at(tap)].target.gradientFilters(moments[at(tap)], features.area(), share));
        if (!m_options.evenGradients)
            return mix.add(features, to, m_tapWork.buffers, context);
        Tensor& own = m_tapWork.gradient;
        mix.forward(features, edges, false, own, m_tapWork.buffers, context);
        const double norm = absoluteSum(own);
        const auto scale = static_cast<float>(norm > 0 ? 1 / norm : 0);
        for (std::size_t i = 0; i < own.size(); ++i)
            to.data()[i] += scale * own.data()[i];
    };
    network.backward(on.picture, edges, m_work, addTapGradient, on.gradient, context);
    return sum;
}

double TextureLoss::evaluate(const Tensor& picture, Edges edges, Tensor* gradient, JobContext& context) {
    fillLevels(picture, context);
    for (Level& level : m_levels) {
        level.gradient.resize(level.picture.channels(), level.picture.height(), level.picture.width());
        level.gradient.clear();
    }
    const std::size_t taps = m_network.taps().size();
    double value = 0;
    for (int level = 0; level < m_options.levels; ++level)
        value += networkTerms(m_network, level, at(level) * taps, edges, gradient != nullptr, context);
    if (m_colours)
        value += networkTerms(*m_colours, 0, m_targets.size() - 1, edges, gradient != nullptr, context);
    if (gradient)
        toPicture(*gradient, context);
    value += rangePenalty(picture, gradient, context);
    if (m_options.variation > 0 && m_exemplarVariation > 0)
        value += m_options.variation * variation(picture, edges, gradient, context) / m_exemplarVariation;
    return value;
}

/// Brings the derivatives by all levels down to the picture's values.
void TextureLoss::toPicture(Tensor& gradient, JobContext& context) {
    for (std::size_t level = m_levels.size() - 1; level > 0; --level)
        addPoolGradient(m_levels[level - 1].picture, Pooling::Average, m_levels[level].gradient,
                        m_levels[level - 1].gradient, context);
    const Tensor& from = m_levels.front().gradient;
    gradient.resize(m_pictureChannels, from.height(), from.width());
    gradient.clear();
    for (int k = 0; k < from.channels(); ++k) {
        float* const to = gradient.channel(m_pictureChannels == 1 ? 0 : k);
        for (std::size_t i = 0; i < from.area(); ++i)
            to[i] += m_scale[at(k)] * from.channel(k)[i];
    }
}

/// The mean square of what lies beyond the exemplar's values, in units of its variance.
double TextureLoss::rangePenalty(const Tensor& picture, Tensor* gradient, JobContext& context) const {
    std::vector<double> sums(at(m_pictureChannels), 0.0);
    context.parallel(0, m_pictureChannels, [&](int c) {
        const float low = m_smallest[at(c)], high = m_largest[at(c)];
        const double unit = m_variance[at(c)] > 0
                                ? m_options.range / (m_variance[at(c)] * static_cast<double>(picture.size()))
                                : 0;
        double sum = 0;
        for (std::size_t i = 0; i < picture.area(); ++i) {
            const float value = picture.channel(c)[i];
            const float excess = value - std::clamp(value, low, high);
            sum += static_cast<double>(excess) * static_cast<double>(excess);
            if (gradient)
                gradient->channel(c)[i] += static_cast<float>(2 * unit) * excess;
        }
        sums[at(c)] = unit * sum;
    });
    double whole = 0;
    for (const double sum : sums)
        whole += sum;
    return whole;
}

/// The mean over all values of the smoothed length of the step to the next column and row.
double TextureLoss::variation(const Tensor& picture, Edges edges, Tensor* gradient,
                              JobContext& context) const {
    std::vector<double> sums(at(m_pictureChannels), 0.0);
    const double count = 1 / static_cast<double>(picture.size());
    const double scale = m_exemplarVariation > 0 ? m_options.variation * count / m_exemplarVariation : 0;
    const double soft = kSmoothing * kSmoothing * m_exemplarVariation * m_exemplarVariation;
    const int width = picture.width(), height = picture.height();
    context.parallel(0, m_pictureChannels, [&](int c) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const int right = x + 1 < width ? x + 1 : edges.x == Padding::Circular ? 0 : x;
                const int below = y + 1 < height ? y + 1 : edges.y == Padding::Circular ? 0 : y;
                const auto here = static_cast<double>(picture.row(c, y)[x]);
                const double dx = static_cast<double>(picture.row(c, y)[right]) - here;
                const double dy = static_cast<double>(picture.row(c, below)[x]) - here;
                const double length = std::sqrt(dx * dx + dy * dy + soft);
                sums[at(c)] += length;
                if (!gradient || length == 0)
                    continue;
                const double pull = scale / length;
                gradient->row(c, y)[right] += static_cast<float>(pull * dx);
                gradient->row(c, below)[x] += static_cast<float>(pull * dy);
                gradient->row(c, y)[x] -= static_cast<float>(pull * (dx + dy));
            }
    });
    double whole = 0;
    for (const double sum : sums)
        whole += sum;
    return whole * count;
}

int TextureLoss::leastSide(const Descriptor& descriptor, int levels) {
    return std::max(kLeastSide, 1 << (mostPools(descriptor) + levels - 1));
}

std::uint64_t TextureLoss::bytesFor(const Descriptor& descriptor, const TextureLossOptions& options,
                                    std::uint64_t pixels, int threads) {
    const DescriptorNetwork network(descriptor, Pooling::Average, options.firstTap, options.lastTap);
    constexpr std::uint64_t kColours = 12 * std::size_t{6}, kTensors = 4;
    const std::uint64_t colours = options.colours ? kTensors * kColours * 4 * pixels : 0;
    return network.bytesFor(pixels, threads) + colours + 12 * at(descriptor.channels) * pixels +
           6 * 4 * descriptor.parameters();
}

double TextureLoss::secondsFor(const Descriptor& descriptor, const TextureLossOptions& options,
                               double pixels) {
    constexpr double kColourOperations = 4 * 72.0 * 72, kOperationsASecond = 1.5e10;
    const DescriptorNetwork network(descriptor, Pooling::Average, options.firstTap, options.lastTap);
    const double levels = (1 - std::pow(0.25, options.levels)) / 0.75;
    return pixels * (2 * levels * network.operationsPerPixel() + (options.colours ? kColourOperations : 0)) /
           kOperationsASecond;
}

} // namespace texloom
