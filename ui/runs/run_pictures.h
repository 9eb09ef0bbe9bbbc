#pragma once

#include "core/session/run/run.h"
#include "ui/picture/display_picture.h"

#include <memory>

namespace texloom::ui {

/// What the tabs show of a run, under way or finished.
struct RunPictures {
    std::shared_ptr<const DisplayPicture> result;
    std::shared_ptr<const DisplayPicture> synthesis; ///< null where there is no map
    std::shared_ptr<const PositionMap> map;          ///< of every step-th pixel; null where there is none
    MapKind mapKind = MapKind::None;                 ///< how far the map is to be believed
    std::shared_ptr<const Result> run;               ///< the finished run; null in a preview
    int step = 1;                                    ///< more than 1 in a preview

    /// Where a pixel of the whole picture came from; not valid if that is not known.
    Source sourceOf(int x, int y) const;
};

/// The pictures of a partial result. Made on a worker.
/// @param output size of the result; a method may work on a larger canvas, of which this is the top left.
RunPictures picturesOf(Preview preview, Size output);

/// Whether the exemplars of a result are at hand: they are not if it learned from none, or was read back and
/// their files are gone.
bool knowsExemplars(const Result& result);

/// The pictures of a finished run; they share its memory. Made on a worker.
RunPictures picturesOf(const std::shared_ptr<const Result>& result);

} // namespace texloom::ui
