#include "core/tools/edits.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <string>

namespace texloom {

namespace {

std::vector<std::string> editingTools() {
    std::vector<std::string> ids;
    for (const Tool& tool : tools())
        if (!tool.joins())
            ids.push_back(tool.id());
    return ids;
}

/// A tool that edits, by its id. @throws UsageError
const Tool& editingTool(std::string_view id) {
    const std::vector<std::string> known = editingTools();
    if (std::find(known.begin(), known.end(), id) == known.end())
        refuseUnknown(message("{} is no tool that edits an exemplar; those are {}.", id, listOf(known)), id,
                      known);
    return findTool(id);
}

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin)
            found.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return found;
}

} // namespace

const Tool& toolOf(const ExemplarEdit& edit) {
    std::vector<std::string> names;
    for (const Tool& tool : tools())
        if (!tool.joins() && edit.contains(tool.id()))
            return tool;
    for (const auto& [name, value] : edit)
        names.push_back(name);
    if (names.empty())
        failUsage("An edit names no tool; those that edit are {}.", listOf(editingTools()));
    failUsage("An edit with {} names no tool that is known here; those that edit are {}.", listOf(names),
              listOf(editingTools()));
}

ExemplarEdit resolved(const ExemplarEdit& edit) {
    const Tool& tool = toolOf(edit);
    const Values all = tool.resolved(edit);
    ExemplarEdit kept;
    for (const Param& param : tool.params()) {
        const Value& value = all.at(param.name());
        const auto* size = std::get_if<Wholes>(&value);
        if (param.applies(all) && (size == nullptr || !size->empty()))
            kept[param.name()] = value;
    }
    return kept;
}

ExemplarEdits resolved(const ExemplarEdits& edits) {
    ExemplarEdits all;
    for (const ExemplarEdit& edit : edits)
        all.push_back(resolved(edit));
    return all;
}

ExemplarEdit parseEdit(std::string_view text) {
    ExemplarEdit edit;
    const Tool* tool = nullptr;
    for (const std::string_view word : words(text)) {
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos)
            failUsage("{} in the edit \"{}\": write it as name=value.", word, text);
        const std::string name(word.substr(0, equals));
        if (tool == nullptr)
            tool = &editingTool(name);
        if (edit.contains(name))
            failUsage("The edit \"{}\" says {} twice.", text, name);
        edit[name] = tool->param(name).parse(word.substr(equals + 1));
    }
    if (tool == nullptr)
        failUsage("An edit is empty; write it as tool=value, with one of {}.", listOf(editingTools()));
    return resolved(edit);
}

Size sizeAfter(const ExemplarEdit& edit, Size before) {
    return warpOf({edit}, before).size();
}

Size sizeAfter(const ExemplarEdits& edits, Size before) {
    return warpOf(edits, before).size();
}

bool changesNothing(const ExemplarEdit& edit, Size size) {
    if (!toolOf(edit).warps())
        return false;
    const Warp warp = warpOf({edit}, size);
    const PlanePoint first{0.5, 0.5}, last{size.width - 0.5, size.height - 0.5};
    return warp.exact() && warp.size() == size && warp.toSource(first) == first &&
           warp.toSource(last) == last;
}

Warp warpOf(const ExemplarEdits& edits, Size source) {
    Warp warp{Placement(source)};
    for (const ExemplarEdit& edit : edits) {
        const Tool& tool = toolOf(edit);
        const Values settings = tool.resolved(edit);
        if (tool.warps())
            warp = warp.after(tool.warp(settings, warp.size()));
    }
    return warp;
}

} // namespace texloom
