#include "core/methods/solid_request.h"

#include "core/base/error.h"
#include "core/image/resample.h"
#include "core/math/histogram.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace texloom {

namespace {

struct AxisGoal {
    Axis axis;
    const char* letter;
    SliceExemplar exemplar;
    SliceTurn turn;
    double weight;
    std::size_t own; ///< the number of its own exemplar
};

std::array<AxisGoal, 3> axisGoals(const SliceSettings& settings) {
    return {AxisGoal{Axis::X, "x", settings.exemplarX, settings.turnX, settings.weightX, 2},
            AxisGoal{Axis::Y, "y", settings.exemplarY, settings.turnY, settings.weightY, 1},
            AxisGoal{Axis::Z, "z", settings.exemplarZ, settings.turnZ, settings.weightZ, 0}};
}

/// The number of the exemplar that an axis wants, which there may not be.
std::optional<std::size_t> exemplarOf(const AxisGoal& goal, std::size_t count) {
    if (goal.exemplar == SliceExemplar::Free || goal.weight <= 0)
        return std::nullopt;
    if (goal.exemplar == SliceExemplar::Own)
        return goal.own < count ? goal.own : 0;
    return static_cast<std::size_t>(goal.exemplar) - static_cast<std::size_t>(SliceExemplar::First);
}

bool swapsSides(SliceTurn turn) {
    return turn == SliceTurn::Right || turn == SliceTurn::Left || turn == SliceTurn::MirroredRight ||
           turn == SliceTurn::MirroredLeft;
}

Image turned(const ImageView& image, SliceTurn turn) {
    const bool mirror = turn >= SliceTurn::Mirrored;
    const int quarters = static_cast<int>(turn) % 4;
    const int w = image.width, h = image.height;
    Image to(swapsSides(turn) ? Size{h, w} : Size{w, h}, image.channels);
    for (int c = 0; c < image.channels; ++c)
        for (int y = 0; y < to.height(); ++y)
            for (int x = 0; x < to.width(); ++x) {
                const std::array<std::pair<int, int>, 4> from{
                    {{x, y}, {y, h - 1 - x}, {w - 1 - x, h - 1 - y}, {w - 1 - y, x}}};
                const auto [u, v] = from[static_cast<std::size_t>(quarters)];
                to(x, y, c) = image(mirror ? w - 1 - u : u, v, c);
            }
    return to;
}

void matchColours(const Image& model, Image& image, const std::function<void()>& check) {
    SampleRanks ranks;
    for (int c = 0; c < image.channels(); ++c)
        Histogram(model.view().plane(c), check).match(image.plane(c), ranks, check);
}

} // namespace

Port solidExemplars() {
    Port port = ports::exemplars();
    port.help =
        TR("What slices look like: one image for all directions, or one each for those square to z, y "
           "and x.");
    port.most = 3;
    return port;
}

std::vector<SliceGoal> sliceGoals(const Request& request, const SliceSettings& settings,
                                  const std::function<void()>& check) {
    std::vector<Image> scaled;
    for (const Exemplar& exemplar : request.exemplars) {
        const Size from = exemplar.image->size(), to = sizeWithin(from, settings.exemplarSide);
        scaled.push_back(from == to ? *exemplar.image : resized(*exemplar.image, to, check));
        if (settings.matchColours && scaled.size() > 1)
            matchColours(scaled.front(), scaled.back(), check);
    }
    std::vector<SliceGoal> goals;
    for (const AxisGoal& goal : axisGoals(settings))
        if (const auto number = exemplarOf(goal, scaled.size()))
            goals.push_back({goal.axis, turned(scaled[*number], goal.turn), goal.weight});
    return goals;
}

std::vector<Size> sliceGoalSizes(const Request& request, const SliceSettings& settings) {
    const std::vector<Size> all = request.exemplarSizes();
    std::vector<Size> sizes;
    for (const AxisGoal& goal : axisGoals(settings))
        if (const auto number = exemplarOf(goal, all.size()); number && *number < all.size()) {
            const Size size = sizeWithin(all[*number], settings.exemplarSide);
            sizes.push_back(swapsSides(goal.turn) ? Size{size.height, size.width} : size);
        }
    return sizes;
}

void checkSliceGoals(const Request& request, const SliceSettings& settings, int shortest) {
    bool any = false;
    for (const AxisGoal& goal : axisGoals(settings)) {
        const auto number = exemplarOf(goal, request.exemplars.size());
        if (number && *number >= request.exemplars.size())
            failUsage(
                "Slices square to {} are to look like exemplar {}, and there are {}: give it, or choose "
                "another one or none.",
                goal.letter, *number + 1, request.exemplars.size());
        any = any || number.has_value();
    }
    if (!any)
        failUsage(
            "All three axes are free, so that nothing is wanted of the solid; give one of them an exemplar "
            "and a weight.");
    for (const Size& size : sliceGoalSizes(request, settings))
        if (size.shorterSide() < shortest)
            failUsage("The exemplar has {} × {} px here; its sides must have at least {} px.", size.width,
                      size.height, shortest);
}

} // namespace texloom
