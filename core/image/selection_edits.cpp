#include "core/image/selection_edits.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

/// The smallest region in which two pictures of one channel differ; empty if they are alike.
Region differenceOf(const Image& a, const Image& b) {
    int left = a.width(), top = a.height(), right = 0, bottom = 0;
    for (int y = 0; y < a.height(); ++y) {
        const float* const one = a.plane(0).row(y);
        const float* const two = b.plane(0).row(y);
        const float* const end = one + a.width();
        const auto first = static_cast<int>(std::mismatch(one, end, two).first - one);
        if (first == a.width())
            continue;
        int last = a.width() - 1;
        while (one[last] == two[last])
            --last;
        left = std::min(left, first);
        right = std::max(right, last + 1);
        top = std::min(top, y);
        bottom = y + 1;
    }
    return right == 0 ? Region{} : Region{left, top, {right - left, bottom - top}};
}

} // namespace

SelectionEdits::SelectionEdits(Image selection, std::int64_t mostPixels)
    : m_selection(std::move(selection)), m_mostPixels(mostPixels) {}

void SelectionEdits::set(const Image& selection) {
    const Region changed = differenceOf(m_selection, selection);
    if (changed.size.empty())
        return;
    m_steps.erase(m_steps.begin() + static_cast<std::ptrdiff_t>(m_done), m_steps.end());
    m_steps.push_back(
        {changed.x, changed.y, Image(selection.view().crop(changed.x, changed.y, changed.size))});
    redo();
    forgetOldest();
}

void SelectionEdits::undo() {
    if (canUndo())
        exchange(m_steps[--m_done]);
}

void SelectionEdits::redo() {
    if (canRedo())
        exchange(m_steps[m_done++]);
}

void SelectionEdits::exchange(Step& step) {
    for (int y = 0; y < step.other.height(); ++y) {
        float* const row = step.other.plane(0).row(y);
        std::swap_ranges(row, row + step.other.width(), m_selection.plane(0).row(step.y + y) + step.x);
    }
}

void SelectionEdits::forgetOldest() {
    std::int64_t pixels = 0;
    for (const Step& step : m_steps)
        pixels += step.other.size().area();
    while (pixels > m_mostPixels && m_steps.size() > 1) {
        pixels -= m_steps.front().other.size().area();
        m_steps.pop_front();
        --m_done;
    }
}

} // namespace texloom
