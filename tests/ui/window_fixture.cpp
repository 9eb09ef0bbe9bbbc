#include "tests/ui/window_fixture.h"

#include "core/io/image_file.h"
#include "core/job/random.h"
#include "tests/support/time_limit.h"
#include "ui/common/appearance.h"
#include "ui/common/background.h"
#include "ui/common/text.h"

#include <QAccessible>
#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QToolButton>

#include <algorithm>
#include <cmath>

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
    constexpr int kPatience = 60'000;
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
    return {};
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
