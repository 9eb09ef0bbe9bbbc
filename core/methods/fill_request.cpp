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
            .help =
                TR("What of the image to start from is kept; the rest, where it is black, is made again."),
            .kind = AssetKind::Mask,
            .extent = Extent::Output};
}

const Image* knownOf(const Request& request) {
    return request.inputs.image(kKnownPort);
}

std::vector<std::uint8_t> madeOf(const Image& known) {
    std::vector<std::uint8_t> made;
    made.reserve(static_cast<std::size_t>(known.size().area()));
    for (int y = 0; y < known.height(); ++y)
        for (int x = 0; x < known.width(); ++x)
            made.push_back(known(x, y, 0) == 0 ? 1 : 0);
    return made;
}

double unknownPixels(const Request& request) {
    const Image* const mask = knownOf(request);
    double pixels = 0;
    for (int y = 0; mask && y < mask->height(); ++y)
        for (int x = 0; x < mask->width(); ++x)
            pixels += (*mask)(x, y, 0) == 0 ? 1 : 0;
    return mask ? pixels : static_cast<double>(request.size.area());
}

namespace {

bool showsHole(const Exemplar& exemplar, const Request& request) {
    return !exemplar.mask() && request.initial() && samePixels(*exemplar.image, *request.initial());
}

[[noreturn]] void failNothingKnown(Size size) {
    failUsage("Nothing of the image to start from, {} × {} px, is known, so that there is no hole to fill; "
              "leave the mask out, or mark what is to be kept.",
              size.width, size.height);
}

/// Whether there is nothing to copy but the picture's own rest.
bool fillsFromItself(const Request& request) {
    return !request.exemplars.empty() &&
           std::all_of(request.exemplars.begin(), request.exemplars.end(),
                       [&](const Exemplar& exemplar) { return showsHole(exemplar, request); });
}

} // namespace

void checkFill(const Request& request) {
    if (knownOf(request) && !request.initial())
        failUsage("There is a mask of what is known, but no image to start from; give that too.");
    const Size size = request.size;
    const double unknown = unknownPixels(request), rest = static_cast<double>(size.area()) - unknown;
    if (unknown == 0)
        failUsage("All {} × {} px of the image to start from are known, so that there is nothing to make; "
                  "mask less.",
                  size.width, size.height);
    if (knownOf(request) && rest == 0 && fillsFromItself(request))
        failNothingKnown(size);
    if (knownOf(request) && rest > 0 && unknown > rest && fillsFromItself(request))
        failUsage("The hole of {:.0f} px is larger than the {:.0f} px of the picture that are left to fill "
                  "it from; mark a smaller one, or add another exemplar.",
                  unknown, rest);
}

void checkSomeKnown(const Request& request) {
    checkFill(request);
    if (knownOf(request) && unknownPixels(request) == static_cast<double>(request.size.area()))
        failNothingKnown(request.size);
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
        if (showsHole(exemplar, request))
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

namespace {

/// Around all pixels of a mask that are, or are not, 0; empty if there are none.
Region around(const PlaneView& mask, bool zero) {
    int left = mask.width, top = mask.height, right = 0, bottom = 0;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if ((mask(x, y) == 0) == zero) {
                left = std::min(left, x);
                top = std::min(top, y);
                right = std::max(right, x + 1);
                bottom = std::max(bottom, y + 1);
            }
    return right > left ? Region{left, top, {right - left, bottom - top}} : Region{};
}

/// A stretch along an axis: where it begins, and how long it is.
struct Stretch {
    int begin, length;
};

/// From the lower to the higher of two stretches' ends; all of an axis that wraps where that reaches its end.
Stretch stretched(Stretch a, Stretch b, int length, bool wraps) {
    const int begin = std::min(a.begin, b.begin);
    const int end = std::max(a.begin + a.length, b.begin + b.length);
    if (wraps && (begin <= 0 || end >= length))
        return {0, length};
    return {std::max(begin, 0), std::min(end, length) - std::max(begin, 0)};
}

std::shared_ptr<const Image> cut(const Image& image, const Region& part) {
    return std::make_shared<const Image>(image.view().crop(part.x, part.y, part.size));
}

} // namespace

FillWindow::FillWindow(const Request& hidden, int margin, const std::function<void()>& check)
    : m_whole(&hidden), m_cut(hidden), m_part(hidden.part()), m_isCut(hidden.exemplars.size(), 0) {
    const Region hole = around(knownOf(hidden)->view().plane(0), true);
    Stretch across{hole.x - margin, hole.size.width + 2 * margin};
    Stretch down{hole.y - margin, hole.size.height + 2 * margin};
    const Size size = hidden.size;
    for (const Exemplar& exemplar : hidden.exemplars) {
        check();
        if (exemplar.image->size() != size)
            continue;
        const Region shown = exemplar.mask() ? around(exemplar.mask()->view().plane(0), false) : m_part;
        if (shown.size.empty())
            continue;
        across = stretched(across, {shown.x, shown.size.width}, size.width, hidden.wrap.x);
        down = stretched(down, {shown.y, shown.size.height}, size.height, hidden.wrap.y);
    }
    across = stretched(across, across, size.width, hidden.wrap.x);
    down = stretched(down, down, size.height, hidden.wrap.y);
    m_part = {across.begin, down.begin, {across.length, down.length}};
    if (m_part.size == size)
        return;
    m_cut.size = m_part.size;
    m_cut.wrap = {hidden.wrap.x && across.length == size.width, hidden.wrap.y && down.length == size.height};
    m_cut.inputs.set(kInitialPort, cut(*hidden.initial(), m_part));
    m_cut.inputs.set(kKnownPort, cut(*knownOf(hidden), m_part));
    for (std::size_t e = 0; e < m_cut.exemplars.size(); ++e) {
        Exemplar& exemplar = m_cut.exemplars[e];
        check();
        if (exemplar.image->size() != size)
            continue;
        m_isCut[e] = 1;
        if (exemplar.mask())
            exemplar.inputs.set(kMaskPort, cut(*exemplar.mask(), m_part));
        exemplar.image = cut(*exemplar.image, m_part);
    }
}

Synthesis FillWindow::filled(const PositionMap& made, JobContext& context) const {
    KnownPicture picture(*m_whole->initial(), *knownOf(*m_whole), *m_whole, context);
    for (int y = 0; y < made.height(); ++y)
        for (int x = 0; x < made.width(); ++x) {
            Source source = made.at(x, y);
            if (!source.valid() || (*knownOf(*m_whole))(m_part.x + x, m_part.y + y, 0) != 0)
                continue;
            if (m_isCut[source.exemplar] != 0) {
                source.x = static_cast<std::uint16_t>(source.x + m_part.x);
                source.y = static_cast<std::uint16_t>(source.y + m_part.y);
            }
            picture.map.at(m_part.x + x, m_part.y + y) = source;
            for (int c = 0; c < picture.image.channels(); ++c)
                picture.image(m_part.x + x, m_part.y + y, c) =
                    (*m_whole->exemplars[source.exemplar].image)(source.x, source.y, c);
        }
    Synthesis result;
    result.mapKind = filledMapKind(picture.map);
    result.map = std::move(picture.map);
    result.image = std::move(picture.image);
    return result;
}

std::uint64_t FillWindow::bytesFor(const Request& request) {
    std::uint64_t bytes = Image::bytesFor(request.size, request.channels() + 1);
    for (const Size& size : request.exemplarSizes())
        bytes += size == request.size ? Image::bytesFor(size, request.channels() + 1) : 0;
    return bytes;
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
