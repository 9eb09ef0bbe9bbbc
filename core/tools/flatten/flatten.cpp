#include "core/base/text.h"
#include "core/tools/flatten/light.h"
#include "core/tools/tool.h"

namespace texloom::flatten {

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Even out the light"),
     .summary = TR("Takes slow changes of brightness out of the colours, so that parts from light and dark "
                   "places match."),
     .adjusts = true},
    {field(&Settings::model, "flatten", TR("Light"))
         .choices({{"smooth", TR("Soft changes")}, {"polynomial", TR("One slope over the whole")}})
         .help(TR("What the light is taken to be: what a wide window sees, or a low polynomial.")),
     field(&Settings::strength, "strength", TR("Strength"))
         .range(0, 1)
         .help(TR("How much of the unevenness is taken out; 1 is all.")),
     field(&Settings::width, "width", TR("Softness"))
         .range(0.02, 1)
         .when("flatten", std::string("smooth"))
         .help(
             TR("Width of the window that finds the light, in shares of the shorter side: larger leaves more "
                "of the texture's own shades.")),
     field(&Settings::order, "order", TR("Bends"))
         .range(1, 4)
         .when("flatten", std::string("polynomial"))
         .help(TR("How often the light may bend over the exemplar: 1 is a plain slope."))},
    evenOut);

} // namespace texloom::flatten
