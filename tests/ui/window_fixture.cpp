#include "tests/ui/window_fixture.h"

#include "core/io/image_file.h"
#include "core/job/random.h"
#include "tests/support/time_limit.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/text.h"

#include <QAbstractScrollArea>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QMainWindow>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStyleOptionComboBox>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom::ui {

int runTests(int argc, char** argv, const std::function<int(int, char**)>& tests) {
    qputenv("TEXLOOM_RESOURCES", TEXLOOM_RESOURCES);
    const QTemporaryDir folder;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QStandardPaths::setTestModeEnabled(true);
    const QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("TexloomTests"));
    QApplication::setApplicationName(QStringLiteral("texloom-tests"));
    QSettings().setValue(QStringLiteral("results/folder"), folder.filePath(QStringLiteral("results")));
    QSettings().setValue(QStringLiteral("window/stacked"), false); // however small the screen is
    applyAppearance(Appearance::Light);
    const int status = tests(argc, argv);
    workers().waitForDone();
    return status;
}

Image testTexture(Size size, int channels, std::uint64_t seed) {
    const Random random(seed);
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const double waves = std::sin(x * 0.21 + c) * std::cos(y * 0.17 - c) * 0.25;
                const double grain = random.uniform(x, y, static_cast<std::uint32_t>(c)) * 0.4;
                image(x, y, c) = static_cast<float>(0.3 + waves + grain);
            }
    return image;
}

QString writeTexture(const QTemporaryDir& folder, const QString& name, Size size, std::uint64_t seed) {
    const QString path = folder.filePath(name);
    writeImage(toPath(path), testTexture(size, 3, seed), {});
    return path;
}

bool openAndFinish(MainWindow& window, const QString& path) {
    QSignalSpy finished(window.desk()->controller(), &RunController::finished);
    window.openFiles({path});
    return finished.wait(60'000);
}

void trigger(const QObject& parent, const char* name) {
    auto* const action = child<QAction>(parent, name);
    if (!QTest::qWaitFor([action] { return action->isEnabled(); }, kPatience))
        qFatal("%s stays disabled", name);
    action->trigger();
}

std::size_t triedMethods() {
    return static_cast<std::size_t>(
        std::count_if(methods().begin(), methods().end(),
                      [](const Method& method) { return method.info().category != Category::Solids; }));
}

void settle() {
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round)
        QCoreApplication::processEvents();
}

namespace {

/// The text of a list of choices that is shorter than what is chosen; those that shorten names on purpose do
/// not count.
QString cutChoice(const QWidget& window) {
    for (const auto* box : window.findChildren<QComboBox*>()) {
        if (!box->isVisible() || box->isEditable() ||
            box->sizeAdjustPolicy() == QComboBox::AdjustToMinimumContentsLengthWithIcon)
            continue;
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect room =
            box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        const int icon = box->itemIcon(box->currentIndex()).isNull() ? 0 : box->iconSize().width() + 4;
        if (box->fontMetrics().horizontalAdvance(box->currentText()) + icon > room.width())
            return box->currentText();
    }
    return {};
}

QString cutTitle(const QWidget& window) {
    for (const auto* group : window.findChildren<QGroupBox*>())
        if (group->isVisible() && group->width() < group->minimumSizeHint().width())
            return group->title();
    for (const auto* header : window.findChildren<QHeaderView*>())
        for (int i = 0; header->isVisible() && header->orientation() == Qt::Horizontal && i < header->count();
             ++i)
            if (!header->isSectionHidden(i) && header->sectionSize(i) < header->sectionSizeHint(i))
                return header->model()->headerData(i, Qt::Horizontal).toString();
    return {};
}

QString nameOf(const QWidget& widget) {
    const QWidget* const around = widget.parentWidget();
    return QStringLiteral("%1 %2 in %3")
        .arg(QLatin1String(widget.metaObject()->className()), widget.objectName(),
             around != nullptr ? around->objectName() : QString());
}

/// The widgets that a layout and those in it give places to.
void gather(const QLayout& layout, std::vector<const QWidget*>& widgets) {
    for (int i = 0; i < layout.count(); ++i) {
        if (const QLayout* inner = layout.itemAt(i)->layout())
            gather(*inner, widgets);
        if (const QWidget* widget = layout.itemAt(i)->widget(); widget != nullptr && widget->isVisible())
            widgets.push_back(widget);
    }
}

/// Two of them that share a pixel.
QString overlapping(const std::vector<const QWidget*>& widgets) {
    for (std::size_t i = 0; i < widgets.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!widgets[i]->geometry().intersected(widgets[j]->geometry()).isEmpty())
                return QStringLiteral("%1 lies on %2").arg(nameOf(*widgets[i]), nameOf(*widgets[j]));
    return {};
}

/// Whether a widget is wider than what is seen of it, and cannot be scrolled to the rest.
bool reachesBeyond(const QWidget& widget) {
    for (const QWidget* around = widget.parentWidget(); around != nullptr; around = around->parentWidget()) {
        const auto* area = qobject_cast<const QAbstractScrollArea*>(around->parentWidget());
        const bool viewport = area != nullptr && area->viewport() == around;
        if (viewport && area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff)
            return false;
        if (!viewport && !around->isWindow())
            continue;
        const QRect place(widget.mapTo(around, QPoint()), widget.size());
        return place.left() < 0 || place.right() >= around->width() ||
               (around->isWindow() && (place.top() < 0 || place.bottom() >= around->height()));
    }
    return false;
}

/// Whether a widget lies in a dock that another one hides, which Qt puts beyond the window.
bool inHiddenDock(const QWidget& widget) {
    for (const QWidget* around = &widget; around != nullptr; around = around->parentWidget())
        if (qobject_cast<const QDockWidget*>(around) != nullptr)
            return around->visibleRegion().isEmpty();
    return false;
}

/// Whether a widget lays others out beside each other; pages and docks in tabs lie on one another.
bool givesPlaces(const QWidget& parent) {
    return parent.layout() != nullptr && !parent.layout()->inherits("QStackedLayout") &&
           qobject_cast<const QStackedWidget*>(&parent) == nullptr &&
           qobject_cast<const QMainWindow*>(&parent) == nullptr &&
           qobject_cast<const QDockWidget*>(&parent) == nullptr;
}

} // namespace

