#pragma once

#include "core/job/job_context.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/grid_match.h"
#include "core/methods/fill_request.h"
#include "core/methods/fill_scales.h"
#include "core/methods/patchmatch/settings.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::patchmatch {

/// Makes what is not known of a picture, from coarse to fine: all patches that show some of it look for
/// similar ones in the exemplars (PatchMatch), and vote for its pixels (Wexler, Shechtman & Irani,
/// "Space-time completion of video", IEEE PAMI 29, 2007; Barnes et al., SIGGRAPH 2009, section 4). As in
/// Synthesizer, each pixel is a copy of the proposed one nearest to the vote. On the coarsest scale pixels
/// grow from the border, so that the first votes have something to go by. On every scale the seams between
/// what is copied are moved to where they are seen least, and at last its tone is evened out.
class Completer {
public:
    /// @param window of a request with what may be copied in the exemplars' masks: see withoutHole().
    /// @param patch side of the patches: see patchFor().
    Completer(const FillWindow& window, int patch, const Settings& settings, JobContext& context);
    Synthesis run();

    /// Side of the patches: half as large again as those of whole outputs, since a hole is a single piece
    /// that must join on all sides; those of whole outputs where larger ones do not fit.
    static int patchFor(const Request& request, const Settings& settings);
    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);

private:
    void grow();
    void refine(int level);
    void enter(int level);
    std::vector<std::uint8_t> wanted(const FillScale& scale) const;
    void adopt(const GridMatcher& matcher, const std::vector<std::uint8_t>& flags, PatchField& field) const;
    Source match(const GridMatcher& matcher, int x, int y) const;
    void gather(int x, int y, Size extent, Interleaved& to) const;
    void vote(const GridMatcher& matcher, const std::vector<std::uint8_t>& flags, const PatchField& field,
              bool late);
    void offer(int level);
    void join();
    void joinScale(int level);
    Synthesis finish();
    bool made(int x, int y) const { return (*m_known)(x, y, 0) == 0; }
    bool place(int& x, int& y) const;

    const FillWindow& m_window;
    const Request& m_request; ///< the window's
    const Settings& m_settings;
    JobContext& m_context;
    int m_patch;
    ExemplarPyramid m_pyramid;
    std::vector<FillScale> m_scales; ///< from fine to coarse
    const Image* m_known = nullptr;  ///< of the present scale
    Interleaved m_pixels;            ///< of the present scale
    PositionMap m_map;               ///< of what is made, at the present scale
    std::vector<float> m_trust;      ///< of the present scale: how much a patch about a pixel counts
};

} // namespace texloom::patchmatch
