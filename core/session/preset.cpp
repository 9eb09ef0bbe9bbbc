#include "core/session/preset.h"

#include "core/base/error.h"
#include "core/base/version.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"
#include "core/methods/registry.h"
#include "core/session/shipped_presets.h"

#include <algorithm>

namespace texloom {

Preset Preset::fromJson(std::string_view id, std::string_view text) {
    const JsonField::Json json = parseJson(TR("preset"), text);
    const JsonField root(TR("preset"), json);
    root.only({"preset", "title", "summary", "steps"});
    if (root.has("preset") && root.at("preset").whole() > kFormat)
        failUsage("The preset is of format {}, made by a newer Texloom; this one ({}) reads up to {}.",
                  root.at("preset").whole(), kVersion, kFormat);
    Preset preset{std::string(id), root.at("title").text(), root.at("summary").text(), {}};
    const JsonField steps = root.at("steps");
    preset.steps = stepsFrom(steps);
    if (preset.steps.empty())
        steps.wrong(TR("a list of at least one method"));
    for (const RecipeStep& step : preset.steps)
        findMethod(step.method).resolved(step.parameters, {});
    return preset;
}

std::string Preset::toJson() const {
    JsonField::Json json = {{"preset", kFormat}, {"title", title}, {"summary", summary}};
    for (const RecipeStep& step : steps)
        json["steps"].push_back({{"method", step.method}, {"parameters", texloom::toJson(step.parameters)}});
    return json.dump(2, ' ', false, JsonField::Json::error_handler_t::replace) + "\n";
}

std::vector<Preset> presetsIn(const std::filesystem::path& folder,
                              const std::function<void(const Message&)>& refused) {
    std::vector<Preset> read;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (entry.path().extension() != ".json")
            continue;
        try {
            read.push_back(Preset::fromJson(entry.path().stem().string(), readText(entry.path())));
        } catch (const Error& wrong) {
            refused(message("{}: {}", entry.path().filename().string(), wrong.message()));
        }
    }
    std::sort(read.begin(), read.end(), [](const Preset& a, const Preset& b) { return a.id < b.id; });
    return read;
}

namespace {

/// Whether a preset names a method that this build lacks.
bool lacksMethods(const ShippedPreset& preset) {
    const JsonField::Json json = parseJson(TR("preset"), preset.json);
    const std::vector<RecipeStep> steps = stepsFrom(JsonField(TR("preset"), json).at("steps"));
    return std::any_of(steps.begin(), steps.end(), [](const RecipeStep& step) {
        const auto& all = absentMethods();
        return std::any_of(all.begin(), all.end(),
                           [&step](const AbsentMethod& absent) { return absent.id == step.method; });
    });
}

} // namespace

const std::vector<Preset>& presets() {
    static const std::vector<Preset> shipped = [] {
        std::vector<Preset> read;
        for (const ShippedPreset& preset : shippedPresets())
            if (!lacksMethods(preset))
                read.push_back(Preset::fromJson(preset.id, preset.json));
        return read;
    }();
    return shipped;
}

const Preset* findPreset(std::string_view id) {
    const auto found = std::find_if(presets().begin(), presets().end(),
                                    [id](const Preset& preset) { return preset.id == id; });
    return found == presets().end() ? nullptr : &*found;
}

} // namespace texloom
