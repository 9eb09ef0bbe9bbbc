#pragma once

#include "core/base/message.h"
#include "core/image/image.h"
#include "core/image/position_map.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texloom {

class Model;
class VolumeSource;
class Mesh;

/// What a thing is that goes into a method or comes out of it.
enum class AssetKind {
    Image,  ///< a picture: colours, heights, labels …
    Mask,   ///< a picture of one channel: 0 leaves a pixel out
    Map,    ///< where each pixel comes from
    Model,  ///< what training or learning leaves behind
    Volume, ///< a solid that can be sampled in any box
    Mesh,   ///< a surface
};

/// One such thing, shared and never changed once it is here; masks are images.
using Asset = std::variant<std::shared_ptr<const Image>, std::shared_ptr<const PositionMap>,
                           std::shared_ptr<const Model>, std::shared_ptr<const VolumeSource>,
                           std::shared_ptr<const Mesh>>;

/// Whether `asset` is of this kind.
bool isOf(AssetKind kind, const Asset& asset);

/// "an image", "a model": for sentences.
Message kindText(AssetKind kind);

/// Things by the id of the port they belong to (see Port), several of one port in the order they were given.
class Assets {
public:
    /// Adds to what the port has already.
    void add(std::string_view port, Asset asset);
    /// Takes the place of what the port had.
    void set(std::string_view port, Asset asset);
    void clear(std::string_view port);
    bool empty() const { return m_byPort.empty(); }

    /// All that a port has; empty if nothing.
    const std::vector<Asset>& at(std::string_view port) const;
    /// The first picture of a port; null if it has none.
    const Image* image(std::string_view port) const { return first<Image>(port).get(); }
    /// The first thing of type T (Image, PositionMap, Model …) of a port; null if it has none.
    template <class T> std::shared_ptr<const T> first(std::string_view port) const {
        for (const Asset& asset : at(port))
            if (const auto* found = std::get_if<std::shared_ptr<const T>>(&asset))
                return *found;
        return nullptr;
    }
    /// Everything by port, in the order of their ids.
    const std::map<std::string, std::vector<Asset>, std::less<>>& byPort() const { return m_byPort; }

private:
    std::map<std::string, std::vector<Asset>, std::less<>> m_byPort;
};

} // namespace texloom
