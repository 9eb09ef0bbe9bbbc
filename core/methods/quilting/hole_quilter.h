#pragma once

#include "core/job/job_context.h"
#include "core/match/masked_distances.h"
#include "core/methods/fill_request.h"
#include "core/methods/quilting/settings.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::quilting {

/// Lays patches over what is not known of a picture, those first that show most of what is known. A patch is
/// compared on all known pixels that it covers, whatever their shape; it is cut against earlier ones along
/// the minimum cut of a graph (Kwatra et al., SIGGRAPH 2003), since these may surround it; and it leaves what
/// was known from the beginning as it is. At last all cuts are moved together, and the tone is evened out.
class HoleQuilter {
public:
    /// @param window of a request with what may be copied in the exemplars' masks: see withoutHole().
    HoleQuilter(const FillWindow& window, const Settings& settings, JobContext& context);
    Synthesis run();

    /// Side of the patches: at most half of what is made, so that several share it.
    static int patchFor(const Request& request, const Settings& settings);
    static Estimate estimate(const Request& request, const Settings& settings, int threads);

private:
    /// A square of the output, of which some is to be made.
    struct Cell {
        int x = 0, y = 0; ///< may lie outside
        int known = 0;    ///< pixels
        bool laid = false;
    };
    /// A part of an exemplar that holds all that may be copied of it.
    struct Part {
        int exemplar = 0, x = 0, y = 0;
        MaskedDistances distances;
    };
    struct Candidate {
        const Part* part;
        int x, y; ///< in the exemplar
    };
    void measure();
    void findParts();
    void divide();
    bool place(int& x, int& y) const;
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_picture.image.width()) +
               static_cast<std::size_t>(x);
    }
    int countKnown(const Cell& cell) const;
    Cell* next();
    Candidate choose(const Cell& cell);
    std::vector<Candidate> within(const Cell& cell, bool limited) const;
    bool near(const Cell& cell, const Candidate& candidate) const;
    void lay(const Cell& cell, const Candidate& candidate);
    std::vector<std::uint8_t> keptOf(const Cell& cell, const ImageView& fresh) const;
    std::int32_t cost(const Cell& cell, const ImageView& fresh, int x, int y) const;
    float keptShare(const std::vector<std::uint8_t>& kept, int x, int y) const;
    Synthesis finish();
    void keepBlends(Synthesis& result) const;
    void offer();
    bool there(int x, int y) const { return m_picture.known[index(x, y)] != 0 || m_made[index(x, y)] != 0; }

    const FillWindow& m_window;
    const Request& m_request; ///< the window's
    const Settings& m_settings;
    JobContext& m_context;
    int m_patch, m_overlap;
    KnownPicture m_picture;
    std::vector<std::uint8_t> m_made; ///< by pixel, 1 where a patch lies
    std::vector<Cell> m_cells;
    std::vector<Part> m_parts;
    std::vector<std::vector<float>> m_distances; ///< of each part
    float m_unit = 1; ///< squared range of the exemplars' values, over all channels
};

} // namespace texloom::quilting
