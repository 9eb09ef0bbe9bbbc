#pragma once

#include "core/image/image.h"
#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/math/grid_flow.h"
#include "core/methods/seam_cost.h"
#include "core/methods/synthesis.h"

#include <functional>
#include <vector>

namespace texloom::graph_cut {

/// A piece of an exemplar over the output.
struct Patch {
    int exemplar = 0;
    int x = 0, y = 0; ///< the output's place of the exemplar's pixel (0, 0)
    Region window;    ///< the output's pixels that it covers, before they are taken round borders that wrap
};

/// An output that grows by pasting patches along minimum cuts, with the seams that are in it (Kwatra et al.
/// 2003). A pixel of a patch that the exemplar's mask hides does not count as covered.
class Canvas {
public:
    Canvas(const Request& request, bool gradient) : Canvas(request, SeamCost(request, gradient)) {}
    /// @param cost of seams between these exemplars, which takes a look at all of their pixels to know.
    Canvas(const Request& request, const SeamCost& cost);

    Size size() const { return m_image.size(); }
    Image& image() { return m_image; }
    const Image& image() const { return m_image; }
    PositionMap& map() { return m_map; }
    /// Whether a pixel has been covered yet.
    bool known(int x, int y) const { return m_map.at(x, y).valid(); }
    std::int64_t covered() const { return m_covered; }
    /// The output's pixel for a place that may lie beyond a border that wraps. @return whether there is one.
    bool settle(int& x, int& y) const;

    /// Pastes a patch along the cut of least cost: new pixels are covered; where it overlaps old ones the cut
    /// decides, and seams of old ones may be covered or stay.
    /// @param core places of the window that must be covered by it, or null.
    /// @return the cut's value.
    std::int64_t paste(const Patch& patch, const std::function<bool(int x, int y)>& core,
                       JobContext& context);
    /// Pastes a patch if that lowers the cost of all seams. @return whether it did.
    bool mend(const Patch& patch, const std::function<bool(int x, int y)>& core, JobContext& context);

    /// Cost of the seams to the right of and below a pixel.
    double seamAt(int x, int y) const { return static_cast<double>(m_seams(x, y, 0)); }
    double totalCost(JobContext& context) const;

    static std::uint64_t bytesFor(Size size, Size exemplar, int channels);

private:
    /// A pixel of the window: where it lies, where it would come from, and its node if it overlaps.
    struct Pixel {
        int x = 0, y = 0;
        Source fresh;
        int node = -1;
        bool inside = false; ///< of the patch
    };
    Pixel& pixel(int x, int y) {
        return m_pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_window.width) +
                        static_cast<std::size_t>(x)];
    }
    void collect(const Patch& patch);
    void linkPixels(const Pixel& a, const Pixel& b, Step step, GridFlow& flow) const;
    void tieBorder(const Pixel& a, const Pixel* neighbour, Step step, bool ahead, GridFlow& flow) const;
    GridFlow graph(const std::function<bool(int, int)>& core, JobContext& context);
    void cover(const Pixel& pixel);
    double seamCost(int x, int y) const;
    double windowCost(const Region& window) const;
    void measureSeams(const Region& window);

    const Request& m_request;
    SeamCost m_cost;
    Image m_image;
    PositionMap m_map;
    Image m_seams;
    std::int64_t m_covered = 0;
    Size m_window;
    std::vector<Pixel> m_pixels; ///< of the patch that is being pasted, by rows
};

} // namespace texloom::graph_cut
