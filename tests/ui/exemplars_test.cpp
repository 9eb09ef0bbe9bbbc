#include "core/base/version.h"
#include "core/io/decoder_process.h"
#include "core/io/image_file.h"
#include "core/session/export/export.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/elided_label.h"
#include "ui/common/message_bar.h"
#include "ui/common/own_folders.h"
#include "ui/common/reading_bar.h"
#include "ui/common/readings.h"
#include "ui/common/text.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/files.h"
#include "ui/exemplar/layer_dialog.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_row.h"
#include "ui/maps/result_view.h"
#include "ui/session/undo_history.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QThread>
#include <QUrl>

using namespace texloom;
using namespace texloom::ui;

namespace {

void drop(QWidget& on, const QMimeData& what) {
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &what, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, &what, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&on, &event);
}

} // namespace

class ExemplarsTest : public QObject {
    Q_OBJECT

    /// Chooses in the dialog that asks for a layer, once it is there.
    void chooseLayer(const QString& name) {
        QTRY_VERIFY(m_window->findChild<LayerDialog*>() != nullptr);
        auto* dialog = m_window->findChild<LayerDialog*>();
        auto* list = child<QListWidget>(*dialog, "layers");
        const QList<QListWidgetItem*> found = list->findItems(name, Qt::MatchStartsWith);
        QCOMPARE(found.size(), 1);
        list->setCurrentItem(found.front());
        dialog->accept();
        QTRY_VERIFY(m_window->findChild<LayerDialog*>() == nullptr);
    }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
    }

    void cleanup() { m_window.reset(); }

    void droppedFileIsOpenedAndRemembered() {
        const QString path = writeTexture(m_folder, QStringLiteral("dropped.png"), {40, 30});
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        drop(*m_window, data);
        QVERIFY(opened.wait());
        QVERIFY((m_window->store()->current()->file().image->size() == Size{40, 30}));
        QCOMPARE(recentFiles().front(), path);
        QVERIFY(m_window->store()->current()->picture == m_window->exemplarPanel()->viewer()->picture());
    }

    void remoteAddressIsRefusedInWords() {
        QMimeData data;
        data.setUrls({QUrl(QStringLiteral("https://example.org/bark.jpg"))});
        drop(*m_window, data);
        QVERIFY(m_window->messages()->isVisible());
        QVERIFY(m_window->messages()->text().contains(QStringLiteral("save the picture")));
    }

    void pastedPixelsBecomeAnExemplar() {
        QImage pixels(33, 22, QImage::Format_RGB32);
        pixels.fill(QColor(10, 200, 30));
        QApplication::clipboard()->setImage(pixels);
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        trigger(*m_window, "paste");
        QVERIFY(opened.wait());
        const ExemplarFile& file = m_window->store()->current()->file();
        QVERIFY((file.image->size() == Size{33, 22}));
        QVERIFY(std::abs((*file.image)(5, 5, 1) - 200.0F / 255) < 1e-5F);
        QFile::remove(toQString(file.path));
    }

    void brokenFileIsSaidInPlaceAndTheExemplarStays() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("good.png"), {64, 64})));
        const auto before = m_window->store()->current()->file().image;
        QFile broken(m_folder.filePath(QStringLiteral("broken.png")));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("no picture");
        broken.close();
        QSignalSpy failed(m_window->store(), &ExemplarStore::failed);
        m_window->openFiles({broken.fileName()});
        QVERIFY(failed.wait());
        QVERIFY(m_window->messages()->isVisible());
        QCOMPARE(m_window->messages()->kind(), MessageBar::Kind::Error);
        QVERIFY2(m_window->messages()->text().contains(QStringLiteral("broken.png")),
                 qPrintable(m_window->messages()->text()));
        QVERIFY(m_window->store()->current()->file().image == before);
        QCOMPARE(m_window->store()->loading(), 0);
    }

    void aLayerIsChosenOnOpeningAndChangedLater() {
        const QString path = m_folder.filePath(QStringLiteral("layers.exr"));
        Image image(Size{48, 40}, 6);
        for (int c = 0; c < 6; ++c)
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 48; ++x)
                    image(x, y, c) = c < 3 ? 0.25F : 0.5F;
        WriteOptions options;
        options.depth = Depth::Float;
        options.channelNames = {"R", "G", "B", "diffuse.R", "diffuse.G", "diffuse.B"};
        writeImage(toPath(path), image, options);
        m_window->openFiles({path});
        QTRY_VERIFY(m_window->findChild<LayerDialog*>() != nullptr);
        auto* dialog = m_window->findChild<LayerDialog*>();
        auto* list = child<QListWidget>(*dialog, "layers");
        QCOMPARE(list->count(), 2);
        QCOMPARE(list->item(1)->text(), QStringLiteral("diffuse (R, G, B)"));
        list->setCurrentRow(1);
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        dialog->accept();
        QVERIFY(opened.wait());
        const auto file = [this] { return m_window->store()->current()->file(); };
        QCOMPARE(file().layer, std::string("diffuse"));
        QCOMPARE(file().image->channels(), 3);
        QCOMPARE((*file().image)(5, 5, 0), 0.5F);
        QCOMPARE(m_window->session().settings.exemplars.front().image.layer, std::string("diffuse"));
        auto* layer = child<QComboBox>(*m_window, "layer");
        QVERIFY(!layer->isHidden());
        QCOMPARE(layer->currentText(), QStringLiteral("diffuse"));
        layer->setCurrentIndex(0);
        Q_EMIT layer->activated(0);
        QTRY_COMPARE(file().image->channels(), 6);
        m_window->undoHistory()->undoAction()->trigger();
        QTRY_COMPARE(file().image->channels(), 3);
        QTRY_COMPARE(layer->currentText(), QStringLiteral("diffuse"));
    }

    void layersOfMasksMapsAndInputsAreChosen() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("base.png"), {48, 40})));
        const QString path = m_folder.filePath(QStringLiteral("maps.exr"));
        Image image(Size{48, 40}, 2);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 48; ++x) {
                image(x, y, 0) = 0.25F;
                image(x, y, 1) = 1;
            }
        WriteOptions options;
        options.depth = Depth::Float;
        options.space = "raw";
        options.channelNames = {"roughness.Y", "matte.Y"};
        writeImage(toPath(path), image, options);
        const auto exemplar = [this] { return m_window->store()->current()->exemplar; };
        const int id = m_window->store()->current()->id;
        m_window->store()->addCompanion(id, path);
        chooseLayer(QStringLiteral("roughness"));
        QTRY_COMPARE(exemplar().companions.size(), std::size_t{1});
        QCOMPARE(exemplar().companions[0].layer, std::string("roughness"));
        QVERIFY(exemplar().companions[0].role == MapRole::Roughness);
        QCOMPARE((*exemplar().companions[0].image)(3, 3, 0), 0.25F);
        m_window->store()->addCompanion(id, path); // another layer of the same file comes beside it
        chooseLayer(QStringLiteral("matte"));
        QTRY_COMPARE(exemplar().companions.size(), std::size_t{2});
        m_window->store()->setMask(id, path);
        chooseLayer(QStringLiteral("matte"));
        QTRY_VERIFY(exemplar().mask);
        QCOMPARE((*exemplar().mask->image)(3, 3, 0), 1.0F);
        const RecipeExemplar kept = m_window->session().settings.exemplars.front();
        QCOMPARE(kept.mask->layer, std::string("matte"));
        QCOMPARE(kept.companions[1].layer, std::string("matte"));
        PortRow row({.id = "guide", .title = "Guide", .help = "", .kind = AssetKind::Image}, {},
                    m_window.get());
        row.read(path);
        chooseLayer(QStringLiteral("roughness"));
        QTRY_COMPARE(row.files().size(), std::size_t{1});
        QCOMPARE(row.files()[0].file.layer, std::string("roughness"));
    }

    void anStMapOfAnotherProgramKnowsTheExemplarsSizes() {
        const QString path = m_folder.filePath(QStringLiteral("stmap.exr"));
        PositionMap map({8, 6}, {{48, 40}});
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 8; ++x)
                map.at(x, y) = {static_cast<std::uint16_t>(x + 5), static_cast<std::uint16_t>(y + 7), 0};
        Image places({8, 6}, 3); // as other programs write them, without a word on the size
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 8; ++x) {
                places(x, y, 0) = (static_cast<float>(x) + 5.5F) / 48;
                places(x, y, 1) = 1 - (static_cast<float>(y) + 7.5F) / 40;
            }
        WriteOptions options;
        options.depth = Depth::Float;
        options.space = "raw";
        writeImage(toPath(path), places, options);
        PortRow row({.id = "map", .title = "Map", .help = "", .kind = AssetKind::Map});
        QSignalSpy failed(&row, &PortRow::failed);
        row.read(path);
        QTRY_COMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("does not say the size")));
        row.setExemplarSizes({{48, 40}});
        row.read(path);
        QTRY_COMPARE(row.files().size(), std::size_t{1});
        const auto read = std::get<std::shared_ptr<const PositionMap>>(row.files()[0].asset);
        QVERIFY(read->at(3, 2) == map.at(3, 2));
        // The window tells its rows.
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("sized.png"), {48, 40})));
        QCOMPARE(m_window->inspector()->output()->exemplarSizes(), std::vector<Size>({{48, 40}}));
    }

    void pastedPicturesAreTakenOverOnce() {
        const QDir before(earlierFolder(kPasted)), after(dataFolder(kPasted));
        QVERIFY(before.mkpath(QStringLiteral(".")));
        QFile old(before.filePath(QStringLiteral("pasted-1.png")));
        QVERIFY(old.open(QIODevice::WriteOnly));
        old.write("a picture");
        old.close();
        for (int times = 0; times < 2; ++times) {
            takeOverFiles(kPasted);
            QFile kept(after.filePath(QStringLiteral("pasted-1.png")));
            QVERIFY(kept.open(QIODevice::ReadOnly));
            QCOMPARE(kept.readAll(), QByteArray("a picture"));
            // Sessions name it where it was.
            QVERIFY(QFileInfo(old.fileName()).isSymLink());
            QCOMPARE(QFileInfo(old.fileName()).symLinkTarget(), kept.fileName());
            QCOMPARE(before.entryList(QDir::Files).size(), 1);
        }
        QFile::remove(old.fileName());
        QFile::remove(after.filePath(QStringLiteral("pasted-1.png")));
    }

    void aFileOfOneLayerAsksNothing() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("one.png"), {64, 64})));
        QVERIFY(m_window->findChild<LayerDialog*>() == nullptr);
        QVERIFY(child<QComboBox>(*m_window, "layer")->isHidden());
    }

    void whatTakesLongToReadIsSaidAndCanBeCancelled() {
        auto* bar = child<ReadingBar>(*m_window, "readingBar");
        QVERIFY(bar->isHidden());
        bool done = false, cancelled = false;
        readInBackground(
            m_window.get(), QStringLiteral("slow.tif"),
            [] {
                for (;;) {
                    DecoderProcess::check();
                    QThread::msleep(1);
                }
                return 0;
            },
            [&done](int) { done = true; }, [&cancelled](const QString& why) { cancelled = why.isEmpty(); });
        QTRY_VERIFY(bar->isVisible());
        QVERIFY(child<ElidedLabel>(*bar, "readingText")->fullText().contains(QStringLiteral("slow.tif")));
        child<QPushButton>(*bar, "cancelReading")->click();
        QTRY_VERIFY(cancelled);
        QVERIFY(!done);
        QVERIFY(bar->isHidden());
        QCOMPARE(Readings::all().count(), 0);
    }

    void listHasWhatIsOpenAndRemovesIt() {
        auto* list = child<QListWidget>(*m_window, "exemplarList");
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("one.png"), {64, 64})));
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        const QString longName = QString(150, QLatin1Char('n')) + QStringLiteral(".png");
        m_window->openFiles({writeTexture(m_folder, longName, {32, 48})});
        QVERIFY(opened.wait());
        QCOMPARE(list->count(), 2);
        QCOMPARE(list->currentRow(), 1);
        QVERIFY(m_window->exemplarPanel()->width() < m_window->width() / 2);
        list->setCurrentRow(0);
        QCOMPARE(m_window->store()->current()->file().name(), std::string("one"));
        trigger(*m_window, "removeExemplar");
        QCOMPARE(list->count(), 1);
        QVERIFY((m_window->store()->current()->file().image->size() == Size{32, 48}));
    }

    void checkedExemplarsAreUsedWhereAMethodTakesSeveral() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("first.png"), {64, 64})));
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        m_window->openFiles({writeTexture(m_folder, QStringLiteral("second.png"), {64, 64}, 2)});
        QVERIFY(opened.wait());
        QVERIFY(m_window->inspector()->method()->info().learnsFromSeveral());
        const auto used = [this] {
            QStringList names;
            for (const RunExemplar& exemplar : m_window->input(false).exemplars)
                names += QString::fromStdString(exemplar.image.name());
            return names.join(QLatin1Char(' '));
        };
        QCOMPARE(used(), QStringLiteral("second")); // what was opened last, alone
        auto* list = child<QListWidget>(*m_window, "exemplarList");
        QCOMPARE(list->item(0)->checkState(), Qt::Unchecked);
        list->setCurrentRow(0); // as long as one alone is in use, it is the one that is looked at
        QCOMPARE(used(), QStringLiteral("first"));
        list->item(1)->setCheckState(Qt::Checked);
        QCOMPARE(used(), QStringLiteral("first second"));
        list->setCurrentRow(1); // looking changes no mixture
        QCOMPARE(used(), QStringLiteral("first second"));
        list->item(0)->setCheckState(Qt::Unchecked);
        QCOMPARE(used(), QStringLiteral("second"));
    }

    void weightsAreSetUndoneAndSaidWhereTheyHaveNoEffect() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("oak.png"), {64, 64})));
        auto* weight = child<QDoubleSpinBox>(*m_window, "exemplarWeight");
        QVERIFY(weight->isHidden()); // one exemplar needs none
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        m_window->openFiles({writeTexture(m_folder, QStringLiteral("ash.png"), {64, 64}, 2)});
        QVERIFY(opened.wait());
        child<QListWidget>(*m_window, "exemplarList")->item(0)->setCheckState(Qt::Checked);
        QVERIFY(!weight->isHidden() && weight->isEnabled());
        weight->setValue(2.5);
        QTRY_COMPARE(m_window->input(false).exemplars.back().weight, 2.5);
        auto* list = child<QListWidget>(*m_window, "exemplarList");
        QVERIFY2(list->item(1)->text().contains(QStringLiteral("2")), qPrintable(list->item(1)->text()));
        trigger(*m_window, "undo");
        QTRY_COMPARE(m_window->input(false).exemplars.back().weight, 1.0);
        QCOMPARE(weight->value(), 1.0);
        trigger(*m_window, "redo");
        QTRY_COMPARE(weight->value(), 2.5);
        auto* method = child<QComboBox>(*m_window, "method");
        for (const char* alike : {"patchmatch", "random-phase"}) {
            method->setCurrentIndex(method->findData(QLatin1String(alike)));
            QVERIFY(!weight->isEnabled() && !weight->toolTip().isEmpty());
            QCOMPARE(m_window->input(false).exemplars.back().weight, 1.0);
        }
    }

    void colourSpaceIsReadAnew() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("space.png"), {32, 32})));
        const auto before = m_window->store()->current()->file().image;
        auto* space = child<QComboBox>(*m_window, "colourSpace");
        QCOMPARE(space->currentData().toString(), QStringLiteral("srgb"));
        const int linear = space->findData(QStringLiteral("linear"));
        QVERIFY(linear >= 0);
        space->setCurrentIndex(linear);
        Q_EMIT space->activated(linear);
        QTRY_COMPARE(m_window->store()->current()->file().space, std::string("linear"));
        QVERIFY((*m_window->store()->current()->file().image)(3, 3, 0) > (*before)(3, 3, 0));
    }

    void masksAreGivenToMethodsThatHeedThem() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("masked.png"), {48, 48})));
        QSignalSpy changed(m_window->store(), &ExemplarStore::changed);
        m_window->store()->setMask(m_window->store()->current()->id,
                                   writeTexture(m_folder, QStringLiteral("mask.png"), {48, 48}));
        QVERIFY(changed.wait());
        QCOMPARE(m_window->input(false).exemplars.front().mask.has_value(),
                 m_window->inspector()->method()->info().heedsMasks());
        trigger(*m_window, "clearExemplarMask");
        QTRY_VERIFY(!m_window->input(false).exemplars.front().mask);
    }

    void recipeInAPictureRestoresTheSettings() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("source.png"), {64, 64})));
        ExportOptions options;
        options.image = toPath(m_folder.filePath(QStringLiteral("made.png")));
        exportResult(*m_window->desk()->result(), options);
        const RunPlan& plan = m_window->desk()->result()->plan;
        const Values settings = plan.steps.front().settings;
        const std::uint64_t seed = plan.request.seed;
        const Size size = plan.request.size;

        m_window->inspector()->setValues({{"patch", 20}});
        m_window->inspector()->output()->setSeed(seed + 77);
        m_window->inspector()->output()->setOutputSize({50, 50});
        QSignalSpy opened(m_window->store(), &ExemplarStore::opened);
        m_window->openFiles({toQString(options.image)});
        QVERIFY(opened.wait());
        QVERIFY(m_window->messages()->isVisible());
        QSignalSpy replaced(m_window->store(), &ExemplarStore::replaced);
        child<QPushButton>(*m_window, "messageAction")->click();
        QVERIFY(replaced.wait());
        QVERIFY(m_window->inspector()->values() == settings);
        QCOMPARE(m_window->inspector()->output()->seed(), seed);
        QVERIFY(m_window->inspector()->output()->outputSize() == size);
        QCOMPARE(m_window->store()->current()->file().name(), std::string("source"));
    }

    void aRecipeOfAnotherBuildSaysSo() {
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("source.png"), {64, 64})));
        ExportOptions options;
        options.image = toPath(m_folder.filePath(QStringLiteral("made.png")));
        exportResult(*m_window->desk()->result(), options);
        const QString recipe = m_folder.filePath(QStringLiteral("made.json"));
        for (const bool other : {false, true}) {
            if (other) {
                QString text = QString::fromStdString(readText(toPath(recipe)));
                text.replace(QLatin1String(kVersion), QStringLiteral("0.0.9+abc"));
                writeText(toPath(recipe), text.toStdString());
            }
            m_window->openFiles({recipe});
            QSignalSpy replaced(m_window->store(), &ExemplarStore::replaced);
            child<QPushButton>(*m_window, "messageAction")->click();
            QVERIFY(replaced.wait());
            QTRY_COMPARE(m_window->messages()->text().contains(QStringLiteral("0.0.9+abc")), other);
        }
    }

    void bundledExemplarsAreOnTheStartPage() {
        auto* list = child<QListWidget>(*m_window, "bundledThumbnails");
        QVERIFY(!bundledExemplars().isEmpty());
        QTRY_COMPARE(list->count(), bundledExemplars().size());
        for (const QString& path : bundledExemplars())
            QVERIFY2(!path.contains(QStringLiteral("_normal")), qPrintable(path));
    }

    void longLabelsAreElidedInTheMiddle() {
        ElidedLabel label;
        label.setFullText(QStringLiteral("a very long name of a file that does not fit.png"));
        label.resize(100, 30);
        label.show();
        QVERIFY(label.text().contains(QChar(0x2026)));
        QVERIFY(label.text().endsWith(QStringLiteral("png")));
        QCOMPARE(label.toolTip(), label.fullText());
    }

private:
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(ExemplarsTest)
#include "exemplars_test.moc"
