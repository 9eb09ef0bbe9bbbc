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
        made["initial"] = state.initial ? state.initial->path.string() + state.initial->hash : "";
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
    state.settings.method = method.currentData().toString().toStdString();
    state.settings.parameters = inspector.changedValues();
    state.settings.then = inspector.then();
    state.settings.size = output->outputSize();
    state.settings.wrap = output->wrap();
    state.settings.seed = output->seed();
    state.settings.region = output->part();
    state.initial = output->initial();
    state.seedLocked = output->seedLocked();
    return state;
}

void showSettings(const SettingsState& state, QComboBox& method, Inspector& inspector) {
    method.setCurrentIndex(method.findData(QString::fromStdString(state.settings.method)));
    inspector.setValues(state.settings.parameters);
    inspector.setThen(state.settings.then);
    OutputGroup* const output = inspector.output();
    output->setOutputSize(state.settings.size);
    output->setWrap(state.settings.wrap);
    output->setSeed(state.settings.seed);
    output->setSeedLocked(state.seedLocked);
    output->setInitial(state.initial);
    output->setPart(state.settings.region);
    Q_EMIT inspector.edited();
}

} // namespace texloom::ui
