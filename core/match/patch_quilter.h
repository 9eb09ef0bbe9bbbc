#pragma once

#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/flat_shares.h"
#include "core/match/patch_canvas.h"
#include "core/match/patch_search.h"
#include "core/match/patch_stitch.h"

#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// What patches are to follow besides what is there already: a second picture of every exemplar and of the
/// output, which are compared over whole patches.
struct QuiltGuide {
    std::vector<PatchSource> exemplars; ///< of the exemplars' sizes, with their masks
    ImageView output;                   ///< of the output's size or larger; mirrored beyond its borders
    /// How much the mean square of its differences counts beside that of the overlap's; infinite: it alone
    /// counts.
    double weight = 1;
};

/// What is quilted, and how.
struct QuiltOptions {
    /// `contrast` and `variety` with which most textures keep their contrast and hardly repeat themselves:
    /// the defaults of methods that quilt. Published image quilting has 0 for both.
    static constexpr double kUsualContrast = 1, kUsualVariety = 0.5;
    /// The overlap, as a share of the patch, and ε of Raad & Galerne, IPOL 2017.
    static constexpr double kUsualOverlap = 0.25, kUsualTolerance = 0.1;

    Size size;
    Wrap wrap;
    int patch = 40;       ///< side w_p in pixels
    int overlap = 10;     ///< w_o in pixels
    double tolerance = 0; ///< ε: a patch up to (1 + ε) times as far as the nearest may be drawn
    double contrast = 0;  ///< see ContrastBalance::share
    /// λ: how much farther a patch is taken to be whose pixels were copied near by; 0: as it is.
    double variety = 0;
    PatchStitch stitch = PatchStitch::Cut;
    int softness = 0; ///< half the width in pixels over which a cut blends; 0 for sharp cuts
    /// An image of the output's size that whole patches are compared with, or none.
    const Image* initial = nullptr;
    const QuiltGuide* guide = nullptr;
    bool traced = true; ///< whether the map is wanted
};

/// What a PatchQuilter makes.
struct Quilt {
    Image image;
    PositionMap map; ///< exact where cuts are sharp, or patches hide what they overlap; empty if not wanted
    int patches = 0;
    std::optional<double> meanCutError; ///< where patches are cut
};

/// Synthesises one output patch by patch (Raad & Galerne, IPOL 2017, algorithms 1 to 4). Every exemplar patch
/// that the masks allow is a candidate for every output patch. With an initial image the whole patch is
/// compared with what is there, not the overlap alone (Raad, thesis 2016, section 5.4.2).
class PatchQuilter {
public:
    /// @param exemplars, options and what they refer to must outlive the quilter.
    PatchQuilter(const std::vector<PatchSource>& exemplars, const QuiltOptions& options, JobContext& context);

    /// Runs to the end, as a wavefront over the context's threads or one patch after another in raster order:
    /// both give the same bits. Its two stages make up `weight` of the run.
    enum class Order { Wavefront, Raster };
    Quilt run(double weight = 1, Order order = Order::Wavefront);

    /// Bytes of the map while it grows.
    static std::uint64_t mapBytesFor(Size size, int patch);

private:
    /// What one thread needs to place a patch.
    struct Workspace {
        Image known;  ///< the patch as it is on the canvas
        Image error;  ///< squared differences to the chosen patch, where they overlap
        Image weight; ///< share of the old pixel, 0 to 1
        PatchSearch::Scratch scratch;
        Image guide; ///< the guide's patch
        PatchSearch::Scratch guideScratch;
        std::optional<PatchStitcher::Scratch> stitch; ///< where patches are not cut
    };
    /// The guide's own search and canvas.
    struct Guide {
        PatchSearch search;
        PatchCanvas canvas;
        double weight;
    };

    Workspace workspace() const;
    void prepareExemplars();
    void place(int index);
    Footprint compared(const PatchCell& cell) const;
    void follow(const PatchCell& cell, Workspace& work) const;
    PatchSearch::Scratch& distances(const PatchCell& cell, bool known, Workspace& work) const;
    PatchPosition choose(int index, Workspace& work) const;
    void vary(int index, PatchSearch::Scratch& distances) const;
    void findFlat(const std::vector<PatchSource>& exemplars);
    void leaveFlat(int index, PatchSearch::Scratch& distances) const;
    bool cuts() const { return !m_stitcher; }
    void trace(const PatchCell& cell, const PatchPosition& source, const PlaneView& weight);

    const QuiltOptions& m_options;
    JobContext& m_context;
    PatchSearch m_search;
    PatchCanvas m_canvas;
    std::optional<Guide> m_guide;
    std::optional<FlatShares> m_flat;        ///< where there are flat patches that are kept from winning
    int m_flatReach = 0;                     ///< cells that an exemplar takes, across or down
    std::optional<PatchStitcher> m_stitcher; ///< where patches are not cut
    PositionMap m_map;
    std::vector<PatchPosition> m_sources; ///< by cell
    std::vector<double> m_cutCosts;       ///< by cell, so that sums do not depend on the order
    Pool<Workspace> m_pool;
};

} // namespace texloom
