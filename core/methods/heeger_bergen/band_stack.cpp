#include "core/methods/heeger_bergen/band_stack.h"

#include <algorithm>

namespace texloom::heeger_bergen {

BandStack::BandStack(const SteerablePyramid& pyramid, JobContext& context)
    : m_pyramid(pyramid), m_context(context) {
    m_parts.push_back({0, kHigh, pyramid.spectrum(0)});
    for (int scale = 0; scale < pyramid.scales(); ++scale)
        for (int orientation = 0; orientation < pyramid.orientations(); ++orientation)
            m_parts.push_back({scale, orientation, pyramid.spectrum(scale)});
    m_parts.push_back({pyramid.scales(), kLow, pyramid.spectrum(pyramid.scales())});
    for (int scale = 0; scale <= pyramid.scales(); ++scale)
        m_spectra.push_back(pyramid.spectrum(scale));
}

/// The high residual needs the whole image's spectrum, which is then low-passed in place for the bands.
void BandStack::decompose(const PlaneView& image) {
    const auto check = [this] { m_context.check(); };
    m_pyramid.forward(0, image.data, m_spectra.front().data(), check);
    m_pyramid.takeHigh(m_spectra.front().data(), m_parts.front().spectrum.data(), check);
    m_pyramid.limit(0, m_spectra.front().data(), check);
    for (std::size_t scale = 0; scale + 1 < m_spectra.size(); ++scale) {
        check();
        m_pyramid.lower(static_cast<int>(scale), m_spectra[scale].data(), m_spectra[scale + 1].data(), check);
    }
}

void BandStack::analyse(const PlaneView& image, bool keep,
                        const std::function<void(int part, const PlaneSpan& plane)>& visit) {
    decompose(image);
    m_context.parallel(0, parts(), [&](int index) {
        const auto check = [this] { m_context.check(); };
        Part& part = m_parts[static_cast<std::size_t>(index)];
        const SteerablePyramid::Complex* whole = m_spectra[static_cast<std::size_t>(part.scale)].data();
        if (part.orientation >= 0)
            m_pyramid.takeBand(part.scale, part.orientation, whole, part.spectrum.data(), check);
        else if (part.orientation == kLow)
            std::copy_n(whole, part.spectrum.size(), part.spectrum.data());
        Image plane(m_pyramid.size(part.scale), 1);
        m_pyramid.backward(part.scale, part.spectrum.data(), plane.plane(0).data, check);
        visit(index, plane.plane(0));
        if (keep)
            m_pyramid.forward(part.scale, plane.plane(0).data, part.spectrum.data(), check);
    });
}

void BandStack::synthesise(const PlaneSpan& image) {
    const auto check = [this] { m_context.check(); };
    std::copy_n(m_parts.back().spectrum.data(), m_parts.back().spectrum.size(), m_spectra.back().data());
    for (int scale = m_pyramid.scales(); scale-- > 0;) {
        Spectrum& current = m_spectra[static_cast<std::size_t>(scale)];
        Spectrum& below = m_spectra[static_cast<std::size_t>(scale) + 1];
        std::fill_n(current.data(), current.size(), 0.0F);
        m_pyramid.limit(scale + 1, below.data(), check);
        m_pyramid.raise(scale, below.data(), current.data(), check);
        for (const Part& part : m_parts)
            if (part.scale == scale && part.orientation >= 0)
                m_pyramid.addBand(scale, part.orientation, part.spectrum.data(), current.data(), check);
    }
    m_pyramid.limit(0, m_spectra.front().data(), check);
    m_pyramid.addHigh(m_parts.front().spectrum.data(), m_spectra.front().data(), check);
    m_pyramid.backward(0, m_spectra.front().data(), image.data, check);
}

std::uint64_t BandStack::bytesFor(Size size, int scales, int orientations, int threads) {
    constexpr std::uint64_t kForThread = 1U << 20; // its stack, and what the allocator keeps for it
    const std::uint64_t plain = RealFft2d(size).spectrumSize() * sizeof(SteerablePyramid::Complex);
    const std::uint64_t spectrum = plain * 4 / 3 + (1U << 16);
    // One thread may plan a transform, which takes arrays to plan with, while all others are at their most.
    const std::uint64_t planning = threads > 1 ? 2 * plain : 0;
    return spectrum * static_cast<std::uint64_t>((scales > 0 ? orientations : 0) + 2) + planning +
           static_cast<std::uint64_t>(threads) *
               (Image::bytesFor(size, 1) + SampleRanks::bytesFor(size) + kForThread);
}

} // namespace texloom::heeger_bergen
