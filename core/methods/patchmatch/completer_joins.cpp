#include "core/base/text.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patchmatch/completer.h"

#include <algorithm>

namespace texloom::patchmatch {

/// Moves the seams of the finest scale.
void Completer::join() {
    m_context.stage(0.1, TR("Moving seams"));
    joinCopies(m_request, kJoinSide, m_settings.radius, m_map, m_context);
}

Synthesis Completer::finish() {
    m_context.stage(m_settings.tone ? 0.02 : 0.1, TR("Copying pixels"));
    Synthesis result = m_window.filled(m_map, m_context);
    if (m_settings.tone)
        evenFilledTone(m_window.whole(), 0.08, m_context, result);
    m_context.progress(1);
    return result;
}

/// Offers the whole picture with what is made at this scale, if it is looked at.
void Completer::offer(int level) {
    offerFilled(
        m_window, level,
        [this](int x, int y, float* values) {
            std::copy_n(m_pixels.at(std::min(x, m_map.width() - 1), std::min(y, m_map.height() - 1)),
                        m_request.channels(), values);
            return true;
        },
        m_context);
}

} // namespace texloom::patchmatch
