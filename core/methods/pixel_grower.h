#pragma once

#include "core/job/job_context.h"
#include "core/job/pool.h"
#include "core/match/neighbourhood_tree.h"
#include "core/match/window_scan.h"
#include "core/methods/synthesis.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace texloom::pixel_growth {

/// In which order pixels are made: those with the most known neighbours first, layer by layer, or in rows.
enum class Order { Onion, Raster };
/// How the windows are found that fit: among all of them, or among those that are likely by their principal
/// components; by itself, among all where there is no coarser scale, or the exemplars are small on the
/// coarsest, and among those near a coarser scale's guess where there is one.
enum class Search { Auto, Exact, Pca };

/// Parameters of the pixel growing of Efros & Leung (ICCV 1999).
struct Settings {
    int window = 21; ///< side n in pixels; an even one counts as the next odd. The source uses 11 to 25
    double tolerance = 0.1; ///< ε: a window up to (1 + ε) times as far as the nearest may be drawn
    double sigma = 0.156;   ///< of the Gaussian weights, as a share of the window: the source has 1 / 6.4
    int seedSize = 3;       ///< side of the square that growth begins with
    Order order = Order::Onion;
    Search search = Search::Auto;
    int components = 20; ///< principal axes on which windows are compared first
    int radius =
        0; ///< in exemplars of the output's size, how far a window may lie from the pixel; 0: anywhere
    /// What is not the Grower's own, but that of who runs it: on how many scales it grows at most, whether
    /// seams are moved, and, where a hole is filled, how far around it windows lie (see withoutHole()) and
    /// whether tone is evened.
    int scales = 4;
    bool seams = true;
    int context = 200;
    bool tone = true;
};

/// What is there before growth begins: an image of the output's size, and a mask that is not 0 where it is to
/// be kept. None: growth begins from a seed.
struct Start {
    const Image* image = nullptr;
    const Image* known = nullptr;
    /// Sources of what is not known, as a guess that growth corrects, such as a coarser scale's; where one is
    /// invalid nothing is guessed. None: what is not made yet is not seen.
    const PositionMap* guess = nullptr;
    /// Called now and then with all sources so far, to offer them to be looked at; none: growth does so
    /// itself.
    std::function<void(const PositionMap&)> offer = nullptr;
};

/// Grows an output pixel by pixel from what is known: each becomes the middle of one of the exemplar's
/// windows that fit what is known around it (Efros & Leung, "Texture synthesis by non-parametric sampling",
/// ICCV 1999). Pixels whose windows do not show each other are made at the same time.
class Grower {
public:
    Grower(const Request& request, const Settings& settings, const Start& start, JobContext& context);
    /// Its three stages make up `weight` of the run.
    Synthesis run(double weight = 1);

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
        std::vector<const Source*> leaves; ///< of the tree that were met
    };
    /// A place of the output, as y × width + x.
    using Place = std::int64_t;
    using Places = std::vector<Place>;

    int x(Place place) const { return static_cast<int>(place % m_request.size.width); }
    int y(Place place) const { return static_cast<int>(place / m_request.size.width); }
    void begin();
    void placeSeed();
    std::optional<Place> guessedNear(int x, int y, int reach) const;
    void keep();
    void guess();
    void growLayers();
    void growRows();
    Places unknownBeside(const Places& made);
    int knownAround(Place place) const;
    void sortByKnown(Places& layer) const;
    void inShares(std::size_t count, const std::function<void(std::size_t)>& work) const;
    std::vector<Places> inTurns(const Places& order);
    std::vector<std::vector<int>> shownBefore(const Places& order);
    void make(const std::vector<Places>& turns);
    void makeLayer(const Places& layer);
    void show(std::int64_t made);
    void makePixel(Place place, Workspace& work);
    Source choose(int x, int y, Workspace& work) const;
    void findLikely(int x, int y, Workspace& work) const;
    void findNear(Workspace& work) const;
    bool searchesNear() const { return m_start.guess && m_settings.search == Search::Auto; }
    void findInTree(int x, int y, Workspace& work) const;
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

} // namespace texloom::pixel_growth
