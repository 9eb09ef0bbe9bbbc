#include "core/methods/assets.h"

#include "core/base/text.h"

#include <array>

namespace texloom {

bool isOf(AssetKind kind, const Asset& asset) {
    switch (kind) {
    case AssetKind::Image:
    case AssetKind::Mask:
        return std::holds_alternative<std::shared_ptr<const Image>>(asset);
    case AssetKind::Map:
        return std::holds_alternative<std::shared_ptr<const PositionMap>>(asset);
    case AssetKind::Model:
        return std::holds_alternative<std::shared_ptr<const Model>>(asset);
    case AssetKind::Volume:
        return std::holds_alternative<std::shared_ptr<const VolumeSource>>(asset);
    case AssetKind::Mesh:
        return std::holds_alternative<std::shared_ptr<const Mesh>>(asset);
    }
    return false;
}

Message kindText(AssetKind kind) {
    static const std::array<const char*, 6> texts = {TR("an image"), TR("a mask"),   TR("a position map"),
                                                     TR("a model"),  TR("a volume"), TR("a mesh")};
    return texts.at(static_cast<std::size_t>(kind));
}

void Assets::add(std::string_view port, Asset asset) {
    m_byPort[std::string(port)].push_back(std::move(asset));
}

void Assets::set(std::string_view port, Asset asset) {
    m_byPort[std::string(port)] = {std::move(asset)};
}

void Assets::clear(std::string_view port) {
    if (const auto found = m_byPort.find(port); found != m_byPort.end())
        m_byPort.erase(found);
}

const std::vector<Asset>& Assets::at(std::string_view port) const {
    static const std::vector<Asset> none;
    const auto found = m_byPort.find(port);
    return found == m_byPort.end() ? none : found->second;
}

} // namespace texloom
