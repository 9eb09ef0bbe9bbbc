#include "core/tools/tool.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/memory.h"

namespace texloom {

void Tool::checkJoin(const ImageView& first, const ImageView& second, const Values& settings) const {
    if (first.channels != second.channels)
        failUsage("The first image has {} channels, the second {}; they must have the same.", first.channels,
                  second.channels);
    if (joinsSameSize() && first.size() != second.size())
        failUsage("The first image is {} × {} px, the second {} × {} px; crop one to the size of the other.",
                  first.width, first.height, second.width, second.height);
    std::get<JoinBy>(m_work).check(first.size(), second.size(), settings);
}

Image Tool::joined(const ImageView& first, const ImageView& second, const Values& settings,
                   JobContext& context) const {
    checkJoin(first, second, settings);
    const JoinBy& join = std::get<JoinBy>(m_work);
    const std::uint64_t bytes = join.bytes(first.size(), second.size(), first.channels, settings);
    if (bytes > availableMemory())
        fail("{} would need {} of memory, more than {}; use smaller images.", Message(m_info.title),
             byteText(bytes), availableMemoryText());
    return join.make(first, second, settings, context);
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
