#include "core/methods/solid_optimise/problem.h"

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/job/voxel_random.h"
#include "core/math/histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace texloom::solid_optimise {

namespace {

constexpr int kNeighbourhoodsAcross = 2; ///< at the coarsest scale

std::vector<double> commonMeans(const std::vector<SliceGoal>& goals, double whole) {
    std::vector<double> means(at(goals.front().exemplar.channels()), 0.0);
    for (const SliceGoal& goal : goals) {
        const std::vector<double> own = channelMeans(goal.exemplar);
        for (std::size_t c = 0; c < means.size(); ++c)
            means[c] += own[c] * goal.weight / whole;
    }
    return means;
}

Eigen::MatrixXd commonCovariance(const std::vector<SliceGoal>& goals, double whole) {
    const int channels = goals.front().exemplar.channels();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(channels, channels);
    for (const SliceGoal& goal : goals)
        sum += channelCovariance(goal.exemplar) * (goal.weight / whole);
    return sum;
}

double weightOf(const std::vector<SliceGoal>& goals) {
    double sum = 0;
    for (const SliceGoal& goal : goals)
        sum += goal.weight;
    return sum;
}

/// Between which two voxels of a solid that repeats one of a larger solid lies.
struct Between {
    int first, second;
    float share;
};
Between between(int place, int side, int from) {
    const double exact = (place + 0.5) * from / side - 0.5, below = std::floor(exact);
    const int first = (static_cast<int>(below) + from) % from;
    return {first, (first + 1) % from, static_cast<float>(exact - below)};
}

} // namespace

