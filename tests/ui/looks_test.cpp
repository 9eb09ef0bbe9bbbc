#include "tests/ui/window_fixture.h"
#include "ui/common/appearance.h"
#include "ui/common/language.h"
#include "ui/exemplar/layer_dialog.h"
#include "ui/export/preset_editor.h"
#include "ui/maps/result_view.h"
#include "ui/session/missing_files_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

#include <cmath>
#include <memory>
#include <vector>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// The ratio of contrast of two colours, 1 to 21: see WCAG 2.1.
double contrast(const QColor& one, const QColor& other) {
    const auto luminance = [](const QColor& color) {
        const auto linear = [](double value) {
            return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
               0.0722 * linear(color.blueF());
    };
    const double a = luminance(one), b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

/// The letter that a text marks with &; null if none.
QChar letterOf(const QString& text) {
    const QKeySequence key = QKeySequence::mnemonic(text);
    return key.isEmpty() ? QChar() : QChar(static_cast<char16_t>(key[0].key()));
}

/// What of a window does not fit: cut texts, and widgets beyond a screen of this size.
QString misfit(QWidget& window, QSize screen) {
    if (window.width() > screen.width() || window.height() > screen.height())
        return QStringLiteral("%1 is %2 × %3")
            .arg(window.windowTitle())
            .arg(window.width())
            .arg(window.height());
    if (const QString cut = cutText(window); !cut.isEmpty())
        return QStringLiteral("cut in %1: “%2”").arg(window.windowTitle(), cut);
    if (const QString wrong = misplaced(window); !wrong.isEmpty())
        return QStringLiteral("in %1: %2").arg(window.windowTitle(), wrong);
    return {};
}

/// A file with layers, one of which has a long name.
LayerQuestion layers() {
    LayerQuestion question{
        QStringLiteral("/materials/cobblestone courtyard after the rain, all passes.exr"), {}, {}};
    question.entries.push_back({"", QStringLiteral("All channels")});
    for (const char* layer : {"beauty", "diffuse.direct", "diffuse.indirect", "specular.direct", "normal",
                              "a layer whose name somebody wrote in full, with all that it is for"})
        question.entries.push_back({layer, QString::fromUtf8(layer)});
    return question;
}

/// The dialogs that no action opens by itself, for something that happens seldom.
std::vector<std::unique_ptr<QDialog>> seldomDialogs(MainWindow& window) {
    std::vector<std::unique_ptr<QDialog>> all;
    all.push_back(std::make_unique<LayerDialog>(layers(), &window));
    all.push_back(std::make_unique<PresetEditor>(QStringLiteral("unity"), &window));
    all.push_back(std::make_unique<MissingFilesDialog>(
        window.session(),
        QStringList{QStringLiteral("materials/a long folder name/bark_albedo.png"),
                    QStringLiteral("materials/bark_normal.png")},
        &window));
    return all;
}

} // namespace

/// That all of it can be read and reached: contrasts, keys, sizes, in three languages.
class LooksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cleanup() {
        applyAppearance(Appearance::Light);
        useLanguage(QLocale(QLocale::English));
    }

    void textsHaveContrast_data() {
        QTest::addColumn<int>("appearance");
        QTest::newRow("light") << static_cast<int>(Appearance::Light);
        QTest::newRow("dark") << static_cast<int>(Appearance::Dark);
    }

    void textsHaveContrast() {
        QFETCH(int, appearance);
        applyAppearance(static_cast<Appearance>(appearance));
        const QPalette palette = QApplication::palette();
        using Role = QPalette::ColorRole;
        const std::pair<Role, Role> pairs[] = {{QPalette::WindowText, QPalette::Window},
                                               {QPalette::Text, QPalette::Base},
                                               {QPalette::Text, QPalette::AlternateBase},
                                               {QPalette::ButtonText, QPalette::Button},
                                               {QPalette::HighlightedText, QPalette::Highlight},
                                               {QPalette::PlaceholderText, QPalette::Base},
                                               {QPalette::PlaceholderText, QPalette::Window},
                                               {QPalette::ToolTipText, QPalette::ToolTipBase},
                                               {QPalette::Link, QPalette::Window},
                                               {QPalette::Link, QPalette::Base}};
        for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
            for (const auto& [text, ground] : pairs) {
                const double ratio = contrast(palette.color(group, text), palette.color(group, ground));
                QVERIFY2(ratio >= 4.5,
                         qPrintable(QStringLiteral("%1 %2 %3").arg(group).arg(text).arg(ratio)));
            }
        QVERIFY(contrast(Qt::white, canvasColor()) >= 4.5);
        QVERIFY(contrast(errorColor(palette), palette.color(QPalette::Window)) >= 4.5);
    }

    void darkIsTheFirstAppearance() { QVERIFY(savedAppearance() == Appearance::Dark); }

    void everyMenuHasALetterOfItsOwn_data() { languages(); }

    void everyMenuHasALetterOfItsOwn() {
        QFETCH(QString, language);
        useLanguage(QLocale(language));
        MainWindow window;
        window.show();
        auto* method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("texture-optimization")));
        QSet<QChar> letters;
        for (const QAction* menu : window.menuBar()->actions()) {
            const QChar letter = letterOf(menu->text());
            QVERIFY2(!letter.isNull(), qPrintable(menu->text()));
            QVERIFY2(!letters.contains(letter), qPrintable(menu->text()));
            letters.insert(letter);
        }
        for (const auto* label : window.findChildren<QLabel*>())
            QVERIFY2(label->buddy() == nullptr || !letters.contains(letterOf(label->text())),
                     qPrintable(label->text()));
        for (const auto* button : window.findChildren<QAbstractButton*>())
            QVERIFY2(!letters.contains(letterOf(button->text())), qPrintable(button->text()));
    }

    void f10OpensTheMenus() {
        MainWindow window;
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QMenu* const first = window.menuBar()->actions().front()->menu();
        QSignalSpy shown(first, &QMenu::aboutToShow);
        QTest::keyClick(&window, Qt::Key_F10);
        QTRY_COMPARE(shown.size(), 1);
        first->close();
    }

    void viewerKeysWorkWhereverTheFocusIs() {
        QTemporaryDir folder;
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, writeTexture(folder, QStringLiteral("keys.png"), {64, 64})));
        window.activateWindow();
        auto* repeat = child<QAction>(window, "repeat");
        for (const char* name : {"resultList", "exemplarList", "method", "outputWidth", "wrapX", "runButton",
                                 "resultViewer", "exemplarViewer"}) {
            auto* widget = child<QWidget>(window, name);
            widget->setFocus();
            const bool before = repeat->isChecked();
            QTest::keyClick(widget, Qt::Key_W);
            QVERIFY2(repeat->isChecked() != before || QLatin1String(name) == QLatin1String("exemplarViewer"),
                     name);
        }
        auto* search = child<QWidget>(window, "resultSearch");
        search->setFocus();
        const bool before = repeat->isChecked();
        QTest::keyClick(search, Qt::Key_W);
        QCOMPARE(repeat->isChecked(), before); // a letter of the text
    }

    void allFitsASmallScreen_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<bool>("stacked");
        for (const char* language : {"en", "de", "fr"}) {
            QTest::addRow("%s", language) << QString(QLatin1String(language)) << QSize(1366, 768) << false;
            // 1920 × 1080 at twice the size, less a window's frame
            QTest::addRow("%s, stacked", language)
                << QString(QLatin1String(language)) << QSize(960, 510) << true;
        }
    }

    /// Offscreen screens are small anyway; what counts is what windows ask for, in points of the screen.
    void allFitsASmallScreen() {
        QFETCH(QString, language);
        QFETCH(QSize, screen);
        QFETCH(bool, stacked);
        useLanguage(QLocale(language));
        QTemporaryDir folder;
        MainWindow window;
        child<QAction>(window, "stackPanels")->setChecked(stacked);
        window.show();
        QVERIFY(openAndFinish(window, writeTexture(folder, QStringLiteral("fits.png"), {64, 64})));
        for (const QSize size : {screen, screen + QSize(200, 100)}) {
            window.resize(size);
            settle();
            tabsFit(window, size);
            if (QTest::currentTestFailed())
                return;
        }
        window.resize(screen);
        dialogsFit(window, screen);
        child<QAction>(window, "stackPanels")->setChecked(false); // which is kept
    }

