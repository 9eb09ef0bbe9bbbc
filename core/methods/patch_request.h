#pragma once

#include "core/job/job_context.h"
#include "core/match/patch_grower.h"
#include "core/match/patch_match.h"
#include "core/methods/method.h"
#include "core/methods/patch_fields.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace texloom {

struct Quilt;

/// What methods that compare square patches share in reading a request.

/// The exemplars with their masks; views of the request.
std::vector<PatchSource> patchSources(const Request& request);

/// Whether the masks leave a whole square of `side` pixels in any exemplar.
bool leavesWholePatch(const Request& request, int side);
/// The largest side of which one is left, where none of this side is; 0 if the masks leave nothing.
int largestLeft(const Request& request, int side);

/// Checks that every exemplar holds a patch of this size, that the masks leave one, and that the output is
/// large enough to wrap. @throws UsageError
void checkPatchRequest(const Request& request, int patch);

/// The same for methods whose settings have a patch.
template <class Settings> void checkPatch(const Request& request, const Settings& settings) {
    checkPatchRequest(request, settings.patch);
}

/// The picture that a map makes of the exemplars (see PositionMap::apply()), made in parallel.
Image copied(const PositionMap& map, const Request& request, JobContext& context);

/// Bytes of a PatchSearch over exemplars of these sizes with one Scratch a thread, for the shapes that a
/// growing output compares. @param balanced whether it balances contrast.
std::uint64_t patchSearchBytes(std::span<const Size> exemplars, int channels, int patch, int threads,
                               bool balanced);

/// Rough time on one thread of comparing one patch with all of these exemplars, in seconds.
double patchSearchSeconds(std::span<const Size> exemplars, int channels);

/// What it takes to grow an output patch by patch: a PatchCanvas and a PatchSearch that is asked once for
/// each patch.
Estimate growthEstimate(const Request& request, int patch, int overlap, int threads, bool balanced);

/// How the output of a request grows from patches of this size.
template <class Settings> PatchGrower::Layout layoutOf(const Request& request, const Settings& settings) {
    return {request.size, request.wrap, settings.patch, settings.overlapPixels(), settings.contrast};
}

/// Grows an output patch by patch; the result has an estimated map and the number of patches.
/// @param stage what the user is told. @param mapWeight of the making of the map; preparing takes 0.02, and
/// growing has the rest.
Synthesis grown(PatchGrower& grower, const Request& request, const Message& stage, double mapWeight,
                JobContext& context);

/// The result of quilting: image and map, the number of patches, and how well they join.
Synthesis quilted(Quilt quilt, MapKind kind);

/// The result of a method that makes new pixels: the image with its estimated map.
/// @param weight of the stage that makes the map.
Synthesis withEstimatedMap(Image image, const Request& request, double weight, JobContext& context);

/// Adds what withEstimatedMap() needs.
void addEstimatedMap(const Request& request, Estimate& need);

/// Gives `result` the image and the map of a method that joins overlapping patches, as the user wants them.
/// @param map of the joined image, which may be larger than the output. @param joined makes that image.
void finishPatches(PatchFinish finish, PositionMap map, const std::function<Image()>& joined,
                   const Request& request, JobContext& context, Synthesis& result);

} // namespace texloom
