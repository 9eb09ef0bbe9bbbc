#include "ui/compare/methods_dialog.h"

#include "core/methods/method.h"
#include "ui/common/text.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

const QString kTicked = QStringLiteral("compare/methods");
constexpr int kWidths = 48;
constexpr int kLines = 28;

} // namespace

MethodsDialog::MethodsDialog(const QString& size, QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)),
      m_quick(new QCheckBox(tr("At a &preview's size, not at %1 px").arg(size), this)) {
    setObjectName(QStringLiteral("methodsDialog"));
    setWindowTitle(tr("Try some methods"));
    m_list->setObjectName(QStringLiteral("triedMethods"));
    m_list->setAccessibleName(tr("Methods to try"));
    const QStringList ticked = QSettings().value(kTicked).toStringList();
    for (const Method* method : methodsByCategory()) {
        const QString id = QString::fromStdString(method->id());
        auto* item = new QListWidgetItem(translated(method->info().title), m_list);
        item->setToolTip(translated(method->info().summary));
        item->setData(Qt::UserRole, id);
        item->setCheckState(ticked.contains(id) ? Qt::Checked : Qt::Unchecked);
    }
    m_list->setCurrentRow(0);
    m_quick->setObjectName(QStringLiteral("triedQuick"));
    m_quick->setChecked(true);
    auto* intro = new QLabel(tr("Makes a run with each method ticked and shows them side by side."), this);
    intro->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_start = buttons->addButton(tr("Start"), QDialogButtonBox::AcceptRole);
    m_start->setObjectName(QStringLiteral("triedStart"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(intro);
    column->addWidget(m_list, 1);
    column->addWidget(m_quick);
    column->addWidget(buttons);
    const auto refresh = [this] { m_start->setEnabled(!chosen().empty()); };
    connect(m_list, &QListWidget::itemChanged, this, refresh);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refresh();
    resize(fontMetrics().averageCharWidth() * kWidths, fontMetrics().height() * kLines);
}

std::vector<std::string> MethodsDialog::chosen() const {
    std::vector<std::string> ids;
    for (int row = 0; row < m_list->count(); ++row)
        if (m_list->item(row)->checkState() == Qt::Checked)
            ids.push_back(m_list->item(row)->data(Qt::UserRole).toString().toStdString());
    return ids;
}

bool MethodsDialog::quick() const {
    return m_quick->isChecked();
}

void MethodsDialog::accept() {
    QStringList ticked;
    for (const std::string& id : chosen())
        ticked += QString::fromStdString(id);
    QSettings().setValue(kTicked, ticked);
    QDialog::accept();
}

} // namespace texloom::ui
