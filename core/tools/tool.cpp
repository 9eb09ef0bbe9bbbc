#include "core/tools/tool.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/job/memory.h"

namespace texloom {

void Tool::checkJoin(const JoinPictures& pictures, const Values& settings) const {
    const ImageView &first = pictures.first, &second = pictures.second;
    if (first.channels != second.channels)
        failUsage("The first image has {}, the second {}; they must have the same.",
                  channelText(first.channels), second.channels);
    if (joinsSameSize() && first.size() != second.size())
        failUsage("The first image is {} × {} px, the second {} × {} px; crop one to the size of the other.",
                  first.width, first.height, second.width, second.height);
    if (pictures.region != nullptr && pictures.region->size() != second.size())
        failUsage("The mask is {} × {} px, the second image {} × {} px; paint it on that image.",
                  pictures.region->width(), pictures.region->height(), second.width, second.height);
    std::get<JoinBy>(m_work).check(pictures, settings);
}

Image Tool::joined(const JoinPictures& pictures, const Values& settings, JobContext& context) const {
    checkJoin(pictures, settings);
    const JoinBy& join = std::get<JoinBy>(m_work);
    const std::uint64_t bytes = join.bytes(pictures, settings);
    if (bytes > availableMemory())
        fail("{} would need {} of memory, more than {}; use smaller images.", Message(m_info.title),
             byteText(bytes), availableMemoryText());
    return join.make(pictures, settings, context);
}

Tool named(std::string id, Tool tool) {
    tool.m_id = std::move(id);
    return tool;
}

const Tool& findTool(std::string_view id) {
    std::vector<std::string> known;
    for (const Tool& tool : tools()) {
        if (tool.id() == id)
            return tool;
        known.push_back(tool.id());
    }
    refuseUnknown(message("There is no tool {}; the tools are {}.", id, listOf(known)), id, known);
}

} // namespace texloom
