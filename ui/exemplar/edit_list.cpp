#include "ui/exemplar/edit_list.h"

#include "core/tools/edits.h"
#include "ui/common/text.h"
#include "ui/common/translate.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace texloom::ui {

namespace {

QString withUnit(const Param& param, const QString& text) {
    return param.unit().empty() ? text : text + QLatin1Char(' ') + translated(param.unit());
}

/// Empty for points, which say nothing in words.
QString valueText(const Param& param, const Value& value) {
    switch (param.type()) {
    case Param::Type::Toggle:
        return std::get<bool>(value) ? tr("on") : tr("off");
    case Param::Type::Choice:
        for (const Choice& choice : param.choices())
            if (choice.id == std::get<std::string>(value))
                return translated(choice.title);
        return {};
    case Param::Type::Area: {
        const auto& area = std::get<Wholes>(value);
        return tr("%1 at %2, %3").arg(sizeText({area[2], area[3]})).arg(area[0]).arg(area[1]);
    }
    case Param::Type::Size: {
        const auto& size = std::get<Wholes>(value);
        return sizeText({size[0], size[1]});
    }
    case Param::Type::Points:
        return {};
    case Param::Type::Integer:
    case Param::Type::Real:
        break;
    }
    return withUnit(param, QString::fromStdString(toText(value)));
}

/// Where the colours at the end of the list begin.
std::size_t firstColour(const ExemplarEdits& edits) {
    const auto moves = std::find_if(edits.rbegin(), edits.rend(),
                                    [](const ExemplarEdit& edit) { return toolOf(edit).warps(); });
    return static_cast<std::size_t>(edits.rend() - moves);
}

bool isPreset(const Tool& tool, const ExemplarEdit& edit) {
    const std::vector<ToolPreset>& presets = tool.info().presets;
    return std::any_of(presets.begin(), presets.end(),
                       [&](const ToolPreset& preset) { return resolved(preset.values) == resolved(edit); });
}

} // namespace

QString editText(const ExemplarEdit& edit) {
    const Tool& tool = toolOf(edit);
    const ExemplarEdit shown = resolved(edit);
    QStringList values;
    for (const Param& param : tool.params()) {
        const auto value = shown.find(param.name());
        const bool first = &param == &tool.params().front();
        if (value == shown.end() || (!first && value->second == param.defaultFor(0)))
            continue;
        const QString text = valueText(param, value->second);
        if (!text.isEmpty())
            values += first ? text : tr("%1 %2").arg(translated(param.title()), text);
    }
    const QString title = translated(tool.info().title);
    return values.isEmpty() ? title : tr("%1: %2").arg(title, values.join(QStringLiteral(", ")));
}

std::optional<std::size_t> standingEdit(const ExemplarEdits& edits, const Tool& tool) {
    const std::size_t colours = firstColour(edits);
    const std::size_t begin = tool.warps() ? std::max<std::size_t>(colours, 1) - 1 : colours;
    const std::size_t end = tool.warps() ? colours : edits.size();
    for (std::size_t i = begin; i < end; ++i)
        if (&toolOf(edits[i]) == &tool && !isPreset(tool, edits[i]))
            return i;
    return std::nullopt;
}

ExemplarEdits withEdit(ExemplarEdits edits, const ExemplarEdit& edit) {
    const std::size_t at = toolOf(edit).warps() ? firstColour(edits) : edits.size();
    edits.insert(edits.begin() + static_cast<std::ptrdiff_t>(at), edit);
    return edits;
}

ExemplarEdits withStanding(ExemplarEdits edits, const Tool& tool, const std::optional<ExemplarEdit>& edit) {
    const std::optional<std::size_t> at = standingEdit(edits, tool);
    if (!at)
        return edit ? withEdit(std::move(edits), *edit) : edits;
    if (edit)
        edits[*at] = *edit;
    else
        edits.erase(edits.begin() + static_cast<std::ptrdiff_t>(*at));
    return edits;
}

} // namespace texloom::ui