private:
    static void tabsFit(MainWindow& window, QSize screen) {
        auto* tabs = child<QTabWidget>(window, "resultTabs");
        for (int tab = 0; tab < tabs->count(); ++tab) {
            if (!tabs->isTabVisible(tab))
                continue;
            tabs->setCurrentIndex(tab);
            settle();
            const QString wrong = misfit(window, screen);
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("%1, tab %2").arg(wrong).arg(tab)));
        }
        tabs->setCurrentIndex(0);
        auto* run = child<QWidget>(window, "runButton");
        const QRect place(run->mapTo(&window, QPoint()), run->size());
        QVERIFY(run->visibleRegion().boundingRect() == run->rect() && window.rect().contains(place));
        const double canvas = window.centralWidget()->width();
        QVERIFY2(canvas >= 0.45 * screen.width(), // German has the longest words
                 qPrintable(QStringLiteral("canvas %1 of %2").arg(canvas).arg(screen.width())));
    }

    static void dialogsFit(MainWindow& window, QSize screen) {
        for (const char* name : {"shortcuts", "export", "sweep", "trySome", "stress", "variance", "blend",
                                 "extendCanvas", "about", "editExemplar", "keepPreset"}) {
            auto* action = window.findChild<QAction*>(QLatin1String(name));
            QVERIFY2(action != nullptr, name);
            if (!action->isEnabled())
                continue;
            action->trigger();
            settle();
            QDialog* dialog = nullptr;
            for (QDialog* open : window.findChildren<QDialog*>())
                if (open->isVisible())
                    dialog = open;
            if (dialog == nullptr) {
                const QString wrong = misfit(window, screen); // a page of its own
                QVERIFY2(wrong.isEmpty(),
                         qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(name), wrong)));
                continue;
            }
            dialogFits(*dialog, screen);
            if (QTest::currentTestFailed())
                return;
            QTest::keyClick(dialog, Qt::Key_Escape);
            settle();
            QVERIFY2(!window.findChildren<QDialog*>().contains(dialog) || !dialog->isVisible(), name);
        }
        for (const auto& dialog : seldomDialogs(window)) {
            dialog->show();
            settle();
            dialogFits(*dialog, screen);
        }
    }

    static void dialogFits(QDialog& dialog, QSize screen) {
        // As on a screen of this size, whatever the offscreen one has: see resizeWithinScreen().
        dialog.resize(dialog.size().expandedTo(dialog.sizeHint()).boundedTo(screen));
        settle();
        const QString wrong = misfit(dialog, screen);
        const QSize least = dialog.minimumSizeHint();
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("%1: %2").arg(dialog.objectName(), wrong)));
        QVERIFY2(least.width() <= screen.width() && least.height() <= screen.height(),
                 qPrintable(dialog.objectName()));
    }

    static void languages() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "fr"})
            QTest::newRow(language) << QString(QLatin1String(language));
    }
};

TEXLOOM_UI_TESTS(LooksTest)
#include "looks_test.moc"
