#include "core/analysis/lattice_values.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/lattice/lattice_fields.h"
#include "ui/lattice/lattice_text.h"
#include "ui/lattice/lattice_tool.h"

#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>

namespace texloom::ui {

QString LatticeTool::problem() const {
    if (!lattice() || !m_exemplar)
        return {};
    LatticeSettings settings;
    settings.lattice = LatticeSource::Given;
    settings.v1x = lattice()->v1.x;
    settings.v1y = lattice()->v1.y;
    settings.v2x = lattice()->v2.x;
    settings.v2y = lattice()->v2.y;
    try {
        checkLattice(settings, m_name.toStdString(), m_exemplar->size());
    } catch (const std::exception& error) {
        return sentence(error);
    }
    return {};
}

void LatticeTool::refreshUse() {
    const Method* const method = m_inspector->method();
    if (method == nullptr)
        return;
    const bool follows = followsLattice(method->params());
    m_use->setVisible(user() != nullptr);
    if (user() == nullptr)
        return;
    const QString title = translated(user()->info().title);
    m_use->setText(tr("Use in %1").arg(title));
    const QString why = problem();
    m_use->setEnabled(lattice() && m_exemplar && why.isEmpty());
    m_fit->setEnabled(lattice() && m_analysis && why.isEmpty());
    m_detect->setEnabled(m_exemplar != nullptr);
    m_fields->setEnabled(m_exemplar != nullptr);
    const std::optional<Lattice> given = givenLattice(method->params(), m_inspector->values());
    QString text;
    if (!why.isEmpty())
        text = why;
    else if (!follows)
        text = tr("%1 follows no lattice.").arg(translated(method->info().title));
    else if (!given)
        text = latticeSource(method->params(), m_inspector->values()) == LatticeSource::None
                   ? tr("%1 is set to use no lattice.").arg(title)
                   : tr("%1 looks for the lattice by itself.").arg(title);
    else if (lattice() && sameVectors(*given, *lattice()))
        text = tr("✓ %1 uses this lattice.").arg(title);
    else
        text = tr("%1 uses another lattice: %2 and %3 px.")
                   .arg(title, vectorText(given->v1), vectorText(given->v2));
    if (why.isEmpty() && lattice() && m_exemplar &&
        (2 * lattice()->extent().x > m_exemplar->width() || 2 * lattice()->extent().y > m_exemplar->height()))
        text +=
            tr(" The exemplar holds fewer than two of these tiles on a side, so results repeat much of it.");
    m_useText->setText(text);
    m_scroll->widget()->layout()->activate();
    m_scroll->setMinimumWidth(m_scroll->widget()->minimumSizeHint().width() +
                              m_scroll->verticalScrollBar()->sizeHint().width());
}

void LatticeTool::sayVerdict() {
    QString text;
    if (!m_failure.isEmpty())
        text = m_failure;
    else if (m_detection.running())
        text = QString();
    else if (!m_exemplar)
        text = tr("Open an exemplar first.");
    else if (!m_analysis)
        text = tr("Press Detect to look for the lattice, or give its vectors.");
    else if (m_edited && m_rating)
        text = tr("Set by hand: %1 agrees with itself by %2 at the multiples of these vectors; by %3 at "
                  "those of "
                  "the best that was found.")
                   .arg(m_name, percentText(m_rating->correlation),
                        percentText(
                            m_analysis->candidates.empty() ? 0 : m_analysis->candidates.front().correlation));
    else if (m_analysis->found() && m_analysis->candidates.front().lattice.keepsOrder(m_exemplar->size()))
        text =
            tr("Nothing in %1 repeats itself, but rows run through all of it (confidence %2): they keep "
               "their order, and begin again after %3 px. If you see it repeat, rectify the exemplar first "
               "(Ctrl+D) where it is seen at an angle, or drag the vectors.")
                .arg(m_name, percentText(m_analysis->confidence))
                .arg(m_analysis->candidates.front().lattice.area(), 0, 'f', 0);
    else if (m_analysis->found() && m_analysis->candidates.front().lattice.rowsOnly())
        text =
            tr("%1 repeats itself in rows (confidence %2); what lies along them may come from anywhere in a "
               "row.")
                .arg(m_name, percentText(m_analysis->confidence));
    else if (m_analysis->found())
        text = tr("%1 repeats itself by this lattice (confidence %2).")
                   .arg(m_name, percentText(m_analysis->confidence));
    else if (m_analysis->candidates.empty())
        text =
            tr("Nothing in %1 repeats itself. A vector must fit into the exemplar about twice to be found. "
               "If you see it repeat, give the vectors, or rectify the exemplar first (Ctrl+D) where it is "
               "seen at an angle; if not, methods without a lattice suit it, such as image quilting.")
                .arg(m_name);
    else
        text =
            tr("No lattice stands out in %1 (confidence %2). Choose one below, drag the vectors to what you "
               "see, or rectify the exemplar first (Ctrl+D) where it is seen at an angle; if it does not "
               "repeat, methods without a lattice suit it, such as image quilting.")
                .arg(m_name, percentText(m_analysis->confidence));
    m_verdict->setVisible(!text.isEmpty());
    m_verdict->setText(text);
    refreshUse();
}

QString LatticeTool::verdict() const {
    return m_verdict->text();
}

QString LatticeTool::useText() const {
    return m_useText->text();
}

} // namespace texloom::ui
