#pragma once

#include "core/image/image.h"
#include "core/math/fft.h"

#include <functional>
#include <vector>

namespace texloom {

/// The widths in pixels of the borders on which a square patch overlaps existing pixels; 0 where it does not.
/// The vertical, horizontal and L-shaped overlaps of Raad & Galerne (IPOL 2017, fig. 2) are {left}, {top} and
/// {left, top}; outputs that wrap close with right and bottom borders too.
struct Overlap {
    int left = 0, top = 0, right = 0, bottom = 0;

    bool none() const { return left == 0 && top == 0 && right == 0 && bottom == 0; }
    bool contains(int x, int y, int patch) const {
        return x < left || y < top || x >= patch - right || y >= patch - bottom;
    }
    friend auto operator<=>(const Overlap&, const Overlap&) = default;
};

/// The pixels of a patch on which it is compared: Q of the source's eq. 1.
struct Footprint {
    /// All of an overlap counts.
    Footprint(const Overlap& overlap) : border(overlap) {}
    /// The top left `pixels` of the patch count, known and unknown alike: for comparing with an initial
    /// image.
    static Footprint filled(Size pixels) {
        Footprint footprint(Overlap{pixels.width, 0, 0, 0});
        footprint.area = pixels;
        return footprint;
    }

    bool contains(int x, int y, int patch) const {
        return x < area.width && y < area.height && border.contains(x, y, patch);
    }
    /// How many pixels of the patch count.
    int pixels(int patch) const;
    friend bool operator==(const Footprint&, const Footprint&) = default;

    Overlap border;
    Size area{1 << 30, 1 << 30}; ///< nothing beyond it counts
};

/// How far distances are normalised by the contrast of the exemplar's patch. Where nothing fits well, the
/// flattest patch has the least squared difference, whatever it shows, and outputs grown that way fade. So
/// distances are divided by the patch's own contrast on the compared pixels, which penalises too much
/// contrast and too little equally.
struct ContrastBalance {
    double share = 0;    ///< from 0, squared differences as they are, to 1, divided by the contrast
    double variance = 0; ///< of an exemplar's pixel about its mean, over all channels: the unit of contrast
};

/// Squared distances between a partly known patch and all patches of an exemplar:
/// D(m, n) = ‖P‖² − 2 Γ(P, I₀)(m, n) + Γ(Q, I₀²)(m, n) (Raad & Galerne, IPOL 2017, eq. 5), with one
/// correlation by FFT. The exemplar's spectrum is computed once; Γ(Q, I₀²) comes from a summed-area table,
/// once for each shape Q. All values are taken relative to `means`, which does not change D and keeps
/// rounding errors small. One object serves any number of threads, each with its own Scratch.
class PatchDistances {
public:
    /// Working memory of one thread.
    struct Scratch {
        FftBuffer<float> patch;                              ///< one channel, zero outside Q
        std::vector<FftBuffer<std::complex<float>>> spectra; ///< one per channel
        FftBuffer<float> distances;                          ///< see distanceRow()
        std::vector<float> rowMinima;                        ///< no distance in a row is smaller
    };

    /// @param mask one channel of the exemplar's size, or {}: patches with a pixel where it is 0 are at
    /// infinite distance.
    /// @param means one per channel. @param patch side in pixels, at most the exemplar's shorter side.
    PatchDistances(const ImageView& exemplar, const PlaneView& mask, std::vector<double> means, int patch,
                   const ContrastBalance& balance = {});

    /// Number of patches in each direction; a patch is named by its top left pixel.
    Size positions() const { return m_positions; }
    /// Patches that the mask allows.
    std::int64_t allowed() const { return m_allowed; }
    bool allows(int x, int y) const { return !forbidden(x, y); }

    /// Computes Γ(Q, I₀²) for a shape; not to be called while other threads compute().
    void prepare(const Footprint& shape);

    Scratch scratch() const;
    /// Distances to `known`, of which the pixels in `shape` count. Afterwards scratch holds them.
    /// @param known a patch × patch image with the exemplar's channels. @param shape as given to prepare().
    /// @param smallest distances below it are raised to it: the source's guard against rounding.
    /// @param check called every few milliseconds; may throw.
    void compute(const ImageView& known, const Footprint& shape, float smallest, Scratch& scratch,
                 const std::function<void()>& check) const;
    /// Distances of the patches (0, row) to (positions().width − 1, row).
    const float* distanceRow(const Scratch& scratch, int row) const {
        return scratch.distances.data() + row * m_fft.rowStride();
    }
    float* distanceRow(Scratch& scratch, int row) const {
        return scratch.distances.data() + row * m_fft.rowStride();
    }

    /// Bytes that an object takes for `shapes` shapes, and one Scratch.
    static std::uint64_t bytesFor(Size exemplar, int channels, int patch, int shapes, bool balanced = false);
    static std::uint64_t scratchBytesFor(Size exemplar, int channels);

private:
    struct Shape {
        Footprint footprint;
        Image squares; ///< Γ(Q, I₀²); infinite where the mask forbids the patch
        Image factors; ///< of the distances, by contrast; empty if they stay as they are
    };
    using Table = std::vector<double>; ///< summed area, (width + 1) × (height + 1)
    bool balances() const { return m_balance.share > 0 && m_balance.variance > 0; }
    /// @param value of a pixel.
    template <class Value> Table tabulated(const Value& value) const;
    Image factorsOf(const Footprint& shape) const;
    void forbid(const PlaneView& mask);
    double transform(const ImageView& known, const Footprint& shape, Scratch& scratch,
                     const std::function<void()>& check) const;
    void correlateColumns(Scratch& scratch, int first, int last) const;
    const Shape& prepared(const Footprint& shape) const;
    bool forbidden(int x, int y) const {
        return !m_forbiddenPatches.empty() &&
               m_forbiddenPatches[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_positions.width) +
                                  static_cast<std::size_t>(x)] != 0;
    }

    double tableSum(const Table& table, int x, int y, int width, int height) const;
    /// Sum of a table over the pixels of a shape at a position.
    double shapeSum(const Table& table, const Footprint& shape, int x, int y) const;

    Size m_size;
    int m_channels;
    int m_patch;
    Size m_positions;
    std::vector<double> m_means;
    RealFft2d m_fft;
    std::vector<FftBuffer<std::complex<float>>> m_spectra;
    ContrastBalance m_balance;
    Table m_squares;           ///< of squares, over all channels
    std::vector<Table> m_sums; ///< of each channel's values, for contrast
    std::vector<std::uint8_t> m_forbiddenPatches;
    std::int64_t m_allowed = 0;
    std::vector<Shape> m_shapes;
};

} // namespace texloom
