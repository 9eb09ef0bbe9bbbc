#include "core/color/color_pipeline.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_config.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace ocio = OCIO_NAMESPACE;

namespace texloom::color {

namespace {

using Check = std::function<void()>;

constexpr int kPixelsAtOnce = 1 << 16; ///< converted between two calls of a check: a few ms
const char* const kWorkingSpace = "srgb";
const char* const kDisplay = "sRGB";
const char* const kView = "Plain";

const ocio::ConstConfigRcPtr& config() {
    static const ocio::ConstConfigRcPtr loaded = [] {
        std::istringstream text(kColorConfig);
        return ocio::Config::CreateFromStream(text);
    }();
    return loaded;
}

void process(Image& image, const ocio::ConstProcessorRcPtr& processor, const Check& check) {
    if (processor->isNoOp())
        return;
    // Lossless: the fast approximations of pow() would not bring an 8-bit or half value back to itself.
    const auto cpu = processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    const PlaneSpan red = image.plane(0);
    const bool grey = image.channels() < 3;
    const PlaneSpan green = grey ? red : image.plane(1);
    const PlaneSpan blue = grey ? red : image.plane(2);
    const int rowsAtOnce = std::max(1, kPixelsAtOnce / std::max(1, red.width));
    for (int y = 0; y < red.height; y += rowsAtOnce) {
        if (check)
            check();
        ocio::PlanarImageDesc pixels(red.row(y), green.row(y), blue.row(y), nullptr, red.width,
                                     std::min(rowsAtOnce, red.height - y), ocio::BIT_DEPTH_F32, sizeof(float),
                                     red.stride * static_cast<std::ptrdiff_t>(sizeof(float)));
        cpu->apply(pixels);
    }
}

void convert(Image& image, std::string_view from, std::string_view to, const Check& check) {
    findSpace(from);
    findSpace(to);
    if (from == to || from == "raw" || to == "raw")
        return;
    process(image, config()->getProcessor(std::string(from).c_str(), std::string(to).c_str()), check);
}

ocio::TransformRcPtr srgbToLinear() {
    const auto curve = ocio::ColorSpaceTransform::Create();
    curve->setSrc("srgb");
    curve->setDst("linear");
    return curve;
}

ocio::TransformRcPtr curveOf(const FileColor& color) {
    if (color.curve == FileColor::Curve::Srgb)
        return srgbToLinear();
    if (color.curve == FileColor::Curve::Power) {
        const auto power = ocio::ExponentTransform::Create();
        power->setValue({color.power, color.power, color.power, 1});
        power->setNegativeStyle(ocio::NEGATIVE_MIRROR);
        return power;
    }
    const auto table = ocio::Lut1DTransform::Create(color.table.size(), false);
    for (std::size_t i = 0; i < color.table.size(); ++i)
        table->setValue(i, color.table[i], color.table[i], color.table[i]);
    return table;
}

/// From a file's numbers to linear Rec.709.
ocio::GroupTransformRcPtr lightOf(const FileColor& color) {
    auto group = ocio::GroupTransform::Create();
    if (color.curve != FileColor::Curve::Linear)
        group->appendTransform(curveOf(color));
    std::array<double, 16> matrix{};
    for (std::size_t i = 0; i < 3; ++i)
        std::copy_n(color.toRec709.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    matrix.begin() + static_cast<std::ptrdiff_t>(4 * i));
    matrix[15] = 1;
    const auto primaries = ocio::MatrixTransform::Create();
    primaries->setMatrix(matrix.data());
    group->appendTransform(primaries);
    return group;
}

} // namespace

const std::vector<ColorSpace>& spaces() {
    static const std::vector<ColorSpace> all = {
        {"srgb", TR("sRGB")},
        {"linear", TR("Linear Rec.709")},
        {"acescg", TR("ACEScg")},
        {"raw", TR("Data (never converted)")},
    };
    return all;
}

const ColorSpace& findSpace(std::string_view id) {
    static const ColorSpace own{kFileSpace, TR("As the file's tags say")};
    if (id == kFileSpace)
        return own;
    std::vector<std::string> known;
    for (const ColorSpace& space : spaces()) {
        if (space.id == id)
            return space;
        known.push_back(space.id);
    }
    failUsage("There is no colour space {}; choose one of {}.", id, listOf(known));
}

void toWorking(Image& image, std::string_view space, const Check& check) {
    convert(image, space, kWorkingSpace, check);
}

void fromWorking(Image& image, std::string_view space, const Check& check) {
    convert(image, kWorkingSpace, space, check);
}

void toWorking(Image& image, const FileColor& from, const Check& check) {
    process(image, config()->getProcessor(lightOf(from)), check);
    convert(image, "linear", kWorkingSpace, check);
}

void fromWorking(Image& image, const FileColor& to, const Check& check) {
    convert(image, kWorkingSpace, "linear", check);
    const auto light = lightOf(to);
    light->setDirection(ocio::TRANSFORM_DIR_INVERSE);
    process(image, config()->getProcessor(light), check);
}

void toDisplay(Image& image) {
    const auto transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(kWorkingSpace);
    transform->setDisplay(kDisplay);
    transform->setView(kView);
    process(image, config()->getProcessor(transform), {});
}

} // namespace texloom::color
