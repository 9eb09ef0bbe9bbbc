#include "core/job/memory.h"
#include "core/session/export/export.h"
#include "core/session/export/output_files.h"

#include <nlohmann/json.hpp>

namespace texloom {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// What a position map says of the image, as a word.
const char* wordFor(MapKind kind) {
    switch (kind) {
    case MapKind::Exact:
        return "exact";
    case MapKind::Dominant:
        return "dominant";
    case MapKind::Estimated:
        return "estimated";
    default:
        return "none";
    }
}

} // namespace

std::string reportJson(const Result& result, const fs::path& folder) {
    Json json = {{"texloomReport", 1}};
    json["recipe"] = Json::parse(result.plan.recipe.toJson(folder));
    json["threads"] = result.plan.threads;
    json["seconds"] = result.seconds;
    if (result.stoppedAt)
        json["stoppedAt"] = *result.stoppedAt;
    for (const StageTime& stage : result.stages)
        json["stages"].push_back({{"name", stage.name.text()}, {"seconds", stage.seconds}});
    json["peakMemoryBytes"] = peakMemory();
    json["memoryBeforeBytes"] = result.plan.memoryBefore;
    json["estimate"] = {{"bytes", result.plan.estimate.bytes}, {"seconds", result.plan.estimate.seconds}};
    json["map"] = wordFor(result.synthesis.mapKind);
    for (const Message& note : result.synthesis.notes)
        json["notes"].push_back(note.text());
    for (const Figure& figure : result.figures)
        json["figures"][figure.name.text()] = figure.value;
    for (const Curve& curve : result.synthesis.curves)
        json["curves"][curve.name.text()] = curve.values;
    if (!result.synthesis.outputs.empty())
        json["outputs"] = Json::parse(outputsReport(result));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace texloom
