#include "ui/session/settings_state.h"

#include "core/methods/method.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"

#include <QComboBox>
#include <QStringList>

#include <nlohmann/json.hpp>

namespace texloom::ui {

QString SettingsState::difference(const SettingsState& other) const {
    const auto json = [](const SettingsState& state) {
        nlohmann::json made = nlohmann::json::parse(state.settings.toJson("/"));
        for (const auto& [port, files] : state.inputs)
            for (const InputFile& input : files)
                made["inputs"][port].push_back(input.file.path.string() + input.file.hash);
        made["seedLocked"] = state.seedLocked;
        return made;
    };
    QStringList paths;
    for (const nlohmann::json& step : nlohmann::json::diff(json(*this), json(other)))
        paths += QString::fromStdString(step.at("path").get<std::string>());
    if (paths.size() <= 1)
        return paths.join(QString());
    QString group = paths.front().section(QLatin1Char('/'), 0, 1);
    for (const QString& path : paths)
        if (path.section(QLatin1Char('/'), 0, 1) != group)
            return QStringLiteral("/");
    return group;
}

SettingsState settingsOf(const QComboBox& method, const Inspector& inspector) {
    const OutputGroup* const output = inspector.output();
    SettingsState state;
    state.settings.steps = {{method.currentData().toString().toStdString(), inspector.changedValues()}};
    for (RecipeStep& step : inspector.then())
        state.settings.steps.push_back(std::move(step));
    state.settings.size = output->outputSize();
    state.settings.wrap = output->wrap();
    state.settings.seed = output->seed();
    state.settings.region = output->part();
    state.inputs = output->inputs();
    state.seedLocked = output->seedLocked();
    return state;
}

void showSettings(const SettingsState& state, QComboBox& method, Inspector& inspector) {
    method.setCurrentIndex(method.findData(QString::fromStdString(state.settings.steps.front().method)));
    inspector.setSteps(state.settings.steps);
    OutputGroup* const output = inspector.output();
    output->setOutputSize(state.settings.size);
    output->setWrap(state.settings.wrap);
    output->setSeed(state.settings.seed);
    output->setSeedLocked(state.seedLocked);
    output->setInputs(state.inputs);
    output->setPart(state.settings.region);
    Q_EMIT inspector.edited();
}

} // namespace texloom::ui
