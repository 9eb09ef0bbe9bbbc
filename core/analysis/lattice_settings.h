#pragma once

#include "core/analysis/lattice_candidate.h"
#include "core/base/message.h"
#include "core/base/param.h"
#include "core/base/text.h"
#include "core/image/image.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// Roles of the parameters by which a method follows a lattice; see Param::role().
namespace lattice_role {
/// A choice: where the lattice comes from, its entries in the order of LatticeSource.
inline constexpr std::string_view kSource = "lattice-source";
/// The given vectors, in pixels of the exemplar.
inline constexpr std::string_view kFirstRight = "lattice-first-right", kFirstDown = "lattice-first-down",
                                  kSecondRight = "lattice-second-right", kSecondDown = "lattice-second-down";
/// The point of the lattice that lies at the output's top left, in pixels of the exemplar.
inline constexpr std::string_view kOriginRight = "lattice-origin-right", kOriginDown = "lattice-origin-down";
/// The corner of the one tile that is repeated, in pixels of the exemplar.
inline constexpr std::string_view kTileRight = "lattice-tile-right", kTileDown = "lattice-tile-down";
} // namespace lattice_role

/// Where a method's lattice comes from.
enum class LatticeSource { Automatic, Given, None };

/// The parameters of a method that follows a lattice: what a user confirms in the window, or types.
struct LatticeSettings {
    LatticeSource lattice = LatticeSource::Automatic;
    double v1x = 0, v1y = 0, v2x = 0, v2y = 0; ///< the given vectors, in pixels of the exemplar
    double alpha = LatticeCriteria{}.alpha, significance = LatticeCriteria{}.significance; ///< of the search

    Lattice given() const { return {{v1x, v1y}, {v2x, v2y}}; }
    LatticeCriteria criteria() const { return {alpha, significance}; }
};

/// The parameters' declarations for a settings struct that is a LatticeSettings.
template <class Settings> std::vector<Param> latticeFields() {
    const auto given = std::string("given");
    const auto vector = [&](double LatticeSettings::*member, const char* name, std::string_view role,
                            const char* title, const char* help) {
        return field(static_cast<double Settings::*>(member), name, title)
            .role(role)
            .range(-65535, 65535)
            .unit("px")
            .when("lattice", given)
            .group(TR("Lattice"))
            .help(help);
    };
    std::vector<Param> fields;
    fields.push_back(
        field(static_cast<LatticeSource Settings::*>(&LatticeSettings::lattice), "lattice", TR("Lattice"))
            .role(lattice_role::kSource)
            .choices({{"automatic", TR("Found by itself")}, {given, TR("As given")}, {"none", TR("None")}})
            .group(TR("Lattice"))
            .help(TR(
                "The two vectors by which the texture repeats itself: found in the exemplar, given, or none "
                "for a texture that does not repeat.")));
    fields.push_back(vector(&LatticeSettings::v1x, "v1-x", lattice_role::kFirstRight,
                            TR("First vector, right"),
                            TR("How far to the right the texture repeats itself first.")));
    fields.push_back(vector(&LatticeSettings::v1y, "v1-y", lattice_role::kFirstDown, TR("First vector, down"),
                            TR("How far down the texture repeats itself first.")));
    fields.push_back(vector(&LatticeSettings::v2x, "v2-x", lattice_role::kSecondRight,
                            TR("Second vector, right"),
                            TR("How far to the right the texture repeats itself in the other direction.")));
    fields.push_back(vector(&LatticeSettings::v2y, "v2-y", lattice_role::kSecondDown,
                            TR("Second vector, down"),
                            TR("How far down the texture repeats itself in the other direction.")));
    return fields;
}

/// The declarations of LatticeCriteria's numbers, which matter where a lattice is looked for.
template <class Settings> std::vector<Param> latticeSearchFields() {
    const auto found = std::string("automatic");
    return {field(static_cast<double Settings::*>(&LatticeSettings::alpha), "alpha", TR("Smaller tiles"))
                .range(1, 2)
                .symbol("α")
                .when("lattice", found)
                .group(TR("Advanced"))
                .help(TR("How much a small tile that repeats often is preferred to a large one that fits "
                         "better when a lattice is looked for: 1 not at all, larger finds smaller tiles.")),
            field(static_cast<double Settings::*>(&LatticeSettings::significance), "significance",
                  TR("Overlap that counts"))
                .range(0.5, 1)
                .when("lattice", found)
                .group(TR("Advanced"))
                .help(TR("The share of a tile by which the exemplar must overlap itself for a repetition to "
                         "count when a lattice is looked for: smaller counts those near its ends, which tell "
                         "less, and finds larger tiles."))};
}

/// Checks the given vectors against an exemplar. @throws UsageError where they span no tile, or one that is
/// larger than the exemplar.
void checkLattice(const LatticeSettings& settings, const std::string& exemplar, Size size);

/// The lattice that the settings ask for; free() if none is asked for, or none is found. An exemplar is
/// analysed once, however many runs need it. @param name of the exemplar, for the notes. @param notes gets a
/// sentence if no lattice was found.
/// @param check called every few milliseconds; may throw.
Lattice latticeFor(const LatticeSettings& settings, const std::string& name,
                   const std::shared_ptr<const Image>& exemplar, std::vector<Message>& notes,
                   const std::function<void()>& check);

} // namespace texloom
