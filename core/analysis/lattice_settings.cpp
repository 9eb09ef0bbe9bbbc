#include "core/analysis/lattice_settings.h"

#include "core/analysis/lattice_detector.h"
#include "core/base/error.h"

namespace texloom {

void checkLattice(const LatticeSettings& settings, const std::string& exemplar, Size size) {
    if (settings.lattice != LatticeSource::Given)
        return;
    const Lattice given = settings.given();
    const std::string vectors =
        fmt::format("({}, {}) and ({}, {}) px", numberText(given.v1.x), numberText(given.v1.y),
                    numberText(given.v2.x), numberText(given.v2.y));
    constexpr double kSmallestTile = 0.5;
    if (!(given.area() >= kSmallestTile) || given.area() < 0.01 * given.v1.length() * given.v2.length())
        failUsage("The lattice's vectors {} do not span a tile; give two that do not lie on one line.",
                  vectors);
    const Lattice shortest = given.reduced();
    const Vec2 extent = shortest.extent();
    if (extent.x > size.width || extent.y > size.height)
        failUsage("The lattice's tile of {:.0f} × {:.0f} px is larger than {} with {} × {} px; give shorter "
                  "vectors, "
                  "or set lattice=none.",
                  extent.x, extent.y, exemplar, size.width, size.height);
}

Lattice latticeFor(const LatticeSettings& settings, const std::string& exemplar, const ImageView& image,
                   std::vector<std::string>& notes, const std::function<void()>& check) {
    if (settings.lattice == LatticeSource::None)
        return {};
    if (settings.lattice == LatticeSource::Given)
        return settings.given().reduced();
    const LatticeAnalysis analysis = analyzeLattice(image, check);
    if (analysis.found())
        return analysis.candidates.front().lattice;
    notes.push_back(
        fmt::format("No lattice was found in {} (confidence {:.0f} %), so it was taken as a texture that "
                    "does not repeat; if it does, give the vectors with lattice=given.",
                    exemplar, 100 * analysis.confidence));
    return {};
}

} // namespace texloom
