#pragma once

#include "core/base/text.h"
#include "core/methods/method.h"

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace texloom {

/// What methods share that fill holes in a picture, or extend one: they take an image of the output's size
/// and a mask of what of it is known, and make the rest.

inline constexpr std::string_view kKnownPort = "known";

namespace ports {

/// A mask of the output's size: what is kept of the image to start from; where it is 0, it is made.
Port known();

} // namespace ports

/// The mask of what is known, or null: nothing is to be filled.
const Image* knownOf(const Request& request);

/// By rows, 1 where a mask of what is known is 0.
std::vector<std::uint8_t> madeOf(const Image& known);

/// Pixels that are to be made; all of the output's if nothing is to be filled.
double unknownPixels(const Request& request);

/// Checks that there is an image where there is a mask, and something to make.
/// @throws UsageError
void checkFill(const Request& request);

/// The same for methods that cannot begin with nothing: some of the image must be known, too.
/// @throws UsageError
void checkSomeKnown(const Request& request);

/// The request with masks that say what of the exemplars may be copied to fill a hole. Where an exemplar is
/// the very picture that is filled, and has no mask of its own, what is to be made anew is hidden in it; and
/// in exemplars of the output's size nothing is copied that lies further than `context` pixels from what is
/// made, in either direction (0: anywhere), unless that leaves no whole square of `side` pixels anywhere.
/// @param check called every few milliseconds; may throw.
Request withoutHole(
    const Request& request, int context, int side, const std::function<void()>& check = [] {});

/// Upper bound of the memory that the masks of withoutHole() take.
std::uint64_t fillMaskBytes(const Request& request);

/// The part of an output about a hole that a method need look at, as a request of its own: where masks leave
/// sources near the hole alone, as those of withoutHole() do, the rest of the picture is cut off.
class FillWindow {
public:
    /// @param hidden a request with a hole, whose masks say what may be copied; must outlive the window.
    /// @param margin pixels around the hole that are kept at least.
    FillWindow(
        const Request& hidden, int margin, const std::function<void()>& check = [] {});

    /// Its exemplars of the output's size are cut as the output is; an axis that is cut does not wrap.
    const Request& request() const { return m_cut; }
    const Request& whole() const { return *m_whole; }
    Region part() const { return m_part; }
    /// The whole output with what the window made: what is not known is copied where its source is valid.
    Synthesis filled(const PositionMap& made, JobContext& context) const;

    /// Upper bound of the memory that a window and the masks and views of its request take.
    static std::uint64_t bytesFor(const Request& request);

private:
    const Request* m_whole;
    Request m_cut;
    Region m_part;
    std::vector<std::uint8_t> m_isCut; ///< by exemplar
};

/// Whether steps of tone between copies and what is around them are evened out.
template <class Settings> Param toneField(bool Settings::*member) {
    return field(member, "tone", TR("Even tone"))
        .group(TR("Advanced"))
        .help(TR("Where a hole is filled, takes the brightness and colour of what is copied from what is "
                 "around it, so that no border is seen where the light changes; what is known stays as it "
                 "is. Off: every pixel is a copy."));
}

/// How far sources may lie from what is made: a parameter of methods that fill holes.
template <class Settings> Param contextField(int Settings::*member) {
    return field(member, "context", TR("Context"))
        .range(0, 4096)
        .unit("px")
        .group(TR("Advanced"))
        .help(TR(
            "Where a hole is filled, how far around it the same picture is copied from: smaller takes what "
            "is near, and is faster; 0 takes all of the picture."));
}

/// How far a source may lie from its own place.
template <class Settings> Param radiusField(int Settings::*member) {
    return field(member, "radius", TR("Search radius"))
        .range(0, 4096)
        .unit("px")
        .group(TR("Advanced"))
        .help(
            TR("How far from its own place in an exemplar of the output's size a pixel's source may lie, as "
               "in a photo that is mended: smaller takes what is near, and is faster; 0 looks everywhere."));
}

/// An output of which some is known. Where an exemplar of its size shows the same, the picture itself most
/// likely, the map says so.
struct KnownPicture {
    /// @param shown of the output's size. @param mask not 0 where it is known.
    KnownPicture(const Image& shown, const Image& mask, const Request& request, JobContext& context);

    Image image;
    PositionMap map;                 ///< of what is known
    std::vector<std::uint8_t> known; ///< by rows, 1 or 0
    std::int64_t wanted = 0;         ///< how many pixels are not
};

/// The kind of a map whose made pixels are copies: exact if what is known has a source, too.
MapKind filledMapKind(const PositionMap& map);

} // namespace texloom
