#include "ui/runs/result_text.h"

#include "core/base/text.h"
#include "ui/common/text.h"
#include "ui/common/translate.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>

namespace texloom::ui {

namespace {

/// A method's title; its id where this version does not have it.
QString methodTitle(const std::string& id) {
    for (const Method& method : methods())
        if (method.id() == id)
            return translated(method.info().title);
    return QString::fromStdString(id);
}

/// What the method that made an output calls it; its id where this version does not have it.
QString outputTitle(const ResultEntry& entry, const std::string& port) {
    for (const RecipeStep& step : entry.recipe.steps)
        for (const Method& method : methods())
            if (const Port* given = method.id() == step.method ? method.info().output(port) : nullptr)
                return translated(given->title);
    return QString::fromStdString(port);
}

QString exemplarsText(const ResultEntry& entry) {
    QStringList names;
    for (const RecipeExemplar& exemplar : entry.recipe.exemplars)
        names += toQString(exemplar.image.path.filename());
    return names.join(QStringLiteral(", "));
}

QString row(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
}

QString finishedText(const ResultEntry& entry) {
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(entry.finished), QLocale::ShortFormat);
}

QString rowsOf(const std::vector<Figure>& figures) {
    QString html;
    for (const Figure& figure : figures)
        html += row(translated(figure.name), QString::number(figure.value, 'g', 4));
    return html;
}

} // namespace

QString methodsText(const ResultEntry& entry) {
    QStringList titles;
    for (const RecipeStep& step : entry.recipe.steps)
        titles += methodTitle(step.method);
    return titles.join(QStringLiteral(" + "));
}

QString titleText(const ResultEntry& entry) {
    return entry.title.empty() ? methodsText(entry) : QString::fromStdString(entry.title);
}

QString labelText(const ResultEntry& entry) {
    const QString label = tr("%1 · seed %2 · %3")
                              .arg(methodsText(entry))
                              .arg(entry.recipe.seed)
                              .arg(sizeText(entry.recipe.size));
    return entry.stoppedAt ? tr("%1 · %2").arg(label, stoppedText(*entry.stoppedAt)) : label;
}

QStringList chipsOf(const ResultEntry& entry) {
    QStringList chips;
    for (const Message& varied : entry.varied)
        chips += translated(varied);
    chips += tr("seed %1").arg(entry.recipe.seed);
    const Recipe& recipe = entry.recipe;
    chips += recipe.region ? tr("%1 of %2").arg(sizeText(recipe.region->size), sizeText(recipe.size))
                           : sizeText(recipe.size);
    if (const auto start = recipe.inputs.find(kInitialPort);
        start != recipe.inputs.end() && !start->second.empty())
        chips += tr("from %1").arg(toQString(start->second.front().path.stem()));
    chips += QString::fromStdString(durationText(entry.seconds));
    if (entry.quick)
        chips += tr("preview");
    if (entry.stoppedAt)
        chips += stoppedText(*entry.stoppedAt);
    return chips;
}

QString detailsText(const ResultEntry& entry) {
    QString html = QStringLiteral("<b>%1</b><table>").arg(titleText(entry).toHtmlEscaped());
    if (!entry.title.empty())
        html += row(tr("Method"), methodsText(entry));
    if (!entry.recipe.exemplars.empty())
        html += row(tr("Exemplars"), exemplarsText(entry));
    html += row(tr("Size"), sizeText(entry.recipe.size));
    html += row(tr("Seed"), QString::number(entry.recipe.seed));
    html += row(tr("Made"), finishedText(entry));
    html += row(tr("Time"), QString::fromStdString(durationText(entry.seconds)));
    if (entry.stoppedAt)
        html += row(tr("Stopped"), tr("at %1 of the work").arg(percentText(*entry.stoppedAt)));
    for (const KeptOutput& output : entry.outputs)
        html += row(outputTitle(entry, output.port), translated(output.size));
    html += rowsOf(entry.figures);
    html += QStringLiteral("</table>");
    for (const Message& note : entry.notes)
        html += QStringLiteral("<p>%1</p>").arg(translated(note).toHtmlEscaped());
    return html;
}

QString figuresText(const std::vector<Figure>& figures) {
    return figures.empty() ? QString() : QStringLiteral("<table>%1</table>").arg(rowsOf(figures));
}

QString searchText(const ResultEntry& entry) {
    QStringList parts = {titleText(entry), methodsText(entry), QString::fromStdString(entry.methodIds()),
                         exemplarsText(entry), chipsOf(entry).join(QLatin1Char(' '))};
    for (const Message& note : entry.notes)
        parts += translated(note);
    return parts.join(QLatin1Char('\n'));
}

} // namespace texloom::ui
