#include "core/volume/box.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <limits>

namespace texloom {

namespace {

/// The common part of [a, a + aLength) and [b, b + bLength).
void intersect(std::int64_t a, int aLength, std::int64_t b, int bLength, std::int64_t& begin, int& length) {
    begin = std::max(a, b);
    length = static_cast<int>(std::max<std::int64_t>(0, std::min(a + aLength, b + bLength) - begin));
}

bool tooFar(std::int64_t begin, int length) {
    return begin < -Box::kFarthest || begin > Box::kFarthest - length;
}

} // namespace

std::int64_t VolumeSize::voxels() const {
    std::int64_t count = static_cast<std::int64_t>(width) * height;
    return __builtin_mul_overflow(count, depth, &count) ? std::numeric_limits<std::int64_t>::max() : count;
}

std::string sizeText(const VolumeSize& size) {
    return fmt::format("{} × {} × {}", size.width, size.height, size.depth);
}

bool Box::within(const Box& whole) const {
    return !size.empty() && intersection(*this, whole) == *this;
}

void Box::check() const {
    if (size.empty())
        failUsage("A box of {} voxels is empty; each side must be at least 1.", sizeText(size));
    if (tooFar(x, size.width) || tooFar(y, size.height) || tooFar(z, size.depth))
        failUsage("The box from ({}, {}, {}) on lies too far out; coordinates go from −{} to {}.", x, y, z,
                  grouped(kFarthest), grouped(kFarthest));
}

Box intersection(const Box& a, const Box& b) {
    Box common;
    intersect(a.x, a.size.width, b.x, b.size.width, common.x, common.size.width);
    intersect(a.y, a.size.height, b.y, b.size.height, common.y, common.size.height);
    intersect(a.z, a.size.depth, b.z, b.size.depth, common.z, common.size.depth);
    return common;
}

std::string boxText(const Box& box) {
    return fmt::format("x {} to {}, y {} to {}, z {} to {}", box.x, box.endX() - 1, box.y, box.endY() - 1,
                       box.z, box.endZ() - 1);
}

} // namespace texloom
