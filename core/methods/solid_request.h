#pragma once

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/methods/method.h"
#include "core/volume/slice.h"

#include <vector>

namespace texloom {

/// What methods share that make a solid whose slices square to an axis look like an exemplar (Gutierrez,
/// thesis 2020, section 4.4.1).

/// Which exemplar the slices square to an axis look like.
enum class SliceExemplar { Own, First, Second, Third, Free };
/// How it lies in them.
enum class SliceTurn { None, Right, Half, Left, Mirrored, MirroredRight, MirroredHalf, MirroredLeft };

/// Settings of such a method, to derive its own from.
struct SliceSettings {
    SliceExemplar exemplarX = SliceExemplar::Own, exemplarY = SliceExemplar::Own,
                  exemplarZ = SliceExemplar::Own;
    SliceTurn turnX = SliceTurn::None, turnY = SliceTurn::None, turnZ = SliceTurn::None;
    double weightX = 1, weightY = 1, weightZ = 1;
    int exemplarSide = 128; ///< exemplars with a longer one are scaled down
    bool matchColours = false;
};

/// All slices square to one axis, and what they are to look like: as they lie in axisPlane().
struct SliceGoal {
    Axis axis = Axis::Z;
    Image exemplar; ///< turned and scaled
    double weight = 1;
};

/// A voxel of a solid whose slice square to `axis` at `normal` has it at (right, down).
struct SliceVoxel {
    int x, y, z;
};
inline SliceVoxel sliceVoxel(Axis axis, int right, int down, int normal) {
    if (axis == Axis::X)
        return {normal, down, right};
    return axis == Axis::Y ? SliceVoxel{right, normal, down} : SliceVoxel{right, down, normal};
}

/// The port of the exemplars: one for all axes, or one each.
Port solidExemplars();

/// The exemplar of every axis that is not free, of weight above 0. @param check called for every row.
std::vector<SliceGoal> sliceGoals(const Request& request, const SliceSettings& settings,
                                  const std::function<void()>& check);
/// Checks that every axis has the exemplar that it wants, that not all are free, and that the exemplars, as
/// they are scaled, have sides of at least `shortest` px. @throws UsageError
void checkSliceGoals(const Request& request, const SliceSettings& settings, int shortest);
/// Size of the exemplar of each axis that is not free, as it is scaled and turned.
std::vector<Size> sliceGoalSizes(const Request& request, const SliceSettings& settings);

/// Parameters of SliceSettings.
template <class Settings> std::vector<Param> sliceFields() {
    const auto exemplar = [](SliceExemplar Settings::*member, const char* name, const char* title) {
        return field(member, name, title)
            .choices({{"own", TR("Own")},
                      {"first", TR("First")},
                      {"second", TR("Second")},
                      {"third", TR("Third")},
                      {"free", TR("Free")}})
            .group(TR("Directions"))
            .help(TR("What slices square to this axis look like. Own is the first exemplar for z, the second "
                     "for y and the third for x, or the first where there are fewer; of a free axis nothing "
                     "is wanted, as along the grain of wood."));
    };
    const auto turn = [](SliceTurn Settings::*member, const char* name, const char* title) {
        return field(member, name, title)
            .choices({{"none", TR("As it is")},
                      {"right", TR("Right")},
                      {"half", TR("Half")},
                      {"left", TR("Left")},
                      {"mirrored", TR("Mirrored")},
                      {"mirrored-right", TR("Mirrored, right")},
                      {"mirrored-half", TR("Mirrored, half")},
                      {"mirrored-left", TR("Mirrored, left")}})
            .group(TR("Directions"))
            .help(TR("How the exemplar is turned in these slices; where they meet, patterns must agree."));
    };
    const auto weight = [](double Settings::*member, const char* name, const char* title) {
        return field(member, name, title)
            .range(0, 10)
            .group(TR("Directions"))
            .help(TR("How much these slices count beside the others; 0 leaves the axis free."));
    };
    return {
        exemplar(&Settings::exemplarX, "exemplar-x", TR("Square to x")),
        exemplar(&Settings::exemplarY, "exemplar-y", TR("Square to y")),
        exemplar(&Settings::exemplarZ, "exemplar-z", TR("Square to z")),
        turn(&Settings::turnX, "turn-x", TR("Turn square to x")),
        turn(&Settings::turnY, "turn-y", TR("Turn square to y")),
        turn(&Settings::turnZ, "turn-z", TR("Turn square to z")),
        weight(&Settings::weightX, "weight-x", TR("Weight square to x")),
        weight(&Settings::weightY, "weight-y", TR("Weight square to y")),
        weight(&Settings::weightZ, "weight-z", TR("Weight square to z")),
        field(static_cast<int Settings::*>(&Settings::exemplarSide), "exemplar-side", TR("Exemplar's side"))
            .range(16, 512)
            .unit("px")
            .help(TR("Exemplars with a longer side are scaled down to this: smaller makes features smaller, "
                     "so that "
                     "a solid holds more of them.")),
        field(static_cast<bool Settings::*>(&Settings::matchColours), "match-colours", TR("Match colours"))
            .group(TR("Directions"))
            .help(TR("Gives all exemplars the colours of the first, without which slices of two kinds cannot "
                     "agree where they cross."))};
}

} // namespace texloom
