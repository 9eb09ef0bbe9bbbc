#include "ui/runs/quick_run.h"

#include <algorithm>

namespace texloom::ui {

namespace {

/// The top left of an image to start from, for a preview of this size.
ExemplarFile croppedTo(ExemplarFile file, Size size) {
    if (file.image->width() >= size.width && file.image->height() >= size.height)
        file.image = std::make_shared<const Image>(file.image->view().crop(0, 0, size));
    return file;
}

} // namespace

Size quickSize(Size size) {
    constexpr int kQuickSide = 384;
    const int longer = size.longerSide();
    if (longer <= kQuickSide)
        return size;
    const auto shortened = [=](int side) {
        return std::max(1, static_cast<int>(static_cast<std::int64_t>(side) * kQuickSide / longer));
    };
    return {shortened(size.width), shortened(size.height)};
}

RunInput quickOf(RunInput input) {
    input.size = quickSize(input.size);
    input.region.reset();
    if (input.initial)
        input.initial = croppedTo(*std::move(input.initial), input.size);
    return input;
}

} // namespace texloom::ui
