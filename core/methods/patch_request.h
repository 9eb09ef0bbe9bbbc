#pragma once

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/job/job_context.h"
#include "core/match/patch_match.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <vector>

namespace texloom {

/// What methods that compare square patches share in reading a request.

/// The exemplars with their masks; views of the request.
std::vector<PatchSource> patchSources(const Request& request);

/// Checks that every exemplar holds a patch of this size, that the masks leave one, and that the output is
/// large enough to wrap. @throws UsageError
void checkPatchRequest(const Request& request, int patch);

/// The picture that a map makes of the exemplars (see PositionMap::apply()), made in parallel.
Image copied(const PositionMap& map, const Request& request, JobContext& context);

/// Bytes of a PatchSearch over the request's exemplars with one Scratch a thread, for the shapes that a
/// growing output compares. @param balanced whether it balances contrast.
std::uint64_t patchSearchBytes(const Request& request, int patch, int threads, bool balanced = false);

/// The parameter of methods that grow from the nearest patches: see ContrastBalance::share.
template <class Settings> Param contrastField(double Settings::*member) {
    return field(member, "contrast", TR("Contrast"))
        .range(0, 1)
        .group(TR("Advanced"))
        .help(TR("How far flat patches are kept from winning where nothing fits well: 1 holds the exemplar's "
                 "contrast; 0 compares as published, and outputs may fade."));
}

/// Rough time on one thread of comparing one patch with all others, in seconds.
double patchSearchSeconds(const Request& request);

/// The result of a method that makes new pixels: the image with its estimated map.
/// @param weight of the stage that makes the map.
Synthesis withEstimatedMap(Image image, const Request& request, double weight, JobContext& context);

/// Adds what withEstimatedMap() needs.
void addEstimatedMap(const Request& request, std::uint64_t& bytes, double& seconds);

} // namespace texloom
