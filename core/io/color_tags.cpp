#include "core/io/color_tags.h"

#include "core/base/text.h"
#include "core/io/icc_profile.h"
#include "core/io/png_chunks.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

void noteUnconverted(ImageFileInfo& info, const Message& what) {
    info.notes.push_back(message("{} carries {}, which Texloom cannot convert; its colours are taken as {}.",
                                 info.name, what,
                                 Message::verbatim(info.space == "linear" ? "linear Rec.709" : "sRGB")));
}

/// A named space where it is one, as near as makes no difference.
void take(ImageFileInfo& info, FileColor color) {
    if (const std::string space = color.space(); !space.empty()) {
        info.space = space;
        return;
    }
    info.notes.push_back(
        message("{} is in colours of its own ({}), which were converted.", info.name, color.name));
    info.space = "file";
    info.color = std::move(color);
}

bool takeProfile(ImageFileInfo& info, const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const profile = spec.find_attribute("ICCProfile");
    if (!profile || profile->type().basesize() != 1)
        return false;
    const Message name =
        info.iccProfile.empty() ? TR("a profile") : message("the profile “{}”", info.iccProfile);
    std::optional<FileColor> color = colorOfProfile(
        {static_cast<const char*>(profile->data()), static_cast<std::size_t>(profile->datasize())});
    if (color) {
        color->name = name;
        take(info, std::move(*color));
    } else {
        noteUnconverted(info, name);
    }
    return true;
}

/// The codes of ITU-T H.273. @return whether they say anything
bool takeCodes(ImageFileInfo& info, const std::array<int, 4>& codes) {
    FileColor color;
    color.name = message("the codes {}-{}-{}-{} of cICP", codes[0], codes[1], codes[2], codes[3]);
    const auto curve = [&](FileColor::Curve kind, double power) {
        color.curve = kind;
        color.power = power;
        return true;
    };
    const bool knownCurve = codes[1] == 13  ? curve(FileColor::Curve::Srgb, 1)
                            : codes[1] == 8 ? curve(FileColor::Curve::Linear, 1)
                            : codes[1] == 4 ? curve(FileColor::Curve::Power, 2.2)
                            : codes[1] == 5 ? curve(FileColor::Curve::Power, 2.8)
                                            : false;
    const bool knownPrimaries = codes[0] == 1 || codes[0] == 9 || codes[0] == 12;
    if (codes[0] == 9)
        color.toRec709 = toRec709({0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290});
    else if (codes[0] == 12)
        color.toRec709 = toRec709({0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290});
    if (knownCurve && knownPrimaries && codes[2] == 0 && codes[3] == 1)
        take(info, std::move(color));
    else
        noteUnconverted(info, color.name);
    return true;
}

void takePng(ImageFileInfo& info, const OIIO::ImageSpec& spec, const PngColor& png) {
    // In the order of the PNG specification: cICP, iCCP, sRGB, gAMA with cHRM.
    if ((png.codes && takeCodes(info, *png.codes)) || takeProfile(info, spec))
        return;
    info.space = "srgb";
    if (png.srgb || (!png.gamma && !png.primaries))
        return;
    constexpr double kSrgbGamma = 0.45455, kNear = 0.001; // how files of sRGB call their curve
    const double gamma = png.gamma.value_or(kSrgbGamma);
    FileColor color;
    color.power = 1 / gamma;
    color.curve = std::abs(gamma - kSrgbGamma) < kNear ? FileColor::Curve::Srgb
                  : std::abs(gamma - 1) < kNear        ? FileColor::Curve::Linear
                                                       : FileColor::Curve::Power;
    color.name = message("gamma {:.3g}", color.power);
    if (png.primaries) {
        color.toRec709 = toRec709(*png.primaries);
        color.name = message("gamma {:.3g} and primaries of its own", color.power);
    }
    take(info, std::move(color));
}

void takeChromaticities(ImageFileInfo& info, const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const tag = spec.find_attribute("chromaticities");
    if (!tag || tag->type().basetype != OIIO::TypeDesc::FLOAT || tag->type().numelements() != 8)
        return;
    Chromaticities primaries{};
    std::copy_n(static_cast<const float*>(tag->data()), primaries.size(), primaries.begin());
    FileColor color;
    color.toRec709 = toRec709(primaries);
    color.name = TR("primaries of its own");
    take(info, std::move(color));
}

} // namespace

void takeColorTags(ImageFileInfo& info, const OIIO::ImageSpec& spec, const std::filesystem::path& path) {
    if (info.texts.contains("texloom:space"))
        return;
    if (info.format == "png")
        takePng(info, spec, readPngColor(path));
    else if (info.format == "openexr")
        takeChromaticities(info, spec);
    else
        takeProfile(info, spec);
}

} // namespace texloom
