#include "ui/compare/compare_bar.h"

#include "ui/common/icons.h"
#include "ui/common/shortcuts.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr double kMostStops = 12;
constexpr double kStopStep = 0.5;

QAction* make(QWidget* window, const char* name, const QString& text, const QKeySequence& key,
              const QString& help, const char* iconName) {
    auto* action = new QAction(text, window);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(key);
    action->setCheckable(true);
    setHelp(action, help);
    if (iconName != nullptr)
        action->setIcon(icon(QLatin1String(iconName)));
    window->addAction(action);
    return action;
}

QString tr(const char* text) {
    return QCoreApplication::translate("texloom::ui::CompareActions", text);
}

} // namespace

CompareActions::CompareActions(QWidget* window)
    : grid(make(window, "compareGrid", tr("&Grid"), Qt::Key_G, tr("Compare pictures side by side"), "grid")),
      wipe(make(window, "compareWipe", tr("&Wipe"), Qt::SHIFT | Qt::Key_W,
                tr("Compare two pictures in one place, parted by a line"), "compare")),
      toggle(make(window, "compareToggle", tr("&Toggle"), Qt::Key_T,
                  tr("Compare two pictures in one place, one after the other"), "toggle")),
      difference(make(window, "compareDifference", tr("&Difference"), Qt::Key_D,
                      tr("Show what two pictures differ in"), "difference")),
      input(make(window, "compareInput", tr("With its &input"), {},
                 tr("Compare the result that is shown with the image that it was made from"), nullptr)),
      exemplar(make(window, "compareExemplar", tr("E&xemplar"), {},
                    tr("Show the exemplars of the results beside them"), nullptr)),
      link(make(window, "compareLink", tr("&Link views"), {},
                tr("Zoom and move all pictures together; those moved apart before stay apart as they are"),
                "link")),
      exemplars(new QMenu(tr("Open e&xemplars"), window)),
      sheet(make(window, "contactSheet", tr("&Contact sheet…"), {},
                 tr("Write all pictures with their labels into one PNG file"), "export")) {
    auto* modes = new QActionGroup(window);
    for (QAction* action : {grid, wipe, toggle, difference})
        modes->addAction(action);
    grid->setChecked(true);
    exemplar->setChecked(true);
    link->setChecked(true);
    for (QAction* action : {input, sheet})
        action->setCheckable(false);
}

QAction* CompareActions::mode(CompareMode mode) const {
    switch (mode) {
    case CompareMode::Wipe:
        return wipe;
    case CompareMode::Toggle:
        return toggle;
    case CompareMode::Difference:
        return difference;
    case CompareMode::Grid:
        break;
    }
    return grid;
}

CompareBar::CompareBar(const CompareActions& actions, QWidget* parent)
    : QWidget(parent), m_first(makeChooser(QStringLiteral("compareFirst"), tr("First picture"))),
      m_second(makeChooser(QStringLiteral("compareSecond"), tr("Second picture"))),
      m_kind(new QComboBox(this)), m_channel(new QComboBox(this)), m_exposure(new QDoubleSpinBox(this)),
      m_said(new QLabel(this)) {
    m_kind->setObjectName(QStringLiteral("differenceKind"));
    m_kind->setAccessibleName(tr("Kind of difference"));
    m_kind->addItem(tr("Absolute"), static_cast<int>(DifferenceKind::Absolute));
    m_kind->addItem(tr("Squared"), static_cast<int>(DifferenceKind::Squared));
    m_kind->addItem(tr("Relative"), static_cast<int>(DifferenceKind::Relative));
    m_said->setObjectName(QStringLiteral("compareSaid"));
    m_said->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_pair = makePair();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(makeModes(actions));
    column->addWidget(m_pair);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &CompareBar::kindChanged);
    connect(m_exposure, &QDoubleSpinBox::valueChanged, this, [this](double stops) {
        m_look.exposure = stops;
        Q_EMIT lookChanged();
    });
    connect(m_channel, &QComboBox::currentIndexChanged, this, [this] {
        m_look.channel = m_channel->currentData().toInt();
        Q_EMIT lookChanged();
    });
    setMode(CompareMode::Grid);
}

