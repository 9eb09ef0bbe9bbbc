#include "core/base/text.h"
#include "core/methods/fill_seams.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patch_request.h"
#include "core/methods/patchmatch/completer.h"

#include <algorithm>

namespace texloom::patchmatch {

namespace {

/// Side of the squares on the border of a hole that are looked for elsewhere, and how many places are taken
/// for each.
constexpr int kSquare = 48, kProposals = 3;

} // namespace

/// Moves the seams of the finest scale.
void Completer::join() {
    m_context.stage(0.1, TR("Moving seams"));
    const std::vector<PatchSource> sources = patchSources(m_request);
    const std::vector<std::uint8_t> made = madeOf(*m_known);
    SeamMoves moves;
    moves.radius = m_settings.radius;
    const CopiedPixels copied{sources, made, m_request.wrap};
    moves.proposals = borderOffsets(copied, *m_request.initial(), kSquare, kProposals, m_context);
    moveSeams(copied, *m_request.initial(), moves, m_map, [this] { m_context.check(); });
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
    const Image &whole = *m_window.whole().initial(), &known = *knownOf(m_window.whole());
    const Region part = m_window.part();
    m_context.preview(whole.size(), [&](Size size, int step) {
        Image image(size, whole.channels());
        for (int row = 0; row < size.height; ++row)
            for (int column = 0; column < size.width; ++column) {
                const int x = column * step, y = row * step;
                const float* const own =
                    known(x, y, 0) != 0 ? nullptr
                                        : m_pixels.at(std::min((x - part.x) >> level, m_map.width() - 1),
                                                      std::min((y - part.y) >> level, m_map.height() - 1));
                for (int c = 0; c < image.channels(); ++c)
                    image(column, row, c) = own ? own[c] : whole(x, y, c);
            }
        return image;
    });
}

} // namespace texloom::patchmatch
