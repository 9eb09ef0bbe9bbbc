#include "ui/compare/example_sweeps.h"

#include "core/io/image_file.h"
#include "core/session/batch/batch.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/resource_folder.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

Batch batchIn(const QString& path) {
    const auto file = toPath(path);
    return Batch::fromJson(readText(file), file.parent_path());
}

/// The run's title, if it has one, and what is varied: "Patch size, fig. 9 · Patch size 10 px"; else the
/// method's.
QString labelOf(const BatchItem& item) {
    const Method& method = findMethod(item.recipe.steps.front().method);
    if (item.cell.empty())
        return translated(item.title.empty() ? method.info().title : item.title);
    QStringList parts;
    if (!item.title.empty())
        parts += translated(item.title);
    for (const QString& part : QString::fromStdString(item.cell).split(QStringLiteral(", "))) {
        const std::string name = part.section(QLatin1Char('='), 0, 0).toStdString();
        const auto& params = method.params();
        const auto param = std::find_if(params.begin(), params.end(),
                                        [&name](const Param& known) { return known.name() == name; });
        if (param == params.end()) {
            parts += part;
            continue;
        }
        parts += QStringLiteral("%1 %2").arg(translated(param->title()), part.section(QLatin1Char('='), 1));
        if (!param->unit().empty())
            parts.back() += QLatin1Char(' ') + translated(param->unit());
    }
    return parts.join(QStringLiteral(" · "));
}

void add(const ExemplarFile& file, std::vector<CompareItem>& items) {
    if (file.image)
        items.push_back({QString::fromStdString(file.name()),
                         std::make_shared<const DisplayPicture>(file.image),
                         {},
                         {}});
}

void add(const InputFiles& inputs, std::vector<CompareItem>& items) {
    for (const auto& [port, files] : inputs)
        for (const InputFile& input : files)
            add(input.file, items);
}

/// What the runs of a batch are given.
struct Loaded {
    QString title;
    std::vector<GridEntry> entries;
    std::vector<CompareItem> first; ///< what the first run learns from
    std::vector<JoinInput> joins;   ///< instead of all these, of a batch that joins images
};

Loaded loaded(const QString& path) {
    const Batch batch = batchIn(path);
    Loaded all{translated(batch.title), {}, {}, {}};
    for (std::size_t i = 0; i < batch.size(); ++i) {
        const BatchItem item = batch.item(i);
        if (item.join != nullptr)
            all.joins.push_back(loadJoin(item));
        else
            all.entries.push_back({labelOf(item), loadRecipe(item.whole())});
    }
    if (all.entries.empty())
        return all;
    const RunInput& first = all.entries.front().input;
    for (const RunExemplar& exemplar : first.exemplars) {
        add(exemplar.inputs, all.first);
        add(exemplar.image, all.first);
    }
    add(first.inputs, all.first);
    return all;
}

} // namespace

ExampleSweeps::ExampleSweeps(QWidget* parent) : QMenu(tr("Exa&mple sweeps"), parent) {
    setObjectName(QStringLiteral("exampleSweeps"));
    setToolTipsVisible(true);
    connect(this, &QMenu::aboutToShow, this, &ExampleSweeps::fill);
    fill();
}

QStringList ExampleSweeps::files() {
    return resourceFiles(QStringLiteral("batches"), QStringLiteral("*.json"));
}

void ExampleSweeps::fill() {
    clear();
    for (const QString& path : files())
        try {
            const Batch batch = batchIn(path);
            QAction* const action = addAction(translated(batch.title), this, [this, path] { start(path); });
            action->setObjectName(QStringLiteral("sweep-") + QFileInfo(path).completeBaseName());
            action->setToolTip(translated(batch.summary));
        } catch (const std::exception& error) {
            addAction(sentence(error))->setEnabled(false);
        }
    if (isEmpty())
        addAction(tr("None were found beside the program"))->setEnabled(false);
}

void ExampleSweeps::start(const QString& path) {
    inBackground(
        this, [path] { return loaded(path); },
        [this](const Loaded& all) {
            if (all.joins.empty())
                Q_EMIT chosen(all.title, all.entries, all.first);
            else
                Q_EMIT joinsChosen(all.joins);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
