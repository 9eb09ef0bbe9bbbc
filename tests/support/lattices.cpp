#include "tests/support/lattices.h"

#include "core/job/random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace texloom::test {

namespace {

constexpr double kTurn = 6.283185307179586;

double normal(const Random& random, int x, int y, std::uint32_t n) {
    return std::sqrt(-2 * std::log(1 - random.uniform(x, y, n))) *
           std::cos(kTurn * random.uniform(x, y, n + 1));
}

/// A sum of waves over the tile, none of which is left out, so that no smaller tile will do.
class Figure {
public:
    explicit Figure(const Random& random) {
        for (int i = 0; i <= 3; ++i)
            for (int j = i == 0 ? 1 : -3; j <= 3; ++j)
                m_waves.push_back(
                    {i, j, (0.3 + random.uniform(i, j, 1)) / (i * i + j * j), random.uniform(i, j, 2)});
    }

    double at(Vec2 point, int channel) const {
        double sum = 0;
        for (const Wave& wave : m_waves)
            sum += wave.strength *
                   std::sin(kTurn * (wave.i * point.x + wave.j * point.y + wave.phase + 0.05 * channel));
        return sum;
    }

private:
    struct Wave {
        int i, j;
        double strength, phase;
    };
    std::vector<Wave> m_waves;
};

} // namespace

Image regularTexture(Size size, int channels, const Lattice& lattice, const Regularity& regularity,
                     std::uint64_t seed) {
    const Random random(seed);
    const Figure figure(random);
    constexpr double kContrast = 0.2;
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Vec2 at = lattice.coordinates({x + 0.5, y + 0.5});
                const Vec2 tile{std::floor(at.x), std::floor(at.y)};
                const Vec2 within = at - tile;
                const auto n = static_cast<std::uint32_t>(10 + c);
                const double change =
                    random.uniform(static_cast<int>(tile.x), static_cast<int>(tile.y), n) - 0.5;
                const bool joint = within.x < 0.12 || within.y < 0.12;
                const double texture =
                    joint ? -1.5 : figure.at(within, c) + 3.4 * regularity.colourChange * change;
                const double light = regularity.ramp * (double(x) / size.width + double(y) / size.height - 1);
                const double noise = regularity.noise == 0
                                         ? 0
                                         : std::sqrt(regularity.noise) *
                                               normal(random, x, y, 20 + 2 * static_cast<std::uint32_t>(c));
                image(x, y, c) = static_cast<float>(0.5 + kContrast * (texture + light + noise));
            }
    return image;
}

namespace {

/// One course: where its stones end, and what each adds to the brightness.
class Course {
public:
    Course(const Random& random, int row, double from, double to, double shortest, double change) {
        m_joints.push_back(from - random.uniform(row, 0) * shortest);
        for (int i = 1; m_joints.back() < to; ++i) {
            m_joints.push_back(m_joints.back() + shortest * (1 + 3 * random.uniform(row, i, 1)));
            m_changes.push_back(change * (random.uniform(row, i, 2) - 0.5));
        }
    }

    /// How far a place is from the nearest joint, and the change of the stone there.
    std::pair<double, double> at(double place) const {
        const auto next = std::upper_bound(m_joints.begin() + 1, m_joints.end() - 1, place);
        const double joint = std::min(*next - place, place - *(next - 1));
        return {std::abs(joint), m_changes[static_cast<std::size_t>(next - m_joints.begin()) - 1]};
    }

private:
    std::vector<double> m_joints, m_changes;
};

} // namespace

Image coursesTexture(Size size, int channels, Vec2 along, double distance, const Regularity& regularity,
                     std::uint64_t seed) {
    const Random random(seed);
    const Vec2 across{-along.y, along.x};
    const double reach = std::hypot(size.width, size.height);
    constexpr double kContrast = 0.2, kJoint = 0.12, kShortest = 0.6;
    std::map<int, Course> courses;
    Image image(size, channels);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec2 at{x + 0.5, y + 0.5};
            const double course = dot(at, across) / distance;
            const int row = static_cast<int>(std::floor(course));
            const auto stones = courses.try_emplace(row, random, row, -reach, reach, kShortest * distance,
                                                    3.4 * regularity.colourChange);
            const auto [joint, change] = stones.first->second.at(dot(at, along));
            // Soft edges, as a lens makes them: hard ones would repeat with the pixels.
            const double bed = 0.5 * distance - std::abs(course - row - 0.5) * distance;
            const double depth = std::min(bed, joint) - 0.5 * kJoint * distance;
            const double shown = std::clamp(0.5 + depth / 2, 0.0, 1.0);
            const double light = regularity.ramp * (double(x) / size.width + double(y) / size.height - 1);
            for (int c = 0; c < channels; ++c) {
                const double noise = std::sqrt(regularity.noise) *
                                     normal(random, x, y, 20 + 2 * static_cast<std::uint32_t>(c));
                image(x, y, c) = static_cast<float>(
                    0.5 + kContrast * ((shown - 1) * 1.5 + shown * change + light + noise));
            }
        }
    return image;
}

