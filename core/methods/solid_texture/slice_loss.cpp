#include "core/methods/solid_texture/slice_loss.h"

#include "core/base/at.h"

namespace texloom::solid_texture {

namespace {

const Descriptor& descriptor() {
    static const Descriptor own = Descriptor::from(ownDescriptor());
    return own;
}

/// The descriptor, or null where it cannot see the exemplars.
const Descriptor* seeing(const Request& request) {
    return request.channels() == 1 || request.channels() == 3 ? &descriptor() : nullptr;
}

GeneratorLossOptions optionsOf(const Settings& settings) {
    return {.descriptorWeight = settings.descriptorWeight, .patchWeight = settings.patchWeight};
}

std::vector<GeneratorGoal> picturesOf(const std::vector<SliceGoal>& slices) {
    std::vector<GeneratorGoal> goals;
    for (const SliceGoal& slice : slices)
        goals.push_back({slice.exemplar, slice.weight});
    return goals;
}

} // namespace

SliceLoss::SliceLoss(const Request& request, const Settings& settings, JobContext& context)
    : SliceLoss(sliceGoals(request, settings, [&context] { context.check(); }), request, settings, context) {}

SliceLoss::SliceLoss(const std::vector<SliceGoal>& slices, const Request& request, const Settings& settings,
                     JobContext& context)
    : m_side(settings.trainSide),
      m_pictures(picturesOf(slices), seeing(request), optionsOf(settings), context) {
    double whole = 0;
    for (const SliceGoal& slice : slices)
        whole += slice.weight;
    for (const SliceGoal& slice : slices) {
        m_axes.push_back(slice.axis);
        m_shares.push_back(static_cast<float>(slice.weight / whole));
    }
}

Image SliceLoss::pictureOf(const Volume& slice, Axis axis) const {
    Image picture({m_side, m_side}, slice.channels());
    for (int c = 0; c < slice.channels(); ++c)
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x) {
                const SliceVoxel v = sliceVoxel(axis, x, y, 0);
                picture(x, y, c) = slice(v.x, v.y, v.z, c);
            }
    return picture;
}

double SliceLoss::evaluate(std::size_t goal, const Volume& slice, int number, Volume& gradient,
                           JobContext& context) {
    const Axis axis = m_axes[goal];
    const Image picture = pictureOf(slice, axis);
    Image change(picture.size(), picture.channels());
    const double loss =
        m_pictures.evaluate(goal, picture, Edges::all(Padding::Reflect), number, change, context);
    gradient = Volume(slice.size(), slice.channels());
    for (int c = 0; c < slice.channels(); ++c)
        for (int y = 0; y < m_side; ++y)
            for (int x = 0; x < m_side; ++x) {
                const SliceVoxel v = sliceVoxel(axis, x, y, 0);
                gradient(v.x, v.y, v.z, c) = m_shares[goal] * change(x, y, c);
            }
    return loss * static_cast<double>(m_shares[goal]);
}

std::uint64_t SliceLoss::bytesFor(const Request& request, const Settings& settings, int threads) {
    return GeneratorLoss::bytesFor(sliceGoalSizes(request, settings),
                                   {settings.trainSide, settings.trainSide}, request.channels(),
                                   seeing(request), optionsOf(settings), threads);
}

double SliceLoss::secondsFor(const Request& request, const Settings& settings) {
    return GeneratorLoss::secondsFor(sliceGoalSizes(request, settings),
                                     {settings.trainSide, settings.trainSide}, seeing(request),
                                     optionsOf(settings));
}

} // namespace texloom::solid_texture
