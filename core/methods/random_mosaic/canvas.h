#pragma once

#include "core/image/image.h"
#include "core/image/position_map.h"
#include "core/job/job_context.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <vector>

namespace texloom::random_mosaic {

/// A mosaic while it is made: its pixels, where they come from, and how the pieces lie that they are of.
struct Canvas {
    /// @param level whether levelJoints() follows.
    Canvas(Size size, const Request& request, bool level)
        : image(size, request.channels()), map(size, request.exemplarSizes()),
          turns(static_cast<std::size_t>(size.area()), 0) {
        if (level) {
            change = Image(size, 1);
            joints.resize(turns.size());
        }
    }

    std::uint8_t& turn(int x, int y) {
        return turns[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
                     static_cast<std::size_t>(x)];
    }
    std::uint8_t turn(int x, int y) const {
        return turns[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width()) +
                     static_cast<std::size_t>(x)];
    }
    static std::uint64_t bytesFor(Size size, int channels, bool level) {
        const auto area = static_cast<std::uint64_t>(size.area());
        return Image::bytesFor(size, channels) + PositionMap::bytesFor(size) + area +
               (level ? Image::bytesFor(size, 1) + area : 0);
    }

    Image image;
    PositionMap map;
    std::vector<std::uint8_t> turns;  ///< see Turn
    Image change;                     ///< for levelJoints(): what is added to a channel
    std::vector<std::uint8_t> joints; ///< and where pieces meet
};

/// Levels the steps between pieces (Pérez, Gangnet & Blake 2003): gradients stay as they are within pieces;
/// across a joint they become the mean of how both pieces go on in their exemplars, where these do, else 0.
/// Solved for what is to be added, f, with nothing flowing over borders that do not wrap; where everything
/// goes on as in the exemplar f is 0. The mean becomes the exemplars'. As pieces are dealt by chance, their
/// slopes add up by chance, too, and would drift over the output like clouds; so f is held to 0 by the weight
/// 1 / reach², which leaves each piece its own level beyond that distance from the joints.
/// @param reach in pixels; 0 levels without limit. @param weight of the stage.
void levelJoints(Canvas& canvas, const Request& request, double reach, double weight, JobContext& context);
/// Bytes that it takes beyond the canvas.
std::uint64_t levellingBytes(Size size, int threads);

} // namespace texloom::random_mosaic
