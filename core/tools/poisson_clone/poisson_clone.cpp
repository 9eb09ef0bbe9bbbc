#include "core/base/error.h"
#include "core/image/mirror.h"
#include "core/match/gradient_mix.h"
#include "core/math/poisson.h"
#include "core/tools/join_region.h"
#include "core/tools/tool.h"

#include <algorithm>

namespace texloom::poisson_clone {

namespace {

constexpr int kFarthest = 65535; ///< pixels by which the region may be moved

/// What fills the region.
enum class Mode { Replace, Mix, Paste };

struct Settings {
    int x = 0, y = 0;
    Mode mode = Mode::Replace;
    double preference = 1;
    bool perChannel = false;
};

/// The region's part within the first picture.
struct Target {
    Region box; ///< of the first picture: around all pixels of the region, with a margin of a pixel if there
                ///< is one
    std::int64_t count = 0; ///< of pixels in the region
};

/// Visits the pixels of the region that come to lie over the first picture, with their places there.
template <class Visit>
void everyCloned(const JoinPictures& pictures, const Settings& settings, const Visit& visit) {
    const Size first = pictures.first.size(), second = pictures.second.size();
    const Region area = pictures.region != nullptr ? Region{0, 0, second} : middleRegion(second);
    const int left = std::max(area.x, -settings.x), right = std::min(area.right(), first.width - settings.x);
    const int top = std::max(area.y, -settings.y),
              bottom = std::min(area.bottom(), first.height - settings.y);
    for (int y = top; y < bottom; ++y) {
        const float* const row = pictures.region != nullptr ? pictures.region->plane(0).row(y) : nullptr;
        for (int x = left; x < right; ++x)
            if (row == nullptr || inRegion(row[x]))
                visit(x + settings.x, y + settings.y);
    }
}

Target targetOf(const JoinPictures& pictures, const Settings& settings) {
    const Size size = pictures.first.size();
    int left = size.width, top = size.height, right = -1, bottom = -1;
    Target target;
    everyCloned(pictures, settings, [&](int x, int y) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
        ++target.count;
    });
    if (target.count == 0)
        return target;
    left = std::max(0, left - 1);
    top = std::max(0, top - 1);
    right = std::min(size.width - 1, right + 1);
    bottom = std::min(size.height - 1, bottom + 1);
    target.box = {left, top, {right - left + 1, bottom - top + 1}};
    return target;
}

/// By rows of a target's box: 1 in the region.
std::vector<std::uint8_t> unknownOf(const Region& box, const JoinPictures& pictures,
                                    const Settings& settings) {
    std::vector<std::uint8_t> unknown(static_cast<std::size_t>(box.size.area()), 0);
    everyCloned(pictures, settings, [&](int x, int y) {
        unknown[static_cast<std::size_t>(y - box.y) * static_cast<std::size_t>(box.size.width) +
                static_cast<std::size_t>(x - box.x)] = 1;
    });
    return unknown;
}

/// The second picture as it comes to lie over the box, mirrored where it has no pixels, so that no gradient
/// is made up there.
Image moved(const ImageView& second, const Region& box, const Settings& settings, const JobContext& context) {
    Image over(box.size, second.channels);
    for (int c = 0; c < over.channels(); ++c)
        for (int y = 0; y < box.size.height; ++y) {
            context.check();
            const int fromY = mirrored(box.y + y - settings.y, second.height);
            for (int x = 0; x < box.size.width; ++x)
                over(x, y, c) = second(mirrored(box.x + x - settings.x, second.width), fromY, c);
        }
    return over;
}

/// The values of all channels in the region, by rows.
std::vector<float> inTarget(const std::vector<std::uint8_t>& unknown, const ImageView& of) {
    std::vector<float> values;
    for (int c = 0; c < of.channels; ++c) {
        auto in = unknown.begin();
        for (int y = 0; y < of.height; ++y)
            for (int x = 0; x < of.width; ++x)
                if (*in++ != 0)
                    values.push_back(of(x, y, c));
    }
    return values;
}

/// Copies the region's pixels of `from`, a picture of the box, into the first picture.
void put(const std::vector<std::uint8_t>& unknown, const Region& box, const ImageView& from, Image& to) {
    for (int c = 0; c < from.channels; ++c) {
        auto in = unknown.begin();
        for (int y = 0; y < from.height; ++y)
            for (int x = 0; x < from.width; ++x)
                if (*in++ != 0)
                    to(box.x + x, box.y + y, c) = from(x, y, c);
    }
}

Image make(const JoinPictures& pictures, const Settings& settings, JobContext& context) {
    context.stage(0.1, TR("Choosing gradients"));
    const Region box = targetOf(pictures, settings).box;
    context.check();
    const std::vector<std::uint8_t> unknown = unknownOf(box, pictures, settings);
    Image result(pictures.first);
    Image before(pictures.first.crop(box.x, box.y, box.size));
    const Image over = moved(pictures.second, box, settings, context);
    if (settings.mode == Mode::Paste) {
        put(unknown, box, over, result);
        context.progress(1);
        context.stage(0.9, TR("Joining gradients"));
        context.progress(1);
        return result;
    }
    const ImageView guide = settings.mode == Mode::Mix ? before.view() : over.view();
    const std::vector<float> wanted = inTarget(
        unknown, mixedDivergence(guide, over, {settings.preference, settings.perChannel, false}, context));
    context.stage(0.9, TR("Joining gradients"));
    solvePoisson(unknown, wanted, before, [&](double share) {
        context.check();
        context.progress(share);
    });
    put(unknown, box, before, result);
    context.progress(1);
    return result;
}

void check(const JoinPictures& pictures, const Settings& settings) {
    const Target target = targetOf(pictures, settings);
    const Size first = pictures.first.size();
    if (target.count == 0)
        failUsage("Moved by {}, {} px, the region of the second image does not lie over the first of {} × {} "
                  "px; move it less, or paint it elsewhere.",
                  settings.x, settings.y, first.width, first.height);
    if (target.count == first.area())
        failUsage("The region covers all of the first image of {} × {} px, so that there is nothing to join "
                  "it with; paint a smaller one.",
                  first.width, first.height);
}

std::uint64_t bytes(const JoinPictures& pictures, const Settings& settings) {
    const Target target = targetOf(pictures, settings);
    const int channels = pictures.first.channels;
    return Image::bytesFor(pictures.first.size(), channels) + 3 * Image::bytesFor(target.box.size, channels) +
           regionPoissonBytes(static_cast<std::uint64_t>(target.count), channels) +
           static_cast<std::uint64_t>(target.box.size.area()) + (1U << 20);
}

ToolPreset way(std::string title, std::string help, const char* mode) {
    return {std::move(title), std::move(help), {{"mode", std::string(mode)}}};
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Clone seamlessly"),
     .summary =
         TR("Puts a region of the second image into the first one, so that no seam shows: its structure "
            "comes along, its light and colour are those around it."),
     .citation = "Pérez, Gangnet & Blake 2003; Raad, thesis 2016, section 5.8",
     .presets = {way(TR("Replaced"), TR("The structure of the second image alone."), "replace"),
                 way(TR("Mixed"), TR("The stronger structure of both, so that the first shows through."),
                     "mix"),
                 way(TR("Pasted"), TR("The pixels as they are, to compare with."), "paste")},
     .handle = ToolHandle::Offset,
     .region = ToolRegion{TR("Region"), TR("Black where the second image is cloned. Without it, that is the "
                                           "middle half of its width and height.")}},
    {field(&Settings::x, "offset-x", TR("Moved right"))
         .range(-kFarthest, kFarthest)
         .usual(-512, 512)
         .unit("px")
         .help(TR("How far right of its place in the second image the region comes to lie in the first.")),
     field(&Settings::y, "offset-y", TR("Moved down"))
         .range(-kFarthest, kFarthest)
         .usual(-512, 512)
         .unit("px")
         .help(TR("How far below its place in the second image the region comes to lie in the first.")),
     field(&Settings::mode, "mode", TR("Mode"))
         .choices({{"replace", TR("Replaced")}, {"mix", TR("Mixed")}, {"paste", TR("Pasted")}})
         .help(TR("Whose gradients fill the region: those of the second image, the stronger ones of both, or "
                  "none: pixels are pasted.")),
     field(&Settings::preference, "preference", TR("Preference"))
         .range(0.1, 10)
         .when("mode", std::string("mix"))
         .help(TR("Factor on the first image's gradients before they are compared: larger keeps more of the "
                  "first image.")),
     field(&Settings::perChannel, "per-channel", TR("Each channel for itself"))
         .when("mode", std::string("mix"))
         .help(TR("Each channel takes its own stronger gradient, as printed; otherwise the length over all "
                  "channels decides for the pixel, so that no false colours appear."))},
    Tool::Join<Settings>{make, check, bytes, false});

} // namespace texloom::poisson_clone
