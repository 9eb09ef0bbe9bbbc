#pragma once

#include "core/io/model_file.h"
#include "core/network/convolution.h"
#include "core/network/pooling.h"

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// The kind of model that a Descriptor is as a file, and the id of ports for it.
inline constexpr std::string_view kDescriptorPort = "descriptor";

/// One step of a network.
struct DescriptorLayer {
    enum class Kind {
        Convolution,
        Rectifier, ///< what is below 0 becomes 0
        Pool,      ///< half the size
        Tap,       ///< what comes out of the layer before is compared
    };

    Kind kind = Kind::Convolution;
    std::string name = {}; ///< of convolutions and taps
    Filters filters = {};
};

/// A network whose feature maps say what a texture looks like (Gatys, Ecker & Bethge 2015), as data: chains
/// of layers, each from the picture on. docs/descriptors.md describes the file.
struct Descriptor {
    std::string name;    ///< for people: "own", "VGG-19 …"
    std::string licence; ///< of the weights
    std::string credit;  ///< who made them, of what
    int channels = 3;    ///< of the picture
    /// The network sees (value − offset) · scale, of values from 0 to 1.
    float offset = 0, scale = 1;
    Pooling pooling = Pooling::Average;
    int levels = 2; ///< of the picture's pyramid on which it is used unless the user says otherwise
    std::vector<std::vector<DescriptorLayer>> chains;

    /// Names of the taps in their order.
    std::vector<std::string> taps() const;
    /// Numbers in all weights.
    std::size_t parameters() const;

    /// As a file has it. Nothing of it depends on the machine.
    Model model() const;
    /// @throws Error in one sentence if it is another kind of model, or its layers do not fit together.
    static Descriptor from(const Model& model);
};

/// The descriptor that Texloom ships, which was learned from free pictures (resources/descriptors).
const Model& ownDescriptor();

} // namespace texloom
