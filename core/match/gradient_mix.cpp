#include "core/match/gradient_mix.h"

#include <algorithm>
#include <vector>

namespace texloom {

namespace {

constexpr int kMixedRows = 32; ///< of one task

/// The chosen gradients of one row: right and down by channel and column.
class GradientRow {
public:
    GradientRow(const ImageView& first, const ImageView& second, const GradientChoice& choice)
        : m_first(first), m_second(second), m_choice(choice),
          m_weight(static_cast<float>(choice.preference * choice.preference)),
          m_right(static_cast<std::size_t>(first.channels) * static_cast<std::size_t>(first.width)),
          m_down(m_right.size()) {}

    void choose(int y) {
        for (int x = 0; x < m_first.width; ++x) {
            if (m_choice.perChannel) {
                for (int c = 0; c < m_first.channels; ++c)
                    chooseAt(x, y, c, c + 1);
            } else {
                chooseAt(x, y, 0, m_first.channels);
            }
        }
    }
    float right(int x, int c) const { return m_right[at(x, c)]; }
    float down(int x, int c) const { return m_down[at(x, c)]; }

private:
    std::size_t at(int x, int c) const {
        return static_cast<std::size_t>(c) * static_cast<std::size_t>(m_first.width) +
               static_cast<std::size_t>(x);
    }
    int next(int at, int length) const { return at + 1 < length ? at + 1 : m_choice.wraps ? 0 : at; }

    /// One decision for the channels [from, to).
    void chooseAt(int x, int y, int from, int to) {
        const int u = next(x, m_first.width), v = next(y, m_first.height);
        float one = 0, two = 0;
        for (int c = from; c < to; ++c) {
            one += squared(m_first, x, y, u, v, c);
            two += squared(m_second, x, y, u, v, c);
        }
        const ImageView& chosen = m_weight * one >= two ? m_first : m_second;
        for (int c = from; c < to; ++c) {
            m_right[at(x, c)] = chosen(u, y, c) - chosen(x, y, c);
            m_down[at(x, c)] = chosen(x, v, c) - chosen(x, y, c);
        }
    }
    static float squared(const ImageView& of, int x, int y, int u, int v, int c) {
        const float right = of(u, y, c) - of(x, y, c), down = of(x, v, c) - of(x, y, c);
        return right * right + down * down;
    }

    const ImageView& m_first;
    const ImageView& m_second;
    const GradientChoice& m_choice;
    float m_weight;
    std::vector<float> m_right, m_down;
};

} // namespace

Image mixedDivergence(const ImageView& first, const ImageView& second, const GradientChoice& choice,
                      JobContext& context) {
    Image sums(first.size(), first.channels);
    const int width = first.width, height = first.height;
    const int strips = (height + kMixedRows - 1) / kMixedRows;
    context.parallel(0, strips, [&](int strip) {
        GradientRow one(first, second, choice), two(first, second, choice);
        GradientRow *above = &one, *here = &two;
        const int begin = strip * kMixedRows, end = std::min(height, begin + kMixedRows);
        const bool hasAbove = begin > 0 || choice.wraps;
        if (hasAbove)
            above->choose(begin > 0 ? begin - 1 : height - 1);
        for (int y = begin; y < end; ++y) {
            context.check();
            here->choose(y);
            for (int c = 0; c < first.channels; ++c)
                for (int x = 0; x < width; ++x) {
                    const bool hasLeft = x > 0 || choice.wraps;
                    const float left = hasLeft ? here->right(x > 0 ? x - 1 : width - 1, c) : 0;
                    const float up = y > begin || hasAbove ? above->down(x, c) : 0;
                    sums(x, y, c) = here->right(x, c) - left + here->down(x, c) - up;
                }
            std::swap(above, here);
        }
    });
    context.progress(1);
    return sums;
}

} // namespace texloom
