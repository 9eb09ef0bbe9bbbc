#pragma once

#include "core/methods/assets.h"

#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// Whose size a picture of a port has.
enum class Extent {
    Exemplar, ///< the size of the exemplar that it belongs to: there is one for each
    Output,   ///< the output's
    Any,      ///< of an input: its own; of an output: that of any part which is asked for
};

/// One thing that a method takes or gives. Everything around a method follows from its ports: the rows of the
/// inspector, `--input`, the fields of recipes, which method may follow which, what is kept and exported.
struct Port {
    /// Kebab-case, as recipes and the command line write it. Of a port of the kind Model, it is also the kind
    /// of model (Model::kind) that goes through it: files and results with a model of another kind are
    /// refused (loadInput(), Method::check(), assetFor()). So methods that make or use the same models give
    /// their port the same id, which lets one follow the other, too; a method can have one port for each
    /// kind; and a kind that changes its meaning needs a new id.
    std::string id;
    std::string title; ///< as the window shows it
    std::string help;  ///< what it is for, in one sentence
    AssetKind kind = AssetKind::Image;
    int least = 0; ///< how many the method needs
    int most = 1;  ///< how many it can use
    Extent extent = Extent::Any;
    bool weighed = false; ///< of several: each counts as much as its weight says
    bool wraps = false;   ///< of the output's image: it can close on itself, on either axis
};

/// Stands for "as many as there are".
inline constexpr int kAnyNumber = 4096;

/// Ids of the ports that more than one method has.
inline constexpr std::string_view kExemplarPort = "exemplar", kMaskPort = "mask", kInitialPort = "initial",
                                  kCompanionPort = "companion", kImagePort = "image", kMapPort = "map";

/// The usual ports, declared once.
namespace ports {

/// The image to learn from.
Port exemplar();
/// Any number of images to learn from, all alike.
Port exemplars();
/// Any number of images to learn from, each counting as much as its weight says.
Port weighedExemplars();
/// A mask of each exemplar: pixels where it is 0 are never used.
Port mask();
/// An image of the output's size to start from.
Port initial();
/// Maps of each exemplar's size that get the result's layout. Every method that takes exemplars has this
/// port: a map of positions lays them out, or they are made as further channels.
Port companions();

/// The output, made whole.
Port image();
/// The output, which can close on itself.
Port wrappingImage();
/// Of an output: any part of it can be made alone, and equals that part of the whole.
Port inParts(Port image);
/// The output's pixels are the exemplar's, and this says from where: companion maps are laid out by it.
Port map();

} // namespace ports

/// The port of this id, or null.
const Port* findPort(const std::vector<Port>& ports, std::string_view id);

} // namespace texloom
