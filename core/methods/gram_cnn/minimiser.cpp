#include "core/methods/gram_cnn/minimiser.h"

#include <cmath>
#include <utility>

namespace texloom::gram_cnn {

Minimiser::Minimiser(const Settings& settings, std::vector<float> start) : m_rate(settings.rate) {
    if (settings.optimiser == Optimiser::Lbfgs) {
        m_lbfgs.emplace(std::move(start), kHistory);
        return;
    }
    m_gradient.resize(start.size());
    m_adam.emplace(std::move(start));
}

bool Minimiser::step(const Objective& objective) {
    if (m_lbfgs)
        return m_lbfgs->step(objective);
    m_value = objective(m_adam->x(), m_gradient);
    if (!std::isfinite(m_value))
        return false;
    m_adam->step(m_gradient, m_rate);
    return true;
}

void Minimiser::takeUp(std::string_view state) {
    if (m_lbfgs)
        m_lbfgs->takeUp(state);
    else
        m_adam->takeUp(state);
}

} // namespace texloom::gram_cnn
