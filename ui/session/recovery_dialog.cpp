#include "ui/session/recovery_dialog.h"

#include "core/session/session.h"
#include "ui/common/background.h"
#include "ui/common/text.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr int kTextWidth = 64, kListLines = 8;

QString whenOf(const QString& copy) {
    return QLocale().toString(QFileInfo(copy).lastModified(), QLocale::ShortFormat);
}

/// What tells a session from others: the file it was saved to, or its exemplars.
QString contentOf(const QString& copy) {
    try {
        const Session session = readSession(toPath(copy));
        if (!session.file.empty())
            return toQString(session.file.stem());
        QStringList names;
        for (const RecipeExemplar& exemplar : session.settings.exemplars)
            names += toQString(exemplar.image.path.filename());
        return names.isEmpty() ? RecoveryDialog::tr("no exemplars") : names.join(QStringLiteral(", "));
    } catch (const std::exception& error) {
        return sentence(error);
    }
}

} // namespace

RecoveryDialog::RecoveryDialog(const QStringList& copies, QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)) {
    setObjectName(QStringLiteral("recoveryDialog"));
    setWindowTitle(tr("Recover a session"));
    auto* text = new QLabel(copies.size() == 1
                                ? tr("Texloom was not closed properly. This session can be recovered.")
                                : tr("Texloom was not closed properly. These sessions can be recovered, the "
                                     "newest first; those that you leave are offered again."),
                            this);
    text->setWordWrap(true);
    text->setMinimumWidth(fontMetrics().averageCharWidth() * kTextWidth);
    m_list->setObjectName(QStringLiteral("lostSessions"));
    m_list->setAccessibleName(tr("Sessions"));
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMinimumHeight(fontMetrics().height() * kListLines);
    for (const QString& copy : copies) {
        auto* item = new QListWidgetItem(whenOf(copy), m_list);
        item->setData(Qt::UserRole, copy);
    }
    auto* buttons = new QDialogButtonBox(this);
    m_recover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    m_recover->setObjectName(QStringLiteral("recover"));
    m_throwAway = buttons->addButton(tr("&Throw away"), QDialogButtonBox::DestructiveRole);
    m_throwAway->setObjectName(QStringLiteral("throwAway"));
    m_throwAway->setToolTip(tr("Removes those that are chosen in the list."));
    buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    auto* column = new QVBoxLayout(this);
    column->addWidget(text);
    column->addWidget(m_list);
    column->addWidget(buttons);
    connect(m_recover, &QPushButton::clicked, this, &RecoveryDialog::recover);
    connect(m_throwAway, &QPushButton::clicked, this, &RecoveryDialog::throwAway);
    connect(m_list, &QListWidget::itemActivated, this, &RecoveryDialog::recover);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &RecoveryDialog::updateButtons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_list->setCurrentRow(0);
    describe(copies);
}

/// Says what is in each, once the copies are read.
void RecoveryDialog::describe(const QStringList& copies) {
    inBackground(
        this,
        [copies] {
            QStringList contents;
            for (const QString& copy : copies)
                contents += contentOf(copy);
            return contents;
        },
        [this, copies](const QStringList& contents) {
            for (int row = 0; row < m_list->count(); ++row) {
                QListWidgetItem* const item = m_list->item(row);
                const auto index = copies.indexOf(item->data(Qt::UserRole).toString());
                item->setText(tr("%1: %2").arg(item->text(), contents[index]));
                item->setToolTip(contents[index]);
            }
        },
        [](const QString&) {});
}

void RecoveryDialog::updateButtons() {
    const auto chosen = m_list->selectedItems().size();
    m_recover->setEnabled(chosen == 1);
    m_recover->setDefault(true);
    m_throwAway->setEnabled(chosen > 0);
}

void RecoveryDialog::recover() {
    const QList<QListWidgetItem*> chosen = m_list->selectedItems();
    if (chosen.size() != 1)
        return;
    const QString copy = chosen.front()->data(Qt::UserRole).toString();
    accept();
    Q_EMIT recoverWanted(copy);
}

void RecoveryDialog::throwAway() {
    for (QListWidgetItem* const item : m_list->selectedItems()) {
        const QString copy = item->data(Qt::UserRole).toString();
        delete item;
        Q_EMIT refused(copy);
    }
    if (m_list->count() == 0)
        return accept();
    m_list->setCurrentRow(0);
}

} // namespace texloom::ui