QString misplaced(const QWidget& window) {
    QList<const QWidget*> parents(1, &window);
    for (const QWidget* inner : window.findChildren<QWidget*>())
        parents += inner;
    for (const QWidget* parent : parents) {
        if (!parent->isVisible() || !givesPlaces(*parent) || inHiddenDock(*parent))
            continue;
        std::vector<const QWidget*> widgets;
        gather(*parent->layout(), widgets);
        if (const QString wrong = overlapping(widgets); !wrong.isEmpty())
            return wrong;
        for (const QWidget* widget : widgets)
            if (widget->width() > 0 && reachesBeyond(*widget))
                return QStringLiteral("%1 reaches beyond").arg(nameOf(*widget));
    }
    return {};
}

QString cutText(const QWidget& window) {
    for (const auto* button : window.findChildren<QAbstractButton*>()) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        const bool iconOnly = tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly;
        if (button->isVisible() && !button->text().isEmpty() && !iconOnly &&
            button->width() < button->minimumSizeHint().width())
            return button->text();
    }
    for (const auto* label : window.findChildren<QLabel*>()) {
        const QSize whole = label->minimumSizeHint();
        const bool cut = label->wordWrap()
                             ? label->height() < label->heightForWidth(label->width())
                             : label->width() < whole.width() || label->height() < whole.height();
        if (label->isVisible() && label->width() > 0 && !label->text().isEmpty() && cut)
            return label->text();
    }
    const QString choice = cutChoice(window);
    return choice.isEmpty() ? cutTitle(window) : choice;
}

QStringList namelessControls(const QWidget& window) {
    QStringList nameless;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        const bool takesFocus = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisibleTo(&window);
        if (!takesFocus || widget->focusProxy() != nullptr)
            continue;
        const QAccessibleInterface* const told = QAccessible::queryAccessibleInterface(widget);
        if (told == nullptr || told->text(QAccessible::Name).isEmpty())
            nameless += QStringLiteral("%1 %2").arg(QLatin1String(widget->metaObject()->className()),
                                                    widget->objectName());
    }
    return nameless;
}

bool inTime(qint64 taken, std::chrono::milliseconds promised) {
    const auto limit = test::limitNow(promised);
    if (!limit)
        qInfo("%s", test::kTooBusy);
    else if (taken > limit->count())
        qWarning("%lld ms, more than the %lld that this machine may take now", taken,
                 static_cast<long long>(limit->count()));
    return !limit || taken <= limit->count();
}

} // namespace texloom::ui
