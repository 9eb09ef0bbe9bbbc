#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/cut_canvas.h"
#include "core/methods/graph_cut/place_search.h"
#include "core/methods/method.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace texloom::graph_cut {

namespace {

/// A square of the output by its top left.
struct Square {
    int x = 0, y = 0;
};

/// Covers the output patch by patch, then mends the worst seams.
class Weaver {
public:
    Weaver(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_canvas(request, settings.gradient),
          m_search(request, settings, context) {}

    Synthesis run() {
        m_context.stage(m_settings.refine > 0 ? 0.8 : 1, TR("Pasting along cuts"));
        cover();
        const int mended = m_settings.refine > 0 ? refine() : 0;
        Synthesis result;
        result.figures = {{TR("Patches"), static_cast<double>(m_steps)},
                          {TR("Mended seams"), static_cast<double>(mended)},
                          {TR("Seam cost per pixel"),
                           m_canvas.totalCost(m_context) / static_cast<double>(m_request.size.area())}};
        result.image = std::move(m_canvas.image());
        result.map = std::move(m_canvas.map());
        result.mapKind = MapKind::Exact;
        return result;
    }

private:
    void cover() {
        const Size size = m_request.size;
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                // A patch covers its anchor, so that this ends.
                while (!m_canvas.known(x, y)) {
                    m_canvas.paste(m_search.placeOver(m_canvas, x, y, m_steps++), nullptr, m_context);
                    show(static_cast<double>(m_canvas.covered()) / static_cast<double>(size.area()));
                }
    }

    void show(double progress) {
        m_context.progress(progress);
        m_context.preview(m_canvas.image(), &m_canvas.map());
    }

    /// @return how many seams could be mended.
    int refine() {
        m_context.stage(0.2, TR("Mending seams"));
        m_context.curve(TR("Cost of all seams"), m_canvas.totalCost(m_context));
        std::vector<Square> given;
        int mended = 0;
        const int reach = m_settings.patch / 4;
        for (int n = 0; n < m_settings.refine; ++n) {
            const std::optional<Square> worst = worstSquare(given);
            if (!worst)
                break;
            const int middleX = worst->x + m_settings.patch / 2, middleY = worst->y + m_settings.patch / 2;
            const auto core = [&](int x, int y) {
                return std::abs(x - middleX) <= reach && std::abs(y - middleY) <= reach &&
                       m_canvas.seamAt(x, y) > 0;
            };
            const Patch patch = m_search.placeOnto(m_canvas, worst->x, worst->y, m_steps + n);
            if (m_canvas.mend(patch, core, m_context))
                ++mended;
            else
                given.push_back(*worst);
            m_context.curve(TR("Cost of all seams"), m_canvas.totalCost(m_context));
            show(static_cast<double>(n + 1) / m_settings.refine);
        }
        m_context.progress(1);
        return mended;
    }

    /// The square with the largest sum of seam costs, of those that do not lie on one that was given up.
    std::optional<Square> worstSquare(const std::vector<Square>& given) {
        const Size size = m_request.size;
        const int patch = m_settings.patch;
        if (size.width < patch || size.height < patch)
            return std::nullopt;
        std::vector<double> sums(static_cast<std::size_t>(size.width), 0.0);
        std::optional<Square> worst;
        double most = 0;
        for (int y = 0; y < size.height; ++y) {
            m_context.check();
            for (int x = 0; x < size.width; ++x) {
                sums[static_cast<std::size_t>(x)] += m_canvas.seamAt(x, y);
                if (y >= patch)
                    sums[static_cast<std::size_t>(x)] -= m_canvas.seamAt(x, y - patch);
            }
            if (y + 1 < patch)
                continue;
            double sum = 0;
            for (int x = 0; x < size.width; ++x) {
                sum += sums[static_cast<std::size_t>(x)];
                if (x >= patch)
                    sum -= sums[static_cast<std::size_t>(x - patch)];
                const Square square{x + 1 - patch, y + 1 - patch};
                if (x + 1 >= patch && sum > most && sum > 1e-6 && !near(given, square)) {
                    most = sum;
                    worst = square;
                }
            }
        }
        return worst;
    }

    bool near(const std::vector<Square>& given, const Square& square) const {
        return std::any_of(given.begin(), given.end(), [&](const Square& one) {
            return std::abs(one.x - square.x) < m_settings.patch / 2 &&
                   std::abs(one.y - square.y) < m_settings.patch / 2;
        });
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    Canvas m_canvas;
    PlaceSearch m_search;
    int m_steps = 0;
};

void check(const Request& request, const Settings& settings) {
    if (settings.placement == Placement::SubPatch || settings.refine > 0)
        for (const Exemplar& exemplar : request.exemplars)
            if (exemplar.image->size().shorterSide() < settings.patch)
                failUsage(
                    "{} is {} × {} px, smaller than the compared square of {} px; choose one of at most "
                    "{} px.",
                    exemplar.name, exemplar.image->width(), exemplar.image->height(), settings.patch,
                    exemplar.image->size().shorterSide());
    if (settings.placement == Placement::Random && request.initial())
        failUsage(
            "Random placement looks at nothing, so it cannot follow the initial image; choose entire or "
            "sub-patch.");
    if (!leavesWholePatch(request, 1))
        failUsage("The mask hides all of the exemplar; leave at least 1 px to copy.");
}

Estimate estimate(const Request& request, const Settings& settings, int) {
    Size largest;
    for (const Size& size : request.exemplarSizes())
        largest = {std::max(largest.width, size.width), std::max(largest.height, size.height)};
    Estimate need;
    need.bytes = Canvas::bytesFor(request.size, largest, request.channels()) +
                 PlaceSearch::bytesFor(request, settings) + (4U << 20);
    const auto exemplar = static_cast<double>(largest.area());
    const double pastes = 3 * static_cast<double>(request.size.area()) / exemplar + settings.refine + 2;
    need.seconds = pastes * exemplar * (1.5e-6 + 4e-7 * request.channels());
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Weaver(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Graph cut"),
     .summary =
         TR("Pastes the whole exemplar again and again, each time along the cheapest seam of any shape, "
            "and mends the worst seams at the end. Keeps objects such as stones and leaves whole; copies "
            "large areas verbatim."),
     .citation = "Kwatra, Schödl, Essa, Turk & Bobick, SIGGRAPH 2003; Boykov & Kolmogorov, IEEE PAMI 2004",
     .category = Category::Patches,
     .suits = {.regular = 4, .grain = 4, .objects = 5, .large = 5},
     .takes = {ports::weighedExemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::placement, "placement", TR("Placement"))
         .choices({{"random", TR("Random")}, {"entire", TR("Entire patch")}, {"sub-patch", TR("Sub-patch")}})
         .help(
             TR("Where the exemplar is pasted next: anywhere, where all of it fits what is there, or where a "
                "square of it does, which suits what has no clear structure.")),
     patchField(&Settings::patch, 0.25)
         .symbol("")
         .help(TR("Side of the square that is compared for sub-patches and for mending: larger keeps larger "
                  "structures whole.")),
     field(&Settings::tolerance, "tolerance", TR("Tolerance"))
         .range(0.001, 1)
         .symbol("k")
         .help(TR("How much worse than the best a place may fit and still be likely: larger varies more, "
                  "smaller fits better.")),
     field(&Settings::refine, "refine", TR("Mended seams"))
         .range(0, 1000)
         .help(
             TR("So many times the worst seam is pasted over, where that makes it better: more takes longer "
                "and hides more.")),
     field(&Settings::gradient, "gradient", TR("Seams along edges"))
         .group(TR("Advanced"))
         .help(TR("Lets seams cost less where the pictures change anyway, so that they follow edges."))},
    run, check, estimate);

} // namespace texloom::graph_cut
