#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/methods/pixel_fields.h"
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
         "details may become blurred."),
     .citation = "Wei & Levoy, SIGGRAPH 2000",
     .category = Category::Pixels,
     .suits = {.regular = 1, .grain = 3, .objects = 2, .large = 1},
     .takes = {ports::exemplars(), ports::mask(), ports::initial()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {neighbourhoodField(&Settings::neighbourhood, 21)
         .symbol("n")
         .help(TR(
             "Side of the square whose known half is compared (an even one counts as the next odd): larger "
             "keeps larger structures, but takes longer and copies more.")),
     levelsField(&Settings::levels),
     field(&Settings::parent, "parent", TR("Parent square"))
         .range(0, 9)
         .unit("px")
         .group(TR("Advanced"))
         .help(TR(
             "Side of the square that is compared on the next coarser scale (an even one counts as the next "
             "odd): larger follows the coarser scale more closely; 0 forgets it.")),
     passesField(&Settings::passes, 5)
         .help(
             TR("How often each scale is made: passes after the first see all that surrounds a pixel, which "
                "repairs seams.")),
     field(&Settings::search, "search", TR("Search"))
         .choices({{"tree", TR("Tree")}, {"exact", TR("Exact")}})
         .group(TR("Advanced"))
         .help(
             TR("A tree finds a neighbourhood that is nearly the nearest, in time that hardly grows with the "
                "exemplar; exact compares all of them.")),
     leafField(&Settings::leaf).when("search", std::string("tree"))},
    run, check, estimate);

} // namespace texloom::wei_levoy
