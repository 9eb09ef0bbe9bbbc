#include "core/analysis/lattice_settings.h"

#include "core/analysis/lattice_detector.h"
#include "core/base/error.h"

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>

namespace texloom {

void checkLattice(const LatticeSettings& settings, const std::string& exemplar, Size size) {
    if (settings.lattice != LatticeSource::Given)
        return;
    const Lattice given = settings.given();
    constexpr double kSmallestTile = 0.5;
    if (!(given.area() >= kSmallestTile) || given.area() < 0.01 * given.v1.length() * given.v2.length())
        failUsage(
            "The lattice's vectors ({}, {}) and ({}, {}) px do not span a tile; give two that do not lie "
            "on one line.",
            numberText(given.v1.x), numberText(given.v1.y), numberText(given.v2.x), numberText(given.v2.y));
    const Lattice shortest = given.reduced();
    const Vec2 extent = shortest.extent();
    if (extent.x > size.width || extent.y > size.height)
        failUsage("The lattice's tile of {:.0f} × {:.0f} px is larger than {} with {} × {} px; give shorter "
                  "vectors, or set lattice=none.",
                  extent.x, extent.y, exemplar, size.width, size.height);
}

namespace {

/// What was found in an exemplar.
struct Finding {
    std::weak_ptr<const Image> exemplar;
    LatticeCriteria criteria;
    Lattice lattice; ///< free() if none is reliable
    bool candidates = false;
    double confidence = 0;
};

/// The exemplars analysed last. An image never changes once it is shared, so the strips of a large output,
/// and later runs, need not repeat the analysis.
class Findings {
public:
    std::optional<Finding> of(const std::shared_ptr<const Image>& exemplar, const LatticeCriteria& criteria) {
        const std::lock_guard lock(m_mutex);
        for (const Finding& finding : m_last)
            if (finding.exemplar.lock() == exemplar && finding.criteria == criteria)
                return finding;
        return {};
    }
    void add(const Finding& finding) {
        constexpr std::size_t kMost = 16;
        const std::lock_guard lock(m_mutex);
        m_last.push_front(finding);
        m_last.resize(std::min(m_last.size(), kMost));
    }

private:
    std::mutex m_mutex;
    std::deque<Finding> m_last;
};

Finding findingIn(const std::shared_ptr<const Image>& exemplar, const LatticeCriteria& criteria,
                  const std::function<void()>& check) {
    static Findings findings;
    if (const std::optional<Finding> known = findings.of(exemplar, criteria))
        return *known;
    const LatticeAnalysis analysis = analyzeLattice(*exemplar, check, criteria);
    Finding finding{exemplar, criteria, analysis.found() ? analysis.candidates.front().lattice : Lattice{},
                    !analysis.candidates.empty(), analysis.confidence};
    findings.add(finding);
    return finding;
}

} // namespace

Lattice latticeFor(const LatticeSettings& settings, const std::string& name,
                   const std::shared_ptr<const Image>& exemplar, std::vector<Message>& notes,
                   const std::function<void()>& check) {
    if (settings.lattice == LatticeSource::None)
        return {};
    if (settings.lattice == LatticeSource::Given)
        return settings.given().reduced();
    const Finding found = findingIn(exemplar, settings.criteria(), check);
    if (!found.lattice.free())
        return found.lattice;
    if (found.candidates)
        notes.push_back(
            message("No lattice was found in {} (confidence {:.0f} %; a vector must fit about twice), so it "
                    "was treated as a texture that does not repeat. If it does, rectify it where it is seen "
                    "at an angle, or give its vectors yourself; if it does not, image quilting may suit it "
                    "better.",
                    name, 100 * found.confidence));
    else
        notes.push_back(message("Nothing in {} repeats about twice, so it was treated as a texture that does "
                                "not repeat. If it does, rectify it where it is seen at an angle, or give "
                                "its vectors yourself; if it does not, image quilting may suit it better.",
                                name));
    return {};
}

} // namespace texloom
