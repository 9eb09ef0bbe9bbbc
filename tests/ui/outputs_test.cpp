// What methods take and give beside pictures, in the window.

#include "core/io/model_file.h"
#include "core/session/export/output_files.h"
#include "core/volume/slice.h"
#include "core/volume/volume_file.h"
#include "tests/support/volumes.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/exemplar/files.h"
#include "ui/export/export_dialog.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_row.h"
#include "ui/maps/result_view.h"
#include "ui/plots/figures_panel.h"
#include "ui/runs/result_text.h"
#include "ui/viewers/image_viewer.h"
#include "ui/volume/slice_view.h"
#include "ui/volume/volume_page.h"
#include "ui/window/drop_targets.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

using namespace texloom;
using namespace texloom::test;
using namespace texloom::ui;

class OutputsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("felt.png"), {48, 48})));
    }

    void cleanupTestCase() { m_window.reset(); }

    void aVolumeIsShownInATabOfItsOwn() {
        auto* page = child<VolumePage>(*m_window, "volumePage");
        QVERIFY2(!m_window->results()->pageOffered(page), "quilting makes none");
        run("solid-noise");
        QVERIFY(m_window->results()->pageOffered(page));
        m_window->results()->showPage(page);
        const SliceView& xy = *page->slice(Axis::Z);
        QTRY_VERIFY2(!xy.busy(), qPrintable(page->message()));
        const auto volume = m_window->desk()->result()->synthesis.outputs.first<VolumeSource>("volume");
        QCOMPARE(page->volumes().front().volume.source, volume);
        QVERIFY(page->volumes().front().volume.recipe.find("solid-noise") != std::string::npos);
        TestContext context;
        QVERIFY(samePixels(
            xy.tile(0, 0)->values->values(),
            slice(*volume, axisPlane(Axis::Z, {0, 0, page->place()->cross().z()}), {64, 64}, context)));
        if (const QString folder = qEnvironmentVariable("TEXLOOM_LOOK"); !folder.isEmpty())
            m_window->grab().save(folder + QStringLiteral("/volume.png"));
    }

    void theVolumeOfAStoredResultIsShownToo() {
        auto* page = child<VolumePage>(*m_window, "volumePage");
        run("solid-noise");
        const std::string key = m_window->desk()->last().key;
        run("quilting");
        QVERIFY(!m_window->results()->pageOffered(page));
        ResultHistory* const history = m_window->desk()->history();
        history->waitForDisk();
        QCoreApplication::processEvents();
        history->setMemoryBudget(0);
        m_window->desk()->show(key);
        QTRY_VERIFY(m_window->results()->pageOffered(page));
        const auto volume = m_window->desk()->result()->synthesis.outputs.first<VolumeSource>("volume");
        QVERIFY2(volume->bounds(), "it was read back");
        history->setMemoryBudget(ResultStore::kMemoryBudget);
    }

    void aModelIsListedAndExported() {
        run("learn-moments");
        const ResultEntry* entry = m_window->desk()->history()->find(m_window->desk()->last().key);
        const QString details = detailsText(*entry);
        QVERIFY2(details.contains(QStringLiteral("Colour moments")), qPrintable(details));
        QVERIFY(details.contains(QStringLiteral("12 numbers, 96 B")));
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        QVERIFY(child<QCheckBox>(*dialog, "export_moments")->isChecked());
        if (const QString folder = qEnvironmentVariable("TEXLOOM_LOOK"); !folder.isEmpty())
            dialog->grab().save(folder + QStringLiteral("/export.png"));
        write(*dialog, target);
        const QStringList models = QDir(target.path()).entryList({QStringLiteral("*.safetensors")});
        QCOMPARE(models.size(), 1);
        m_model = m_folder.filePath(models.front());
        QVERIFY(QFile::copy(target.filePath(models.front()), m_model));
        QCOMPARE(readModel(m_model.toStdString()).kind, std::string("moments"));
    }

    void aVolumeIsExportedInTheFormThatIsChosen() {
        run("solid-noise");
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        auto* box = child<QCheckBox>(*dialog, "export_volume");
        auto* format = child<QComboBox>(*dialog, "format_volume");
        QVERIFY2(!box->isChecked() && !format->isEnabled(), "volumes may be large");
        const int without = child<QTableWidget>(*dialog, "exportTable")->rowCount();
        box->setChecked(true);
        QCOMPARE(child<QTableWidget>(*dialog, "exportTable")->rowCount(), without + 2);
        format->setCurrentIndex(format->findData(QStringLiteral(".png")));
        QCOMPARE(child<QTableWidget>(*dialog, "exportTable")->rowCount(), without + 96);
        format->setCurrentIndex(0);
        write(*dialog, target);
        const QStringList raws = QDir(target.path()).entryList({QStringLiteral("*_volume.json")});
        QCOMPARE(raws.size(), 1);
        TestContext context;
        QCOMPARE(readVolume(target.filePath(raws.front()).toStdString(), context).source->volume().depth(),
                 96);
    }

    void aModelGoesIntoItsRow() {
        choose("draw-moments");
        auto* row = child<PortRow>(*m_window, "port_moments");
        const RunInput without = m_window->input(false);
        QVERIFY(without.inputs.empty());
        row->add(loadInput(row->port(), {m_model.toStdString(), "", ""}, {}));
        run("draw-moments");
        const auto& result = m_window->desk()->result();
        QCOMPARE(result->plan.steps.front().method->id(), std::string("draw-moments"));
        QCOMPARE(result->plan.recipe.inputs.at("moments").front().path, m_model.toStdString());
    }

    void theModelOfTheShownResultGoesIntoItsRow() {
        run("quilting");
        choose("draw-moments");
        auto* button = child<QToolButton>(*m_window, "useResult_moments");
        QVERIFY(!button->isEnabled());
        QVERIFY2(button->toolTip().contains(QStringLiteral("no model of the kind moments")),
                 qPrintable(button->toolTip()));
        run("learn-moments");
        const auto learned = m_window->desk()->result()->synthesis.outputs.first<Model>("moments");
        choose("draw-moments");
        button = child<QToolButton>(*m_window, "useResult_moments");
        QVERIFY2(button->isEnabled(), qPrintable(button->toolTip()));
        button->click();
        QTRY_COMPARE(m_window->input(false).inputs.count("moments"), 1U);
        const InputFile used = m_window->input(false).inputs.at("moments").front();
        QVERIFY(toQString(used.file.path).startsWith(ownFolder()));
        QVERIFY(std::get<std::shared_ptr<const Model>>(used.asset)->arrays == learned->arrays);
        run("draw-moments");
        QCOMPARE(m_window->desk()->result()->plan.recipe.inputs.at("moments").front().hash, used.file.hash);
        QVERIFY2(!child<QToolButton>(*m_window, "useResult_moments")->isEnabled(),
                 "what is shown now gives no model");
    }

    void theVolumeOfTheShownResultGoesIntoItsRow() {
        run("solid-noise");
        const auto source = m_window->desk()->result()->synthesis.outputs.first<VolumeSource>("volume");
        choose("bend-by-volume");
        child<QToolButton>(*m_window, "useResult_volume")->click();
        QTRY_COMPARE(m_window->input(false).inputs.count("volume"), 1U);
        const InputFile used = m_window->input(false).inputs.at("volume").front();
        const auto read = std::get<std::shared_ptr<const VolumeSource>>(used.asset);
        QVERIFY(read->bounds());
        TestContext context;
        QVERIFY2(sameVoxels(read->sample(*read->bounds(), context), source->sample(*read->bounds(), context)),
                 "bit for bit");
        run("bend-by-volume");
        const Recipe recipe = m_window->desk()->result()->plan.recipe;
        QCOMPARE(recipe.inputs.at("volume").front().hash, used.file.hash);

        // The file of numbers stays as long as the head that a recipe names.
        const std::vector<std::filesystem::path> files = filesOf(AssetKind::Volume, used.file.path);
        QCOMPARE(files.size(), 2U);
        for (const std::filesystem::path& path : files) {
            QFile file(toQString(path));
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addDays(-30),
                                     QFileDevice::FileModificationTime));
        }
        const QTemporaryDir nothing;
        removeOldFiles({recipe}, nothing.path());
        for (const std::filesystem::path& path : files)
            QVERIFY(std::filesystem::exists(path));
        removeOldFiles({}, nothing.path());
        for (const std::filesystem::path& path : files)
            QVERIFY(!std::filesystem::exists(path));
    }

    void aResultIsDraggedOntoARowOfAnyKind() {
        run("learn-moments");
        const auto learned = m_window->desk()->result()->synthesis.outputs.first<Model>("moments");
        run("quilting");
        choose("draw-moments");
        auto* row = child<PortRow>(*m_window, "port_moments");
        row->setFiles({});
        ResultHistory* const history = m_window->desk()->history();
        const auto drop = [&](int place) {
            const std::unique_ptr<QMimeData> data(history->mimeData({history->index(place)}));
            QDragEnterEvent enter({2, 2}, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(row, &enter);
            QDropEvent event({2, 2}, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(row, &event);
        };
        drop(0); // of quilting
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("no model of the kind moments")));
        QVERIFY(row->files().empty());
        drop(1);
        QTRY_COMPARE(row->files().size(), 1U);
        QVERIFY(std::get<std::shared_ptr<const Model>>(row->files().front().asset)->arrays ==
                learned->arrays);

        auto* targets = child<DropTargets>(*m_window, "dropTargets");
        targets->open(DropTargets::Dragged::Result, true, {row->port()});
        QCOMPARE(targets->portAt(targets->placeOf("moments").center()), std::string("moments"));
        targets->open(DropTargets::Dragged::Picture, true, {row->port()});
        QCOMPARE(targets->portAt(targets->placeOf("moments").center()), std::string());
        targets->hide();
    }

    void aWindowWithoutExemplarsTakesWhatIsDroppedIntoAPort() {
        MainWindow empty;
        auto* targets = child<DropTargets>(empty, "dropTargets");
        QMimeData file;
        file.setUrls({QUrl::fromLocalFile(writeTexture(m_folder, QStringLiteral("face.png"), {40, 30}))});
        const auto enter = [&] {
            QDragEnterEvent event(empty.rect().center(), Qt::CopyAction, &file, Qt::LeftButton,
                                  Qt::NoModifier);
            QApplication::sendEvent(&empty, &event);
        };
        auto* method = child<QComboBox>(empty, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("draw-moments")));
        enter();
        QVERIFY(targets->isVisibleTo(&empty));
        QCOMPARE(targets->targetAt(targets->placeOf(DropTargets::Target::Exemplar).center()),
                 DropTargets::Target::Exemplar);
        QCOMPARE(targets->portAt(targets->placeOf("moments").center()), std::string("moments"));
        QVERIFY(!targets->placeOf("moments").isEmpty());
    }

    void methodsThatTheBuildLacksAreListedWithTheReason() {
        auto* method = child<QComboBox>(*m_window, "method");
        const int line = method->findText(QStringLiteral("left-out"));
        QVERIFY(line >= 0);
        QVERIFY(!(method->model()->index(line, 0).flags() & Qt::ItemIsEnabled));
        QVERIFY(method->itemData(line, Qt::ToolTipRole).toString().contains(QStringLiteral("install it")));
    }

    void whatTakesAModelFollowsWhatMakesIt() {
        choose("learn-moments");
        m_window->inspector()->setThen({{"draw-moments", {}}});
        QCOMPARE(m_window->inspector()->steps().size(), std::size_t{2});
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        trigger(*m_window, "run");
        QVERIFY(finished.wait(60'000));
        QCOMPARE(m_window->desk()->result()->plan.steps.back().method->id(), std::string("draw-moments"));
        m_window->inspector()->setThen({});
    }

    void mapsAndMasksComeBackAsTheyWere() {
        run("quilting");
        const auto copied = m_window->desk()->result();
        const Port layout{.id = "layout", .title = "Layout", .help = "", .kind = AssetKind::Map};
        PortRow row(layout);
        auto* button = child<QToolButton>(row, "useResult_layout");
        row.setResult(copied);
        QVERIFY(button->isEnabled());
        const QString map = saveInput(*copied, layout, assetFor(copied, layout).value());
        row.read(map);
        QTRY_COMPARE(row.files().size(), 1U);
        QVERIFY(*std::get<std::shared_ptr<const PositionMap>>(row.files().front().asset) ==
                copied->synthesis.map);
        run("solid-noise");
        row.setResult(m_window->desk()->result());
        QVERIFY2(!button->isEnabled(), "new pixels come from nowhere");
        QVERIFY(button->toolTip().contains(QStringLiteral("no position map")));

        const Port holes{.id = "holes", .title = "Holes", .help = "", .kind = AssetKind::Mask};
        const auto mask = std::make_shared<const Image>(testTexture({9, 7}, 1));
        const InputFile read = loadInput(holes, {toPath(saveInput(*copied, holes, mask)), "", ""}, {});
        QVERIFY(samePixels(*read.image(), *mask));
    }

    void aMethodWithoutExemplarsRunsWhereNoneIsOpen() {
        choose("quilting");
        m_window->desk()->clear();
        while (m_window->store()->current() != nullptr)
            m_window->store()->remove(m_window->store()->current()->id);
        QVERIFY2(!m_window->results()->isVisible(), "the start page shows");
        QTRY_VERIFY(!m_window->desk()->canRun());
        choose("draw-moments");
        auto* row = child<PortRow>(*m_window, "port_moments");
        row->setFiles({loadInput(row->port(), {m_model.toStdString(), "", ""}, {})});
        QTRY_VERIFY2(m_window->desk()->canRun(), "it needs its model alone");
        run("draw-moments");
        QVERIFY(m_window->results()->isVisible());
        const Result& result = *m_window->desk()->result();
        QVERIFY(result.plan.request.exemplars.empty());
        QCOMPARE(result.synthesis.image.channels(), 3);
        QVERIFY(!child<QAction>(*m_window, "stress")->isEnabled());
        auto* figures = child<FiguresPanel>(*m_window, "figuresPanel");
        figures->setSeen(true);
        QTRY_VERIFY(figures->titles().contains(QStringLiteral("Numbers")));
        QVERIFY(!figures->titles().contains(QStringLiteral("Autocorrelation: exemplar")));
        const std::string key = m_window->desk()->last().key;
        QVERIFY(!detailsText(*m_window->desk()->history()->find(key)).contains(QStringLiteral("Exemplars")));
        const QTemporaryDir target;
        write(*openDialog(target.path()), target);

        // Its settings come back, and leave what is open as it is.
        m_window->store()->open(m_folder.filePath(QStringLiteral("felt.png")));
        QTRY_COMPARE(m_window->store()->entries().size(), std::size_t{1});
        choose("quilting");
        m_window->restoreResult(key);
        QTRY_COMPARE(m_window->inspector()->method()->id(), std::string("draw-moments"));
        QTRY_COMPARE(m_window->input(false).inputs.count("moments"), std::size_t{1});
        QCOMPARE(m_window->store()->entries().size(), std::size_t{1});
        QVERIFY(m_window->input(false).exemplars.empty());
        if (const QString folder = qEnvironmentVariable("TEXLOOM_LOOK"); !folder.isEmpty())
            m_window->grab().save(folder + QStringLiteral("/no_exemplar.png"));
    }

private:
    void choose(const char* id) {
        auto* method = child<QComboBox>(*m_window, "method");
        method->setCurrentIndex(method->findData(QLatin1String(id)));
        QCOMPARE(m_window->inspector()->method()->id(), std::string(id));
    }

    /// Runs a method to its end, with the result on show.
    void run(const char* id) {
        choose(id);
        QSignalSpy shown(m_window->desk(), &RunDesk::shown);
        QTRY_VERIFY(!m_window->desk()->running());
        m_window->startRun(false);
        QVERIFY2(shown.wait(60'000), qPrintable(m_window->messages()->text()));
    }

    ExportDialog* openDialog(const QString& folder) {
        trigger(*m_window, "export");
        ExportDialog* dialog = nullptr;
        for (auto* opened : m_window->findChildren<ExportDialog*>())
            if (opened->isVisible())
                dialog = opened;
        child<QLineEdit>(*dialog, "exportFolder")->setText(folder);
        return dialog;
    }

    void write(const ExportDialog& dialog, const QTemporaryDir& target) {
        child<QPushButton>(dialog, "exportWrite")->click();
        QTRY_VERIFY(m_window->messages()->text().startsWith(QStringLiteral("Wrote ")));
        QVERIFY(m_window->messages()->text().contains(target.path()));
    }

    QTemporaryDir m_folder;
    QString m_model;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(OutputsTest)
#include "outputs_test.moc"
