#include "ui/inspector/output_group.h"

#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/inspector/analogy_view.h"
#include "ui/inspector/part_editor.h"
#include "ui/inspector/port_pairs.h"
#include "ui/inspector/port_row.h"
#include "ui/inspector/seed_edit.h"

#include <QCheckBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kFirstSide = 512;
/// The size taken by itself for a new exemplar goes no higher; larger ones are asked for.
constexpr int kLargestFirstSide = 1024;
constexpr int kMostThreads = 256;
/// The form's row below the seed.
constexpr int kFirstPortRow = 4;

QWidget* rowOf(const QList<QWidget*>& widgets, int stretched) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    for (int i = 0; i < widgets.size(); ++i)
        layout->addWidget(widgets[i], i == stretched ? 1 : 0);
    if (stretched < 0)
        layout->addStretch();
    return row;
}

/// Whether what goes in there belongs to the exemplar.
bool ofExemplar(const PortRow* row) {
    return row->port().extent == Extent::Exemplar;
}

int limited(int side) {
    return std::clamp(side, 1, kLargestSide);
}

} // namespace

OutputGroup::OutputGroup(QWidget* parent)
    : QGroupBox(tr("Output"), parent), m_width(makeSide(QStringLiteral("outputWidth"))),
      m_height(makeSide(QStringLiteral("outputHeight"))), m_wrapX(new QCheckBox(tr("across (X)"), this)),
      m_wrapY(new QCheckBox(tr("down (Y)"), this)), m_seed(new SeedEdit(this)), m_lock(new QToolButton(this)),
      m_part(new PartEditor(this)), m_threads(new QSpinBox(this)) {
    m_width->setAccessibleName(tr("Width"));
    m_height->setAccessibleName(tr("Height"));
    m_threads->setObjectName(QStringLiteral("threads"));
    m_threads->setRange(0, kMostThreads);
    m_threads->setSpecialValueText(tr("Automatic"));
    explain(m_threads,
            tr("<b>Threads</b> How many of the processor's cores a run uses. The result is the same with any "
               "number. Automatic: one for each core."));

    auto* form = m_form = new QFormLayout(this);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("S&ize"), makeSizeRow());
    qobject_cast<QLabel*>(form->labelForField(form->itemAt(0, QFormLayout::FieldRole)->widget()))
        ->setBuddy(m_width);
    form->addRow(QString(), makePresetRow());
    form->addRow(tr("Wraps"), makeWrapRow());
    form->addRow(tr("See&d"), makeSeedRow());
    qobject_cast<QLabel*>(form->labelForField(m_seed->parentWidget()))->setBuddy(m_seed);
    form->addRow(tr("Make"), m_part);
    form->addRow(tr("&Threads"), m_threads);
    connect(m_part, &PartEditor::edited, this, &OutputGroup::edited);
    connect(m_threads, &QSpinBox::valueChanged, this, &OutputGroup::edited);
}

QSpinBox* OutputGroup::makeSide(const QString& name) {
    auto* side = new QSpinBox(this);
    side->setObjectName(name);
    side->setRange(1, kLargestSide);
    side->setValue(kFirstSide);
    side->setKeyboardTracking(false);
    explain(side,
            tr("<b>Size</b> Width and height of the result in pixels, 1 to %1 each.").arg(kLargestSide));
    connect(side, &QSpinBox::valueChanged, this, [this] {
        m_sizeChosen = true;
        m_part->setWhole(outputSize());
        Q_EMIT edited();
    });
    return side;
}

QWidget* OutputGroup::makeSizeRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_width, 1);
    layout->addWidget(new QLabel(tr("×"), row));
    layout->addWidget(m_height, 1);
    layout->addWidget(new QLabel(tr("px"), row));
    return row;
}

