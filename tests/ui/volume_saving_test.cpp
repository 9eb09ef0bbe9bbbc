// What is written from the views of volumes, and what is refused.

#include "core/io/image_file.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/ui/volume_views.h"
#include "ui/common/text.h"
#include "ui/volume/box_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

#include <fstream>

using namespace texloom;
using namespace texloom::test;
using namespace texloom::ui;

class VolumeSavingTest : public VolumeViews {
    Q_OBJECT

private Q_SLOTS:
    void init() { showEndless(); }
    void cleanup() { m_page.reset(); }

    void slicesBoxesAndMeshesAreSavedWithTheRecipe() {
        QSignalSpy saved(m_page.get(), &VolumePage::saved);
        const auto file = [this](const char* name) { return m_folder.filePath(QLatin1String(name)); };
        SliceView& xy = *m_page->slice(Axis::Z);
        m_page->saveSlice(xy, file("seen.png"));
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 20000);
        QCOMPARE(QImage(file("seen.png")).size(), xy.size());
        QVERIFY(readImage(toPath(file("seen.png"))).info.recipe.find("seed") != std::string::npos);
        m_page->saveBox({-4, -3, -2, {6, 5, 4}}, file("box.json"));
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 2, 20000);
        TestContext context;
        const LoadedVolume box = readVolume(toPath(file("box.json")), context);
        QVERIFY(sameVoxels(box.source->volume(), m_source->sample({-4, -3, -2, {6, 5, 4}}, context)));
        m_page->saveBox({-4, -3, -2, {6, 5, 4}}, file("box.png"));
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 3, 20000);
        QVERIFY(QFile::exists(file("box-0003.png")));
        m_page->solid()->setView(SolidPanel::OnMesh);
        QTRY_VERIFY(m_page->solid()->placed().mesh);
        m_page->saveMesh(file("ball.ply"), 4);
        QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 4, 20000);
        QVERIFY(readMesh(toPath(file("ball.ply")), context).triangles.size() >
                m_page->solid()->placed().mesh->triangles.size());
        QVERIFY2(m_page->message().isEmpty(), qPrintable(m_page->message()));
    }

    void whatCannotBeDoneIsSaidAndNothingIsLost() {
        m_page->solid()->setView(SolidPanel::OnMesh);
        SolidView& view = *m_page->solid()->onMesh();
        QTRY_VERIFY(view.mesh());
        const auto mesh = view.mesh();
        const QString flat = m_folder.filePath(QStringLiteral("flat.obj"));
        std::ofstream(toPath(flat)) << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
        m_page->solid()->openMesh(flat);
        QTRY_VERIFY2(m_page->message().contains(QStringLiteral("flat.obj")), qPrintable(m_page->message()));
        QCOMPARE(view.mesh(), mesh);
        QCOMPARE(child<QComboBox>(*m_page, "solidShape")->currentIndex(), 1);

        m_page->saveBox({0, 0, 0, {10000, 10000, 10000}}, m_folder.filePath(QStringLiteral("huge.json")));
        QTRY_VERIFY2(m_page->message().contains(QStringLiteral("10000 × 10000 × 10000")),
                     qPrintable(m_page->message()));
        QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("huge.json"))));

        QSignalSpy refused(m_page.get(), &VolumePage::refused);
        m_page->openFile(m_folder.filePath(QStringLiteral("none.safetensors")));
        QTRY_COMPARE(refused.count(), 1);
        const QString other = QStringLiteral(TEXLOOM_RESOURCES "/descriptors/own.safetensors");
        m_page->openFile(other);
        QTRY_COMPARE(refused.count(), 2);
        QVERIFY2(m_page->message().contains(QStringLiteral("solid-generator")),
                 qPrintable(m_page->message()));
        QCOMPARE(m_page->volumes().size(), std::size_t{1});
        rest();
        compare(Axis::Z);
    }

    void theBoxToSaveSaysHowLargeItIs() {
        BoxDialog dialog({-5, 0, 3, {16, 16, 16}});
        QCOMPARE(dialog.box(), (Box{-5, 0, 3, {16, 16, 16}}));
        auto* verdict = child<QLabel>(dialog, "boxVerdict");
        QVERIFY(verdict->text().contains(QStringLiteral("4")));
        auto* save = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
        QVERIFY(save->isEnabled());
        for (const char* side : {"boxSide_x", "boxSide_y", "boxSide_z"})
            child<QSpinBox>(dialog, side)->setValue(10000);
        QVERIFY(!save->isEnabled());
        QVERIFY2(verdict->text().contains(QStringLiteral("10000 × 10000 × 10000")),
                 qPrintable(verdict->text()));
    }
};

TEXLOOM_UI_TESTS(VolumeSavingTest)
#include "volume_saving_test.moc"
