#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace texloom {

/// A function to be minimised: its value at x; its derivative goes to `gradient`, as long as x.
using Objective = std::function<double(std::span<const float> x, std::span<float> gradient)>;

/// Minimises a smooth function of many variables by L-BFGS with a line search that ends where the strong
/// Wolfe conditions hold (Nocedal & Wright, Numerical Optimization, 2nd ed., algorithms 3.5, 3.6 and 7.5;
/// slope 0.9, decrease 1e-4). Sums are made in double and in a fixed order.
class Lbfgs {
public:
    /// @param start the first x. @param history how many steps curvature is learned from, at least 1.
    Lbfgs(std::vector<float> start, int history);

    /// One iteration: usually one evaluation, more where the step does not suit; the first takes one before.
    /// @return false where no step lowers the value, or the derivative is 0: it will not come further.
    bool step(const Objective& objective);

    const std::vector<float>& x() const { return m_x; }
    /// Of x; infinity before the first step.
    double value() const { return m_value; }

    /// All that it takes to go on later with the same bits, and the inverse.
    /// @throws Error if the state is not of as many variables.
    std::string state() const;
    void takeUp(std::string_view state);

    /// Bytes for so many variables.
    static std::uint64_t bytesFor(std::uint64_t variables, int history) {
        return variables * 4 * (2 * static_cast<std::uint64_t>(history) + 7);
    }

private:
    struct Pair {
        std::vector<float> step, change; ///< of x, of the gradient
        double product = 0;              ///< of both
    };
    struct Probe {
        double length = 0, value = 0, slope = 0;
    };

    std::vector<float> direction() const;
    Probe probe(const Objective& objective, const std::vector<float>& along, double length);
    Probe search(const Objective& objective, const std::vector<float>& along, double first, double slope);
    Probe narrowed(const Objective& objective, const std::vector<float>& along, Probe low, Probe high,
                   double slope, int probes);
    void remember(const std::vector<float>& oldGradient, const std::vector<float>& along, double length);

    int m_history;
    double m_value;
    std::vector<float> m_x, m_gradient;
    std::vector<float> m_probeX, m_probeGradient; ///< of the last probe
    std::deque<Pair> m_pairs;                     ///< the newest last
};

/// Minimises by Adam (Kingma & Ba 2015): every variable moves by about `rate`, whatever the function's scale.
class Adam {
public:
    explicit Adam(std::vector<float> start)
        : m_x(std::move(start)), m_mean(m_x.size()), m_square(m_x.size()) {}

    /// One step against the gradient. Means of the gradient and of its square fade by 0.9 and 0.999 a step.
    void step(std::span<const float> gradient, double rate);

    const std::vector<float>& x() const { return m_x; }
    std::string state() const;
    /// @throws Error if the state is not of as many variables.
    void takeUp(std::string_view state);

private:
    std::vector<float> m_x, m_mean, m_square;
    int m_steps = 0;
};

} // namespace texloom
