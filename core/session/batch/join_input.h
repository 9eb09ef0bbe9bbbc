#pragma once

#include "core/base/message.h"
#include "core/session/run/exemplar_file.h"
#include "core/tools/tool.h"

#include <memory>
#include <optional>

namespace texloom {

struct BatchItem;

/// Two images that a tool joins, as they were loaded and edited.
struct JoinInput {
    const Tool* tool = nullptr;
    ExemplarFile first, second;
    std::shared_ptr<const Image> region; ///< the second one's mask; null if there is none
    Values settings;                     ///< complete

    /// Both images, as views of these; those of a tool that joins one size only are cropped to what they have
    /// in common, from the top left.
    JoinPictures pictures() const;
    /// What is to be said if they are cropped.
    std::optional<Message> cropNote() const;

private:
    bool crops() const { return tool->joinsSameSize() && first.image->size() != second.image->size(); }
    Size common() const;
};

/// Loads what an item joins. @param item one without a problem, of which a tool joins the exemplars.
/// @throws Error, UsageError
JoinInput loadJoin(const BatchItem& item);

} // namespace texloom
