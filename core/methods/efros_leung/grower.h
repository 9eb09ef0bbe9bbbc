#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/neighbourhood_tree.h"
#include "core/match/window_scan.h"
#include "core/methods/efros_leung/settings.h"
#include "core/methods/synthesis.h"

#include <functional>
#include <memory>
#include <vector>

namespace texloom::efros_leung {

/// What is there before growth begins: an image of the output's size, and a mask that is not 0 where it is to
/// be kept. None: growth begins from a seed.
struct Start {
    const Image* image = nullptr;
    const Image* known = nullptr;
};

/// Grows an output pixel by pixel from what is known: each becomes the middle of one of the exemplar's
/// windows that fit what is known around it (Efros & Leung, "Texture synthesis by non-parametric sampling",
/// ICCV 1999). Pixels whose windows do not show each other are made at the same time.
class Grower {
public:
    Grower(const Request& request, const Settings& settings, const Start& start, JobContext& context);
    Synthesis run();

    static int window(const Settings& settings);
    static NeighbourhoodTree::Options treeOptions(const Settings& settings);
    static std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads);

private:
    struct Workspace {
        WindowScan::Query query;
        std::vector<WindowScan::Found> found;
        std::vector<Continuation> coherent;
        std::vector<Source> likely;
        std::vector<float> vector;
    };
    /// A place of the output, as y × width + x.
    using Place = std::int64_t;
    using Places = std::vector<Place>;

    int x(Place place) const { return static_cast<int>(place % m_request.size.width); }
    int y(Place place) const { return static_cast<int>(place / m_request.size.width); }
    void begin();
    void placeSeed();
    void keep();
    void growLayers();
    void growRows();
    Places unknownBeside(const Places& made);
    int knownAround(Place place) const;
    void sortByKnown(Places& layer) const;
    std::vector<Places> inTurns(const Places& order);
    void make(const std::vector<Places>& turns);
    void makePixel(Place place, Workspace& work);
    Source choose(int x, int y, Workspace& work) const;
    void findLikely(int x, int y, Workspace& work) const;
    Source draw(const std::vector<WindowScan::Found>& found, int x, int y) const;
    bool neighbour(int x, int y, int dx, int dy, Place& found) const;
    Image shown() const;
    Synthesis finish();

    const Request& m_request;
    const Settings& m_settings;
    const Start m_start;
    JobContext& m_context;
    WindowScan m_scan;
    std::unique_ptr<NeighbourhoodTree> m_tree;
    PixelCanvas m_canvas;
    KnownPixels m_known;
    std::vector<std::int32_t> m_turn; ///< of the places of the layer that is sorted, by place; else 0
    std::int64_t m_made = 0, m_wanted = 0;
    Pool<Workspace> m_pool;
};

} // namespace texloom::efros_leung
