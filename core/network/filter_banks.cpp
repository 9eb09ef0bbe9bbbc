#include "core/network/filter_banks.h"

#include "core/base/text.h"
#include "core/job/random.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace texloom {

namespace {

constexpr std::uint64_t kBankSeed = 2017;

Descriptor begun(const char* name, const char* credit, int channels) {
    Descriptor descriptor;
    descriptor.name = name;
    descriptor.licence = "CC0-1.0";
    descriptor.credit = credit;
    descriptor.channels = channels;
    descriptor.offset = 0.5F;
    descriptor.scale = 4;
    descriptor.levels = 3;
    return descriptor;
}

/// Morlet's wavelet along a direction, with mean 0: exp(−r²/2σ²) (exp(iξs) − κ).
class Morlet {
public:
    Morlet(double angle, double deviation, double frequency)
        : m_angle(angle), m_deviation(deviation), m_frequency(frequency) {}

    /// The part of a phase at each pixel of a square, with an absolute sum of 1.
    std::vector<double> part(int side, double phase) const {
        const int radius = side / 2;
        std::complex<double> sum;
        double weights = 0;
        const auto every = [&](const auto& visit) {
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) {
                    const double x = i - radius, y = j - radius;
                    const double along = x * std::cos(m_angle) + y * std::sin(m_angle);
                    const double across = -x * std::sin(m_angle) + y * std::cos(m_angle);
                    // Longer than wide, so that directions are told apart.
                    visit(
                        std::exp(-(along * along + across * across / 2.25) / (2 * m_deviation * m_deviation)),
                        std::polar(1.0, m_frequency * along));
                }
        };
        every([&](double window, std::complex<double> wave) {
            sum += window * wave;
            weights += window;
        });
        std::vector<double> values;
        double absolute = 0;
        every([&](double window, std::complex<double> wave) {
            values.push_back((window * (wave - sum / weights) * std::polar(1.0, -phase)).real());
            absolute += std::abs(values.back());
        });
        for (double& value : values)
            value /= absolute;
        return values;
    }

private:
    double m_angle, m_deviation, m_frequency;
};

constexpr int kPhases = 4, kWaveletSide = 11, kShiftSide = 5;

/// Which channels a view of the picture mixes.
std::vector<std::vector<double>> viewsOf(int channels) {
    if (channels == 3)
        return {{0.4, 0.4, 0.2}, {0.7, -0.7, 0}, {-0.4, -0.4, 0.8}};
    std::vector<std::vector<double>> views;
    for (int c = 0; c < channels; ++c) {
        views.emplace_back(at(channels), 0.0);
        views.back()[at(c)] = 1;
    }
    return views;
}

/// Adds the filters of one view at one scale.
void addWavelets(const std::vector<double>& view, int directions, double deviation, double frequency,
                 Filters& to) {
    for (int d = 0; d < directions; ++d)
        for (int p = 0; p < kPhases; ++p) {
            const std::vector<double> part = Morlet(std::numbers::pi * d / directions, deviation, frequency)
                                                 .part(kWaveletSide, 2 * std::numbers::pi * p / kPhases);
            for (const double share : view)
                for (const double value : part)
                    to.weights.push_back(static_cast<float>(share * value));
            to.bias.push_back(0);
            ++to.outputs;
        }
}

/// Some of the channels at their place and at four places around it.
Filters shifts(int inputs, int first, int count) {
    constexpr int kPlaces[][2] = {{2, 2}, {4, 2}, {2, 4}, {4, 4}, {4, 0}};
    Filters filters = Filters::zero(count * static_cast<int>(std::size(kPlaces)), inputs, kShiftSide);
    int output = 0;
    for (const auto& [x, y] : kPlaces)
        for (int c = first; c < first + count; ++c)
            filters.at(output++, c, y, x) = 1;
    return filters;
}

} // namespace

Descriptor randomDescriptor(int channels) {
    using Kind = DescriptorLayer::Kind;
    constexpr int kFilters = 64;
    Descriptor descriptor =
        begun("random", "Filters drawn at random, after Ustyuzhaninov et al. 2017", channels);
    for (const int side : {3, 7, 11}) {
        Filters filters = Filters::zero(kFilters, channels, side);
        const double scale = 1 / std::sqrt(static_cast<double>(channels) * side * side);
        const Random random(kBankSeed, static_cast<std::uint32_t>(side));
        for (std::size_t i = 0; i < filters.weights.size(); ++i)
            filters.weights[i] = static_cast<float>(scale * random.normal(static_cast<int>(i), channels));
        const std::string name = "random" + std::to_string(side);
        descriptor.chains.push_back({{Kind::Convolution, name, std::move(filters)},
                                     {Kind::Rectifier, "", {}},
                                     {Kind::Tap, name, {}}});
    }
    return descriptor;
}

Descriptor waveletDescriptor(int channels) {
    using Kind = DescriptorLayer::Kind;
    Descriptor descriptor =
        begun("wavelet", "Rectified Morlet wavelets, after Brochard et al. 2022", channels);
    Filters wavelets = Filters::zero(0, channels, kWaveletSide);
    const auto views = viewsOf(channels);
    constexpr double kFine = 0.9, kCoarse = 1.8, kFrequency = 0.75 * std::numbers::pi * 0.9;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const int directions = v == 0 ? 8 : 4;
        addWavelets(views[v], directions, kCoarse, kFrequency / kCoarse, wavelets);
        if (v == 0)
            addWavelets(views[v], directions, kFine, kFrequency / kFine, wavelets);
    }
    const int outputs = wavelets.outputs;
    descriptor.chains.push_back({{Kind::Convolution, "wavelets", std::move(wavelets)},
                                 {Kind::Rectifier, "", {}},
                                 {Kind::Tap, "wavelets", {}},
                                 {Kind::Pool, "", {}},
                                 {Kind::Convolution, "shifts", shifts(outputs, 0, 4 * kPhases)},
                                 {Kind::Tap, "shifts", {}}});
    return descriptor;
}

} // namespace texloom
