// The tab that shows results as lit materials.

#include "core/io/image_file.h"
#include "core/volume/mesh_file.h"
#include "tests/support/time_limit.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/text.h"
#include "ui/maps/result_view.h"
#include "ui/material/material_page.h"
#include "ui/material/material_view.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QSpinBox>
#include <QWheelEvent>

#include <cmath>
#include <fstream>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// Steep stripes, so that a normal map has something to show.
Image stripedNormals(Size size) {
    Image normals(size, 3);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            normals(x, y, 0) = x % 16 < 8 ? 0.2F : 0.8F;
            normals(x, y, 1) = 0.5F;
            normals(x, y, 2) = 0.9F;
        }
    return normals;
}

} // namespace

class MaterialTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        qputenv("TEXLOOM_RESOURCES", TEXLOOM_RESOURCES);
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1366, 768);
        m_window->show();
        const QString path = writeTexture(m_folder, QStringLiteral("felt_albedo.png"), {96, 96});
        writeImage(toPath(m_folder.filePath(QStringLiteral("felt_normal_gl.png"))), stripedNormals({96, 96}),
                   {});
        QVERIFY(openAndFinish(*m_window, path));
        m_page = child<MaterialPage>(*m_window, "materialPage");
        m_window->results()->showPage(m_page);
        QTRY_VERIFY_WITH_TIMEOUT(view()->rested(), 20000);
    }

    void cleanupTestCase() { m_window.reset(); }

    void init() {
        view()->setLook({});
        QTRY_VERIFY_WITH_TIMEOUT(view()->rested(), 20000);
    }

    void theResultIsShownLit() {
        QVERIFY(view()->material());
        QCOMPARE(view()->picture().size(), view()->size() * view()->devicePixelRatioF());
        look("material");
    }

    void eachShapeAndLightIsAnotherPicture() {
        auto* shapes = child<QComboBox>(*m_page, "materialShape");
        auto* lights = child<QComboBox>(*m_page, "materialLight");
        QVERIFY2(lights->count() >= 5, "the bundled panoramas are offered");
        QList<QImage> seen;
        for (int shape = 0; shape + 1 < shapes->count(); ++shape) {
            choose(shapes, shape);
            QVERIFY2(!seen.contains(view()->picture()), qPrintable(shapes->currentText()));
            seen += view()->picture();
            look(qPrintable(QStringLiteral("material-shape-%1").arg(shape)));
        }
        for (int light = 1; light + 1 < lights->count(); ++light) {
            choose(lights, light);
            QVERIFY2(!seen.contains(view()->picture()), qPrintable(lights->currentText()));
            seen += view()->picture();
        }
        QVERIFY2(m_page->message().isEmpty(), qPrintable(m_page->message()));
        choose(lights, 0);
        choose(shapes, 1);
    }

    void keysTurnComeNearerAndShowMapsAlone() {
        view()->setFocus();
        const Look before = view()->look();
        QTest::keyClick(view(), Qt::Key_Left);
        QVERIFY(view()->look().camera.turn > before.camera.turn);
        QTest::keyClick(view(), Qt::Key_Up);
        QVERIFY(view()->look().camera.rise < before.camera.rise);
        QTest::keyClick(view(), Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(view()->look().lightTurn > before.lightTurn);
        QTest::keyClick(view(), Qt::Key_Plus);
        QVERIFY(view()->look().camera.distance < before.camera.distance);
        QTest::keyClick(view(), Qt::Key_C);
        QCOMPARE(view()->look().shown, Shown::Color);
        QCOMPARE(child<QComboBox>(*m_page, "materialShown")->currentIndex(), 1);
        QTest::keyClick(view(), Qt::Key_M);
        QCOMPARE(view()->look().shown, Shown::Lit);
        QTest::keyClick(view(), Qt::Key_R);
        QCOMPARE(view()->look().camera.turn, before.camera.turn);
        QCOMPARE(view()->look().lightTurn, 0.0F);
    }

    void theMouseDoesTheSame() {
        const Look before = view()->look();
        drag(Qt::LeftButton, Qt::NoModifier);
        QVERIFY(view()->look().camera.turn != before.camera.turn);
        QCOMPARE(view()->look().lightTurn, before.lightTurn);
        drag(Qt::MiddleButton, Qt::NoModifier);
        QVERIFY(view()->look().camera.target != before.camera.target);
        drag(Qt::RightButton, Qt::ShiftModifier);
        QVERIFY(view()->look().lightTurn != before.lightTurn);
        QWheelEvent wheel(view()->rect().center(), view()->mapToGlobal(view()->rect().center()), {}, {0, 120},
                          Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(view(), &wheel);
        QVERIFY(view()->look().camera.distance < before.camera.distance);
    }

    void fieldsSayHowItIsShown() {
        child<QSpinBox>(*m_page, "materialRepeat")->setValue(3);
        QCOMPARE(view()->look().repeat, 3.0F);
        child<QDoubleSpinBox>(*m_page, "materialExposure")->setValue(-1);
        QCOMPARE(view()->look().exposure, -1.0F);
        child<QDoubleSpinBox>(*m_page, "materialLightTurn")->setValue(90);
        QVERIFY(std::abs(view()->look().lightTurn - static_cast<float>(M_PI / 2)) < 1e-5F);
        child<QDoubleSpinBox>(*m_page, "materialRelief")->setValue(10);
        QVERIFY(std::abs(view()->look().relief - 0.1F) < 1e-6F);
        MaterialPage again;
        QCOMPARE(again.view()->look().repeat, 3.0F); // kept for the next start
        child<QSpinBox>(*m_page, "materialRepeat")->setValue(1);
        child<QDoubleSpinBox>(*m_page, "materialExposure")->setValue(0);
        child<QDoubleSpinBox>(*m_page, "materialRelief")->setValue(0);
    }

    void aMeshWithoutPlacesInATextureIsShown() {
        const QString path = m_folder.filePath(QStringLiteral("roof.obj"));
        std::ofstream(toPath(path))
            << "v 0 0 0\nv 1 0 0\nv 0.5 1 0\nv 0.5 0.4 -1\nf 1 2 3\nf 2 4 3\nf 4 1 3\nf 1 4 2\n";
        const auto before = view()->mesh();
        m_page->openMesh(path);
        QTRY_VERIFY(view()->mesh() != before);
        QCOMPARE(view()->mesh()->mesh.triangles.size(), std::size_t{4});
        QTRY_VERIFY(view()->rested());
        QVERIFY2(m_page->message().isEmpty(), qPrintable(m_page->message()));
    }

    void whatCannotBeOpenedIsSaidAndNothingIsLost() {
        const auto mesh = view()->mesh();
        const auto light = view()->light();
        m_page->openMesh(m_folder.filePath(QStringLiteral("none.obj")));
        QTRY_VERIFY(!m_page->message().isEmpty());
        QVERIFY(m_page->message().contains(QStringLiteral("none.obj")));
        QCOMPARE(view()->mesh(), mesh);
        m_page->openPanorama(m_folder.filePath(QStringLiteral("felt_none.exr")));
        QTRY_VERIFY(m_page->message().contains(QStringLiteral("felt_none.exr")));
        QCOMPARE(view()->light(), light);
    }

    void picturesAndTurnsAreWritten() {
        QSignalSpy saved(m_page, &MaterialPage::saved);
        const QString file = m_folder.filePath(QStringLiteral("seen.png"));
        m_page->savePicture(file);
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 60000);
        QCOMPARE(QImage(file).width(), view()->width());
        QDir(m_folder.path()).mkdir(QStringLiteral("turn"));
        const QString folder = m_folder.filePath(QStringLiteral("turn"));
        m_page->saveTurntable(folder, 4, 64);
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 2, 60000);
        QCOMPARE(QDir(folder).entryList(QDir::Files).size(), 4);
        QVERIFY(QImage(folder + QStringLiteral("/turn_0000.png")) !=
                QImage(folder + QStringLiteral("/turn_0002.png")));
        m_page->saveTurntable(folder, 4, 64);
        QTRY_VERIFY(m_page->message().contains(QStringLiteral("turn_0000.png")));
    }

    void draggingIsFluent() {
        QElapsedTimer timer;
        timer.start();
        constexpr int kFrames = 10;
        QSignalSpy drawn(view(), &MaterialView::drawn);
        for (int i = 0; i < kFrames; ++i) {
            Look turned = view()->look();
            turned.camera.turn += 0.05F;
            view()->setLook(turned);
            QTRY_VERIFY(drawn.count() > i);
        }
        qInfo("%.0f ms a frame while dragging", static_cast<double>(timer.elapsed()) / kFrames);
    }

private:
    MaterialView* view() const { return m_page->view(); }

    void choose(QComboBox* box, int index) {
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
        QTRY_VERIFY_WITH_TIMEOUT(!view()->rested(), 5000);
        QTRY_VERIFY_WITH_TIMEOUT(view()->rested(), 20000);
    }

    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        const QPoint from = view()->rect().center();
        QMouseEvent press(QEvent::MouseButtonPress, from, view()->mapToGlobal(from), button, button,
                          modifiers);
        QCoreApplication::sendEvent(view(), &press);
        const QPoint to = from + QPoint(30, 20);
        QMouseEvent move(QEvent::MouseMove, to, view()->mapToGlobal(to), Qt::NoButton, button, modifiers);
        QCoreApplication::sendEvent(view(), &move);
    }

    void look(const char* name) const {
        if (const QString folder = qEnvironmentVariable("TEXLOOM_LOOK"); !folder.isEmpty())
            m_window->grab().save(QStringLiteral("%1/%2.png").arg(folder, QLatin1String(name)));
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    MaterialPage* m_page = nullptr;
};

TEXLOOM_UI_TESTS(MaterialTest)
#include "material_test.moc"
