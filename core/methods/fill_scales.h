#pragma once

#include "core/match/exemplar_pyramid.h"
#include "core/methods/method.h"

#include <functional>
#include <vector>

namespace texloom {

/// A picture with a hole at one scale.
struct FillScale {
    Image picture;
    Image known; ///< one channel, 0 where it is made

    Size size() const { return picture.size(); }
};

/// The picture of a request and what is known of it, from fine to coarse, each half the one before, down to
/// the scale at which a square reaches across the hole.
/// @param side of the square in pixels. @param most scales, at least 1; there are fewer where nothing would
/// be known, or the picture would be shorter than the square.
/// @param check called every few milliseconds; may throw.
std::vector<FillScale> fillScales(const Request& request, int side, int most,
                                  const std::function<void()>& check);

/// Steps from each pixel to the nearest that is known, by rows, 0 there; diagonal ones count as one.
std::vector<int> depths(const Image& known, const std::function<void()>& check);

/// The request at a scale: the exemplars and their masks, for an output of this size.
Request requestAt(const Request& request, const ExemplarPyramid& exemplars, int level, Size size);
/// The same with the picture and what is known of it.
Request requestAt(const Request& request, const ExemplarPyramid& exemplars, int level,
                  const FillScale& scale);

/// The map of a scale in the pixels of the next finer one, of this size; without a source where it has none.
/// @param exemplars sizes there.
PositionMap finer(const PositionMap& map, Size size, std::vector<Size> exemplars,
                  const std::function<void()>& check);
/// The same for a picture with a hole. @param known of the finer scale; where it is not 0, sources are
/// invalid.
PositionMap finer(const PositionMap& map, const Image& known, std::vector<Size> exemplars,
                  const std::function<void()>& check);

/// Upper bound of the memory that all scales take.
std::uint64_t fillScalesBytes(const Request& request);

} // namespace texloom
