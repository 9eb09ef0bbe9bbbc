#include "core/analysis/lattice_values.h"

#include <gtest/gtest.h>

namespace texloom::test {
namespace {

enum class Corner { Anywhere, Here };

struct Settings : LatticeSettings {
    Corner corner = Corner::Anywhere;
    double right = 0, down = 0;
};

/// A lattice's parameters under names of their own: only their roles say what they are.
std::vector<Param> renamed() {
    const auto number = [](double LatticeSettings::*member, const char* name, std::string_view role) {
        return field(static_cast<double Settings::*>(member), name, name)
            .role(role)
            .range(-100, 100)
            .when("whence", std::string("mine"));
    };
    std::vector<Param> params;
    params.push_back(
        field(static_cast<LatticeSource Settings::*>(&LatticeSettings::lattice), "whence", "Whence")
            .role(lattice_role::kSource)
            .choices({{"search", ""}, {"mine", ""}, {"nowhere", ""}}));
    params.push_back(number(&LatticeSettings::v2y, "d", lattice_role::kSecondDown));
    params.push_back(number(&LatticeSettings::v2x, "c", lattice_role::kSecondRight));
    params.push_back(number(&LatticeSettings::v1y, "b", lattice_role::kFirstDown));
    params.push_back(number(&LatticeSettings::v1x, "a", lattice_role::kFirstRight));
    params.push_back(field(&Settings::corner, "corner", "Corner").choices({{"any", ""}, {"this", ""}}));
    params.push_back(field(&Settings::right, "to-the-right", "Right")
                         .role(lattice_role::kTileRight)
                         .when("corner", std::string("this")));
    params.push_back(field(&Settings::down, "downwards", "Down")
                         .role(lattice_role::kTileDown)
                         .when("corner", std::string("this")));
    return params;
}

const Lattice kLattice{{20, 1}, {3, 17}};

TEST(LatticeValues, knowParametersByTheirRoles) {
    const std::vector<Param> params = renamed();
    ASSERT_TRUE(followsLattice(params));
    const Values given = latticeValues(params, kLattice, Vec2{45, 30});
    EXPECT_EQ(given, (Values{{"whence", std::string("mine")},
                             {"a", 20.0},
                             {"b", 1.0},
                             {"c", 3.0},
                             {"d", 17.0},
                             {"corner", std::string("this")},
                             {"to-the-right", 45.0},
                             {"downwards", 30.0}}));
    ASSERT_TRUE(givenLattice(params, given).has_value());
    EXPECT_EQ(*givenLattice(params, given), kLattice);
    EXPECT_EQ(latticeSource(params, given), LatticeSource::Given);
}

TEST(LatticeValues, leaveTheTileToTheMethodWithoutAnOrigin) {
    const Values given = latticeValues(renamed(), kLattice, {});
    EXPECT_EQ(given.at("corner"), Value(std::string("any")));
    EXPECT_EQ(given.at("to-the-right"), Value(0.0));
}

TEST(LatticeValues, foldTheOriginIntoOneTile) {
    std::vector<Param> params = latticeFields<LatticeSettings>();
    struct Origin {
        double right = 0;
    };
    params.push_back(field(&Origin::right, "from", "From").role(lattice_role::kOriginRight));
    const Values given = latticeValues(params, {{20, 0}, {0, 17}}, Vec2{-7, 40});
    EXPECT_EQ(given.at("from"), Value(13.0));
}

TEST(LatticeValues, giveNoLatticeWhereNoneIsGiven) {
    const std::vector<Param> params = renamed();
    Values settings = latticeValues(params, kLattice, {});
    settings["whence"] = std::string("nowhere");
    EXPECT_EQ(latticeSource(params, settings), LatticeSource::None);
    EXPECT_FALSE(givenLattice(params, settings));
    settings["whence"] = std::string("search");
    EXPECT_EQ(latticeSource(params, settings), LatticeSource::Automatic);
    EXPECT_FALSE(givenLattice(params, settings));
    settings["whence"] = std::string("mine");
    settings["a"] = settings["b"] = 0.0;
    EXPECT_FALSE(givenLattice(params, settings)) << "two vectors on one line";
}

TEST(LatticeValues, areThoseOfTheLatticeAmongAllSettings) {
    const std::vector<Param> params = renamed();
    Values settings = latticeValues(params, kLattice, Vec2{4, 5});
    const Values own = settings;
    settings["patch"] = 12;
    EXPECT_EQ(latticeValues(params, settings), own);
}

TEST(LatticeValues, wantAllFiveParameters) {
    std::vector<Param> params = latticeFields<LatticeSettings>();
    EXPECT_TRUE(followsLattice(params));
    params.pop_back();
    EXPECT_FALSE(followsLattice(params));
    EXPECT_FALSE(givenLattice(params, {}));
    EXPECT_FALSE(followsLattice({}));
}

} // namespace
} // namespace texloom::test
