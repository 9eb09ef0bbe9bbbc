#pragma once

#include "core/job/job_context.h"
#include "core/math/fft.h"
#include "core/methods/cut_canvas.h"
#include "core/methods/graph_cut/settings.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::graph_cut {

/// Finds out how well the exemplars fit a part of the output for all displacements at once: the mean square
/// of the differences where both are known (Kwatra et al. 2003, eq. 3 and 4), by Fourier transforms.
class PlaceSearch {
public:
    PlaceSearch(const Request& request, const Settings& settings, JobContext& context);

    /// Where to paste next, over a pixel that is not covered. @param step number of the patch, for drawing.
    Patch placeOver(const Canvas& canvas, int x, int y, int step);
    /// Where to paste so that a covered square fits best. @param x, y its top left.
    Patch placeOnto(const Canvas& canvas, int x, int y, int step);

    static std::uint64_t bytesFor(const Request& request, const Settings& settings);

private:
    using Complex = RealFft2d::Complex;
    using Spectrum = FftBuffer<Complex>;

    /// An exemplar's transforms: of its pixels by channel, of their squares' sum, and of where it counts.
    struct Transforms {
        RealFft2d fft;
        std::vector<Spectrum> channels;
        Spectrum squares, shape;
        Size reach; ///< pixels across that are pasted at once
    };
    /// The pixels that are looked at, around an anchor, and which pixels of an exemplar may lie on it.
    struct Frame {
        Region looked; ///< offsets from the anchor
        Region anchors;
    };

    void addExemplar(const Exemplar& exemplar);
    Frame wholeFrame(std::size_t exemplar) const;
    Frame squareFrame(std::size_t exemplar, int offset) const;
    float sample(const Canvas& canvas, int x, int y, int channel, bool& counts) const;
    void measure(const Canvas& canvas, int x, int y, const Frame& frame, const Transforms& exemplar);
    void collect(const Frame& frame, std::size_t exemplar);
    Patch drawn(int x, int y, int step) const;
    Patch anywhere(int x, int y, int step) const;
    Patch over(int x, int y, std::size_t exemplar, int u, int v) const;
    bool allowed(std::size_t exemplar, int u, int v) const;

    struct Candidate {
        std::size_t exemplar;
        int u, v;
        double cost;
    };

    const Request& m_request;
    const Image* m_initial; ///< of the request
    const Settings& m_settings;
    JobContext& m_context;
    std::vector<double> m_means;
    double m_variance = 0; ///< σ², over all channels
    std::vector<Transforms> m_exemplars;
    std::vector<FftBuffer<float>> m_planes; ///< looked-at pixels by channel, their squares, where they count
    std::vector<Spectrum> m_spectra;
    std::vector<Candidate> m_candidates;
};

} // namespace texloom::graph_cut
