#pragma once

#include "core/session/run/run.h"
#include "ui/picture/display_picture.h"

#include <QImage>

#include <functional>
#include <memory>
#include <vector>

namespace texloom::ui {

/// An exemplar with the pictures that show it.
struct ShownExemplar {
    RunExemplar exemplar;
    std::shared_ptr<const DisplayPicture> picture;
    QImage hidden; ///< what the mask hides, as Format_Alpha8 of the exemplar's size; null without a mask
    std::vector<QImage> companionThumbs;

    const ExemplarFile& file() const { return exemplar.image; }
};

/// One exemplar that is open.
struct ExemplarEntry : ShownExemplar {
    int id = 0;          ///< its own as long as the window lives
    bool checked = true; ///< whether methods that learn from several use it
};

/// All that can be changed of an exemplar, and undone: pixels are shared, so that copies cost nothing.
struct ExemplarState {
    RunExemplar original;
    ExemplarEdits edits;
};

/// @param before the same exemplar as it was shown until now, whose picture is kept where its pixels are the
/// same; null for one that is new.
ShownExemplar shown(RunExemplar exemplar, const ShownExemplar* before = nullptr);

ExemplarState stateOf(const RunExemplar& exemplar);

/// Puts these maps, at least one, in the place of what came from the same file, or the same layer of it.
void putCompanions(RunExemplar& original, std::vector<ExemplarFile> maps);

/// What the state makes of an exemplar, whose pixels are kept where they stay the same.
/// @param check called every few milliseconds; may throw.
RunExemplar madeFrom(const ExemplarState& state, const RunExemplar& known,
                     const std::function<void()>& check);

} // namespace texloom::ui
