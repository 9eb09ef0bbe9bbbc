#include "core/match/error_path.h"

#include <algorithm>
#include <limits>

namespace texloom {

namespace {

constexpr float kOutOfReach = std::numeric_limits<float>::max() / 4;

/// Errors of a band, line by line, and the sums of paths through it.
class ErrorBand {
public:
    ErrorBand(int length, int width)
        : m_length(length), m_width(width),
          m_errors(static_cast<std::size_t>(length) * static_cast<std::size_t>(width)) {}

    float* errors(int along) { return m_errors.data() + offset(along); }

    /// The cheapest path over `turns` rounds of the band that begins anywhere, or at `pinned` and ends there.
    std::vector<int> path(int turns, int pinned, const std::function<void()>& check) const {
        const int lines = turns * m_length;
        std::vector<signed char> steps(static_cast<std::size_t>(lines) * static_cast<std::size_t>(m_width));
        std::vector<float> sums(m_errors.begin(), m_errors.begin() + m_width), next(sums);
        for (int i = 0; i < m_width; ++i)
            if (pinned >= 0 && i != pinned)
                sums[static_cast<std::size_t>(i)] = kOutOfReach;
        for (int line = 1; line < lines; ++line) {
            if (line % 256 == 0)
                check();
            // Sums are kept small, so that their rounding is.
            const float least = *std::min_element(sums.begin(), sums.end());
            for (int i = 0; i < m_width; ++i) {
                int from = i;
                for (const int other : {i - 1, i + 1})
                    if (other >= 0 && other < m_width &&
                        sums[static_cast<std::size_t>(other)] < sums[static_cast<std::size_t>(from)])
                        from = other;
                steps[static_cast<std::size_t>(line) * static_cast<std::size_t>(m_width) +
                      static_cast<std::size_t>(i)] = static_cast<signed char>(from - i);
                next[static_cast<std::size_t>(i)] =
                    sums[static_cast<std::size_t>(from)] - least +
                    m_errors[offset(line % m_length) + static_cast<std::size_t>(i)];
            }
            sums.swap(next);
        }
        int at = static_cast<int>(std::min_element(sums.begin(), sums.end()) - sums.begin());
        // Where the path must close, its end may lie a step aside of its beginning.
        if (pinned >= 0)
            for (int i = std::max(0, pinned - 1), best = at = pinned; i <= std::min(m_width - 1, pinned + 1);
                 ++i)
                if (sums[static_cast<std::size_t>(i)] < sums[static_cast<std::size_t>(best)])
                    best = at = i;
        std::vector<int> places(static_cast<std::size_t>(lines));
        for (int line = lines - 1; line >= 0; --line) {
            places[static_cast<std::size_t>(line)] = at;
            at += steps[static_cast<std::size_t>(line) * static_cast<std::size_t>(m_width) +
                        static_cast<std::size_t>(at)];
        }
        return places;
    }

private:
    std::size_t offset(int along) const {
        return static_cast<std::size_t>(along) * static_cast<std::size_t>(m_width);
    }

    int m_length, m_width;
    std::vector<float> m_errors;
};

} // namespace

std::vector<int> leastErrorPath(int length, int width,
                                const std::function<void(int along, float* errors)>& errorsOf, bool closes,
                                const std::function<void()>& check) {
    ErrorBand band(length, width);
    for (int along = 0; along < length; ++along) {
        if (along % 64 == 0)
            check();
        errorsOf(along, band.errors(along));
    }
    if (!closes || width == 1)
        return band.path(1, -1, check);
    const std::vector<int> twice = band.path(2, -1, check);
    return band.path(1, twice[static_cast<std::size_t>(length)], check);
}

} // namespace texloom
