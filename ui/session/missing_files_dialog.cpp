#include "ui/session/missing_files_dialog.h"

#include "ui/common/text.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace texloom::ui {

namespace {

constexpr int kWidth = 70;

} // namespace

MissingFilesDialog::MissingFilesDialog(Session session, const QStringList& missing, QWidget* parent)
    : QDialog(parent), m_session(std::move(session)), m_missing(missing), m_text(new QLabel(this)),
      m_list(new QListWidget(this)), m_find(new QPushButton(tr("&Find…"), this)) {
    setObjectName(QStringLiteral("missingFilesDialog"));
    setWindowTitle(tr("Missing files"));
    m_text->setWordWrap(true);
    m_text->setMinimumWidth(fontMetrics().averageCharWidth() * kWidth);
    m_list->setObjectName(QStringLiteral("missingFiles"));
    m_list->setAccessibleName(tr("Missing files"));
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_find->setObjectName(QStringLiteral("findFile"));
    m_find->setToolTip(tr("Says where the chosen file is now; others that lie beside it are found with it."));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_go = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
    m_go->setObjectName(QStringLiteral("goOn"));
    buttons->addButton(m_find, QDialogButtonBox::ActionRole);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_text);
    column->addWidget(m_list);
    column->addWidget(buttons);
    connect(m_find, &QPushButton::clicked, this, &MissingFilesDialog::choose);
    connect(m_list, &QListWidget::itemActivated, this, &MissingFilesDialog::choose);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refresh();
}

Session MissingFilesDialog::session() const {
    Session rest = m_session;
    for (const QString& path : m_missing)
        leaveOut(rest, toPath(path));
    return rest;
}

void MissingFilesDialog::choose() {
    const QListWidgetItem* const item = m_list->currentItem();
    if (item == nullptr)
        return;
    const QString name = QFileInfo(item->text()).fileName();
    const QString path = QFileDialog::getOpenFileName(this, tr("Where is %1?").arg(name), {},
                                                      tr("%1 (%1);;All files (*)").arg(name));
    if (!path.isEmpty())
        found(item->text(), path);
}

void MissingFilesDialog::found(const QString& missing, const QString& path) {
    relocate(m_session, toPath(missing), toPath(path));
    m_missing.clear();
    for (const auto& still : missingFiles(m_session))
        m_missing += toQString(still);
    refresh();
}

void MissingFilesDialog::refresh() {
    m_list->clear();
    m_list->addItems(m_missing);
    for (int row = 0; row < m_list->count(); ++row)
        m_list->item(row)->setToolTip(m_missing[row]);
    m_list->setCurrentRow(0);
    m_find->setEnabled(!m_missing.isEmpty());
    m_text->setText(m_missing.isEmpty()
                        ? tr("All files were found.")
                        : tr("These files of the session are not where they were. Say where they "
                             "are, or go on without them; everything else is kept."));
    m_go->setText(m_missing.isEmpty() ? tr("&Open") : tr("&Go on without them"));
}

} // namespace texloom::ui
