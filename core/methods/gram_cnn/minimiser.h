#pragma once

#include "core/math/lbfgs.h"
#include "core/methods/gram_cnn/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace texloom::gram_cnn {

/// What brings the loss down, as the settings say.
class Minimiser {
public:
    static constexpr int kHistory = 20;

    Minimiser(const Settings& settings, std::vector<float> start);

    /// One iteration. @return false where it will not come further, or a value is no number.
    bool step(const Objective& objective);
    const std::vector<float>& x() const { return m_lbfgs ? m_lbfgs->x() : m_adam->x(); }
    double value() const { return m_lbfgs ? m_lbfgs->value() : m_value; }

    std::string state() const { return m_lbfgs ? m_lbfgs->state() : m_adam->state(); }
    void takeUp(std::string_view state);

private:
    double m_rate;
    std::optional<Lbfgs> m_lbfgs;
    std::optional<Adam> m_adam;
    std::vector<float> m_gradient;
    double m_value = 0;
};

} // namespace texloom::gram_cnn
