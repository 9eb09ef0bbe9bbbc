#include "core/methods/port.h"

#include "core/base/text.h"

#include <algorithm>

namespace texloom {

namespace ports {

Port exemplar() {
    return {.id = std::string(kExemplarPort),
            .title = TR("Exemplar"),
            .help = TR("The image to learn from."),
            .least = 1,
            .most = 1};
}

Port exemplars() {
    Port port = exemplar();
    port.most = kAnyNumber;
    return port;
}

Port weighedExemplars() {
    Port port = exemplars();
    port.weighed = true;
    return port;
}

Port mask() {
    return {.id = std::string(kMaskPort),
            .title = TR("Mask"),
            .help = TR("Pixels of the exemplar where it is black are never used."),
            .kind = AssetKind::Mask,
            .extent = Extent::Exemplar};
}

Port initial() {
    return {.id = std::string(kInitialPort),
            .title = TR("Start from"),
            .help = TR("An image of the result's size that the method begins with."),
            .extent = Extent::Output};
}

Port companions() {
    return {.id = std::string(kCompanionPort),
            .title = TR("Companion maps"),
            .help = TR("Maps of the exemplar's size, such as normals or heights, that get the result's "
                       "layout."),
            .most = kAnyNumber,
            .extent = Extent::Exemplar};
}

Port image() {
    return {.id = std::string(kImagePort),
            .title = TR("Result"),
            .help = TR("The texture that was made."),
            .least = 1,
            .extent = Extent::Output};
}

Port wrappingImage() {
    Port port = image();
    port.wraps = true;
    return port;
}

Port inParts(Port image) {
    image.extent = Extent::Any;
    return image;
}

Port map() {
    return {.id = std::string(kMapPort),
            .title = TR("Position map"),
            .help = TR("The exemplar's pixel that each pixel of the result was copied from."),
            .kind = AssetKind::Map,
            .least = 1,
            .extent = Extent::Output};
}

} // namespace ports

const Port* findPort(const std::vector<Port>& ports, std::string_view id) {
    const auto found =
        std::find_if(ports.begin(), ports.end(), [id](const Port& port) { return port.id == id; });
    return found == ports.end() ? nullptr : &*found;
}

} // namespace texloom
