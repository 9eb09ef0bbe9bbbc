#include "app/cli/commands.h"
#include "app/cli/param_text.h"
#include "core/base/text.h"
#include "core/io/json_field.h"
#include "core/methods/registry.h"
#include "core/session/preset.h"
#include "core/session/run/asset_file.h"
#include "core/session/session.h"

#include <fmt/format.h>

#include <array>

namespace texloom::cli {

namespace {

using Json = JsonField::Json;

Json toJson(const Port& port) {
    static const std::array<const char*, 3> extents = {"exemplar", "output", "any"};
    return {{"id", port.id},
            {"title", port.title},
            {"kind", kindId(port.kind)},
            {"least", port.least},
            {"most", port.most},
            {"extent", extents.at(static_cast<std::size_t>(port.extent))},
            {"weighed", port.weighed},
            {"wraps", port.wraps},
            {"help", port.help}};
}

Json toJson(const Method& method) {
    const MethodInfo& info = method.info();
    Json json = {{"id", method.id()},
                 {"title", info.title},
                 {"summary", info.summary},
                 {"citation", info.citation},
                 {"category", categoryId(info.category)},
                 {"takes", Json::array()},
                 {"gives", Json::array()},
                 {"repeats", info.repeats == Repeats::Bits ? "bits" : "nearly"},
                 {"usesSeed", info.usesSeed},
                 {"keepsCheckpoints", info.keepsCheckpoints},
                 {"cancelsWithinMilliseconds", info.cancelsWithin.count()},
                 {"parameters", Json::array()}};
    for (const Port& port : info.takes)
        json["takes"].push_back(toJson(port));
    for (const Port& port : info.gives)
        json["gives"].push_back(toJson(port));
    for (const Param& param : method.params())
        json["parameters"].push_back(cli::toJson(param));
    return json;
}

void printMethod(const Method& method) {
    const MethodInfo& info = method.info();
    fmt::print("{}: {}\n  {}\n  {}\n", method.id(), info.title, info.summary, info.citation);
    if (!info.takesExemplars())
        fmt::print("  Takes no exemplar.\n");
    for (const Port& port : info.takes)
        if (port.id != kExemplarPort && port.id != kCompanionPort)
            fmt::print("  --input {}=FILE  {}\n      {}\n", port.id, kindText(port.kind), port.help);
    for (const Port& port : info.gives)
        if (port.id != kImagePort && port.id != kMapPort)
            fmt::print("  --save {}=FILE  {}\n      {}\n", port.id, kindText(port.kind), port.help);
    for (const Param& param : method.params())
        printParam("--set " + param.name() + "=…", param);
}

void printPreset(const Preset& preset) {
    fmt::print("{}: {}\n  {}\n  Runs {}.\n", preset.id, preset.title, preset.summary,
               methodIds(preset.steps, ", then "));
}

} // namespace

void listMethods(const std::string& id, bool json) {
    Json all = Json::array();
    if (!id.empty() && !findPreset(id))
        findMethod(id);
    const Category* last = nullptr;
    for (const Method* method : methodsByCategory()) {
        if (!id.empty() && method->id() != id)
            continue;
        const Category& category = method->info().category;
        if (json)
            all.push_back(toJson(*method));
        else if (id.empty() && (last == nullptr || *last != category))
            fmt::print("{}\n\n", categoryTitle(category));
        if (!json)
            printMethod(*method);
        last = &category;
    }
    for (const AbsentMethod& absent : absentMethods()) {
        if (!id.empty())
            break;
        if (json)
            all.push_back({{"id", absent.id}, {"absent", absent.reason}});
        else
            fmt::print("{}: not part of this build\n  {}\n", absent.id, absent.reason);
    }
    if (json) {
        fmt::print("{}\n", all.dump(2));
        return;
    }
    for (const Preset& preset : presets())
        if (id.empty() || preset.id == id)
            printPreset(preset);
}

} // namespace texloom::cli
