#pragma once

#include "core/session/run/run.h"
#include "core/volume/volume_source.h"
#include "tests/methods/every_method.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace texloom::test {

/// What the promises of every method are tested with. A new method is tested by being registered.

/// The image, where a request wants it.
std::shared_ptr<const Image> shared(Image image);

/// A request with a made-up exemplar.
Request requestFor(Size exemplar, int channels, Size output, std::uint64_t seed = 7);

/// The defaults, but with no more than three iterations, which are alike in all that is asked here, and no
/// solids or slices of them of more than 32 voxels a side.
Values briefSettings(const Method& method, const Request& request);

/// Whether a method's result follows from an exemplar, if only by way of a model that another one learned.
bool learns(const MethodInfo& info);

/// The plan of a run as the window and the command line have it, however much memory this machine has.
/// @param threads 0: one per core
RunPlan planFor(const Method& method, const Request& request, const Values& settings, int threads = 0);

/// The result of a run, with something made up in every port that must be filled. @throws UsageError, Error
Synthesis runWith(const Method& method, Request request, int threads);
/// The same with other settings than the brief ones.
Synthesis runWith(const Method& method, Request request, const Values& settings, int threads);

/// What a method makes of an exemplar of 50 × 61 px, 97 × 80 px of it: made once for all the promises that
/// only look at it.
const Synthesis& usualResult(const Method& method);

/// A size; half of its sides under a sanitizer, where everything takes ten times as long.
Size reduced(Size size);

/// A run that keeps nearly every method busy for seconds, so that it can be watched and stopped.
RunPlan longPlan(const Method& method, Size output = {4096, 4096});

/// A box that a source has.
Box boxOf(const VolumeSource& source);
/// The voxels of a box, on so many threads.
Volume sampled(const VolumeSource& source, const Box& box, int threads = 2);

/// The promises that every registered method keeps; the parameter is its id.
class Conformance : public testing::TestWithParam<std::string> {
protected:
    const Method& method() const { return findMethod(GetParam()); }
};

} // namespace texloom::test
