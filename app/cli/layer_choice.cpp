#include "app/cli/layer_choice.h"

#include "core/base/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace texloom::cli {

LayerChoice::LayerChoice(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            m_entries.push_back({std::string(kPictures), word});
        else
            m_entries.push_back({word.substr(0, equals), word.substr(equals + 1)});
    }
}

std::string LayerChoice::of(std::string_view what, std::size_t index, std::size_t count) {
    std::vector<Entry*> own;
    for (Entry& entry : m_entries)
        if (entry.what == what) {
            entry.used = true;
            own.push_back(&entry);
        }
    if (own.size() > 1 && own.size() != count)
        failUsage(
            "{} layers were given for {} files ({}); give one for all of them, or one for each in order.",
            own.size(), count, std::string(what));
    return own.empty() ? std::string() : own[own.size() == 1 ? 0 : index]->layer;
}

bool LayerChoice::names(std::string_view what) const {
    return std::any_of(m_entries.begin(), m_entries.end(),
                       [&](const Entry& entry) { return entry.what == what; });
}

void LayerChoice::checkUsed() const {
    for (const Entry& entry : m_entries)
        if (!entry.used)
            failUsage("--layer {}={}: no file is given for {}.", entry.what, entry.layer, entry.what);
}

void addLayers(CLI::App& command, std::vector<std::string>& words, const std::string& others) {
    std::string help = "Layer, part or page of the pictures' files, such as an EXR's; all channels of the "
                       "first part if not given. Given once for all, or once for each in order";
    if (!others.empty())
        help += fmt::format("; WHAT=NAME is for {}", others);
    command.add_option("--layer", words, help)->take_all()->allow_extra_args(false);
}

} // namespace texloom::cli
