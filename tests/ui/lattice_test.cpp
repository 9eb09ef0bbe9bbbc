#include "core/analysis/lattice_values.h"
#include "core/io/image_file.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/lattice/candidate_table.h"
#include "ui/lattice/lattice_previews.h"
#include "ui/lattice/lattice_tool.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>

#include <map>

using namespace texloom;
using namespace texloom::ui;

namespace {

const Lattice kBricks{{40.5, 0}, {20.25, 21}};

bool near(const Lattice& a, const Lattice& b, double tolerance) {
    return (a.v1 - b.v1).length() < tolerance && (a.v2 - b.v2).length() < tolerance;
}

double number(const MainWindow& window, const char* name) {
    return std::get<double>(window.inspector()->values().at(name));
}

/// The window with the lattice of a texture found and shown.
bool openLattice(MainWindow& window, const QString& path) {
    window.show();
    if (!openAndFinish(window, path))
        return false;
    trigger(window, "lattice");
    return QTest::qWaitFor([&] { return window.lattice()->analysis() != nullptr; }, kPatience);
}

} // namespace

/// The workspace in which lattices are found, changed and given to the method.
class LatticeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_bricks = m_folder.filePath(QStringLiteral("bricks.png"));
        writeImage(toPath(m_bricks), test::regularTexture({220, 200}, 3, kBricks, {.noise = 0.05}, 3), {});
        m_grain = m_folder.filePath(QStringLiteral("grain.png"));
        writeImage(toPath(m_grain), test::noise({96, 80}, 3, 4), {});
    }

    void latticeIsFoundShownAndGivenToTheMethod() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        const LatticeTool& tool = *window.lattice();
        QVERIFY(tool.isVisible());
        QVERIFY(tool.analysis()->found());
        QVERIFY(tool.lattice().has_value());
        QVERIFY(tool.lattice()->like(kBricks, 0.5));
        QVERIFY(tool.canvas()->picture() == window.store()->current()->picture);
        QVERIFY(tool.correlationCanvas()->picture());
        QCOMPARE(child<QTableWidget>(tool, "latticeCandidates")->rowCount(),
                 static_cast<int>(tool.analysis()->candidates.size()));
        QVERIFY2(tool.useText().contains(QStringLiteral("follows no lattice")), qPrintable(tool.useText()));

        child<QPushButton>(tool, "useLattice")->click();
        QCOMPARE(window.inspector()->method()->id(), std::string("near-regular"));
        const auto given = givenLattice(window.inspector()->method()->params(), window.inspector()->values());
        QVERIFY(given && *given == *tool.lattice());
        QCOMPARE(number(window, "origin-x"), 0.0);
        QVERIFY2(tool.useText().contains(QStringLiteral("uses this lattice")), qPrintable(tool.useText()));

        QSignalSpy finished(window.desk()->controller(), &RunController::finished);
        window.startRun(true);
        QVERIFY(finished.wait(kPatience));
        const auto& figures = window.desk()->result()->synthesis.figures;
        const auto right = std::find_if(figures.begin(), figures.end(), [](const Figure& figure) {
            return figure.name == "Lattice, first vector right";
        });
        QVERIFY(right != figures.end());
        QVERIFY(std::abs(right->value - given->reduced().v1.x) < 1e-9);
        window.inspector()->resetAll();
        QVERIFY2(tool.useText().contains(QStringLiteral("by itself")), qPrintable(tool.useText()));
    }

    void everyCandidateShowsTheResultThatItGives() {
        MainWindow window;
        std::map<int, std::shared_ptr<const DisplayPicture>> made;
        connect(window.lattice()->findChild<LatticePreviews*>(), &LatticePreviews::made, this,
                [&](int row, const std::shared_ptr<const DisplayPicture>& picture) { made[row] = picture; });
        QVERIFY(openLattice(window, m_bricks));
        const LatticeTool& tool = *window.lattice();
        const auto& candidates = tool.analysis()->candidates;
        QVERIFY(candidates.size() > 1);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), candidates.size(), kPatience);
        auto* const table = child<QTableWidget>(tool, "latticeCandidates");
        for (int row = 0; row < table->rowCount(); ++row)
            QVERIFY(!table->item(row, CandidateTable::Result)->icon().isNull());
        // What was made with the right lattice has it, and a wrong one gives something else.
        const LatticeAnalysis ofFirst = analyzeLattice(made[0]->values());
        QVERIFY(ofFirst.found());
        QVERIFY(ofFirst.candidates.front().lattice.like(kBricks, 1));
        QVERIFY(made[1]->image() != made[0]->image());

        const std::shared_ptr<const DisplayPicture> blocks = made[0];
        made.clear();
        auto* const method = child<QComboBox>(window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("regular-tile")));
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), candidates.size(), kPatience);
        QVERIFY2(made[0]->image() != blocks->image(), "the method that would use it makes it");
    }

    void previewsLoseNoLattice() {
        for (const Size exemplar : {Size{64, 64}, Size{220, 200}, Size{4096, 1024}, Size{8192, 8192}})
            for (const double large : {8.0, 40.0, 300.0, 2000.0})
                for (const double small : {4.0, 11.0, 90.0}) {
                    const std::vector<Lattice> lattices = {
                        {{large, 0}, {large / 2, large}}, {{small, 1}, {0, small}}, {{1, 0}, {0, small}}};
                    if (2 * large > exemplar.shorterSide() || small > large)
                        continue;
                    const LatticePreviewFrame frame = previewFrame(exemplar, lattices);
                    QVERIFY(frame.part.within(exemplar));
                    QVERIFY(frame.scale <= 1 && frame.output.longerSide() <= 256);
                    QVERIFY(frame.scale * small >= std::min(small, 5.0) - 1e-9);
                    QVERIFY(frame.part.size.shorterSide() >=
                            std::min<double>(2 * large, exemplar.shorterSide()) - 1);
                }
    }

    void whatDecidesBetweenLatticesCanBeChangedAndUndone() {
        MainWindow window;
        const QString squares = m_folder.filePath(QStringLiteral("squares.png"));
        writeImage(toPath(squares), test::nearlyAlikeSquares(), {});
        QVERIFY(openLattice(window, squares));
        const LatticeTool& tool = *window.lattice();
        const auto area = [&] { return std::lround(tool.lattice()->area() / 256); };
        QCOMPARE(area(), 2);
        child<QToolButton>(tool, "latticeAdvanced")->click();
        auto* const alpha = child<QWidget>(tool, "alphaEditor")->findChild<QDoubleSpinBox*>();
        QVERIFY(alpha->isVisible());
        alpha->setFocus();
        alpha->selectAll();
        QTest::keyClicks(alpha, QLocale().toString(1.4));
        QTest::keyClick(alpha, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(area(), 1, kPatience);
        QCOMPARE(tool.analysis()->criteria.alpha, 1.4);
        child<QAction>(window, "undo")->trigger();
        QCOMPARE(alpha->value(), 1.12);
        QTRY_COMPARE_WITH_TIMEOUT(tool.analysis()->criteria.alpha, 1.12, kPatience);
        QCOMPARE(area(), 2);
        child<QAction>(window, "redo")->trigger();
        QCOMPARE(alpha->value(), 1.4);
        QTRY_COMPARE_WITH_TIMEOUT(area(), 1, kPatience);
        // What was drawn by hand stays whatever is found.
        child<QDoubleSpinBox>(tool, "latticeV1x")->setValue(31);
        const Lattice drawn = *tool.lattice();
        alpha->setValue(1.5);
        QTRY_COMPARE_WITH_TIMEOUT(tool.analysis()->criteria.alpha, 1.5, kPatience);
        QVERIFY(*tool.lattice() == drawn);
    }

    void handlesMoveByKeysMouseAndNumbers() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        LatticeCanvas* const canvas = tool.canvas();
        const Lattice found = *tool.lattice();
        const auto field = [&](const char* name) { return child<QDoubleSpinBox>(tool, name); };
        field("latticeV1x")->setValue(40);
        field("latticeV1y")->setValue(0);
        QTest::keyClick(canvas, Qt::Key_Space);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::Origin);
        QTest::keyClick(canvas, Qt::Key_Space);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::First);
        QVERIFY(tool.correlationCanvas()->handle() == LatticeCanvas::Handle::First);
        QTest::keyClick(canvas, Qt::Key_Right);
        QTest::keyClick(canvas, Qt::Key_Down, Qt::ShiftModifier);
        QTest::keyClick(canvas, Qt::Key_Left, Qt::ControlModifier);
        QVERIFY((tool.lattice()->v1 - Vec2{40.9, 10}).length() < 1e-6);
        QCOMPARE(field("latticeV1x")->value(), 40.9);

        canvas->fit();
        const Vec2 from = canvas->placeOf(LatticeCanvas::Handle::Second);
        const auto point = [&](Vec2 p) { return canvas->view().toWidget({p.x, p.y}).toPoint(); };
        const Vec2 way{2, 1};
        QTest::mousePress(canvas, Qt::LeftButton, {}, point(from));
        const Lattice before = *tool.lattice();
        QTest::mouseMove(canvas, point(from + way));
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, point(from + way));
        QVERIFY((tool.lattice()->v2 - before.v2 - way).length() < 1.5 / canvas->view().scale());
        QVERIFY(tool.lattice()->v1 == before.v1);
        QVERIFY(*tool.correlationCanvas()->lattice() == *tool.lattice());

        field("latticeV1y")->setValue(1);
        QTRY_VERIFY(tool.verdict().startsWith(QStringLiteral("Set by hand")));
        const QString ofWrong = tool.verdict();
        child<QPushButton>(tool, "fitLattice")->click();
        QTRY_VERIFY(tool.lattice()->like(kBricks, 0.5));
        QTRY_VERIFY(tool.verdict() != ofWrong && tool.verdict().startsWith(QStringLiteral("Set by hand")));

        const Lattice fitted = *tool.lattice();
        auto* const undo = child<QAction>(window, "undo");
        while (undo->isEnabled() && !(*tool.lattice() == found))
            undo->trigger(); // what follows closely is one step
        QVERIFY(*tool.lattice() == found);
        QVERIFY(tool.verdict().contains(QStringLiteral("confidence")));
        auto* const redo = child<QAction>(window, "redo");
        while (redo->isEnabled())
            redo->trigger();
        QVERIFY(*tool.lattice() == fitted);
    }

    void aMovedOriginIsWhereTheResultBegins() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        const Lattice lattice = *tool.lattice();
        tool.canvas()->setHandle(LatticeCanvas::Handle::Origin);
        QTest::keyClick(tool.canvas(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(*tool.lattice() == lattice);
        child<QPushButton>(tool, "useLattice")->click();
        const Vec2 given{number(window, "origin-x"), number(window, "origin-y")};
        const Vec2 phase = lattice.coordinates(tool.canvas()->origin() - given);
        QVERIFY(std::abs(phase.x - std::round(phase.x)) < 1e-6);
        QVERIFY(std::abs(phase.y - std::round(phase.y)) < 1e-6);
        QVERIFY(given.length() > 5);
    }

    void aGivenLatticeStaysWithItsExemplar() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        const LatticeTool& tool = *window.lattice();
        child<QPushButton>(tool, "useLattice")->click();
        const auto given = [&] {
            return givenLattice(window.inspector()->method()->params(), window.inspector()->values());
        };
        QVERIFY(given());
        const int bricks = window.store()->current()->id;
        window.openFiles({m_grain});
        QTRY_VERIFY(window.store()->current()->id != bricks);
        QVERIFY(!given());
        QTRY_VERIFY_WITH_TIMEOUT(tool.analysis(), kPatience);
        QVERIFY(!tool.lattice() || !tool.lattice()->like(kBricks, 0.5));
        window.store()->setCurrent(bricks);
        QVERIFY(given() && given()->like(kBricks, 0.5));
        QVERIFY(tool.lattice() && *tool.lattice() == *given());
    }

    void vectorsThatSpanNoTileAreRefusedInWords() {
        MainWindow window;
        QVERIFY(openLattice(window, m_bricks));
        LatticeTool& tool = *window.lattice();
        for (const char* name : {"latticeV2x", "latticeV2y"})
            child<QDoubleSpinBox>(tool, name)->setValue(0);
        QVERIFY2(tool.useText().contains(QStringLiteral("do not span a tile")), qPrintable(tool.useText()));
        QVERIFY(!child<QPushButton>(tool, "useLattice")->isEnabled());
        child<QTableWidget>(tool, "latticeCandidates")->setCurrentCell(-1, -1);
        child<QTableWidget>(tool, "latticeCandidates")->setCurrentCell(0, 0);
        QVERIFY(child<QPushButton>(tool, "useLattice")->isEnabled());
        QVERIFY(near(*tool.lattice(), tool.analysis()->candidates.front().lattice, 1e-9));
    }

    void rowsAreNamedAndUsedAsALattice() {
        MainWindow window;
        const QString courses = m_folder.filePath(QStringLiteral("courses.png"));
        writeImage(toPath(courses), test::coursesTexture({200, 180}, 3, {1, 0}, 30, {.colourChange = 0.3}, 3),
                   {});
        QVERIFY(openLattice(window, courses));
        const LatticeTool& tool = *window.lattice();
        QVERIFY2(tool.verdict().contains(QStringLiteral("in rows")), qPrintable(tool.verdict()));
        const auto* const table = child<QTableWidget>(tool, "latticeCandidates");
        QVERIFY(table->item(0, CandidateTable::Vectors)->text().startsWith(QStringLiteral("free")));
        // The handle of the free vector lies beside the origin, where it can be taken.
        LatticeCanvas* const canvas = tool.canvas();
        const QPointF origin = canvas->view().toWidget({canvas->origin().x, canvas->origin().y});
        const QPoint at = (origin + QPointF(canvas->fontMetrics().height() * 0.55 * 3, 0)).toPoint();
        QTest::mousePress(canvas, Qt::LeftButton, {}, at);
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, at);
        QVERIFY(canvas->handle() == LatticeCanvas::Handle::First);
        child<QPushButton>(tool, "useLattice")->click();
        QVERIFY2(tool.useText().contains(QStringLiteral("uses this lattice")), qPrintable(tool.useText()));
    }

    void withoutALatticeItSaysWhatWorks() {
        MainWindow window;
        QVERIFY(openLattice(window, m_grain));
        QVERIFY(!window.lattice()->analysis()->found());
        QVERIFY2(window.lattice()->verdict().contains(QStringLiteral("image quilting")),
                 qPrintable(window.lattice()->verdict()));
    }

private:
    QTemporaryDir m_folder;
    QString m_bricks;
    QString m_grain;
};

TEXLOOM_UI_TESTS(LatticeTest)
#include "lattice_test.moc"
