#include "ui/exemplar/exemplar_panel.h"

#include "core/color/color_pipeline.h"
#include "ui/common/down_scroll.h"
#include "ui/common/elided_label.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/exemplar/companion_list.h"
#include "ui/exemplar/files.h"
#include "ui/viewers/image_viewer.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

constexpr int kListIconLines = 2;

QString channelText(int channels) {
    switch (channels) {
    case 1:
        return ExemplarPanel::tr("grey");
    case 3:
        return ExemplarPanel::tr("colour");
    case 4:
        return ExemplarPanel::tr("colour and alpha");
    default:
        return ExemplarPanel::tr("%1 channels").arg(channels);
    }
}

QString factsOf(const ExemplarFile& file) {
    return ExemplarPanel::tr("%1 px · %2 · %3 · %4")
        .arg(sizeText(file.image->size()), QString::fromStdString(file.info.format).toUpper(),
             QString::fromStdString(file.info.depth), channelText(file.image->channels()));
}

/// The scale at which a picture fills an icon of this side.
double iconScale(const DisplayPicture& picture, int side) {
    return static_cast<double>(side) / picture.size().longerSide();
}

/// An icon that keeps its colours where it is selected.
QIcon pictureIcon(const QImage& image) {
    const QPixmap pixmap = QPixmap::fromImage(image);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

} // namespace

ExemplarPanel::ExemplarPanel(ExemplarStore* store, const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent), m_store(store), m_viewer(new ImageViewer(this)), m_name(new ElidedLabel(this)),
      m_facts(new QLabel(this)), m_layer(new QComboBox(this)), m_space(new QComboBox(this)),
      m_maskName(new ElidedLabel(this)), m_setMask(new QToolButton(this)), m_clearMask(new QToolButton(this)),
      m_maskRow(new QWidget(this)), m_weight(new QDoubleSpinBox(this)),
      m_companions(new CompanionList(store, this)), m_list(new QListWidget(this)) {
    setObjectName(QStringLiteral("exemplarPanel"));
    m_viewer->setObjectName(QStringLiteral("exemplarViewer"));
    m_viewer->setAccessibleName(tr("Exemplar"));
    m_viewer->setPlaceholder(tr("No exemplar yet.\nDrop a picture here."));
    QFont bold = font();
    bold.setBold(true);
    m_name->setFont(bold);
    m_facts->setWordWrap(true);

    m_list->setObjectName(QStringLiteral("exemplarList"));
    m_list->setAccessibleName(tr("Open exemplars"));
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setIconSize(QSize(1, 1) * fontMetrics().height() * kListIconLines);

    auto* buttons = new QHBoxLayout;
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();

    auto* column = new QVBoxLayout(this);
    column->addWidget(m_viewer, 3);
    column->addWidget(m_name);
    column->addWidget(m_facts);
    auto* below = new QWidget;
    auto* details = new QVBoxLayout(below);
    details->setContentsMargins(0, 0, 0, 0);
    details->addWidget(makeDetails());
    details->addWidget(m_list, 1);
    column->addWidget(new DownScroll(below, this), 3);
    column->addLayout(buttons);
    connectStore();
    showCurrent();
}

QWidget* ExemplarPanel::makeDetails() {
    m_layer->setObjectName(QStringLiteral("layer"));
    m_layer->setToolTip(tr("The file holds several pictures; this is the one that is learnt from."));
    m_layer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_space->setObjectName(QStringLiteral("colourSpace"));
    m_space->setToolTip(
        tr("The colour space that the file's values are in. Data, such as heights, is never converted."));
    m_space->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const ColorSpace& space : color::spaces())
        m_space->addItem(translated(space.title), QString::fromStdString(space.id));
    m_setMask->setObjectName(QStringLiteral("setMask"));
    m_setMask->setText(tr("Choose…"));
    m_setMask->setToolTip(tr("A picture of the exemplar's size: where it is black, nothing is copied."));
    m_setMask->setAccessibleName(tr("Choose a mask"));
    m_clearMask->setObjectName(QStringLiteral("clearMask"));
    setIconButton(m_clearMask, QStringLiteral("close"), tr("Remove the mask"));
    for (QToolButton* button : {m_setMask, m_clearMask})
        button->setFocusPolicy(Qt::StrongFocus);

    auto* maskLayout = new QHBoxLayout(m_maskRow);
    maskLayout->setContentsMargins(0, 0, 0, 0);
    maskLayout->addWidget(m_maskName, 1);
    maskLayout->addWidget(m_setMask);
    maskLayout->addWidget(m_clearMask);

    m_weight->setObjectName(QStringLiteral("exemplarWeight"));
    m_weight->setRange(Exemplar::kLeastWeight, Exemplar::kMostWeight);
    m_weight->setDecimals(2);
    m_weight->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_weight->setPrefix(QStringLiteral("× "));
    m_weight->setKeyboardTracking(false);

    auto* details = new QWidget(this);
    m_form = new QFormLayout(details);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->addRow(tr("&Layer"), m_layer);
    m_form->addRow(tr("&Colour space"), m_space);
    m_form->addRow(tr("Wei&ght"), m_weight);
    m_form->addRow(tr("Mask"), m_maskRow);
    m_form->addRow(new QLabel(tr("Maps"), details)); // across: what they hold takes room
    m_form->addRow(m_companions);
    return details;
}