QWidget* OutputGroup::makePresetRow() {
    m_presets = new QWidget(this);
    auto* layout = new QHBoxLayout(m_presets);
    layout->setContentsMargins(0, 0, 0, 0);
    for (const int factor : {1, 2, 4}) {
        auto* button = new QToolButton(m_presets);
        button->setText(tr("×%1").arg(factor));
        button->setObjectName(QStringLiteral("sizeTimes%1").arg(factor));
        button->setAccessibleName(tr("%1 times the exemplar's size").arg(factor));
        button->setFocusPolicy(Qt::StrongFocus);
        explain(button,
                tr("<b>×%1</b> Makes the result %1 times as wide and as high as the exemplar.").arg(factor));
        connect(button, &QToolButton::clicked, this, [this, factor] { multiply(factor); });
        layout->addWidget(button);
    }
    layout->addWidget(new QLabel(tr("of the exemplar"), m_presets), 1);
    return m_presets;
}

QWidget* OutputGroup::makeWrapRow() {
    m_wrapX->setObjectName(QStringLiteral("wrapX"));
    m_wrapY->setObjectName(QStringLiteral("wrapY"));
    m_wrapX->setAccessibleName(tr("Wraps across"));
    m_wrapY->setAccessibleName(tr("Wraps down"));
    for (QCheckBox* box : {m_wrapX, m_wrapY}) {
        box->setChecked(true); // most outputs are tiles
        connect(box, &QCheckBox::toggled, this, &OutputGroup::edited);
    }
    return rowOf({m_wrapX, m_wrapY}, -1);
}

QWidget* OutputGroup::makeSeedRow() {
    m_seed->setObjectName(QStringLiteral("seed"));
    m_seed->setAccessibleName(tr("Seed"));
    explain(
        m_seed,
        tr("<b>Seed</b> Where the random choices begin. The same seed and settings give the same pixels."));
    auto* dice = new QToolButton(this);
    dice->setObjectName(QStringLiteral("drawSeed"));
    setIconButton(dice, QStringLiteral("dice"), tr("Draw a new seed"));
    m_lock->setObjectName(QStringLiteral("lockSeed"));
    m_lock->setCheckable(true);
    m_lock->setChecked(true);
    setIconButton(m_lock, QStringLiteral("lock"), tr("Keep the seed"));
    m_lock->setIcon(toggleIcon(QStringLiteral("lock")));
    explain(m_lock, tr("<b>Keep the seed</b> On: every run uses this seed. Off: every run draws a new one."));
    for (QToolButton* button : {dice, m_lock})
        button->setFocusPolicy(Qt::StrongFocus);
    connect(m_seed, &SeedEdit::seedChanged, this, &OutputGroup::edited);
    connect(dice, &QToolButton::clicked, this, &OutputGroup::drawSeed);
    return rowOf({m_seed, dice, m_lock}, 0);
}

void OutputGroup::explain(QWidget* widget, const QString& help) {
    widget->setToolTip(help);
    widget->installEventFilter(this);
}

bool OutputGroup::eventFilter(QObject* watched, QEvent* event) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (widget != nullptr && (event->type() == QEvent::FocusIn || event->type() == QEvent::Enter))
        Q_EMIT helpWanted(widget->toolTip());
    if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
        event->ignore();
        return true;
    }
    return QGroupBox::eventFilter(watched, event);
}

Size OutputGroup::outputSize() const {
    return {m_width->value(), m_height->value()};
}

void OutputGroup::setOutputSize(Size size) {
    m_width->setValue(limited(size.width));
    m_height->setValue(limited(size.height));
    m_sizeChosen = true;
}

Wrap OutputGroup::wrap() const {
    return {m_wrapX->isEnabled() && m_wrapX->isChecked(), m_wrapY->isEnabled() && m_wrapY->isChecked()};
}

void OutputGroup::setWrap(Wrap wrap) {
    m_wrapX->setChecked(wrap.x);
    m_wrapY->setChecked(wrap.y);
}

std::uint64_t OutputGroup::seed() const {
    return m_seed->seed();
}

void OutputGroup::setSeed(std::uint64_t seed) {
    m_seed->setSeed(seed);
}

