#include "tests/ui/window_fixture.h"

#include "core/io/image_file.h"
#include "core/job/random.h"
#include "ui/jobs/background.h"
#include "ui/window/appearance.h"
#include "ui/window/text.h"

#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>

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
    QSignalSpy finished(window.controller(), &RunController::finished);
    window.openFiles({path});
    return finished.wait(60'000);
}

} // namespace texloom::ui
