#include "ui/compare/tries.h"

#include "core/session/run/exemplar_use.h"
#include "ui/common/icons.h"
#include "ui/common/shortcuts.h"
#include "ui/common/text.h"
#include "ui/compare/comparisons.h"
#include "ui/compare/example_sweeps.h"
#include "ui/compare/grid_run.h"
#include "ui/compare/methods_dialog.h"
#include "ui/compare/sweep_dialog.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/runs/quick_run.h"
#include "ui/runs/run_desk.h"

#include <QAction>

#include <algorithm>
#include <limits>
#include <utility>

namespace texloom::ui {

namespace {

constexpr double kLongest = 60; ///< seconds that one of all methods may take

/// "Patch size 16 px · Seed 2".
QString labelOf(const SweepCell& cell) {
    QStringList parts;
    for (const SweepCell::Part& part : cell.parts) {
        parts += QStringLiteral("%1 %2").arg(translated(part.title), translated(part.value));
        if (!part.unit.empty())
            parts.back() += QLatin1Char(' ') + translated(part.unit);
    }
    return parts.join(QStringLiteral(" · "));
}

std::vector<Message> variedOf(const SweepCell& cell) {
    std::vector<Message> varied;
    for (const SweepCell::Part& part : cell.parts)
        varied.push_back(part.unit.empty() ? Message("{} {}", {Message(part.title), Message(part.value)})
                                           : Message("{} {} {}", {Message(part.title), Message(part.value),
                                                                  Message(part.unit)}));
    return varied;
}

/// What the runs of a sweep have in common: "Image quilting · bark · 512 × 512".
QString headingOf(const RunInput& input) {
    QStringList methods;
    for (const RecipeStep& step : input.steps)
        methods += translated(findMethod(step.method).info().title);
    QStringList names;
    for (const RunExemplar& exemplar : input.exemplars)
        names += QString::fromStdString(exemplar.image.name());
    QStringList parts = {methods.join(QStringLiteral(" + "))};
    if (!names.isEmpty())
        parts += names.join(QStringLiteral(", "));
    parts += sizeText(input.size);
    return parts.join(QStringLiteral(" · "));
}

} // namespace

Tries::Tries(RunDesk* desk, const ExemplarStore* store, Comparisons* comparisons, Input input, Order order,
             QWidget* window)
    : QObject(window), m_desk(desk), m_store(store), m_comparisons(comparisons), m_input(std::move(input)),
      m_order(std::move(order)), m_window(window), m_grid(new GridRun(desk, comparisons->view(), this)),
      m_all(new QAction(window)), m_some(new QAction(window)), m_sweep(new QAction(window)) {
    auto* const examples = new ExampleSweeps(window);
    m_examples = examples;
    m_all->setText(tr("Try &all methods"));
    m_all->setObjectName(QStringLiteral("tryAll"));
    m_all->setIcon(icon(QStringLiteral("grid")));
    setHelp(m_all,
            tr("Make a preview with every method but those of solids, the quickest first, and compare them"));
    m_some->setText(tr("Try &some methods…"));
    m_some->setObjectName(QStringLiteral("trySome"));
    setHelp(m_some, tr("Choose methods, make a run with each and compare them"));
    m_sweep->setText(tr("Parameter s&weep…"));
    m_sweep->setObjectName(QStringLiteral("sweep"));
    setHelp(m_sweep, tr("Make a run for every combination of some values and compare them"));
    connect(m_all, &QAction::triggered, this, &Tries::tryAll);
    connect(m_some, &QAction::triggered, this, &Tries::trySome);
    connect(m_sweep, &QAction::triggered, this, &Tries::startSweep);
    connect(examples, &ExampleSweeps::failed, this, &Tries::failed);
    connect(examples, &ExampleSweeps::joinsChosen, this, &Tries::joinsWanted);
    connect(examples, &ExampleSweeps::chosen, this,
            [this](const QString& title, const std::vector<GridEntry>& entries,
                   const std::vector<CompareItem>& first) {
                m_comparisons->leaveFor();
                m_grid->start(entries, first, {title, 0, false});
            });
}

void Tries::updateActions() {
    m_all->setEnabled(m_store->current() != nullptr);
    m_some->setEnabled(m_store->current() != nullptr);
    m_sweep->setEnabled(m_desk->canRun());
}

std::optional<int> Tries::stop() {
    return m_grid->stop();
}

void Tries::tryAll() {
    std::vector<std::string> ids = m_order();
    for (const Method& method : methods())
        if (std::find(ids.begin(), ids.end(), method.id()) == ids.end())
            ids.push_back(method.id());
    std::erase_if(ids, [](const std::string& id) { // which take minutes, and whose result is no picture
        return findMethod(id).info().category == Category::Solids;
    });
    tryMethods(ids, true, kLongest);
}

void Tries::trySome() {
    auto* dialog = new MethodsDialog(sizeText(m_input().size), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        tryMethods(dialog->chosen(), dialog->quick(), std::numeric_limits<double>::infinity());
    });
    dialog->open();
}

/// One run with each method on the exemplar that is looked at, with its defaults.
void Tries::tryMethods(const std::vector<std::string>& ids, bool quick, double longest) {
    const ExemplarEntry* const current = m_store->current();
    if (current == nullptr)
        return;
    const RunInput asked = quick ? quickOf(m_input()) : m_input();
    std::vector<GridEntry> entries;
    for (const std::string& id : ids) {
        const Method& method = findMethod(id);
        RunInput input;
        input.steps = {{id, {}}};
        input.exemplars = {current->exemplar};
        input.size = asked.size;
        input.wrap = asked.wrap;
        input.seed = asked.seed;
        input.threads = asked.threads;
        keepUsed(input);
        const QString label = tr("%1 · seed %2 · %3")
                                  .arg(translated(method.info().title))
                                  .arg(input.seed)
                                  .arg(sizeText(input.size));
        entries.push_back({label, std::move(input)});
    }
    m_comparisons->leaveFor();
    const QString heading = tr("%1 · seed %2 · %3")
                                .arg(QString::fromStdString(current->file().name()))
                                .arg(asked.seed)
                                .arg(sizeText(asked.size));
    m_grid->start(std::move(entries), m_comparisons->exemplarItems({current->id}),
                  {heading, 0, quick, longest, true});
}

void Tries::startSweep() {
    auto* dialog = new SweepDialog(m_input(), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        std::vector<GridEntry> entries;
        for (const SweepCell& cell : dialog->cells()) {
            entries.push_back({labelOf(cell), cell.input, variedOf(cell)});
            if (dialog->quick())
                entries.back().input = quickOf(cell.input);
        }
        m_comparisons->leaveFor();
        const QString heading = entries.empty() ? QString() : headingOf(entries.front().input);
        m_grid->start(std::move(entries), {}, {heading, dialog->columns(), dialog->quick()});
    });
    dialog->open();
}

} // namespace texloom::ui