QComboBox* CompareBar::makeChooser(const QString& name, const QString& title) {
    auto* chooser = new QComboBox(this);
    chooser->setObjectName(name);
    chooser->setAccessibleName(title);
    chooser->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(chooser, &QComboBox::currentIndexChanged, this, &CompareBar::pairChanged);
    return chooser;
}

QWidget* CompareBar::makeModes(const CompareActions& actions) {
    auto* bar = new QToolBar(this);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->setIconSize(QSize(1, 1) * fontMetrics().height());
    for (QAction* action : {actions.grid, actions.wipe, actions.toggle, actions.difference, actions.exemplar,
                            actions.link, actions.sheet}) {
        bar->addAction(action);
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
        button->setFocusPolicy(Qt::StrongFocus);
        if (action == actions.exemplar) {
            button->setPopupMode(QToolButton::MenuButtonPopup);
            button->setMenu(actions.exemplars);
        }
        if (action == actions.link || action == actions.sheet) {
            button->setToolButtonStyle(Qt::ToolButtonIconOnly);
            button->setAccessibleName(action->text().remove(QLatin1Char('&')));
        }
    }
    m_exposure->setObjectName(QStringLiteral("compareExposure"));
    m_exposure->setRange(-kMostStops, kMostStops);
    m_exposure->setSingleStep(kStopStep);
    m_exposure->setDecimals(1);
    m_exposure->setSuffix(tr(" EV"));
    m_exposure->setAccessibleName(tr("Exposure in stops"));
    m_exposure->setToolTip(
        tr("Brightens or darkens all pictures on the screen; each stop doubles the light"));
    m_channel->setObjectName(QStringLiteral("compareChannel"));
    m_channel->setAccessibleName(tr("Channel shown"));
    m_channel->setToolTip(tr("The channel shown of all pictures (Shift+C, R, G, B, A)"));
    const std::pair<QString, int> channels[] = {
        {tr("Colour"), -1}, {tr("Red"), 0}, {tr("Green"), 1}, {tr("Blue"), 2}, {tr("Alpha"), 3}};
    for (const auto& [title, channel] : channels)
        m_channel->addItem(title, channel);
    bar->addWidget(m_exposure);
    bar->addWidget(m_channel);
    return bar;
}

QWidget* CompareBar::makePair() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout;
    row->addWidget(m_first, 1);
    row->addWidget(m_second, 1);
    row->addWidget(m_kind);
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(row);
    column->addWidget(m_said);
    return bar;
}

void CompareBar::setLabels(const QStringList& labels) {
    for (QComboBox* chooser : {m_first, m_second}) {
        const QSignalBlocker blocker(chooser);
        const int kept = chooser->currentIndex();
        chooser->clear();
        chooser->addItems(labels);
        chooser->setCurrentIndex(
            kept >= 0 && kept < labels.size() ? kept : (chooser == m_second && labels.size() > 1));
    }
}

void CompareBar::setMode(CompareMode mode) {
    m_pair->setVisible(mode != CompareMode::Grid);
    m_kind->setVisible(mode == CompareMode::Difference);
}

int CompareBar::first() const {
    return m_first->currentIndex();
}

int CompareBar::second() const {
    return m_second->currentIndex();
}

void CompareBar::setPair(int first, int second) {
    {
        const QSignalBlocker firstBlocker(m_first);
        const QSignalBlocker secondBlocker(m_second);
        m_first->setCurrentIndex(first);
        m_second->setCurrentIndex(second);
    }
    Q_EMIT pairChanged();
}

DifferenceKind CompareBar::kind() const {
    return static_cast<DifferenceKind>(m_kind->currentData().toInt());
}

void CompareBar::setLook(const DisplayLook& look) {
    m_exposure->setValue(look.exposure);
    m_channel->setCurrentIndex(m_channel->findData(look.channel));
}

void CompareBar::say(const QString& text) {
    m_said->setText(text);
    m_said->setVisible(!text.isEmpty());
}

QString CompareBar::said() const {
    return m_said->text();
}

} // namespace texloom::ui
