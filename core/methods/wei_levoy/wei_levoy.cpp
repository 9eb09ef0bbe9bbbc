#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/pixel_request.h"
#include "core/methods/wei_levoy/settings.h"

namespace texloom::wei_levoy {

namespace {

void check(const Request& request, const Settings& settings) {
    checkSquares(request, settings.options().side);
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    return CausalSynthesis::estimate(request, settings.options(), threads);
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return CausalSynthesis(request, settings.options(), context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Wei–Levoy"),
     .summary = TR(
         "Makes one pixel after another in rows, from coarse to fine, and takes each from where the exemplar "
         "looks most like what is there above and to the left. Always tiles from left to right; small "
         "details "
         "may become blurred."),
     .citation = "Wei & Levoy, SIGGRAPH 2000",
     .category = Category::Pixels,
     .takes = {ports::exemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::neighbourhood, "neighbourhood", TR("Neighbourhood"))
         .range(3, 21)
         .unit("px")
         .symbol("n")
         .help(TR(
             "Side of the square whose known half is compared (an even one counts as the next odd): larger "
             "keeps larger structures, but takes longer and copies more.")),
     field(&Settings::levels, "levels", TR("Scales"))
         .range(1, 8)
         .help(TR("At most so many, each half the size of the one before: more keep larger structures.")),
     field(&Settings::parent, "parent", TR("Parent square"))
         .range(0, 9)
         .unit("px")
         .group(TR("Advanced"))
         .help(TR(
             "Side of the square that is compared on the next coarser scale (an even one counts as the next "
             "odd): larger follows the coarser scale more closely; 0 forgets it.")),
     field(&Settings::passes, "passes", TR("Passes"))
         .range(1, 5)
         .help(
             TR("How often each scale is made: passes after the first see all that surrounds a pixel, which "
                "mends joins.")),
     field(&Settings::search, "search", TR("Search"))
         .choices({{"tree", TR("Tree")}, {"exact", TR("Exact")}})
         .group(TR("Advanced"))
         .help(
             TR("A tree finds a neighbourhood that is nearly the nearest, in time that hardly grows with the "
                "exemplar; exact compares all of them.")),
     field(&Settings::leaf, "leaf", TR("Leaf"))
         .range(1, 256)
         .when("search", std::string("tree"))
         .group(TR("Advanced"))
         .help(TR("Neighbourhoods in a leaf of the tree: larger finds nearer ones, but takes longer."))},
    run, check, estimate);

} // namespace texloom::wei_levoy
