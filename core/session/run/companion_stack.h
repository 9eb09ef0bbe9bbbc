#pragma once

#include "core/image/image.h"

#include <memory>
#include <string_view>
#include <vector>

namespace texloom {

struct RunExemplar;
struct RunInput;

/// The parameter of methods that copy pixels by which companion maps count where pixels are compared.
inline constexpr std::string_view kCompanionWeight = "companion-weight";

/// How companion maps take part in a run.
struct CompanionUse {
    bool stacked = false; ///< they are further channels of the exemplars
    /// Of methods that copy pixels, what a difference of all maps together counts beside one of the image,
    /// each in units of its own deviation over the exemplars. 0: maps are as they are.
    double weight = 0;
    bool inVain = false; ///< a weight was asked for, but what the run starts from has no maps
};

/// Methods that make new pixels make those of maps along with them; those that copy pixels find them by the
/// position map, and need the maps before only if they are to compare them.
CompanionUse companionUse(const RunInput& input);

/// Each exemplar with its companions as further channels. Where `use` has a weight w, map k of K is
/// multiplied by sqrt(w V / (K V_k)), with the variances V of the images' channels and V_k of the map's, each
/// summed over channels and taken over all exemplars: sums of squared differences then hold w times as much
/// of maps as of images. A map that is the same everywhere stays as it is.
std::vector<std::shared_ptr<const Image>> stackedExemplars(const std::vector<RunExemplar>& exemplars,
                                                           const CompanionUse& use);

/// An image to start from, with the means of the exemplar's further channels where it has none.
std::shared_ptr<const Image> withMeans(const Image& initial, const Image& exemplar);

} // namespace texloom
