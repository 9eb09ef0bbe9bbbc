#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/patch_canvas.h"
#include "core/match/patch_search.h"
#include "core/match/patch_stitch.h"

#include <optional>
#include <vector>

namespace texloom {

/// Grows an output patch by patch in raster order, working on independent patches in parallel. Methods differ
/// in how a patch is made, which is make().
class PatchGrower {
public:
    struct Layout {
        Size output;
        Wrap wrap;
        int patch = 0;       ///< side in pixels
        int overlap = 0;     ///< of neighbouring patches, in pixels
        double contrast = 0; ///< see ContrastBalance::share
    };

    virtual ~PatchGrower() = default;
    PatchGrower(const PatchGrower&) = delete;
    PatchGrower& operator=(const PatchGrower&) = delete;

    int patches() const { return m_canvas.grid().count(); }
    /// Does the work that all patches share, once.
    void prepare();
    /// The output. Progress goes from 0 to 1 and previews are shown on the way.
    Image grow();

protected:
    /// What one thread needs to make a patch.
    struct Workspace {
        Image known; ///< the patch as it is on the canvas
        Image fresh; ///< the new patch, which make() fills
        PatchSearch::Scratch search;
        PatchStitcher::Scratch stitch;
    };

    /// @param sources must outlive the grower. @param stitcher for join(), where it is used.
    PatchGrower(const std::vector<PatchSource>& sources, const Layout& layout, JobContext& context,
                std::optional<PatchStitcher> stitcher = {});

    /// Makes `fresh` from the exemplars' patches and the `known` pixels. Called from several threads.
    virtual void make(const PatchCell& cell, Workspace& work) = 0;
    /// Puts `fresh` on the canvas: as it is, unless a method mixes it with the existing pixels.
    virtual void place(const PatchCell& cell, Workspace& work);
    /// The pixels on which a patch is compared with the exemplars': its overlap with earlier patches, or all
    /// of it where there are none.
    virtual Footprint compared(const PatchCell& cell) const;

    /// The exemplars' patches nearest to `known`. Where nothing is known yet, a patch is drawn (draw 0 of
    /// place (0, 0)) and becomes `known`.
    std::vector<PatchPosition> nearest(const PatchCell& cell, int count, Workspace& work) const;
    /// Compares `known` with the exemplars' patches, for the choices of PatchSearch.
    void compare(const PatchCell& cell, const Image& known, Workspace& work) const;
    /// Joins `fresh` to `known` where they overlap.
    void join(const PatchCell& cell, Workspace& work) const;

    Size patchSize() const { return {m_canvas.patch(), m_canvas.patch()}; }
    JobContext& context() const { return m_context; }
    const PatchSearch& search() const { return m_search; }
    PatchSearch& search() { return m_search; }
    const PatchCanvas& canvas() const { return m_canvas; }
    PatchCanvas& canvas() { return m_canvas; }

private:
    void grow(const PatchCell& cell);

    JobContext& m_context;
    PatchSearch m_search;
    PatchCanvas m_canvas;
    std::optional<PatchStitcher> m_stitcher;
    Pool<Workspace> m_pool;
};

} // namespace texloom
