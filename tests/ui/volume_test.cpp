// The views of volumes: slices with one crosshair, an oblique slice, a block, a mesh.

#include "core/base/error.h"
#include "tests/ui/volume_views.h"
#include "ui/common/text.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QWheelEvent>

#include <atomic>
#include <cmath>
#include <fstream>
#include <thread>

using namespace texloom;
using namespace texloom::test;
using namespace texloom::ui;
using Eigen::Vector3d;

namespace {

/// The pixel of a view that a point in space is seen in.
QPoint pixelOf(const SliceView& view, const Vector3d& space) {
    const QPointF place = view.placeOf(space);
    return {static_cast<int>(std::floor(place.x())), static_cast<int>(std::floor(place.y()))};
}

} // namespace

class VolumeTest : public VolumeViews {
    Q_OBJECT

private Q_SLOTS:
    void init() { showEndless(); }
    void cleanup() { m_page.reset(); }

    void anEndlessVolumeIsLookedAtFromItsOrigin() {
        QCOMPARE(cross(), Vector3d(0, 0, 0));
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
            compare(axis);
        QCOMPARE(m_page->slice(Axis::Z)->title(), QStringLiteral("XY · z = 0"));
    }

    void slicesHaveTheVoxelsOfTheSourceAlsoAtNegativeCoordinates() {
        m_page->place()->setMiddle({-1000, -40, -333});
        m_page->place()->setCross({-1003, -45, -330});
        rest();
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
            compare(axis);
        const SliceView& xy = *m_page->slice(Axis::Z);
        const SliceView::Tile* tile = xy.tile(-16, -1); // x −1024 to −961, y −64 to −1
        QVERIFY(tile != nullptr);
        TestContext context;
        const Volume box = m_source->sample({-1024, -64, -330, {64, 64, 1}}, context);
        QCOMPARE(tile->values->values()(5, 6, 2), box(5, 6, 0, 2));
    }

    void whatIsPaintedIsTheVoxelUnderThePoint() {
        SliceView& xy = *m_page->slice(Axis::Z);
        const QPoint point(xy.width() / 2 + 37, xy.height() / 2 + 41);
        const Vector3d voxel = xy.spaceAt(point + QPointF(0.5, 0.5)).array().round();
        const QImage seen = xy.grab().toImage();
        TestContext context;
        const Box box{
            static_cast<std::int64_t>(voxel.x()), static_cast<std::int64_t>(voxel.y()), 0, {1, 1, 1}};
        const Volume value = m_source->sample(box, context);
        auto one = std::make_shared<Image>(Size{1, 1}, 3);
        for (int c = 0; c < 3; ++c)
            (*one)(0, 0, c) = value(0, 0, 0, c);
        QCOMPARE(seen.pixelColor(point).name(), DisplayPicture(one).image().pixelColor(0, 0).name());
    }

    void clickingInOneSliceMovesTheTwoOthers() {
        SliceView& xy = *m_page->slice(Axis::Z);
        QTest::mouseClick(&xy, Qt::LeftButton, Qt::NoModifier, pixelOf(xy, {30, -20, 0}));
        QCOMPARE(cross(), Vector3d(30, -20, 0));
        rest();
        QCOMPARE(m_page->slice(Axis::X)->title(), QStringLiteral("YZ · x = 30"));
        QCOMPARE(m_page->slice(Axis::Y)->title(), QStringLiteral("XZ · y = −20"));
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
            compare(axis);
        SliceView& yz = *m_page->slice(Axis::X);
        QTest::mouseClick(&yz, Qt::LeftButton, Qt::NoModifier, pixelOf(yz, {30, 11, 25}));
        QCOMPARE(cross(), Vector3d(30, 11, 25));
    }

    void linesOfTheCrosshairAreDragged() {
        SliceView& xz = *m_page->slice(Axis::Y);
        const QPoint line = pixelOf(xz, {0, 0, 40}); // on x = 0, away from the middle
        drag(xz, line, line + QPoint(25, 13));
        QCOMPARE(cross(), Vector3d(25, 0, 0));
        const QPoint middle = pixelOf(xz, cross());
        drag(xz, middle, middle + QPoint(5, 8));
        QCOMPARE(cross(), Vector3d(30, 0, 8));
    }

