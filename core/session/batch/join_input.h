#pragma once

#include "core/session/run/exemplar_file.h"
#include "core/tools/tool.h"

namespace texloom {

struct BatchItem;

/// Two images that a tool joins, as they were loaded and edited.
struct JoinInput {
    const Tool* tool = nullptr;
    ExemplarFile first, second;
    std::shared_ptr<const Image> region; ///< the second one's mask; null if there is none
    Values settings;                     ///< complete

    JoinPictures pictures() const { return {*first.image, *second.image, region.get()}; }
};

/// Loads what an item joins. @param item one without a problem, of which a tool joins the exemplars.
/// @throws Error, UsageError
JoinInput loadJoin(const BatchItem& item);

} // namespace texloom