void ExemplarPanel::connectStore() {
    connect(m_store, &ExemplarStore::changed, this, &ExemplarPanel::fillList);
    connect(m_store, &ExemplarStore::currentChanged, this, &ExemplarPanel::showCurrent);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item != nullptr && !m_filling)
            m_store->setCurrent(item->data(Qt::UserRole).toInt());
    });
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (!m_filling && m_abilities.several)
            m_store->setChecked(item->data(Qt::UserRole).toInt(), item->checkState() == Qt::Checked);
    });
    connect(m_layer, &QComboBox::activated, this, [this] {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->setLayer(entry->id, m_layer->currentData().toString().toStdString());
    });
    connect(m_space, &QComboBox::activated, this, [this] {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->setSpace(entry->id, m_space->currentData().toString());
    });
    connect(m_weight, &QDoubleSpinBox::valueChanged, this, [this](double weight) {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->setWeight(entry->id, weight);
    });
    connect(m_store, &ExemplarStore::failed, this, [this] { showDetails(m_store->current()); });
    connect(m_setMask, &QToolButton::clicked, this, &ExemplarPanel::chooseMask);
    connect(m_clearMask, &QToolButton::clicked, this, [this] {
        if (const ExemplarEntry* entry = m_store->current())
            m_store->clearMask(entry->id);
    });
    connect(m_viewer, &ImageViewer::hovered, this, &ExemplarPanel::hovered);
    connect(m_viewer, &ImageViewer::unhovered, this, &ExemplarPanel::unhovered);
}

void ExemplarPanel::chooseMask() {
    const ExemplarEntry* const entry = m_store->current();
    if (entry == nullptr)
        return;
    const QString path = QFileDialog::getOpenFileName(
        window(), tr("Choose a mask"), toQString(entry->file().path.parent_path()), pictureFilter());
    if (!path.isEmpty())
        m_store->setMask(entry->id, path);
}

void ExemplarPanel::setAbilities(const ExemplarUse& abilities) {
    m_maskRow->setEnabled(abilities.masks);
    m_maskRow->setToolTip(abilities.masks ? QString() : tr("The method does not use a mask."));
    const bool same = m_abilities.several == abilities.several && m_abilities.weights == abilities.weights;
    m_abilities = abilities;
    if (!same)
        fillList();
}

void ExemplarPanel::fillList() {
    m_filling = true;
    // Rows are kept where that is possible: a click on one may be what this follows from.
    while (m_list->count() > static_cast<int>(m_store->entries().size()))
        delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < static_cast<int>(m_store->entries().size()))
        m_list->addItem(new QListWidgetItem);
    int row = 0;
    for (const ExemplarEntry& entry : m_store->entries())
        fillRow(*m_list->item(row++), entry);
    m_filling = false;
    showCurrent();
}

void ExemplarPanel::fillRow(QListWidgetItem& item, const ExemplarEntry& entry) const {
    item.setIcon(pictureIcon(entry.picture->levelFor(iconScale(*entry.picture, m_list->iconSize().width()))));
    QString name = QString::fromStdString(entry.file().name());
    if (!entry.file().layer.empty()) // two layers of one file would read alike
        name += QStringLiteral(" · ") + QString::fromStdString(entry.file().layer);
    const bool weighted = m_abilities.several && m_abilities.weights && entry.exemplar.weight != 1;
    item.setText(weighted ? tr("%1 (× %2)").arg(name, QLocale().toString(entry.exemplar.weight)) : name);
    item.setToolTip(toQString(entry.file().path));
    item.setData(Qt::UserRole, entry.id);
    item.setData(Qt::CheckStateRole,
                 m_abilities.several ? QVariant(entry.checked ? Qt::Checked : Qt::Unchecked) : QVariant());
}

