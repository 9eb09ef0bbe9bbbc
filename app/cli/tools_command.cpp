#include "app/cli/commands.h"
#include "app/cli/param_text.h"
#include "core/tools/tool.h"

namespace texloom::cli {

namespace {

using Json = JsonField::Json;

const char* actsOn(const Tool& tool) {
    return tool.joins() ? "two-images" : tool.warps() ? "image-mask-and-companions" : "colours";
}

Json toJson(const Tool& tool) {
    const ToolInfo& info = tool.info();
    Json json = {{"id", tool.id()},           {"title", info.title},    {"summary", info.summary},
                 {"citation", info.citation}, {"actsOn", actsOn(tool)}, {"parameters", Json::array()}};
    for (const Param& param : tool.params())
        json["parameters"].push_back(cli::toJson(param));
    return json;
}

void print(const Tool& tool) {
    fmt::print("{}: {}\n  {}\n", tool.id(), tool.info().title, tool.info().summary);
    if (!tool.info().citation.empty())
        fmt::print("  {}\n", tool.info().citation);
    for (const Param& param : tool.params()) {
        const bool first = &param == &tool.params().front();
        const std::string how = tool.joins() ? "--" + param.name() + " …" : param.name() + "=…";
        printParam(first && !tool.joins() ? "--edit " + how : how, param);
    }
}

} // namespace

void listTools(const std::string& id, bool json) {
    Json all = Json::array();
    if (!id.empty())
        findTool(id);
    for (const Tool& tool : tools()) {
        if (!id.empty() && tool.id() != id)
            continue;
        if (json)
            all.push_back(toJson(tool));
        else
            print(tool);
    }
    if (json)
        fmt::print("{}\n", all.dump(2));
}

} // namespace texloom::cli