Problem::Problem(const Request& request, const Settings& settings, bool principal, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_principal(principal),
      m_goals(sliceGoals(request, settings, [&context] { context.check(); })),
      m_wholeWeight(weightOf(m_goals)), m_means(commonMeans(m_goals, m_wholeWeight)),
      m_colours(commonCovariance(m_goals, m_wholeWeight)) {
    if (!m_principal || m_colours.components() == 0)
        return;
    for (SliceGoal& goal : m_goals) {
        Image components(goal.exemplar.size(), m_colours.components());
        m_colours.project(goal.exemplar, m_means, 0, components.height(), components);
        goal.exemplar = std::move(components);
        context.check();
    }
}

void Problem::toColours(const ImageView& components, Image& to) const {
    if (m_colours.components() > 0) {
        m_colours.unproject(components, m_means, 0, to.height(), to);
        return;
    }
    for (int c = 0; c < to.channels(); ++c)
        for (int y = 0; y < to.height(); ++y)
            std::fill_n(to.plane(c).row(y), to.width(), static_cast<float>(m_means[at(c)]));
}

void Problem::show(const Volume& solid) const {
    m_context.preview(m_request.size, [&](Size size, int step) { return picture(solid, size, step); });
}

Image Problem::picture(const Volume& solid, Size size, int step) const {
    const int side = m_settings.side;
    Image slice({side, side}, m_request.channels());
    Image chosen({side, side}, std::max(1, solid.channels()));
    for (int c = 0; c < solid.channels(); ++c)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                chosen(x, y, c) = solid(x * solid.width() / side, y * solid.height() / side, 0, c);
    if (m_principal)
        toColours(chosen, slice);
    else
        slice = std::move(chosen);
    Image picture(size, slice.channels());
    for (int c = 0; c < picture.channels(); ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                picture(x, y, c) = slice(x * step % side, y * step % side, c);
    return picture;
}

Volume Problem::coloured(const Volume& solid) const {
    if (!m_principal)
        return solid;
    Volume to(solid.size(), m_request.channels());
    m_context.parallel(0, solid.depth(), [&](int z) {
        Image made({solid.width(), solid.height()}, m_request.channels());
        toColours(solid.slice(z), made);
        for (int c = 0; c < made.channels(); ++c)
            for (int y = 0; y < solid.height(); ++y)
                std::copy_n(made.plane(c).row(y), solid.width(), to.row(y, z, c));
    });
    return to;
}

std::string Progress::bytes() const {
    const std::array<std::int64_t, 6> head{
        scale,          iteration,        solid.width(),
        solid.height(), solid.channels(), static_cast<std::int64_t>(matches.size())};
    std::string text(reinterpret_cast<const char*>(head.data()), sizeof head);
    for (int c = 0; c < solid.channels(); ++c)
        text.append(reinterpret_cast<const char*>(solid.row(0, 0, c)),
                    static_cast<std::size_t>(solid.size().voxels()) * sizeof(float));
    text.append(reinterpret_cast<const char*>(matches.data()), matches.size() * sizeof(std::int32_t));
    return text;
}

Progress Progress::from(const std::string& text) {
    std::array<std::int64_t, 6> head{};
    if (text.size() < sizeof head)
        fail("The checkpoint holds no solid; start again without it.");
    std::memcpy(head.data(), text.data(), sizeof head);
    Progress made;
    made.scale = static_cast<int>(head[0]);
    made.iteration = static_cast<int>(head[1]);
    const int side = static_cast<int>(head[2]);
    made.solid = Volume({side, side, side}, static_cast<int>(head[4]));
    made.matches.resize(static_cast<std::size_t>(head[5]));
    const std::size_t plane = static_cast<std::size_t>(made.solid.size().voxels()) * sizeof(float);
    const std::size_t wanted =
        sizeof head + plane * at(made.solid.channels()) + made.matches.size() * sizeof(std::int32_t);
    if (text.size() != wanted)
        fail("The checkpoint holds no solid; start again without it.");
    const char* from = text.data() + sizeof head;
    for (int c = 0; c < made.solid.channels(); ++c, from += plane)
        std::memcpy(made.solid.row(0, 0, c), from, plane);
    std::memcpy(made.matches.data(), from, made.matches.size() * sizeof(std::int32_t));
    return made;
}

int sideAt(const Settings& settings, int scale) {
    return std::max(settings.side >> scale, settings.patch);
}

int scalesFor(const Request& request, const Settings& settings) {
    int shortest = settings.side;
    for (const Size& size : sliceGoalSizes(request, settings))
        shortest = std::min(shortest, size.shorterSide());
    int scales = 1;
    while (scales < settings.scales && (shortest >> scales) >= kNeighbourhoodsAcross * settings.patch)
        ++scales;
    return scales;
}

Volume noise(int side, int channels, const JobContext& context) {
    Volume solid({side, side, side}, channels);
    const VoxelRandom random(context.random().bits(0, 0, 1));
    for (int z = 0; z < side; ++z, context.check())
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int c = 0; c < channels; ++c)
                    solid(x, y, z, c) =
                        static_cast<float>(random.normal({x, y, z}, static_cast<std::uint32_t>(c)));
    return solid;
}

Volume enlarged(const Volume& solid, int side, JobContext& context) {
    Volume large({side, side, side}, solid.channels());
    const int from = solid.width();
    context.parallel(0, side, [&](int z) {
        const Between w = between(z, side, from);
        for (int c = 0; c < solid.channels(); ++c)
            for (int y = 0; y < side; ++y) {
                const Between v = between(y, side, from);
                for (int x = 0; x < side; ++x) {
                    const Between u = between(x, side, from);
                    const auto line = [&](int row, int plane) {
                        const float a = solid(u.first, row, plane, c), b = solid(u.second, row, plane, c);
                        return a + u.share * (b - a);
                    };
                    const auto square = [&](int plane) {
                        const float a = line(v.first, plane), b = line(v.second, plane);
                        return a + v.share * (b - a);
                    };
                    const float a = square(w.first), b = square(w.second);
                    large(x, y, z, c) = a + w.share * (b - a);
                }
            }
    });
    return large;
}

void matchColours(const Problem& problem, Volume& solid) {
    std::vector<Histogram> wanted(at(solid.channels()));
    const auto check = [&] { problem.context().check(); };
    problem.context().parallel(0, solid.channels(), [&](int c) {
        std::vector<float> all;
        for (const SliceGoal& goal : problem.goals())
            for (int y = 0; y < goal.exemplar.height(); ++y) {
                const float* row = goal.exemplar.view().plane(c).row(y);
                all.insert(all.end(), row, row + goal.exemplar.width());
            }
        const int count = static_cast<int>(all.size());
        SampleRanks ranks;
        const int rows = solid.height() * solid.depth();
        Histogram({all.data(), count, 1, count}, check)
            .match({solid.row(0, 0, c), solid.width(), rows, solid.width()}, ranks, check);
    });
}

} // namespace texloom::solid_optimise
