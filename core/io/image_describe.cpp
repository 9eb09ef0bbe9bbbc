#include "core/io/image_describe.h"

#include <OpenImageIO/imageio.h>

namespace texloom {

namespace {

std::string depthText(const OIIO::TypeDesc& type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return "8-bit";
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return "16-bit";
    case OIIO::TypeDesc::HALF:
        return "half";
    case OIIO::TypeDesc::FLOAT:
        return "float";
    default:
        return fmt::format("{}-bit", type.basesize() * 8);
    }
}

std::string spaceOf(const OIIO::ImageSpec& spec) {
    std::string own = spec.get_string_attribute("texloom:space");
    if (!own.empty() && own != "file") // which says nothing without the tags that it stands for
        return own;
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const bool linear =
        OIIO::Strutil::istarts_with(space, "lin") || OIIO::Strutil::iequals(space, "scene_linear");
    return linear || (space.empty() && spec.format.is_floating_point()) ? "linear" : "srgb";
}

std::string recipeOf(const OIIO::ImageSpec& spec) {
    std::string embedded = spec.get_string_attribute("texloom:recipe");
    if (!embedded.empty())
        return embedded;
    // TIFF has no place for attributes of one's own; there the description holds it.
    std::string description = spec.get_string_attribute("ImageDescription");
    return description.find("\"texloom\"") != std::string::npos ? description : std::string();
}

/// Texts in the metadata by which Texloom knows its own files.
std::map<std::string, std::string> textsOf(const OIIO::ImageSpec& spec) {
    std::map<std::string, std::string> texts;
    for (const OIIO::ParamValue& attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeString &&
            (attribute.name() == "Software" ||
             OIIO::Strutil::istarts_with(attribute.name().string(), "texloom:")))
            texts[attribute.name().string()] = attribute.get_string();
    texts.erase("texloom:recipe"); // which has its own place
    return texts;
}

/// Whether colours were multiplied by alpha: always in an EXR, in a TIFF where its ExtraSamples say so.
bool associated(const OIIO::ImageSpec& spec, const std::string& format) {
    return format == "openexr" || (format == "tiff" && spec.alpha_channel >= 0 &&
                                   spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0);
}

} // namespace

ImageFileInfo describe(const OIIO::ImageSpec& spec, const std::string& format) {
    ImageFileInfo info;
    const bool turned = spec.get_int_attribute("Orientation", 1) >= 5;
    info.size = turned ? Size{spec.height, spec.width} : Size{spec.width, spec.height};
    info.channels = spec.nchannels;
    info.format = format;
    info.depth = depthText(spec.format);
    info.space = spaceOf(spec);
    info.iccProfile = spec.get_string_attribute("ICCProfile:profile_description");
    info.recipe = recipeOf(spec);
    info.channelNames = spec.channelnames;
    info.associatedAlpha = associated(spec, format);
    info.compression = spec.get_string_attribute("compression");
    info.texts = textsOf(spec);
    return info;
}

} // namespace texloom
