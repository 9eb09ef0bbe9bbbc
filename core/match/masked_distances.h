#pragma once

#include "core/image/image.h"
#include "core/match/patch_source.h"
#include "core/math/fft.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace texloom {

/// Squared distances between a patch, of which some pixels count, and all patches of an exemplar:
/// D(m, n) = Σ M |P|² − 2 Γ(M P, I)(m, n) + Γ(M, |I|²)(m, n), with correlations by FFT. Where PatchDistances
/// prepares the last term for the few shapes of a growing output, here every patch may have a shape of its
/// own, as at the border of a hole.
class MaskedDistances {
public:
    /// @param source its image's shorter side is at least the patch; where its mask is 0, nothing is found.
    /// @param patch side in pixels. @param check called every few milliseconds; may throw.
    MaskedDistances(const PatchSource& source, int patch, const std::function<void()>& check);

    /// Number of patches in each direction; a patch is named by its top left pixel.
    Size positions() const { return m_positions; }
    bool allows(int x, int y) const { return m_allowed[index(x, y)] != 0; }
    /// Patches that the mask allows.
    std::int64_t allowed() const { return m_count; }

    /// Fills `distances` row by row, infinite where the mask forbids a patch. @param known patch × patch.
    /// @param counts one channel, patch × patch, 1 where a pixel counts and 0 elsewhere.
    void compute(const ImageView& known, const PlaneView& counts, std::vector<float>& distances,
                 const std::function<void()>& check) const;

    /// Divides distances by the contrast of the exemplar's patches, their variance beside its mean: where
    /// nothing fits well, the flattest patch has the least squared difference, whatever it shows, and holes
    /// would be filled with it (see ContrastBalance, whose growing outputs would fade).
    void balance(std::vector<float>& distances) const;

    static std::uint64_t bytesFor(Size exemplar, int channels);

private:
    using Complex = std::complex<float>;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_positions.width) +
               static_cast<std::size_t>(x);
    }
    void measureContrasts(const ImageView& image, const std::function<void()>& check);
    FftBuffer<Complex> spectrumOf(const FftBuffer<float>& image, int rows,
                                  const std::function<void()>& check) const;

    int m_patch;
    Size m_positions;
    RealFft2d m_fft;
    std::vector<double> m_means;
    std::vector<FftBuffer<Complex>> m_spectra; ///< of each channel, and of the sum of their squares
    std::vector<std::uint8_t> m_allowed;
    std::vector<float> m_contrasts; ///< by position: 1 for the mean
    std::int64_t m_count = 0;
};

} // namespace texloom
