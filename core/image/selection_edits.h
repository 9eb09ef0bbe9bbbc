#pragma once

#include "core/image/image.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace texloom {

/// A selection (see selections) as it is being edited, with what undo and redo need: of each step the pixels
/// that it changed.
class SelectionEdits {
public:
    /// @param mostPixels the oldest steps are forgotten where all together hold more.
    explicit SelectionEdits(Image selection, std::int64_t mostPixels = std::int64_t{1} << 26U);

    const Image& selection() const { return m_selection; }
    /// Puts another of the same size in its place, which is a step unless both are alike. Steps that were
    /// undone are forgotten.
    void set(const Image& selection);
    bool canUndo() const { return m_done > 0; }
    bool canRedo() const { return m_done < m_steps.size(); }
    /// Goes back by a step, or forward again; nothing where there is none.
    void undo();
    void redo();

private:
    struct Step {
        int x, y;
        Image other; ///< what to put there
    };

    void exchange(Step& step);
    void forgetOldest();

    Image m_selection;
    std::int64_t m_mostPixels;
    std::deque<Step> m_steps; ///< those from m_done on were undone
    std::size_t m_done = 0;
};

} // namespace texloom
