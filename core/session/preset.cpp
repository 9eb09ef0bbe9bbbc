#include "core/session/preset.h"

#include "core/io/json_field.h"
#include "core/methods/method.h"
#include "core/session/shipped_presets.h"

#include <algorithm>

namespace texloom {

Preset Preset::fromJson(std::string_view id, std::string_view text) {
    const JsonField::Json json = parseJson("preset", text);
    const JsonField root("preset", json);
    root.only({"title", "summary", "steps"});
    Preset preset{std::string(id), root.at("title").text(), root.at("summary").text(), {}};
    const JsonField steps = root.at("steps");
    preset.steps = stepsFrom(steps);
    if (preset.steps.empty())
        steps.wrong("a list of at least one method");
    for (const RecipeStep& step : preset.steps)
        findMethod(step.method).resolved(step.parameters, {});
    return preset;
}

const std::vector<Preset>& presets() {
    static const std::vector<Preset> shipped = [] {
        std::vector<Preset> read;
        for (const ShippedPreset& preset : shippedPresets())
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
