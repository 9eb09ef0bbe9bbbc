#include "ui/exemplar/layer_dialog.h"

#include "core/io/channel_names.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <set>

namespace texloom::ui {

namespace {

constexpr int kWidth = 56, kLines = 12;

QString titleOf(const std::string& layer, const ImageFileInfo& info) {
    QString name = QString::fromStdString(layer);
    bool number = false;
    name.toInt(&number);
    if (!number)
        return name;
    return info.format == "tiff" ? LayerDialog::tr("Page %1").arg(name)
                                 : LayerDialog::tr("Part %1").arg(name);
}

/// Whether the file is taken whole if nobody chooses, with the channels of all its layers.
bool takenWhole(const ImageFileInfo& info) {
    std::set<std::string> layers;
    for (const std::string& channel : info.channelNames)
        layers.insert(layerOf(channel));
    return layers.size() > 1;
}

/// The channels of a layer without its name: "R, G, B"; empty for parts whose channels are not known.
QString channelsOf(const std::string& layer, const ImageFileInfo& info) {
    QStringList names;
    for (const std::string& channel : info.channelNames)
        if (layerOf(channel) == layer)
            names += QString::fromStdString(channel.substr(layer.size() + 1));
    return names.join(QStringLiteral(", "));
}

} // namespace

std::vector<LayerEntry> layerEntries(const ImageFileInfo& info) {
    std::vector<LayerEntry> entries;
    if (info.layers.empty())
        return entries;
    if (takenWhole(info) || (!info.layer.empty() && info.format != "tiff"))
        entries.push_back({"", LayerDialog::tr("All channels")});
    for (const std::string& layer : info.layers)
        entries.push_back({layer, titleOf(layer, info), channelsOf(layer, info)});
    return entries;
}

LayerDialog::LayerDialog(const LayerQuestion& question, QWidget* parent)
    : QDialog(parent), m_list(new QListWidget(this)) {
    setObjectName(QStringLiteral("layerDialog"));
    setWindowTitle(tr("Choose a layer"));
    auto* text = new QLabel(
        tr("%1 holds several pictures. Which one is to be taken?").arg(QFileInfo(question.path).fileName()),
        this);
    text->setWordWrap(true);
    text->setMinimumWidth(fontMetrics().averageCharWidth() * kWidth);
    m_list->setObjectName(QStringLiteral("layers"));
    m_list->setAccessibleName(tr("Layers"));
    m_list->setMinimumHeight(fontMetrics().height() * kLines);
    for (const LayerEntry& entry : question.entries) {
        auto* item = new QListWidgetItem(
            entry.channels.isEmpty() ? entry.title : tr("%1 (%2)").arg(entry.title, entry.channels), m_list);
        item->setData(Qt::UserRole, QString::fromStdString(entry.layer));
    }
    m_list->setCurrentRow(0);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    auto* column = new QVBoxLayout(this);
    column->addWidget(text);
    column->addWidget(m_list);
    column->addWidget(buttons);
    connect(m_list, &QListWidget::itemActivated, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void LayerDialog::ask(const LayerQuestion& question, QWidget* parent, const QObject* context) {
    auto* dialog = new LayerDialog(question, parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, context, [dialog, take = question.take] { take(dialog->layer()); });
    dialog->open();
}

std::string LayerDialog::layer() const {
    const QListWidgetItem* const item = m_list->currentItem();
    return item != nullptr ? item->data(Qt::UserRole).toString().toStdString() : std::string();
}

} // namespace texloom::ui
