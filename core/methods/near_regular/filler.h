#pragma once

#include "core/job/job_context.h"
#include "core/methods/near_regular/border_match.h"
#include "core/methods/near_regular/layout.h"
#include "core/methods/near_regular/sampler.h"
#include "core/methods/near_regular/settings.h"
#include "core/methods/synthesis.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace texloom::near_regular {

/// An exemplar as it is sampled, the lattices to sample it by, and the sizes that were chosen.
struct Plan {
    ImageView exemplar;
    PlaneView mask;   ///< of the exemplar's size, or {}
    Lattice from, to; ///< in the exemplar and in the output
    int block = 0, border = 0;
};

/// Fills the part of an output that a request asks for. Sampled blocks depend on their place and the seed
/// alone, gaps on the four sampled blocks around them, and their cuts on up to four more gaps, so that every
/// part equals that part of the whole.
class Filler {
public:
    Filler(const Request& request, const Settings& settings, const Plan& plan, JobContext& context);
    ~Filler();
    Filler(const Filler&) = delete;
    Filler& operator=(const Filler&) = delete;

    /// Fills image and map of the result, in two stages of total weight `weight`.
    void fill(Synthesis& result, double weight);

private:
    struct Workspace;
    /// A filled gap: where its patch lies in the exemplar, and which part of it was cut away.
    struct Gap {
        Cell cell;
        Point patch;
        std::vector<std::uint8_t> keep; ///< patch × patch, 1 where the sampled blocks stay
        double cutCost = 0;
    };
    /// Where the exemplar's pixel for an output pixel lies: the output pixel plus this.
    struct Shift {
        int x = 0, y = 0;
    };

    Overlap borderOf(Cell cell) const;
    Point corner(Cell cell) const;
    Shift shiftOf(Cell cell, Point patch) const;
    void readBorder(const Gap& gap, Workspace& work) const;
    void readCutsAround(const Gap& gap, Workspace& work) const;
    void addCornerSeams(const Gap& gap, Workspace& work) const;
    void fillGap(int index);
    void cutGap(Gap& gap, Workspace& work) const;
    void paintSampled(Cell cell);
    void paintGap(const Gap& gap);
    void paint(int x, int y, Shift shift);
    void blendCell(Cell cell);
    std::vector<Cell> cellsOfPart() const;
    const Gap* gapAt(Cell cell) const;
    Point patchAt(Cell cell) const;

    std::unique_ptr<Workspace> borrow();
    void giveBack(std::unique_ptr<Workspace> work);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    Plan m_plan;
    Region m_part;
    Layout m_layout;
    BorderMatch m_match;
    Sampler m_sampler;
    std::vector<Gap> m_gaps; ///< even rows first
    std::map<Cell, int> m_index;
    Image m_image;
    PositionMap m_map;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<Workspace>> m_idle;
};

} // namespace texloom::near_regular
