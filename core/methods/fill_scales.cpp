#include "core/methods/fill_scales.h"

#include "core/image/half_scale.h"
#include "core/methods/fill_request.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace texloom {

namespace {

int deepest(const Image& known, const std::function<void()>& check) {
    const std::vector<int> depth = depths(known, check);
    return *std::max_element(depth.begin(), depth.end());
}

bool anyKnown(const Image& known) {
    return valueRange(known).largest > 0;
}

} // namespace

std::vector<FillScale> fillScales(const Request& request, int side, int most,
                                  const std::function<void()>& check) {
    std::vector<FillScale> scales;
    scales.push_back({*request.initial(), *knownOf(request)});
    while (static_cast<int>(scales.size()) < most) {
        check();
        const FillScale& fine = scales.back();
        if (fine.size().shorterSide() < 2 * side || 2 * deepest(fine.known, check) <= side)
            break;
        FillScale coarse{halved(fine.picture, check), halvedMask(fine.known.view().plane(0), check)};
        if (!anyKnown(coarse.known))
            break;
        scales.push_back(std::move(coarse));
    }
    return scales;
}

std::vector<int> depths(const Image& known, const std::function<void()>& check) {
    const int width = known.width(), height = known.height();
    constexpr int kFar = std::numeric_limits<int>::max() / 2;
    std::vector<int> depth(static_cast<std::size_t>(known.size().area()), kFar);
    const auto at = [&](int x, int y) -> int& {
        return depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)];
    };
    const auto lower = [&](int x, int y, int dx, int dy) {
        if (x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < height)
            at(x, y) = std::min(at(x, y), at(x + dx, y + dy) + 1);
    };
    for (int y = 0; y < height; ++y) {
        check();
        for (int x = 0; x < width; ++x) {
            if (known(x, y, 0) != 0)
                at(x, y) = 0;
            for (int dx = -1; dx <= 1; ++dx)
                lower(x, y, dx, -1);
            lower(x, y, -1, 0);
        }
    }
    for (int y = height - 1; y >= 0; --y) {
        check();
        for (int x = width - 1; x >= 0; --x) {
            for (int dx = -1; dx <= 1; ++dx)
                lower(x, y, dx, 1);
            lower(x, y, 1, 0);
        }
    }
    return depth;
}

Request requestAt(const Request& request, const ExemplarPyramid& exemplars, int level, Size size) {
    Request scaled;
    for (const PatchSource& source : exemplars.level(level)) {
        const double weight = request.exemplars[scaled.exemplars.size()].weight;
        Exemplar& exemplar = scaled.exemplars.emplace_back();
        exemplar.image = std::make_shared<const Image>(source.image);
        exemplar.weight = weight;
        if (!source.mask.data)
            continue;
        Image mask({source.mask.width, source.mask.height}, 1);
        for (int y = 0; y < mask.height(); ++y)
            std::copy_n(source.mask.row(y), mask.width(), mask.plane(0).row(y));
        exemplar.inputs.set(kMaskPort, std::make_shared<const Image>(std::move(mask)));
    }
    scaled.size = size;
    scaled.wrap = request.wrap;
    return scaled;
}

Request requestAt(const Request& request, const ExemplarPyramid& exemplars, int level,
                  const FillScale& scale) {
    Request scaled = requestAt(request, exemplars, level, scale.size());
    scaled.inputs.set(kInitialPort, std::make_shared<const Image>(scale.picture));
    scaled.inputs.set(kKnownPort, std::make_shared<const Image>(scale.known));
    return scaled;
}

PositionMap finer(const PositionMap& map, Size size, std::vector<Size> exemplars,
                  const std::function<void()>& check) {
    PositionMap fine(size, std::move(exemplars));
    for (int y = 0; y < fine.height(); ++y) {
        check();
        for (int x = 0; x < fine.width(); ++x) {
            Source source = map.at(std::min(x / 2, map.width() - 1), std::min(y / 2, map.height() - 1));
            if (!source.valid())
                continue;
            const Size from = fine.exemplarSizes()[source.exemplar];
            source.x = static_cast<std::uint16_t>(std::min(2 * source.x + x % 2, from.width - 1));
            source.y = static_cast<std::uint16_t>(std::min(2 * source.y + y % 2, from.height - 1));
            fine.at(x, y) = source;
        }
    }
    return fine;
}

PositionMap finer(const PositionMap& map, const Image& known, std::vector<Size> exemplars,
                  const std::function<void()>& check) {
    PositionMap fine = finer(map, known.size(), std::move(exemplars), check);
    for (int y = 0; y < fine.height(); ++y)
        for (int x = 0; x < fine.width(); ++x)
            if (known(x, y, 0) != 0)
                fine.at(x, y) = {};
    return fine;
}

std::uint64_t fillScalesBytes(const Request& request) {
    return Image::bytesFor(request.size, request.channels() + 1) * 3 / 2 +
           static_cast<std::uint64_t>(request.size.area()) * sizeof(int);
}

} // namespace texloom
