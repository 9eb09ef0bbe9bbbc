#include "ui/inspector/port_pairs.h"

#include <algorithm>
#include <iterator>

namespace texloom::ui {

std::optional<AnalogyPorts> analogyAmong(const std::vector<Port>& ports) {
    const auto first = [&ports](Extent extent) {
        return std::find_if(ports.begin(), ports.end(), [extent](const Port& port) {
            return port.kind == AssetKind::Image && port.extent == extent && port.most == 1 &&
                   port.id != kInitialPort && port.id != kCompanionPort && port.id != kExemplarPort;
        });
    };
    const auto a = first(Extent::Exemplar), b = first(Extent::Output);
    if (a == ports.end() || b == ports.end())
        return std::nullopt;
    return AnalogyPorts{*a, *b};
}

const Port* pictureBefore(const std::vector<Port>& ports, std::string_view mask) {
    const auto own =
        std::find_if(ports.begin(), ports.end(), [mask](const Port& port) { return port.id == mask; });
    if (own == ports.end())
        return nullptr;
    const auto found = std::find_if(std::make_reverse_iterator(own), ports.rend(), [own](const Port& port) {
        return port.kind == AssetKind::Image && port.extent == own->extent;
    });
    return found == ports.rend() ? nullptr : &*found;
}

} // namespace texloom::ui
