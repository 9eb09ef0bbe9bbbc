#include "core/tools/join_region.h"

#include <algorithm>

namespace texloom {

Region middleRegion(Size picture) {
    const Size half{std::max(1, picture.width / 2), std::max(1, picture.height / 2)};
    return {(picture.width - half.width) / 2, (picture.height - half.height) / 2, half};
}

} // namespace texloom
