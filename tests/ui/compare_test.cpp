#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/session/batch/batch.h"
#include "core/session/batch/join_input.h"
#include "tests/ui/window_fixture.h"
#include "ui/blend/blend_window.h"
#include "ui/common/text.h"
#include "ui/compare/compare_view.h"
#include "ui/compare/contact_sheet.h"
#include "ui/compare/example_sweeps.h"
#include "ui/compare/sweep_dialog.h"
#include "ui/compare/wipe_viewer.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/method_hint.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSignalSpy>
#include <QToolButton>

#include <algorithm>
#include <cmath>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr int kTriesPatience = 120'000;

std::shared_ptr<const DisplayPicture> pictureOf(const Image& image) {
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(image));
}

Image flat(Size size, float red, float green, float blue) {
    Image image(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            image(x, y, 0) = red;
            image(x, y, 1) = green;
            image(x, y, 2) = blue;
        }
    return image;
}

/// Three pictures: red, blue, and one that is half as large.
std::vector<CompareItem> threeItems() {
    return {{QStringLiteral("red"), pictureOf(flat({64, 64}, 1, 0, 0)), {}, {}},
            {QStringLiteral("blue"), pictureOf(flat({64, 64}, 0, 0, 1)), {}, {}},
            {QStringLiteral("texture"), pictureOf(testTexture({32, 32})), {}, {}}};
}

QPointF centreOf(const ImageViewer& viewer) {
    return viewer.view().toImage(QRectF(viewer.rect()).center());
}

QColor colorAt(QWidget& widget, QPoint point) {
    const QImage shown = widget.grab().toImage();
    return shown.pixelColor((QPointF(point) * shown.devicePixelRatio()).toPoint());
}

struct Fixture {
    QWidget window;
    CompareActions actions{&window};
    CompareView view{actions, &window};

    Fixture() {
        window.resize(900, 700);
        view.resize(900, 700);
        view.setItems(threeItems());
        window.show();
    }
};

} // namespace