Image planksTexture(Size size, int channels, Vec2 along, double widest, std::uint64_t seed) {
    const Random random(seed);
    const Vec2 across{-along.y, along.x};
    const double reach = std::hypot(size.width, size.height);
    std::vector<double> joints = {-reach};
    while (joints.back() < reach)
        joints.push_back(joints.back() +
                         widest * (0.3 + 0.7 * random.uniform(static_cast<int>(joints.size()), 0)));
    Image image(size, channels);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double place = dot({x + 0.5, y + 0.5}, across);
            const auto next = std::upper_bound(joints.begin() + 1, joints.end() - 1, place);
            const int plank = static_cast<int>(next - joints.begin());
            const double joint = std::min(*next - place, place - *(next - 1));
            const double shade = 0.2 * random.uniform(plank, 1);
            const double streak = 0.1 * random.uniform(static_cast<int>(std::floor(place)), 2);
            for (int c = 0; c < channels; ++c)
                image(x, y, c) =
                    static_cast<float>((joint < 1.5 ? 0.1 : 0.4 + shade + streak) +
                                       0.05 * normal(random, x, y, 20 + 2 * static_cast<std::uint32_t>(c)));
        }
    return image;
}

LatticeCase latticeCase(int index) {
    static const char* const kKinds[] = {"square", "rectangular", "hexagonal", "oblique", "brick bond"};
    const Random random(static_cast<std::uint64_t>(index) + 1000);
    const auto draw = [&](int n, double low, double high) {
        return low + (high - low) * random.uniform(n, 0);
    };
    const int kind = index % 5;
    LatticeCase made;
    made.kind = kKinds[kind];
    double period = 9 * std::pow(10.0, draw(0, 0, 1));
    if (random.uniform(1, 0) < 0.4)
        period = std::round(period);
    const double turn = kind == 4 && random.uniform(8, 0) < 0.5 ? 0 : draw(2, -0.3, 0.3);
    const Vec2 along{period * std::cos(turn), period * std::sin(turn)};
    const Vec2 across{-along.y, along.x};
    const double aspect = draw(3, 0.6, 1.6);
    switch (kind) {
    case 0:
        made.lattice = {along, across};
        break;
    case 1:
        made.lattice = {along, aspect * across};
        break;
    case 2:
        made.lattice = {along, 0.5 * along + std::sqrt(0.75) * across};
        break;
    case 3:
        made.lattice = {along, draw(4, -0.5, 0.5) * along + aspect * across};
        break;
    default:
        made.lattice = {along, 0.5 * along + draw(5, 0.3, 0.6) * across};
        break;
    }
    const Lattice shortest = made.lattice.reduced();
    const double grow = std::max(1.0, 9 / std::min(shortest.v1.length(), shortest.v2.length()));
    made.lattice = {grow * made.lattice.v1, grow * made.lattice.v2};
    const Vec2 extent = made.lattice.extent();
    const double least = 2.4 * std::max(extent.x, extent.y);
    const int side = static_cast<int>(std::max(least, draw(6, 128, 288)));
    made.size = {side, static_cast<int>(side * draw(7, 0.85, 1.0))};
    made.regularity = {random.uniform(9, 0) < 0.5 ? 0 : 0.1 * random.uniform(10, 0),
                       random.uniform(11, 0) < 0.5 ? 0 : 0.6 * random.uniform(12, 0),
                       random.uniform(13, 0) < 0.5 ? 0 : 2 * random.uniform(14, 0)};
    return made;
}

CoursesCase coursesCase(int index) {
    const Random random(static_cast<std::uint64_t>(index) + 5000);
    const auto draw = [&](int n, double low, double high) {
        return low + (high - low) * random.uniform(n, 0);
    };
    const double turn = draw(0, -0.3, 0.3) + (index % 2 == 0 ? 0 : std::acos(0.0));
    CoursesCase made;
    made.along = {std::cos(turn), std::sin(turn)};
    made.distance = 9 * std::pow(60.0 / 9, draw(1, 0, 1));
    const int side = static_cast<int>(std::max(4 * made.distance, draw(2, 128, 288)));
    made.size = {side, static_cast<int>(side * draw(3, 0.85, 1.0))};
    made.regularity = {random.uniform(4, 0) < 0.5 ? 0 : 0.1 * random.uniform(5, 0),
                       random.uniform(6, 0) < 0.5 ? 0 : 0.6 * random.uniform(7, 0),
                       random.uniform(8, 0) < 0.5 ? 0 : 2 * random.uniform(9, 0)};
    return made;
}

Image nearlyAlikeSquares() {
    Image board({160, 160}, 1);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) {
            const bool joint = x % 16 < 2 || y % 16 < 2;
            board(x, y, 0) = joint ? 0.0F : (x / 16 + y / 16) % 2 == 0 ? 0.9F : 0.68F;
        }
    return board;
}

} // namespace texloom::test
