#pragma once

#include "core/analysis/lattice.h"
#include "core/analysis/lattice_settings.h"

#include <optional>
#include <vector>

namespace texloom {

/// Whether these parameters of a method are those of one that follows a lattice, whatever they are called:
/// they are known by their roles.
bool followsLattice(const std::vector<Param>& params);

/// The settings by which a method with these parameters uses the lattice; the method must follow one.
/// @param origin where a tile begins, in pixels of the exemplar; none where the method chooses.
Values latticeValues(const std::vector<Param>& params, const Lattice& lattice,
                     const std::optional<Vec2>& origin);

/// The settings that determine which lattice is used, and where it begins.
Values latticeValues(const std::vector<Param>& params, const Values& settings);

/// The source of the lattice according to the settings; the method must follow one.
LatticeSource latticeSource(const std::vector<Param>& params, const Values& settings);

/// The lattice that the settings give; none where the method finds its own or follows none.
std::optional<Lattice> givenLattice(const std::vector<Param>& params, const Values& settings);

} // namespace texloom
