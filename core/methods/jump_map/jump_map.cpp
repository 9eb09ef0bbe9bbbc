#include "core/base/text.h"
#include "core/methods/jump_map/walker.h"
#include "core/methods/method.h"

namespace texloom::jump_map {

namespace {

void check(const Request& request, const Settings& settings) {
    checkSquares(request, oddSide(settings.neighbourhood));
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const int channels = request.channels();
    const std::vector<Size> exemplars = request.exemplarSizes();
    double pixels = 0;
    for (const Size& size : exemplars)
        pixels += static_cast<double>(size.area());
    Estimate need;
    need.bytes = PixelCanvas::bytesFor(request.size, channels) + Image::bytesFor(request.size, channels) +
                 ScanOrder::bytesFor(request.size) + PixelPyramid::bytesFor(request) +
                 NeighbourhoodSet::bytesFor(exemplars) + JumpLists::bytesFor(exemplars, settings.jumps) +
                 (8U << 20U) + static_cast<std::uint64_t>(threads) * 65536;
    const double floats = static_cast<double>(settings.neighbourhood) * settings.neighbourhood * channels;
    need.seconds =
        static_cast<double>(request.size.area()) * 1.2e-7 + pixels * (3e-6 + settings.jumps * floats * 5e-9);
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Walker(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Jump map"),
     .summary = TR(
         "Finds out once which places of the exemplar look alike, and then walks through it, jumping between "
         "them. The fastest of the methods that work pixel by pixel; joins are rougher than Ashikhmin's."),
     .citation = "Zelinka & Garland, Eurographics Workshop on Rendering 2002",
     .category = Category::Pixels,
     .suits = {.regular = 1, .grain = 3, .objects = 2, .large = 2},
     .takes = {ports::exemplars(), ports::mask()},
     .gives = {ports::wrappingImage(), ports::map()}},
    {field(&Settings::neighbourhood, "neighbourhood", TR("Neighbourhood"))
         .range(3, 21)
         .unit("px")
         .help(TR("Side of the squares by which places look alike (an even one counts as the next odd): "
                  "larger jumps only where larger structures agree.")),
     field(&Settings::jumps, "jumps", TR("Jumps"))
         .range(1, 16)
         .symbol("k")
         .help(TR("Places that are kept for each pixel of the exemplar because they look like it: more vary "
                  "more.")),
     field(&Settings::apart, "apart", TR("Distance"))
         .range(1, 200)
         .unit("px")
         .scaled(0.08)
         .symbol("r")
         .help(TR(
             "How far these lie from the pixel and from each other at least: larger leads to more different "
             "parts of the exemplar.")),
     field(&Settings::jump, "jump", TR("Jump probability"))
         .range(0, 1)
         .help(TR(
             "How likely a walk jumps where another place looks the same: larger copies smaller pieces."))},
    run, check, estimate);

} // namespace texloom::jump_map
