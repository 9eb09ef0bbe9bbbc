#pragma once

#include "core/match/neighbourhood.h"
#include "core/match/patch_match.h"
#include "core/match/pixel_canvas.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// Which pixels of an output are made, one byte each. Others may be guessed: they are seen, but count less.
struct KnownPixels {
    static constexpr std::uint8_t kMade = 1, kGuessed = 2;

    explicit KnownPixels(Size extent) : size(extent), flags(static_cast<std::size_t>(extent.area()), 0) {}

    std::uint8_t& at(int x, int y) { return flags[index(x, y)]; }
    bool at(int x, int y) const { return flags[index(x, y)] == kMade; }
    /// What a pixel counts: 1 if it is made, less if it is guessed, 0 if nothing is there.
    float trust(int x, int y) const {
        const std::uint8_t flag = flags[index(x, y)];
        return flag == kMade ? 1.0F : flag == kGuessed ? guessed : 0.0F;
    }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    }

    Size size;
    std::vector<std::uint8_t> flags;
    float guessed = 0.5F; ///< what a guessed pixel counts beside a made one
};

/// Compares a partly known window of an output with all windows of exemplars (Efros & Leung, ICCV 1999):
/// d(p, q) = Σ g(i) M(i) |u(p + i) − u₀(q + i)|² / Σ g(i) M(i), where M is 1 on what is known and
/// g(i) = exp(−|i|² / 2σ²); what is guessed counts less, see KnownPixels::trust(). Windows lie whole in their
/// exemplar and show nothing that its mask hides.
///
/// Exact, but most windows are given up after a few terms: colours are turned to their principal axes, which
/// leaves distances as they are, and the terms that are likely the largest come first.
class WindowScan {
public:
    /// One term of a distance.
    struct Factor {
        const float* from; ///< of the exemplar's pixel at (0, 0)
        float weight, value;
    };
    /// Centres that may be found, side by side.
    struct Row {
        int exemplar, x, y, count;
    };
    /// The largest sum that still counts.
    struct Bound {
        float factor, least, limit;
        void lower(float sum) {
            const float now = factor * (sum > least ? sum : least);
            limit = now < limit ? now : limit;
        }
    };

    /// What is known of one window of the output.
    class Query {
    public:
        /// Whether nothing is known.
        bool blank() const { return m_terms.empty(); }

    private:
        friend class WindowScan;
        struct Term {
            int number; ///< among all terms of a window
            float weight, value;
        };
        std::vector<Term> m_terms;
        float m_whole = 0;             ///< Σ g M
        std::vector<Factor> m_factors; ///< the terms for one exemplar
    };
    struct Found {
        float distance; ///< times Σ g M
        Source source;
    };

    /// Where windows are wanted: in exemplars of one size at most so far from a place, in both directions; in
    /// others everywhere.
    struct Nearby {
        Size size;
        int x = 0, y = 0;
        int radius = 0; ///< 0: everywhere

        bool limits(Size exemplar) const { return radius > 0 && exemplar == size; }
    };

    /// @param exemplars must outlive the scan. @param window odd side. @param sigma of the weights, in
    /// pixels.
    /// @param check called every few milliseconds; may throw.
    WindowScan(std::span<const PatchSource> exemplars, int window, double sigma,
               const std::function<void()>& check);

    WindowScan(const WindowScan&) = delete;
    WindowScan& operator=(const WindowScan&) = delete;

    int window() const { return m_window; }
    /// The pixels of an exemplar, or of any image, with their colours turned.
    const Interleaved& pixels(int exemplar) const { return m_pixels[static_cast<std::size_t>(exemplar)]; }
    Interleaved turned(const ImageView& image, const std::function<void()>& check) const;
    /// The windows that may be found, by their centres, as whole squares with the weights g.
    const NeighbourhoodSet& windows() const { return m_set; }
    bool lies(const Source& window, const Nearby& nearby) const {
        return wanted({window.exemplar, window.x, window.y, 1}, nearby).count > 0;
    }

    /// Looks at the window about (x, y), round the borders on the axes that wrap.
    void look(const PixelCanvas& canvas, const KnownPixels& known, int x, int y, Wrap wrap,
              Query& query) const;
    /// The same window as a whole vector of windows(), where another window stands for what is not known, or
    /// the mean of what is known if there is none.
    /// @param standIn one of windows(), or an invalid source.
    void complete(const PixelCanvas& canvas, const KnownPixels& known, int x, int y, Wrap wrap,
                  const Source& standIn, std::vector<float>& vector) const;

    /// All windows at most (1 + tolerance) times as far as the nearest, in order of reading. Distances below
    /// a 255th of the exemplars' range count as that. Never empty. @param nearby where they lie; everywhere
    /// if there are none there. @param hints some windows that are likely near: they change nothing but the
    /// time.
    /// @param check called every few milliseconds; may throw.
    void within(double tolerance, const Nearby& nearby, std::span<const Source> hints, Query& query,
                std::vector<Found>& found, const std::function<void()>& check) const;
    /// The same of these windows alone, in their order.
    void withinOf(std::span<const Source> windows, double tolerance, Query& query,
                  std::vector<Found>& found) const;
    /// The nearest of these windows, of equal ones the first. @param windows at least one.
    Source nearestOf(std::span<const Source> windows, Query& query) const;

    static std::uint64_t bytesFor(std::span<const Size> exemplars, int channels);

private:
    /// A channel of a pixel of the window.
    struct Offset {
        int dx, dy, axis;
        float weight;
        float expected; ///< share of the distance
    };
    void learnColours(std::span<const PatchSource> exemplars);
    void makePlanes(const std::function<void()>& check);
    void orderOffsets(double sigma);
    void findRows();
    Bound boundFor(const Query& query, double tolerance) const;
    void bind(Query& query, int exemplar) const;
    float distance(const Query& query, const Source& source, float limit) const;
    const float* plane(int exemplar, int axis) const;
    Row wanted(const Row& row, const Nearby& nearby) const;

    int m_window, m_channels;
    float m_smallest = 0; ///< distances below it count as it
    std::vector<double> m_mean, m_axes, m_variances;
    std::vector<Interleaved> m_pixels;
    std::vector<std::vector<float>> m_planes; ///< of each exemplar, axis by axis
    std::vector<Offset> m_offsets;            ///< by falling expectation
    std::vector<float> m_weights;             ///< g, row by row
    NeighbourhoodSet m_set;
    std::vector<Row> m_rows;
};

} // namespace texloom
