#include "ui/runs/quick_run.h"

#include <algorithm>

namespace texloom::ui {

namespace {

/// The top left of a picture of the output's size, for a preview of this size.
InputFile croppedTo(InputFile input, Size size) {
    const Image* const image = input.image();
    if (image == nullptr || image->width() < size.width || image->height() < size.height)
        return input;
    input.file.image = std::make_shared<const Image>(image->view().crop(0, 0, size));
    return InputFile(std::move(input.file));
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
    for (auto& [id, files] : input.inputs)
        if (portOf(input.steps, id).extent == Extent::Output)
            for (InputFile& file : files)
                file = croppedTo(std::move(file), input.size);
    return input;
}

} // namespace texloom::ui
