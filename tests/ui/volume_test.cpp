#include "core/base/error.h"
#include "tests/support/volumes.h"
#include "tests/ui/window_fixture.h"
#include "ui/viewers/image_viewer.h"
#include "ui/volume/slice_panel.h"

#include <QSignalSpy>
#include <QSpinBox>

#include <atomic>
#include <thread>

using namespace texloom;
using namespace texloom::test;
using namespace texloom::ui;

namespace {

/// Different everywhere, and not symmetric in its axes.
std::shared_ptr<const VolumeSource> endless() {
    return std::make_shared<FunctionSource>(
        [](std::int64_t x, std::int64_t y, std::int64_t z, int c) {
            return static_cast<double>((x * 7 + y * 131 + z * 1021 + c * 13) & 1023) / 1023;
        },
        3);
}

/// Waits for the slice and holds it against the one that core makes.
void compare(SlicePanel& panel, const VolumeSource& source, const Plane& plane, Size size) {
    QTRY_VERIFY(!panel.busy());
    QVERIFY2(panel.viewer()->picture(), qPrintable(panel.message()));
    TestContext context;
    QVERIFY(samePixels(panel.viewer()->picture()->values(), slice(source, plane, size, context)));
}

} // namespace

class VolumeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEndlessVolumeIsLookedAtFromItsOrigin() {
        const auto source = endless();
        SlicePanel panel;
        panel.setSource(source);
        QCOMPARE(panel.middle(), (std::array<int, 3>{0, 0, 0}));
        compare(panel, *source, axisPlane(Axis::Z, {-128, -128, 0}), {256, 256});
    }

    void scrollsIntoNegativeCoordinatesAlongEveryAxis() {
        const auto source = endless();
        SlicePanel panel;
        panel.setSource(source);
        panel.findChild<QSpinBox*>(QStringLiteral("sliceSide"))->setValue(64);
        panel.setMiddle(-1000, 20, -3);
        compare(panel, *source, axisPlane(Axis::Z, {-1032, -12, -3}), {64, 64});
        panel.setAxis(Axis::X);
        compare(panel, *source, axisPlane(Axis::X, {-1000, -12, -35}), {64, 64});
        panel.setAxis(Axis::Y);
        compare(panel, *source, axisPlane(Axis::Y, {-1032, 20, -35}), {64, 64});
    }

    void turnsAboutThePicturesMiddle() {
        const auto source = endless();
        SlicePanel panel;
        panel.setSource(source);
        panel.setMiddle(5, 6, -7);
        panel.setAngles(45, -10);
        QTRY_VERIFY(!panel.busy());
        const Plane plane = panel.plane();
        QVERIFY((plane.at(128, 128) - Eigen::Vector3d(5, 6, -7)).norm() < 1e-9);
        QVERIFY(std::abs(plane.right.x() - std::cos(M_PI / 4)) < 1e-9);
        compare(panel, *source, plane, {256, 256});
        panel.setAngles(0, 0);
        compare(panel, *source, axisPlane(Axis::Z, {-123, -122, -7}), {256, 256});
    }

    void keysStepThroughTheVolume() {
        const auto source = endless();
        SlicePanel panel;
        panel.setSource(source);
        panel.show();
        panel.viewer()->setFocus();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QTest::keyClick(panel.viewer(), Qt::Key_PageUp);
        QCOMPARE(panel.middle(), (std::array<int, 3>{0, 0, -1}));
        QTest::keyClick(panel.viewer(), Qt::Key_PageDown, Qt::ControlModifier);
        QCOMPARE(panel.middle(), (std::array<int, 3>{0, 0, 9}));
        QTest::keyClick(panel.viewer(), Qt::Key_Left, Qt::ControlModifier);
        QTest::keyClick(panel.viewer(), Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(panel.middle(), (std::array<int, 3>{-64, 64, 9}));
        panel.setAxis(Axis::X);
        QTest::keyClick(panel.viewer(), Qt::Key_PageDown);
        QCOMPARE(panel.middle(), (std::array<int, 3>{-63, 64, 9}));
        compare(panel, *source, axisPlane(Axis::X, {-63, -64, -119}), {256, 256});
    }

    void aVolumeThatEndsIsShownWhole() {
        const auto source =
            std::make_shared<DenseSource>(sampleVolume({40, 30, 20}, 1), DenseSource::Edge::Ends, -10, 0, 5);
        SlicePanel panel;
        panel.setSource(source);
        QCOMPARE(panel.middle(), (std::array<int, 3>{9, 14, 14}));
        QCOMPARE(panel.pictureSize(), (Size{40, 40}));
        compare(panel, *source, axisPlane(Axis::Z, {-11, -6, 14}), {40, 40});
        panel.setMiddle(0, 0, 100);
        QCOMPARE(panel.middle()[2], 24);
    }

    void aRefusalIsSaidInPlace() {
        class Broken : public VolumeSource {
            int channels() const override { return 1; }
            void fill(const Box&, Volume&, JobContext&) const override { fail("It is broken."); }
        };
        SlicePanel panel;
        panel.setSource(std::make_shared<Broken>());
        QTRY_COMPARE(panel.message(), QStringLiteral("It is broken."));
        QVERIFY(!panel.viewer()->picture());
        const auto source = endless();
        panel.setSource(source);
        compare(panel, *source, panel.plane(), panel.pictureSize());
        QVERIFY(panel.message().isEmpty());
        panel.setSource(nullptr);
        QVERIFY(!panel.viewer()->picture());
    }

    void aSlowVolumeHoldsNobodyUp() {
        class Slow : public VolumeSource {
        public:
            mutable std::atomic<int> waiting = 0;

        private:
            int channels() const override { return 1; }
            void fill(const Box& box, Volume& volume, JobContext& context) const override {
                ++waiting;
                while (box.z == 0) { // until it is called off
                    context.check();
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                volume(0, 0, 0, 0) = static_cast<float>(box.z);
            }
        };
        const auto source = std::make_shared<Slow>();
        SlicePanel panel;
        panel.setSource(source);
        QTRY_COMPARE(panel.viewer()->badge(), QStringLiteral("Making the slice…"));
        QVERIFY(panel.busy());
        panel.setMiddle(0, 0, 3);
        QTRY_VERIFY(!panel.busy());
        QCOMPARE(panel.viewer()->picture()->values()(0, 0, 0), 3.0F);
        QVERIFY(panel.viewer()->badge().isEmpty());
        panel.setMiddle(0, 0, 0);
        QTRY_VERIFY(source->waiting > 5); // and the panel may go while one is made
    }
};

TEXLOOM_UI_TESTS(VolumeTest)
#include "volume_test.moc"
