#pragma once

#include "core/base/message.h"
#include "core/image/image.h"
#include "core/image/position_map.h"
#include "core/job/curve.h"
#include "core/methods/port.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// An image to learn from, shared and never changed once it is here.
struct Exemplar {
    std::string name;                   ///< for messages and labels
    std::shared_ptr<const Image> image; ///< colours in the working space, or data
    /// What goes into the method's ports of the exemplar's extent, such as its mask.
    Assets inputs = {};
    /// How much it counts beside the other exemplars, from kLeastWeight to kMostWeight: one of weight 2
    /// counts as though it were given twice. Only methods that say so (Port::weighed) heed it.
    double weight = 1;

    static constexpr double kLeastWeight = 0.01, kMostWeight = 100;

    /// One channel of the exemplar's size, or null: pixels where it is 0 are never copied.
    const Image* mask() const { return inputs.image(kMaskPort); }
};

/// All that a method is given: an immutable copy of the input.
struct Request {
    /// All with the same number of channels; none for methods that learn from none.
    std::vector<Exemplar> exemplars;
    int companionChannels = 0; ///< how many of these, the last ones, are of companion maps
    Assets inputs = {};        ///< what goes into the method's other ports
    Size size;                 ///< of the output
    Wrap wrap;
    std::uint64_t seed = 0;
    /// The part of the output to make, which equals that part of the whole; all of it if not given.
    std::optional<Region> region;
    /// Whether this is a later strip of an output: what the first one learned is among the inputs, and
    /// nothing is learned anew.
    bool continues = false;
    /// Channels of the output where no exemplar says how many there are: see Method::channels().
    int freeChannels = kFreeChannels;
    static constexpr int kFreeChannels = 3; ///< colour, unless somebody knows better

    /// An image of the output's size to start from, or null.
    const Image* initial() const { return inputs.image(kInitialPort); }
    std::vector<Size> exemplarSizes() const;
    /// The part of the output that is made; image and map of the result have its size.
    Region part() const { return region.value_or(Region{0, 0, size}); }
    /// Channels of the output: those of the exemplars, if there are any.
    int channels() const { return exemplars.empty() ? freeChannels : exemplars.front().image->channels(); }
    /// Channels of the result without those of companion maps.
    int resultChannels() const { return channels() - companionChannels; }
};

/// A named picture beside the result, such as a dictionary or a lattice.
struct Picture {
    Message name;
    Image image;
};

/// A named number about the result.
struct Figure {
    Message name;
    double value = 0;
};

/// What a position map says of the image it comes with.
enum class MapKind {
    None,      ///< there is no map
    Exact,     ///< applying the map to the exemplars gives the image, bit for bit
    Dominant,  ///< pixels are blends; the map names the source with the largest weight
    Estimated, ///< pixels are new; the map names the most similar exemplar pixel
};

/// What a method returns.
struct Synthesis {
    Image image;
    PositionMap map;
    MapKind mapKind = MapKind::None;
    Assets outputs;            ///< what comes out of the method's further ports, such as a model or a volume
    std::vector<Curve> curves; ///< those of JobContext::curve(); Method fills them in
    std::vector<Picture> pictures;
    std::vector<Figure> figures;
    std::vector<Message> notes; ///< sentences for the user about what the method decided by itself
};

} // namespace texloom
