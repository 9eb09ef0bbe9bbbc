#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace texloom {

/// Laplace equations on some pixels of a grid, and a V-cycle that nearly inverts them: coarser levels have
/// one cell for every 2 × 2, halfway between the sums of the finer equations (aggregation), and each level is
/// smoothed forwards on the way down and backwards on the way up, so that the whole is symmetric and can
/// precondition conjugate gradients.
class Multigrid {
public:
    using Check = std::function<void()>;

    /// A pixel with its neighbours by number; count() where there is none or its value is given.
    struct Cell {
        int left = 0, up = 0, right = 0, down = 0;
        float toRight = 0, toDown = 0; ///< weights of these links; 1 at the finest level
        float diagonal = 0;            ///< the sum of all weights, those of links to given values among them
        float inverse = 0;             ///< of the diagonal
    };
    struct Pixel {
        int x, y;
    };

    /// @param pixels by rows. @param given how many neighbours of each are given. @param check called every
    /// few milliseconds, here and in precondition(); may throw.
    Multigrid(const std::vector<Pixel>& pixels, const std::vector<float>& given, Check check);

    int count() const { return static_cast<int>(m_levels.front().cells.size()) - 1; }
    /// The finest level, with a last cell that stands for all missing ones.
    const std::vector<Cell>& cells() const { return m_levels.front().cells; }

    /// to = A from; both with count() + 1 values, the last 0.
    void multiply(const std::vector<double>& from, std::vector<double>& to) const;
    /// Where to write the right-hand side of the equations before precondition(), by pixel.
    std::vector<float>& right() { return m_levels.front().right; }
    /// The V-cycle's solution.
    const std::vector<float>& precondition();

private:
    struct Level {
        std::vector<Cell> cells;
        std::vector<int> parents; ///< empty at the coarsest level
        std::vector<float> right, values;
    };

    template <class Visit> void each(const Level& level, Visit visit) const;
    template <class Visit> void eachBackwards(const Level& level, Visit visit) const;
    void link(Level& level, const std::vector<Pixel>& pixels) const;
    /// Adds the level above `finer`. @param pixels of the finer level; become those of the new one.
    Level coarsened(Level& finer, std::vector<Pixel>& pixels, int side) const;
    /// @param given weights of the cells' links to given values.
    void finish(Level& level, const std::vector<float>& given) const;
    static void relax(Level& level, std::size_t i, const Cell& cell);
    void smoothForwards(Level& level) const;
    void smoothBackwards(Level& level) const;
    void descend(std::size_t number);

    Check m_check;
    std::vector<Level> m_levels;
};

} // namespace texloom
