#include "ui/results/limits_dialog.h"

#include "ui/common/elided_label.h"
#include "ui/runs/result_history.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QUrl>

namespace texloom::ui {

namespace {

const QString kMemory = QStringLiteral("results/memory");
const QString kDisk = QStringLiteral("results/disk");
constexpr double kGiB = 1024.0 * 1024 * 1024;
constexpr double kSmallestSize = 0.1;
constexpr double kLargestSize = 10000;

std::uint64_t bytesOf(const QDoubleSpinBox& size) {
    return static_cast<std::uint64_t>(size.value() * kGiB);
}

} // namespace

void restoreLimits(ResultHistory& history) {
    const QSettings settings;
    history.setMemoryBudget(settings.value(kMemory, quint64{ResultStore::kMemoryBudget}).toULongLong());
    history.setDiskBudget(settings.value(kDisk, quint64{ResultStore::kDiskBudget}).toULongLong());
}

void chooseLimits(ResultHistory& history, QWidget* parent) {
    auto* dialog = new LimitsDialog(history.store(), resultFolder(), parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QDialog::accepted, &history, [&history, dialog] {
        QSettings settings;
        settings.setValue(kMemory, quint64{dialog->memory()});
        settings.setValue(kDisk, quint64{dialog->disk()});
        history.setMemoryBudget(dialog->memory());
        history.setDiskBudget(dialog->disk());
    });
    dialog->open();
}

LimitsDialog::LimitsDialog(const ResultStore& store, const QString& folder, QWidget* parent)
    : QDialog(parent),
      m_memory(makeSize(QStringLiteral("memoryLimit"), static_cast<double>(store.memoryBudget()),
                        tr("The latest results stay in memory up to this; others are read from the disk when "
                           "they are shown."))),
      m_disk(makeSize(QStringLiteral("diskLimit"), static_cast<double>(store.diskBudget()),
                      tr("Beyond this the oldest results are removed; those pinned stay."))) {
    setObjectName(QStringLiteral("limitsDialog"));
    setWindowTitle(tr("Limits for results"));
    auto* place = new ElidedLabel(this);
    place->setFullText(folder);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* form = new QFormLayout(this);
    form->addRow(tr("In &memory"), m_memory);
    form->addRow(tr("On the &disk"), m_disk);
    form->addRow(tr("Now"),
                 new QLabel(tr("%1 in memory, %2 on the disk")
                                .arg(QLocale().formattedDataSize(static_cast<qint64>(store.memoryUsed())),
                                     QLocale().formattedDataSize(static_cast<qint64>(store.diskUsed()))),
                            this));
    form->addRow(tr("Kept in"), place);
    auto* reveal = new QPushButton(tr("&Show the folder"), this);
    reveal->setObjectName(QStringLiteral("revealResults"));
    connect(reveal, &QPushButton::clicked, this,
            [folder] { QDesktopServices::openUrl(QUrl::fromLocalFile(folder)); });
    form->addRow(QString(), reveal);
    form->addRow(buttons);
}

QDoubleSpinBox* LimitsDialog::makeSize(const QString& name, double bytes, const QString& help) {
    auto* size = new QDoubleSpinBox(this);
    size->setObjectName(name);
    size->setRange(kSmallestSize, kLargestSize);
    size->setDecimals(1);
    size->setSuffix(tr(" GiB"));
    size->setValue(bytes / kGiB);
    size->setToolTip(help);
    return size;
}

std::uint64_t LimitsDialog::memory() const {
    return bytesOf(*m_memory);
}

std::uint64_t LimitsDialog::disk() const {
    return bytesOf(*m_disk);
}

} // namespace texloom::ui