    void draggingElsewhereScrollsAllSlicesAlong() {
        SliceView& xy = *m_page->slice(Axis::Z);
        const QPoint from(20, 20);
        drag(xy, from, from + QPoint(70, 50));
        QCOMPARE(cross(), Vector3d(0, 0, 0));
        QCOMPARE(m_page->place()->middle(), Vector3d(-70, -50, 0));
        rest();
        for (const Axis axis : {Axis::X, Axis::Y, Axis::Z})
            compare(axis);
    }

    void keysDoWhatTheMouseDoes() {
        SliceView& xy = *m_page->slice(Axis::Z);
        xy.setFocus();
        QTest::keyClick(&xy, Qt::Key_PageDown);
        QCOMPARE(cross(), Vector3d(0, 0, 1));
        QTest::keyClick(&xy, Qt::Key_PageUp, Qt::ControlModifier);
        QCOMPARE(cross(), Vector3d(0, 0, -9));
        QTest::keyClick(&xy, Qt::Key_Left, Qt::ShiftModifier);
        QTest::keyClick(&xy, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(cross(), Vector3d(-1, 1, -9));
        QTest::keyClick(&xy, Qt::Key_Left);
        QVERIFY(m_page->place()->middle().x() < 0);
        QTest::keyClick(&xy, Qt::Key_F);
        QCOMPARE(m_page->place()->middle(), cross());
        QTest::keyClick(&xy, Qt::Key_Plus);
        QCOMPARE(m_page->place()->zoom(), 1.25);
        QTest::keyClick(&xy, Qt::Key_1);
        QCOMPARE(m_page->place()->zoom(), 1.0);
        SliceView& yz = *m_page->slice(Axis::X); // z to the right
        QTest::keyClick(&yz, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(cross(), Vector3d(-1, 1, -8));
        rest();
        compare(Axis::Z);
    }

    void coordinatesAreTypedIn() {
        child<QSpinBox>(*m_page, "sliceZ")->setValue(-512);
        QCOMPARE(cross(), Vector3d(0, 0, -512));
        QCOMPARE(m_page->place()->middle(), Vector3d(0, 0, -512));
        rest();
        compare(Axis::Z);
        QVERIFY2(m_page->readout().startsWith(QStringLiteral("x 0 · y 0 · z −512 · ")),
                 qPrintable(m_page->readout()));
    }

    void smallScalesTakeFewerVoxels() {
        m_page->place()->setZoom(0.25);
        rest();
        const SliceView& xy = *m_page->slice(Axis::Z);
        QVERIFY(xy.step() > 1);
        const SliceView::Tile* tile = xy.tile(-1, -1, xy.step());
        QVERIFY(tile != nullptr);
        TestContext context;
        const int x = -64 * xy.step() + 3 * xy.step(), y = -64 * xy.step() + 9 * xy.step();
        QCOMPARE(tile->values->values()(3, 9, 1),
                 m_source->sample({x, y, 0, {1, 1, 1}}, context)(0, 0, 0, 1));
        QWheelEvent wheel({5, 5}, m_page->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        SliceView& view = *m_page->slice(Axis::Z);
        const Vector3d before = view.spaceAt({5.5, 5.5}); // the middle of the pixel
        QCoreApplication::sendEvent(&view, &wheel);
        QVERIFY2((view.spaceAt({5.5, 5.5}) - before).norm() < 1e-9, "what is under the mouse stays there");
    }

    void theObliqueSliceGoesThroughTheCrosshairAtAnyAngle() {
        m_page->solid()->setView(SolidPanel::Oblique);
        SliceView& oblique = *m_page->solid()->oblique();
        QCOMPARE(m_page->place()->turn(), 45.0);
        m_page->place()->setCross({5, 6, -7});
        rest();
        QVERIFY((oblique.plane().at(0, 0) - Vector3d(5, 6, -7)).norm() < 1e-9);
        QVERIFY(std::abs(oblique.plane().right.x() - std::sqrt(0.5)) < 1e-9);
        compareOblique();
        child<QDoubleSpinBox>(*m_page, "sliceTilt")->setValue(-10);
        QCOMPARE(m_page->place()->tilt(), -10.0);
        rest();
        compareOblique();
        const double turn = m_page->place()->turn();
        drag(oblique, {40, 40}, {60, 30}, Qt::ShiftModifier);
        QVERIFY(m_page->place()->turn() != turn);
        QCOMPARE(child<QDoubleSpinBox>(*m_page, "sliceTurn")->value(), std::round(m_page->place()->turn()));
        m_page->place()->setAngles(0, 0);
        QTest::keyClick(&oblique, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(m_page->place()->turn(), 5.0);
        m_page->place()->setAngles(0, 0);
        rest();
        QCOMPARE(oblique.plane().right, Vector3d(1, 0, 0));
        // Slices agree where they meet.
        TestContext context;
        const Image values = texloom::slice(*m_source, oblique.plane(), {64, 64}, context);
        QVERIFY(samePixels(oblique.tile(0, 0)->values->values(), values));
    }

    void theBlockIsCutAtTheCrosshair() {
        SolidView& block = *m_page->solid()->block();
        QTRY_VERIFY_WITH_TIMEOUT(block.rested(), 20000);
        QVERIFY(!block.picture().isNull());
        const Box box = m_page->solid()->box();
        QCOMPARE(box, (Box{-48, -48, -48, {96, 96, 96}}));
        const QImage before = block.picture();
        m_page->place()->setCross({20, -10, 5});
        QTRY_VERIFY_WITH_TIMEOUT(block.rested() && block.picture() != before, 20000);
        QCOMPARE(m_page->solid()->box(), box);
        m_page->place()->setCross({200, -10, 5});
        QCOMPARE(m_page->solid()->box(), (Box{152, -58, -43, {96, 96, 96}}));
        const Vector3d at = cross();
        block.setFocus();
        QTest::keyClick(&block, Qt::Key_Down, Qt::ControlModifier);
        QVERIFY2(cross() != at, "the cut moved");
        QVERIFY(cross().y() >= at.y());
        const float turn = block.look().camera.turn;
        QTest::keyClick(&block, Qt::Key_Left);
        QVERIFY(block.look().camera.turn != turn);
        auto* cut = child<QComboBox>(*m_page, "blockCut");
        const std::size_t triangles = block.mesh()->mesh.triangles.size();
        cut->setCurrentIndex(0);
        QCOMPARE(block.mesh()->mesh.triangles.size(), std::size_t{12});
        QVERIFY(triangles > 12);
    }

    void aMeshTakesItsColoursFromTheVolume() {
        m_page->solid()->setView(SolidPanel::OnMesh);
        SolidView& view = *m_page->solid()->onMesh();
        QTRY_VERIFY_WITH_TIMEOUT(view.rested() && !view.picture().isNull(), 20000);
        const QImage first = view.picture();
        child<QSpinBox>(*m_page, "solidScale")->setValue(64);
        QTRY_VERIFY_WITH_TIMEOUT(view.rested() && view.picture() != first, 20000);
        child<QDoubleSpinBox>(*m_page, "solidAngle_y")->setValue(30);
        QVERIFY(std::abs(view.placement().angles.y() - M_PI / 6) < 1e-9);
        const Vector3d offset = view.placement().offset;
        QTest::keyClick(&view, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY((view.placement().offset - offset).norm() > 0.5);
        m_page->solid()->openMesh(roof());
        const auto before = view.mesh();
        QTRY_VERIFY(view.mesh() != before);
        QCOMPARE(m_page->solid()->placed().mesh->triangles.size(), std::size_t{4});
        // What is drawn and what is written lie alike in the volume.
        const PlacedMesh placed = m_page->solid()->placed();
        const Mesh::Bounds bounds = placed.mesh->bounds();
        const Eigen::Vector3f middle = (bounds.lowest + bounds.highest) / 2;
        QVERIFY((placed.placement.at(middle.cast<double>()) - view.placement().offset).norm() < 1e-4);
        QTRY_VERIFY_WITH_TIMEOUT(view.rested(), 20000);
        QVERIFY2(m_page->message().isEmpty(), qPrintable(m_page->message()));
    }

    void aVolumeThatEndsIsShownWhereItIs() {
        const auto source =
            std::make_shared<DenseSource>(sampleVolume({40, 30, 20}, 1), DenseSource::Edge::Ends, -10, 0, 5);
        m_page->setVolumes({named(QStringLiteral("block"), source)});
        rest();
        QCOMPARE(cross(), Vector3d(9, 14, 14));
        m_page->place()->setCross({0, 0, 100});
        QCOMPARE(cross(), Vector3d(0, 0, 24));
        rest();
        const SliceView& xy = *m_page->slice(Axis::Z);
        const QImage& tile = xy.tile(-1, 0)->picture; // x −64 to −1
        QCOMPARE(qAlpha(tile.pixel(53, 3)), 0);
        QCOMPARE(qAlpha(tile.pixel(54, 3)), 255);
        QCOMPARE(qAlpha(tile.pixel(60, 30)), 0);
        QVERIFY2(m_page->message().isEmpty(), qPrintable(m_page->message()));
        QCOMPARE(m_page->solid()->box(), *source->bounds());
    }

    void everyVolumeOfAResultCanBeChosen() {
        const auto second =
            std::make_shared<DenseSource>(sampleVolume({8, 8, 8}, 1), DenseSource::Edge::Repeats);
        auto* choice = child<QComboBox>(*m_page, "volumeChoice");
        QVERIFY(!choice->isVisible());
        m_page->setVolumes(
            {named(QStringLiteral("first"), m_source), named(QStringLiteral("second"), second)});
        QVERIFY(choice->isVisible());
        QCOMPARE(choice->count(), 2);
        m_page->place()->setCross({3, 4, 5});
        choice->setCurrentIndex(1);
        rest();
        QCOMPARE(cross(), Vector3d(0, 0, 0));
        TestContext context;
        QVERIFY(samePixels(m_page->slice(Axis::Z)->tile(0, 0)->values->values(),
                           texloom::slice(*second, axisPlane(Axis::Z, {0, 0, 0}), {64, 64}, context)));
        m_page->setVolumes({});
        QVERIFY(m_page->empty());
    }

    void oneViewMayHaveAllTheRoom() {
        SliceView& xy = *m_page->slice(Axis::Z);
        const int before = xy.width();
        xy.setFocus();
        QTest::keyClick(&xy, Qt::Key_Return);
        settle();
        QVERIFY(!m_page->slice(Axis::X)->isVisible());
        QVERIFY(xy.width() > before * 3 / 2);
        child<QToolButton>(*m_page, "volumeAll")->click();
        settle();
        QVERIFY(m_page->slice(Axis::X)->isVisible() && m_page->solid()->isVisible());
    }

    void aRefusalIsSaidInPlace() {
        class Broken : public VolumeSource {
            int channels() const override { return 1; }
            void fill(const Box&, Volume&, JobContext&) const override { fail("It is broken."); }
        };
        m_page->setVolumes({named(QStringLiteral("broken"), std::make_shared<Broken>())});
        QTRY_COMPARE(m_page->message(), QStringLiteral("It is broken."));
        m_page->setVolumes({named(QStringLiteral("solid"), m_source)});
        rest();
        QVERIFY(m_page->message().isEmpty());
        compare(Axis::Z);
    }

    void aSlowVolumeHoldsNobodyUp() {
        class Slow : public VolumeSource {
        public:
            mutable std::atomic<int> waiting = 0;

        private:
            int channels() const override { return 1; }
            void fill(const Box& box, Volume& volume, JobContext& context) const override {
                ++waiting;
                while (box.z <= 0 && box.endZ() > 0) { // until it is called off
                    context.check();
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                volume(0, 0, 0, 0) = static_cast<float>(box.z);
            }
        };
        const auto source = std::make_shared<Slow>();
        m_page->setVolumes({named(QStringLiteral("slow"), source)});
        SliceView& xy = *m_page->slice(Axis::Z);
        QTRY_VERIFY(source->waiting > 0);
        QVERIFY(xy.busy());
        m_page->place()->setMiddle({0, 0, 3});
        m_page->place()->setCross({0, 0, 3});
        QTRY_VERIFY_WITH_TIMEOUT(!xy.busy(), 20000);
        QCOMPARE(xy.tile(0, 0)->values->values()(0, 0, 0), 3.0F);
        m_page->place()->setCross({0, 0, 0}); // and the page may go while one is made
    }

private:
    QString roof() const {
        const QString path = m_folder.filePath(QStringLiteral("roof.obj"));
        std::ofstream(toPath(path))
            << "v 10 0 0\nv 13 0 0\nv 10.5 1 0\nv 10.5 0.4 -1\nf 1 2 3\nf 2 4 3\nf 4 1 3\nf 1 4 2\n";
        return path;
    }

    static void drag(QWidget& widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
        const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons held) {
            QMouseEvent event(type, at, widget.mapToGlobal(at), button, held, modifiers);
            QCoreApplication::sendEvent(&widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
};

TEXLOOM_UI_TESTS(VolumeTest)
#include "volume_test.moc"