void ExemplarPanel::showCurrent() {
    const ExemplarEntry* const entry = m_store->current();
    showPicture(entry);
    m_viewer->setMarker({});
    const QSignalBlocker blocker(m_list);
    for (int row = 0; row < m_list->count(); ++row)
        if (entry != nullptr && m_list->item(row)->data(Qt::UserRole).toInt() == entry->id)
            m_list->setCurrentRow(row);
    showDetails(entry);
}

void ExemplarPanel::showDetails(const ExemplarEntry* entry) {
    const bool mask = entry != nullptr && entry->exemplar.mask;
    for (QWidget* detail : {static_cast<QWidget*>(m_space), static_cast<QWidget*>(m_setMask)})
        detail->setEnabled(entry != nullptr);
    m_clearMask->setVisible(mask);
    showWeight(entry);
    showLayer(entry);
    const QString maskFile = mask ? toQString(entry->exemplar.mask->path) : QString();
    m_maskName->setFullText(!mask                              ? tr("None")
                            : maskFile.startsWith(ownFolder()) ? tr("Painted")
                                                               : QFileInfo(maskFile).completeBaseName(),
                            maskFile);
    m_name->setVisible(entry != nullptr);
    m_facts->setVisible(entry != nullptr);
    if (entry == nullptr)
        return;
    m_name->setFullText(toQString(entry->file().path.filename()), toQString(entry->file().path));
    m_facts->setText(factsOf(entry->file()));
    const QString space = QString::fromStdString(entry->file().space);
    if (m_space->findData(space) < 0)
        m_space->addItem(translated(color::findSpace(entry->file().space).title), space);
    m_space->setCurrentIndex(m_space->findData(space));
}

void ExemplarPanel::showWeight(const ExemplarEntry* entry) {
    m_form->setRowVisible(m_weight, m_store->entries().size() > 1);
    const bool heeded = m_abilities.several && m_abilities.weights;
    m_weight->setEnabled(heeded && entry != nullptr && entry->checked);
    m_weight->setToolTip(
        heeded ? tr("How much the exemplar counts beside the others: with 2 as though it were open twice.")
        : m_abilities.several ? tr("The method takes all exemplars alike.")
                              : tr("The method learns from one exemplar, the one that is chosen."));
    const QSignalBlocker blocker(m_weight);
    if (entry != nullptr)
        m_weight->setValue(entry->exemplar.weight);
}

void ExemplarPanel::showLayer(const ExemplarEntry* entry) {
    const std::vector<LayerEntry> layers =
        entry != nullptr ? layerEntries(entry->file().info) : std::vector<LayerEntry>();
    m_form->setRowVisible(m_layer, !layers.empty());
    m_layer->clear();
    for (const LayerEntry& layer : layers)
        m_layer->addItem(layer.title, QString::fromStdString(layer.layer));
    if (entry != nullptr)
        m_layer->setCurrentIndex(std::max(0, m_layer->findData(QString::fromStdString(entry->file().layer))));
}

void ExemplarPanel::showSource(const ExemplarEntry& entry, QPoint pixel) {
    showPicture(&entry);
    m_viewer->setMarker(pixel);
}

void ExemplarPanel::hideSource() {
    m_viewer->setMarker({});
    showPicture(m_store->current());
}

void ExemplarPanel::setLegend(std::shared_ptr<const DisplayPicture> legend) {
    m_legend = std::move(legend);
    showPicture(m_store->current());
}

void ExemplarPanel::showPicture(const ExemplarEntry* entry) {
    std::shared_ptr<const DisplayPicture> picture = entry != nullptr ? entry->picture : nullptr;
    const bool legend =
        m_legend && entry == m_store->current() && picture && m_legend->size() == picture->size();
    if (legend)
        picture = m_legend;
    m_viewer->setBadge(legend ? tr("Position map") : QString());
    if (m_viewer->picture() != picture)
        m_viewer->setPicture(std::move(picture));
    m_viewer->setHidden(entry != nullptr && !legend ? entry->hidden : QImage());
}

} // namespace texloom::ui
