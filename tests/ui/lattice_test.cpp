#include "core/analysis/lattice_values.h"
#include "core/io/image_file.h"
#include "tests/support/lattices.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/lattice/lattice_tool.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr int kPatience = 60'000;
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
        QCOMPARE(child<QTableWidget>(tool, "latticeCandidates")->item(0, 0)->text(), QStringLiteral("free"));
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
