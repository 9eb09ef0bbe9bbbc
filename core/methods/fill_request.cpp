#include "core/methods/fill_request.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace texloom {

Port ports::known() {
    return {.id = std::string(kKnownPort),
            .title = TR("Known"),
            .help = TR("What of the image to start from is kept; the rest, where it is black, is made anew."),
            .kind = AssetKind::Mask,
            .extent = Extent::Output};
}

const Image* knownOf(const Request& request) {
    return request.inputs.image(kKnownPort);
}

double unknownPixels(const Request& request) {
    const Image* const mask = knownOf(request);
    double pixels = 0;
    for (int y = 0; mask && y < mask->height(); ++y)
        for (int x = 0; x < mask->width(); ++x)
            pixels += (*mask)(x, y, 0) == 0 ? 1 : 0;
    return mask ? pixels : static_cast<double>(request.size.area());
}

void checkFill(const Request& request) {
    if (knownOf(request) && !request.initial())
        failUsage("There is a mask of what is known, but no image to start from; give that too.");
    if (unknownPixels(request) == 0)
        failUsage("All of the image to start from is known, so that there is nothing to make; mask less.");
}

void checkSomeKnown(const Request& request) {
    checkFill(request);
    if (knownOf(request) && unknownPixels(request) == static_cast<double>(request.size.area()))
        failUsage(
            "Nothing of the image to start from is known, so that there is no hole to fill; leave the mask "
            "out, or mark what is to be kept.");
}

namespace {

/// In each row, or column, 1 where one of the `reach` values to either side is.
void widen(std::vector<std::uint8_t>& flags, Size size, int reach, bool rows,
           const std::function<void()>& check) {
    const int length = rows ? size.width : size.height, lines = rows ? size.height : size.width;
    const std::ptrdiff_t step = rows ? 1 : size.width, next = rows ? size.width : 1;
    std::vector<std::uint8_t> line(static_cast<std::size_t>(length));
    for (int n = 0; n < lines; ++n) {
        check();
        std::uint8_t* const first = flags.data() + n * next;
        int count = 0;
        for (int i = -reach; i < length; ++i) {
            if (i + reach < length)
                count += first[(i + reach) * step];
            if (i - reach - 1 >= 0)
                count -= first[(i - reach - 1) * step];
            if (i >= 0)
                line[static_cast<std::size_t>(i)] = count > 0 ? 1 : 0;
        }
        for (int i = 0; i < length; ++i)
            first[i * step] = line[static_cast<std::size_t>(i)];
    }
}

/// 1 where a pixel that is to be made lies at most `reach` pixels away in both directions.
std::vector<std::uint8_t> nearHole(const Image& known, int reach, const std::function<void()>& check) {
    std::vector<std::uint8_t> near;
    near.reserve(static_cast<std::size_t>(known.size().area()));
    for (int y = 0; y < known.height(); ++y)
        for (int x = 0; x < known.width(); ++x)
            near.push_back(known(x, y, 0) == 0 ? 1 : 0);
    check();
    widen(near, known.size(), reach, true, check);
    widen(near, known.size(), reach, false, check);
    return near;
}

Image both(const Image& mask, const std::vector<std::uint8_t>& near) {
    Image result(mask.size(), 1);
    std::size_t at = 0;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            result(x, y, 0) = near[at++] != 0 ? mask(x, y, 0) : 0;
    return result;
}

} // namespace

Request withoutHole(const Request& request, int context, int side, const std::function<void()>& check) {
    Request hidden = request;
    const auto known = request.inputs.first<Image>(kKnownPort);
    if (!known || !request.initial())
        return hidden;
    for (Exemplar& exemplar : hidden.exemplars)
        if (!exemplar.mask() && samePixels(*exemplar.image, *request.initial()))
            exemplar.inputs.set(kMaskPort, known);
    if (context == 0)
        return hidden;
    Request near = hidden;
    const std::vector<std::uint8_t> band = nearHole(*known, context, check);
    Image all({1, 1}, 1);
    for (Exemplar& exemplar : near.exemplars) {
        if (exemplar.image->size() != known->size())
            continue;
        if (!exemplar.mask() && all.size() != known->size()) {
            all = Image(known->size(), 1);
            for (int y = 0; y < all.height(); ++y)
                std::fill_n(all.plane(0).row(y), all.width(), 1.0F);
        }
        check();
        const Image& mask = exemplar.mask() ? *exemplar.mask() : all;
        exemplar.inputs.set(kMaskPort, std::make_shared<const Image>(both(mask, band)));
    }
    return leavesWholePatch(near, side) ? near : hidden;
}

std::uint64_t fillMaskBytes(const Request& request) {
    if (!knownOf(request))
        return 0;
    return (request.exemplars.size() + 2) * Image::bytesFor(request.size, 1);
}

KnownPicture::KnownPicture(const Image& shown, const Image& mask, const Request& request, JobContext& context)
    : image(shown), map(image.size(), request.exemplarSizes()),
      known(static_cast<std::size_t>(image.size().area()), 0) {
    const auto shows = [&](const Image& exemplar, int x, int y) {
        bool same = exemplar.size() == image.size();
        for (int c = 0; c < image.channels() && same; ++c)
            same = exemplar(x, y, c) == image(x, y, c);
        return same;
    };
    std::size_t at = 0;
    for (int y = 0; y < image.height(); ++y) {
        context.check();
        for (int x = 0; x < image.width(); ++x, ++at) {
            known[at] = mask(x, y, 0) != 0 ? 1 : 0;
            wanted += known[at] == 0 ? 1 : 0;
            for (std::size_t e = 0; e < request.exemplars.size() && known[at] != 0 && !map.at(x, y).valid();
                 ++e)
                if (shows(*request.exemplars[e].image, x, y))
                    map.at(x, y) = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                    static_cast<std::uint16_t>(e)};
        }
    }
}

MapKind filledMapKind(const PositionMap& map) {
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x)
            if (!map.at(x, y).valid())
                return MapKind::Dominant;
    return MapKind::Exact;
}

} // namespace texloom
