#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/coherent_candidates.h"
#include "core/match/neighbourhood_tree.h"
#include "core/match/pixel_canvas.h"
#include "core/match/scan_order.h"
#include "core/methods/pixel_request.h"
#include "core/methods/synthesis.h"

#include <memory>
#include <optional>
#include <vector>

namespace texloom {

/// Pictures that say what parts of the exemplars and of the output are alike: labels, say, or the unfiltered
/// pictures of an analogy. All have the same number of channels.
struct CausalGuides {
    std::vector<const Image*> exemplars; ///< of each exemplar's size
    const Image* output = nullptr;       ///< of the output's size
    /// How much they count beside the pictures themselves, as though both had the same variance: so it is no
    /// matter what numbers stand for labels.
    double weight = 1;
};

struct CausalOptions {
    int side = 9;       ///< of the compared square, odd
    int levels = 4;     ///< scales, at most
    int parent = 3;     ///< side of the square on the next coarser scale, odd; 0 for none
    bool exact = false; ///< compares all neighbourhoods instead of those that a tree finds
    int leaf = 8;       ///< most neighbourhoods in a leaf of the tree
    int passes = 1;     ///< on each scale; those after the first compare whole squares
    /// κ: a pixel that continues a neighbour's copy is taken if it is no more than 1 + 2⁻ˡ κ times as far as
    /// the nearest, on the l-th scale from the finest; 0 asks for the nearest alone.
    double coherence = 0;
    /// Whether pixels count by a Gaussian of their distance to the centre, and each part of the neighbourhood
    /// as much as any other.
    bool falloff = false;
    std::optional<CausalGuides> guides;
};

/// Makes an output from coarse to fine, on each scale pixel by pixel in raster order: a pixel becomes the
/// exemplar's whose causal neighbourhood is nearest, together with a square of the coarser scale, which is
/// finished already (Wei & Levoy, "Fast texture synthesis using tree-structured vector quantization",
/// SIGGRAPH 2000). With guides and coherence it is the method of Hertzmann et al., "Image analogies"
/// (SIGGRAPH 2001). Neighbourhoods reach round the output's borders; guides go on mirrored on axes that do
/// not wrap, where what they show on the other side says nothing.
class CausalSynthesis {
public:
    CausalSynthesis(const Request& request, CausalOptions options, JobContext& context);
    Synthesis run(ScanOrder::Order order = ScanOrder::Order::Wavefront);

    static Estimate estimate(const Request& request, const CausalOptions& options, int threads);

private:
    /// What a scan compares, and where it looks for it.
    struct Matcher {
        NeighbourhoodSet set;
        std::unique_ptr<NeighbourhoodTree> tree;
        bool parent; ///< whether the coarser scale is compared too
    };
    struct Workspace {
        std::vector<float> wanted;
        std::vector<Continuation> coherent;
    };
    /// A pixel that was found, and how far its neighbourhood is.
    struct Found {
        Source source;
        float distance;
    };

    int levelsFor() const;
    int guideMargin() const;
    void makeGuides();
    void begin(int level);
    void loadInitial(int level);
    NeighbourhoodSet set(int level, const PixelRuns& runs, bool withParent) const;
    NeighbourhoodSource source(int level, int exemplar, bool withParent) const;
    std::vector<const Interleaved*> outputPictures(int level, bool withParent) const;
    Matcher matcher(int level, const PixelRuns& runs) const;
    void makeLevel(int level, double weight, ScanOrder::Order order);
    void scan(int level, const Matcher& matcher, const ScanOrder& scan, ScanOrder::Order order);
    Found choose(int level, const Matcher& matcher, int x, int y, Workspace& work) const;
    float bound(const Matcher& matcher, const float* wanted, int x, int y) const;
    Found mostCoherent(const Matcher& matcher, int x, int y, Workspace& work) const;

    const Request& m_request;
    const CausalOptions m_options;
    JobContext& m_context;
    PixelPyramid m_pyramid;
    std::vector<Size> m_sizes; ///< of the output at each level
    /// By level and exemplar, and by level.
    std::vector<std::vector<Interleaved>> m_exemplarGuides;
    std::vector<Interleaved> m_outputGuides;
    double m_guideWeight = 0; ///< of their squared differences
    PixelRuns m_causal;
    PixelCanvas m_canvas;
    Interleaved m_coarse; ///< the output at the next coarser scale
    std::vector<double> m_rowErrors;
    Pool<Workspace> m_pool;
};

} // namespace texloom