/// Pictures beside one another, and runs made many at a time.
class CompareTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { m_exemplar = writeTexture(m_folder, QStringLiteral("weave.png"), {64, 64}); }

    void everyShippedSweepCanBeRunAsItStands() {
        const QStringList files = ExampleSweeps::files();
        QVERIFY(files.size() >= 5);
        for (const QString& path : files) {
            const auto file = toPath(path);
            const Batch batch = Batch::fromJson(readText(file), file.parent_path());
            QVERIFY2(!batch.title.empty() && !batch.summary.empty(), qPrintable(path));
            for (std::size_t i = 0; i < batch.size(); ++i) {
                const BatchItem item = batch.item(i);
                QVERIFY2(item.problem == Message(), qPrintable(translated(item.problem)));
                if (item.join != nullptr) {
                    const JoinInput joined = loadJoin(item);
                    joined.tool->checkJoin(joined.pictures(), joined.settings);
                } else
                    planRun(loadRecipe(item.whole()));
            }
        }
    }

    void aShippedSweepShowsItsRunsBesideWhatTheyLearnFrom() {
        MainWindow window;
        window.show();
        trigger(window, "sweep-ashikhmin-jumps");
        const CompareView* const view = window.compare();
        QTRY_COMPARE(view->items().size(), 5U);
        QTRY_VERIFY(view->isVisible());
        QCOMPARE(view->items()[0].label, QStringLiteral("grass_dry_gray"));
        QCOMPARE(view->items()[2].label, QStringLiteral("Jump 0.01"));
        const auto made = [view] {
            return std::all_of(view->items().begin() + 1, view->items().end(),
                               [](const CompareItem& item) { return !item.key.empty(); });
        };
        QTRY_VERIFY_WITH_TIMEOUT(made(), kTriesPatience);
        QVERIFY2(window.store()->entries().empty(), "what is open stays as it is");
    }

    void aShippedJoinOpensTheWindowThatBlends() {
        MainWindow window;
        window.show();
        trigger(window, "sweep-poisson-mix");
        const auto opened = [&] { return window.findChild<BlendWindow*>(QStringLiteral("blendWindow")); };
        QTRY_VERIFY(opened());
        BlendWindow* const blend = opened();
        QVERIFY(blend->tool().id() == "poisson-mix");
        QCOMPARE(child<QComboBox>(*blend, "blendFirst")->currentText(), QStringLiteral("plank_wall_dark"));
        QCOMPARE(child<QComboBox>(*blend, "blendSecond")->currentText(),
                 QStringLiteral("riveted_metal_stained_albedo"));
        // Each file is offered once, though most are in several pairs.
        QStringList offered;
        for (int i = 0; i < 7; ++i)
            offered += child<QComboBox>(*blend, "blendFirst")->itemText(i);
        QCOMPARE(offered.removeDuplicates(), 0);
        QVERIFY(offered.contains(QStringLiteral("rock_strata_large")));
        for (const std::size_t way : {0, 1, 2, 3})
            QTRY_VERIFY_WITH_TIMEOUT(blend->viewer(way)->picture(), kTriesPatience);
        QVERIFY2(window.store()->entries().empty(), "what is open stays as it is");
    }

    void linkedViewsMoveTogetherAndKeepTheirOffsets() {
        Fixture fixture;
        QVERIFY(QTest::qWaitForWindowExposed(&fixture.window));
        ImageViewer* const first = fixture.view.viewer(0);
        ImageViewer* const second = fixture.view.viewer(1);
        ImageViewer* const third = fixture.view.viewer(2);
        const double before = third->view().scale();
        first->zoomIn();
        first->zoomIn();
        QCOMPARE(second->view().scale(), first->view().scale());
        QVERIFY(std::abs(third->view().scale() / before - 1.5625) < 1e-9);
        QTest::keyClick(first, Qt::Key_Left);
        QVERIFY((centreOf(*first) - centreOf(*second)).manhattanLength() < 1e-9);

        fixture.actions.link->setChecked(false);
        QTest::keyClick(second, Qt::Key_Down);
        QTest::keyClick(second, Qt::Key_Down);
        const QPointF apart = centreOf(*second) - centreOf(*first);
        QVERIFY(std::abs(apart.y()) > 1);
        fixture.actions.link->setChecked(true);
        first->zoomIn();
        QTest::keyClick(first, Qt::Key_Right);
        QVERIFY((centreOf(*second) - centreOf(*first) - apart).manhattanLength() < 1e-9);
        QTest::keyClick(first, Qt::Key_F);
        QVERIFY(second->fitted() && third->fitted());
        QTest::keyClick(third, Qt::Key_W);
        QVERIFY(first->repeats() && second->repeats());
    }

    void theSamePlaceIsMarkedInPicturesOfTheSameSize() {
        Fixture fixture;
        QSignalSpy hovered(&fixture.view, &CompareView::hovered);
        Q_EMIT fixture.view.viewer(0)->hovered({5, 6});
        QVERIFY(!fixture.view.viewer(0)->marker());
        QCOMPARE(fixture.view.viewer(1)->marker(), QPoint(5, 6));
        QVERIFY(!fixture.view.viewer(2)->marker());
        QCOMPARE(hovered.front().at(2).toString(), QStringLiteral("1.000 0.000 0.000 · 255 0 0 · #FF0000"));
        Q_EMIT fixture.view.viewer(0)->unhovered();
        QVERIFY(!fixture.view.viewer(1)->marker());
    }

    void wipePartsTwoPicturesAtAnyAngle() {
        Fixture fixture;
        fixture.view.bar()->setPair(0, 1);
        fixture.view.setMode(CompareMode::Wipe);
        WipeViewer* const wipe = fixture.view.single();
        wipe->actualSize();
        for (int i = 0; i < 3; ++i)
            wipe->zoomIn();
        const QPoint middle = wipe->rect().center();
        QCOMPARE(colorAt(*wipe, middle - QPoint(30, 0)), QColor(Qt::red));
        QCOMPARE(colorAt(*wipe, middle + QPoint(30, 0)), QColor(Qt::blue));
        wipe->setAngle(90);
        QCOMPARE(colorAt(*wipe, middle - QPoint(-20, 30)), QColor(Qt::red));
        QCOMPARE(colorAt(*wipe, middle + QPoint(20, 30)), QColor(Qt::blue));
        for (int i = 0; i < 10; ++i)
            QTest::keyClick(wipe, Qt::Key_Up, Qt::ControlModifier);
        QVERIFY(std::abs(wipe->place().y() - 0.3) < 1e-9);
        QCOMPARE(colorAt(*wipe, middle - QPoint(-20, 30)), QColor(Qt::blue));
        QTest::keyClick(wipe, Qt::Key_Left, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(wipe->angle(), 85.0);
    }

    void wipeIsDraggedByItsHandle() {
        Fixture fixture;
        fixture.view.setMode(CompareMode::Wipe);
        WipeViewer* const wipe = fixture.view.single();
        QVERIFY(QTest::qWaitForWindowExposed(&fixture.window));
        const ViewTransform before = wipe->view();
        const QPoint handle(wipe->width() / 2, wipe->height() / 2);
        QTest::mousePress(wipe, Qt::LeftButton, {}, handle);
        QMouseEvent move(QEvent::MouseMove, QPointF(handle) + QPointF(50, 20),
                         wipe->mapToGlobal(QPointF(handle) + QPointF(50, 20)), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QApplication::sendEvent(wipe, &move);
        QTest::mouseRelease(wipe, Qt::LeftButton, {}, handle + QPoint(50, 20));
        QVERIFY(std::abs(wipe->place().x() * wipe->width() - handle.x() - 50) < 1);
        QVERIFY2(wipe->view() == before, "the picture does not move with it");
    }

    void toggleShowsOneAfterTheOther() {
        Fixture fixture;
        QCOMPARE(fixture.view.bar()->second(), 2);
        fixture.view.bar()->setPair(0, 1);
        fixture.view.setMode(CompareMode::Toggle);
        QCOMPARE(fixture.view.single()->badge(), QStringLiteral("red"));
        fixture.view.setMode(CompareMode::Toggle);
        QCOMPARE(fixture.view.single()->badge(), QStringLiteral("blue"));
        QVERIFY(fixture.view.single()->picture() == fixture.view.items()[1].picture);
        fixture.view.setMode(CompareMode::Toggle);
        QCOMPARE(fixture.view.single()->badge(), QStringLiteral("red"));
    }

    void theLastTwoLookedAtAreThePair() {
        Fixture fixture;
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        fixture.view.viewer(0)->setFocus();
        fixture.view.viewer(2)->setFocus();
        QCOMPARE(fixture.view.bar()->first(), 0);
        QCOMPARE(fixture.view.bar()->second(), 2);
        QCOMPARE(fixture.view.front(), fixture.view.viewer(2));
    }

    void differenceHasItsNumber() {
        Fixture fixture;
        fixture.view.bar()->setPair(0, 2);
        fixture.view.setMode(CompareMode::Difference);
        const Image texture = testTexture({32, 32});
        double absolute = 0, squared = 0, relative = 0;
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < 32; ++y)
                for (int x = 0; x < 32; ++x) {
                    const double b = static_cast<double>(texture(x, y, c));
                    const double apart = std::abs((c == 0 ? 1 : 0) - b);
                    absolute += apart;
                    squared += apart * apart;
                    relative += apart / (std::abs(b) + 0.01);
                }
        const double count = 32.0 * 32 * 3;
        auto* kind = child<QComboBox>(fixture.view, "differenceKind");
        const double expected[] = {absolute / count, std::sqrt(squared / count), relative / count};
        for (int i = 0; i < 3; ++i) {
            kind->setCurrentIndex(i);
            QTRY_VERIFY(!fixture.view.bar()->said().isEmpty());
            const QString said = fixture.view.bar()->said();
            QVERIFY2(said.contains(QString::number(expected[i], 'g', 4)), qPrintable(said));
            QVERIFY2(said.contains(QStringLiteral("32 × 32")), qPrintable(said));
        }
        QVERIFY((fixture.view.single()->picture()->size() == Size{32, 32}));
    }

    void exposureAndChannelAreThoseOfAll() {
        Fixture fixture;
        const auto before = fixture.view.viewer(2)->picture();
        fixture.view.bar()->setLook({1, -1});
        QTRY_VERIFY(fixture.view.viewer(2)->picture() != before);
        const auto brighter = fixture.view.viewer(2)->picture();
        QVERIFY(qGreen(brighter->image().pixel(5, 5)) > qGreen(before->image().pixel(5, 5)));
        fixture.view.bar()->setLook({0, 2});
        QTRY_VERIFY(fixture.view.viewer(1)->picture()->image().pixel(3, 3) == qRgb(255, 255, 255));
        QTRY_VERIFY(fixture.view.viewer(0)->picture()->image().pixel(3, 3) == qRgb(0, 0, 0));
        fixture.view.bar()->setLook({});
        QVERIFY(fixture.view.viewer(2)->picture() == before);
    }

    void contactSheetHasAllPicturesAndLabels() {
        std::vector<CompareItem> items = threeItems();
        items.push_back({QStringLiteral("none"), nullptr, QStringLiteral("The patch is too large."), {}});
        const QImage sheet = contactSheet(items, QString(), 2, 96, QFont());
        QCOMPARE(sheet.pixelColor(4 + 48, 4 + 48), QColor(Qt::red));
        QCOMPARE(sheet.pixelColor(4 + 96 + 4 + 48, 4 + 48), QColor(Qt::blue));
        int dark = 0;
        for (int x = 0; x < sheet.width(); ++x)
            for (int y = 4 + 96; y < 4 + 96 + 24; ++y)
                dark += qGray(sheet.pixel(x, y)) < 100;
        QVERIFY2(dark > 10, "labels stand below the pictures");
        const QString path = m_folder.filePath(QStringLiteral("sheet.png"));
        writeSheet(sheet, path);
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), sheet);
        QVERIFY_EXCEPTION_THROWN(writeSheet(sheet, QStringLiteral("/not/there/sheet.png")), Error);
    }

    void keysCompareTheLastTwoResults() {
        MainWindow window;
        window.resize(1200, 900);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QVERIFY(openAndFinish(window, m_exemplar));
        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.inspector()->output()->setSeed(9);
        window.startRun(true);
        QVERIFY(finished.wait(kTriesPatience));
        ImageViewer* const viewer = window.results()->viewer(ResultView::ResultTab);
        viewer->setFocus();
        QTest::keyClick(viewer, Qt::Key_W, Qt::ShiftModifier);
        const CompareView* const compare = window.compare();
        QTRY_COMPARE(compare->mode(), CompareMode::Wipe);
        QVERIFY(compare->isVisible());
        QCOMPARE(compare->pictures(), 2);
        QVERIFY(!viewer->repeats());
        QVERIFY2(compare->items()[1].label.contains(QStringLiteral("seed 9")),
                 qPrintable(compare->items()[1].label));
        for (const auto& [key, mode] :
             {std::pair(Qt::Key_T, CompareMode::Toggle), std::pair(Qt::Key_D, CompareMode::Difference),
              std::pair(Qt::Key_G, CompareMode::Grid)}) {
            QTest::keyClick(&window, key);
            QCOMPARE(compare->mode(), mode);
        }
        Q_EMIT window.resultPanel()->compareWanted({window.desk()->history()->entries().back().key});
        QTRY_VERIFY(compare->items().front().label.contains(QStringLiteral("exemplar")));
        QCOMPARE(compare->pictures(), 2);
    }

    void tryAllFillsTheGridAndOneIsTakenOver() {
        MainWindow window;
        window.resize(1200, 900);
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        window.inspector()->output()->setOutputSize({48, 48});
        auto* const hint = window.findChild<MethodHint*>();
        QTRY_VERIFY(!hint->order().empty());
        trigger(window, "tryAll");
        CompareView* const compare = window.compare();
        QTRY_COMPARE(compare->items().size(), triedMethods() + 1);
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string title = findMethod(hint->order()[i]).info().title;
            QVERIFY2(compare->items()[i + 1].label.startsWith(QString::fromStdString(title)),
                     qPrintable(compare->items()[i + 1].label));
        }
        const JobQueue* const queue = window.desk()->queue();
        QTRY_VERIFY_WITH_TIMEOUT(queue->current() == nullptr && queue->waiting() == 0, kTriesPatience);
        std::string random;
        for (std::size_t i = 1; i < compare->items().size(); ++i) {
            const CompareItem& item = compare->items()[i];
            QVERIFY2(item.key.empty() ? item.message.size() > 20 : item.picture != nullptr,
                     qPrintable(item.label + item.message));
            QCOMPARE(item.figures.contains(QStringLiteral("<tr>")), !item.key.empty());
            if (item.label.startsWith(QStringLiteral("Random phase")))
                random = item.key;
        }
        QVERIFY(!random.empty());
        Q_EMIT compare->useWanted(random);
        QCOMPARE(window.inspector()->method()->id(), std::string("random-phase"));
        QVERIFY((window.inspector()->output()->outputSize() == Size{48, 48}));
    }

    void hintNamesMethodsThatSuitAndAClickChoosesOne() {
        MainWindow window;
        window.resize(1200, 900);
        window.show();
        auto* const hint = window.findChild<MethodHint*>();
        QVERIFY(!hint->isVisible());
        QVERIFY(openAndFinish(window, m_exemplar));
        QTRY_VERIFY(hint->isVisible());
        const std::string first = hint->order().front();
        QVERIFY(hint->text().contains(QString::fromStdString(findMethod(first).info().title)));
        Q_EMIT hint->linkActivated(QString::fromStdString(first));
        QCOMPARE(window.inspector()->method()->id(), first);
    }

    void sweepMakesEveryCombination() {
        MainWindow window;
        window.resize(1200, 900);
        window.show();
        QVERIFY(openAndFinish(window, m_exemplar));
        window.inspector()->output()->setOutputSize({40, 40});
        JobQueue* const queue = window.desk()->queue();
        queue->setPaused(true);
        trigger(window, "sweep");
        auto* dialog = child<SweepDialog>(window, "sweepDialog");
        auto* values = child<QLineEdit>(*dialog, "sweepAcrossValues");
        auto* start = child<QPushButton>(*dialog, "sweepStart");
        values->setText(QStringLiteral("8, oak"));
        QVERIFY(!start->isEnabled());
        QVERIFY(child<QLabel>(*dialog, "sweepSaid")->text().contains(QStringLiteral("oak")));
        values->setText(QStringLiteral("8, 10:12:2"));
        auto* down = child<QComboBox>(*dialog, "sweepDown");
        down->setCurrentIndex(down->findText(QStringLiteral("Seed")));
        child<QLineEdit>(*dialog, "sweepDownValues")->setText(QStringLiteral("5, 6"));
        QCOMPARE(child<QLabel>(*dialog, "sweepSaid")->text(), QStringLiteral("6 runs"));
        start->click();
        QTRY_COMPARE(queue->waiting(), 6);
        const CompareView* const compare = window.compare();
        QCOMPARE(compare->columns(), 3);
        QCOMPARE(compare->items()[4].label, QStringLiteral("Patch size 10 px · Seed 6"));
        const int before = window.desk()->history()->rowCount();
        queue->setPaused(false);
        QTRY_COMPARE_WITH_TIMEOUT(window.desk()->history()->rowCount(), before + 6, kTriesPatience);
        QCOMPARE(compare->pictures(), 6);
        const ResultEntry* const made = window.desk()->history()->find(compare->items()[4].key);
        QCOMPARE(made->recipe.seed, 6U);
        QCOMPARE(std::get<int>(made->recipe.steps.front().parameters.at("patch")), 10);
    }

private:
    QTemporaryDir m_folder;
    QString m_exemplar;
};

TEXLOOM_UI_TESTS(CompareTest)
#include "compare_test.moc"