bool OutputGroup::seedLocked() const {
    return m_lock->isChecked();
}

void OutputGroup::setSeedLocked(bool locked) {
    m_lock->setChecked(locked);
}

void OutputGroup::drawSeed() {
    m_seed->draw();
}

std::optional<Region> OutputGroup::part() const {
    return m_part->part();
}

void OutputGroup::setPart(const std::optional<Region>& part) {
    m_part->setPart(part);
}

int OutputGroup::threads() const {
    return m_threads->value();
}

void OutputGroup::setMethod(const MethodInfo& info) {
    const QString title = translated(info.title);
    for (QCheckBox* box : {m_wrapX, m_wrapY}) {
        box->setEnabled(info.canWrap());
        const QString axis = box == m_wrapX ? tr("left and right edges") : tr("upper and lower edges");
        explain(box,
                info.canWrap()
                    ? tr("<b>Wraps</b> The result's %1 join without a seam when it is repeated.").arg(axis)
                    : tr("<b>Wraps</b> %1 cannot make a result that wraps.").arg(title.toHtmlEscaped()));
    }
    m_part->setEnabled(info.makesParts());
    explain(m_part, info.makesParts()
                        ? tr("<b>Only a part</b> Makes a rectangle of the output, which equals that part of "
                             "the whole.")
                        : tr("<b>Only a part</b> %1 can only make the whole.").arg(title.toHtmlEscaped()));
}

void OutputGroup::setExemplarSize(Size size) {
    m_exemplar = size;
    m_presets->setEnabled(!size.empty());
    if (m_sizeChosen || size.empty())
        return;
    const QSignalBlocker widthBlocker(m_width);
    const QSignalBlocker heightBlocker(m_height);
    m_width->setValue(std::min(size.width * 2, kLargestFirstSide));
    m_height->setValue(std::min(size.height * 2, kLargestFirstSide));
    m_part->setWhole(outputSize());
}

void OutputGroup::setExemplarSizes(const std::vector<Size>& sizes) {
    m_exemplars = sizes;
    for (PortRow* row : m_ports)
        row->setExemplarSizes(sizes);
}

void OutputGroup::multiply(int factor) {
    setOutputSize({limited(m_exemplar.width * factor), limited(m_exemplar.height * factor)});
}

InputFiles OutputGroup::inputs() const {
    InputFiles inputs;
    for (const PortRow* row : m_ports)
        if (!ofExemplar(row) && !row->files().empty())
            inputs[row->port().id] = row->files();
    return inputs;
}

void OutputGroup::setInputs(const InputFiles& inputs) {
    for (PortRow* row : m_ports) {
        if (ofExemplar(row))
            continue;
        const auto found = inputs.find(row->port().id);
        row->setFiles(found == inputs.end() ? std::vector<InputFile>() : found->second);
    }
}

void OutputGroup::addInput(const std::string& port, InputFile file) {
    for (PortRow* row : m_ports)
        if (row->port().id == port)
            return row->add(std::move(file));
}

void OutputGroup::readInput(const std::string& port, const QString& path) {
    for (PortRow* row : m_ports)
        if (row->port().id == port)
            return row->read(path);
}

void OutputGroup::replaceInputs(const InputFiles& inputs, Size size) {
    for (PortRow* row : m_ports)
        if (const auto found = inputs.find(row->port().id); found != inputs.end())
            row->setFiles(found->second);
    if (!size.empty()) {
        const QSignalBlocker width(m_width), height(m_height);
        setOutputSize(size);
        m_part->setWhole(outputSize());
    }
    Q_EMIT edited();
}

std::vector<Port> OutputGroup::ports() const {
    std::vector<Port> ports;
    for (const PortRow* row : m_ports)
        ports.push_back(row->port());
    return ports;
}

void OutputGroup::setResult(const std::shared_ptr<const Result>& result) {
    m_result = result;
    for (PortRow* row : m_ports)
        row->setResult(m_result);
    if (m_analogy != nullptr)
        m_analogy->setResult(m_result);
}

void OutputGroup::setExemplar(const QString& name, const std::shared_ptr<const Image>& image,
                              const InputFiles& inputs) {
    m_exemplarName = name;
    m_exemplarImage = image;
    m_exemplarInputs = inputs;
    showExemplarInputs();
}

void OutputGroup::showExemplarInputs() {
    if (m_analogy != nullptr)
        m_analogy->setExemplar(m_exemplarName, m_exemplarImage);
    for (PortRow* row : m_ports) {
        if (!ofExemplar(row))
            continue;
        const auto found = m_exemplarInputs.find(row->port().id);
        row->setFiles(found == m_exemplarInputs.end() ? std::vector<InputFile>() : found->second);
        row->setEnabled(m_exemplarImage != nullptr);
    }
}

PortRow* OutputGroup::makePort(const Port& port, const PortLook& look) {
    auto* row = new PortRow(port, look, this);
    row->setResult(m_result);
    row->setExemplarSizes(m_exemplars);
    explain(row, row->toolTip());
    connect(row, &PortRow::edited, this, [this, row] {
        if (ofExemplar(row))
            Q_EMIT exemplarInputsEdited(row->port().id, row->files());
        else
            Q_EMIT edited();
    });
    connect(row, &PortRow::failed, this, &OutputGroup::failed);
    connect(row, &PortRow::resultWanted, this,
            [this, row](const std::string& key) { Q_EMIT resultWanted(row->port().id, key); });
    connect(row, &PortRow::paintWanted, this, [this, row] { Q_EMIT paintWanted(row->port().id); });
    connect(row, &PortRow::extendWanted, this, [this, row] { Q_EMIT extendWanted(row->port().id); });
    m_ports.push_back(row);
    return row;
}

/// Above all else: it is what the method is about.
void OutputGroup::addAnalogy(PortRow* a, PortRow* b) {
    m_analogy = new AnalogyView(a, b, this);
    m_analogy->setResult(m_result);
    connect(m_analogy, &AnalogyView::exemplarWanted, this, [this] { Q_EMIT exemplarWanted({}); });
    connect(m_analogy, &AnalogyView::exemplarOffered, this, &OutputGroup::exemplarWanted);
    connect(m_analogy, &AnalogyView::resultOffered, this,
            [this](const std::string& key) { Q_EMIT resultWanted(std::string(kExemplarPort), key); });
    connect(m_analogy, &AnalogyView::resultWanted, this, &OutputGroup::resultLookedAt);
    m_form->insertRow(0, m_analogy);
    QWidget* last = m_width->previousInFocusChain();
    for (QWidget* stop : m_analogy->stops()) {
        setTabOrder(last, stop);
        last = stop;
    }
}

void OutputGroup::setPorts(const std::vector<Port>& ports) {
    const InputFiles kept = inputs();
    if (m_analogy != nullptr)
        m_form->removeRow(m_analogy);
    m_analogy = nullptr;
    for (PortRow* row : m_ports)
        if (m_form->indexOf(row) >= 0)
            m_form->removeRow(row);
    m_ports.clear();
    int at = kFirstPortRow;
    const std::optional<AnalogyPorts> pair = analogyAmong(ports);
    if (pair) {
        PortRow* const a = makePort(pair->exemplars, {true, tr("A"), true, false});
        addAnalogy(a, makePort(pair->output, {true, tr("B"), true, false}));
        ++at;
    }
    for (const Port& port : ports) {
        if (pair && (port.id == pair->exemplars.id || port.id == pair->output.id))
            continue;
        const bool mask = port.kind == AssetKind::Mask;
        m_form->insertRow(at++, translated(port.title),
                          makePort(port, {false, {}, mask, mask && pictureBefore(ports, port.id)}));
    }
    setInputs(kept);
    showExemplarInputs();
}

} // namespace texloom::ui
