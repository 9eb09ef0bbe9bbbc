#include "core/io/image_file.h"
#include "core/session/export/export.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/exemplar/area_drag.h"
#include "ui/exemplar/edit_canvas.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/material.h"
#include "ui/export/export_dialog.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableWidget>
#include <QUrl>

using namespace texloom;
using namespace texloom::ui;

namespace {

void sendMouse(QWidget& widget, QEvent::Type type, QPointF at, Qt::KeyboardModifiers held = {}) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    const Qt::MouseButtons down = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, down, held);
    QApplication::sendEvent(&widget, &event);
}

void dragOn(QWidget& widget, QPointF from, QPointF to, Qt::KeyboardModifiers held = {}) {
    sendMouse(widget, QEvent::MouseButtonPress, from, held);
    sendMouse(widget, QEvent::MouseMove, (from + to) / 2, held);
    sendMouse(widget, QEvent::MouseMove, to, held);
    sendMouse(widget, QEvent::MouseButtonRelease, to, held);
}

} // namespace

/// Materials as one: packed maps, neighbours, folders, maps that are derived; and what is done with results.
class MaterialsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        QDir(resultFolder()).removeRecursively();
        QSettings().clear();
        QSettings().setValue(QStringLiteral("results/folder"), m_results.path());
        m_window = std::make_unique<MainWindow>();
        m_window->resize(1600, 1000);
        m_window->show();
        m_window->activateWindow();
    }

    void cleanup() { m_window.reset(); }

    void aPackedMapIsSplitIntoItsSlots() {
        const QString folder = newFolder();
        m_window->openFiles({write(folder, QStringLiteral("rock_albedo.png")),
                             write(folder, QStringLiteral("rock_orm.png"))});
        QTRY_COMPARE(companions().size(), std::size_t{3});
        QCOMPARE(m_window->store()->entries().size(), std::size_t{1}); // never a second exemplar
        auto* list = child<QListWidget>(*m_window, "companionList");
        QCOMPARE(list->count(), 3);
        QVERIFY2(list->item(1)->text().contains(QStringLiteral("Roughness")) &&
                     list->item(1)->text().contains(QStringLiteral("rock_orm, green")),
                 qPrintable(list->item(1)->text()));
        QVERIFY(list->height() >= 3 * list->sizeHintForRow(0));
    }

    void neighboursAreOfferedAndTheOfferLeaves() {
        const QString folder = newFolder();
        const QString image = write(folder, QStringLiteral("bark.png"));
        write(folder, QStringLiteral("bark_normal.png"));
        write(folder, QStringLiteral("bark_rough.png"));
        const QString other = write(folder, QStringLiteral("moss.png"));
        QVERIFY(openAndFinish(*m_window, image));
        QTRY_VERIFY2(m_window->messages()->text().contains(QStringLiteral("bark_normal.png, bark_rough.png")),
                     qPrintable(m_window->messages()->text()));
        m_window->openFiles({other});
        QTRY_VERIFY(m_window->messages()->text().isEmpty()); // it was about the other one
        m_window->openFiles({image});
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("bark_rough.png")));
        child<QPushButton>(*m_window, "messageAction")->click();
        QTRY_COMPARE(companions().size(), std::size_t{2});
    }

    void aFolderIsOneMaterial() {
        const QString folder = newFolder();
        for (const char* name : {"T_Rock_BC.png", "T_Rock_N.png", "T_Rock_ORM.png"})
            write(folder, QLatin1String(name));
        m_window->openFiles({folder});
        QTRY_COMPARE(m_window->store()->entries().size(), std::size_t{1});
        QTRY_COMPARE(companions().size(), std::size_t{4});
        QCOMPARE(companions()[0].role, MapRole::NormalDx);
        QCOMPARE(m_window->store()->current()->file().name(), std::string("T_Rock_BC"));
        m_window->openFiles({newFolder()});
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("no picture")));
    }

    void anArchiveIsOneMaterial() {
        // "stone_color.png" and "stone_height.png", stored; put together by hand in zip_file_test.cpp, too.
        const QString folder = newFolder();
        QByteArray files, directory;
        int count = 0;
        for (const char* name : {"stone_color.png", "stone_height.png"}) {
            QFile file(write(folder, QLatin1String(name)));
            QVERIFY(file.open(QIODevice::ReadOnly));
            addStored(files, directory, "set/" + QByteArray(name), file.readAll());
            ++count;
        }
        const QByteArray end = QByteArray("PK\5\6") + QByteArray(4, '\0') + little(count, 2) +
                               little(count, 2) + little(directory.size(), 4) + little(files.size(), 4) +
                               little(0, 2);
        QFile archive(newFolder() + QStringLiteral("/stone.zip"));
        QVERIFY(archive.open(QIODevice::WriteOnly));
        archive.write(files + directory + end);
        archive.close();
        m_window->openFiles({archive.fileName()});
        QTRY_COMPARE(m_window->store()->entries().size(), std::size_t{1});
        QCOMPARE(companions().size(), std::size_t{1});
        QCOMPARE(companions()[0].role, MapRole::Height);
    }

    void mapsThatAreMissingAreDerivedAndSaySo() {
        const QString folder = newFolder();
        m_window->openFiles({write(folder, QStringLiteral("clay_albedo.png")),
                             write(folder, QStringLiteral("clay_height.png"))});
        QTRY_COMPARE(companions().size(), std::size_t{1});
        QVERIFY(!child<QAction>(*m_window, "deriveHeight")->isEnabled()); // there is no normal map
        for (const char* name : {"deriveNormal", "deriveRoughness", "deriveOcclusion"}) {
            const std::size_t before = companions().size();
            trigger(*m_window, name);
            QTRY_COMPARE(companions().size(), before + 1);
        }
        QCOMPARE(companions()[1].role, MapRole::NormalGl);
        QCOMPARE(companions()[1].image->channels(), 3);
        QCOMPARE(companions()[2].role, MapRole::Roughness);
        QCOMPARE(companions()[3].role, MapRole::Occlusion);
        auto* list = child<QListWidget>(*m_window, "companionList");
        QVERIFY(!list->item(0)->text().contains(QStringLiteral("derived")));
        QVERIFY2(list->item(1)->text().contains(QStringLiteral("clay_normal, derived")),
                 qPrintable(list->item(1)->text()));
        QVERIFY(child<QAction>(*m_window, "deriveHeight")->isEnabled());
    }

    void wrappingIsOnAtFirstAndOfferedWhereAResultDoesNot() {
        QVERIFY((m_window->inspector()->output()->wrap() == Wrap{true, true}));
        m_window->inspector()->output()->setWrap({false, true});
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("tile.png"))));
        auto* offer = child<QPushButton>(*m_window, "wrapOffer");
        QVERIFY(offer->isHidden());
        child<QAction>(*m_window, "repeat")->setChecked(true);
        QVERIFY(!offer->isHidden());
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        offer->click();
        QVERIFY(finished.wait(kPatience));
        QVERIFY((m_window->inspector()->output()->wrap() == Wrap{true, true}));
        QTRY_VERIFY((m_window->desk()->result()->plan.request.wrap == Wrap{true, true}));
        QTRY_VERIFY(offer->isHidden());
    }

    void whatWasMadeBeforeAnEditSaysSoAndIsRunAgain() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("plank.png"))));
        auto* offer = child<QPushButton>(*m_window, "rerunOffer");
        ResultHistory* const history = m_window->desk()->history();
        const auto chips = [history] {
            return history->index(0).data(ResultHistory::ChipsRole).toStringList().join(QLatin1Char('|'));
        };
        QVERIFY(offer->isHidden());
        QVERIFY2(!chips().contains(QStringLiteral("before the edit")), qPrintable(chips()));
        m_window->store()->setEdits(m_window->store()->current()->id, {{{"flip", std::string("horizontal")}}},
                                    QStringLiteral("Mirror"));
        QTRY_VERIFY(!offer->isHidden());
        QVERIFY2(chips().contains(QStringLiteral("before the edit")), qPrintable(chips()));
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        offer->click();
        QVERIFY(finished.wait(kPatience));
        QTRY_VERIFY(offer->isHidden());
        QCOMPARE(m_window->desk()->result()->plan.recipe.exemplars.front().edits.size(), std::size_t{1});
    }

    void starsAndKeepingTakeOneKeyEach() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("felt.png"))));
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        trigger(*m_window, "newSeedRun");
        QVERIFY(finished.wait(kPatience));
        ResultHistory* const history = m_window->desk()->history();
        QTRY_COMPARE(history->rowCount(), 2);
        auto* list = child<QListView>(*m_window, "resultList");
        list->setFocus();
        list->setCurrentIndex(list->model()->index(0, 0));
        QTest::keyClick(list, Qt::Key_4);
        QCOMPARE(history->index(0).data(ResultHistory::StarsRole).toInt(), 4);
        QTest::keyClick(list, Qt::Key_0);
        QCOMPARE(history->index(0).data(ResultHistory::StarsRole).toInt(), 0);
        trigger(*m_window, "keepResult");
        QVERIFY(history->index(0).data(ResultHistory::PinnedRole).toBool());
        QCOMPARE(list->currentIndex().row(), 1);
        // It is shown, too.
        QTRY_COMPARE(m_window->desk()->last().key,
                     history->index(1).data(ResultHistory::KeyRole).toString().toStdString());
    }

    void aResultIsDraggedOutAsAFile() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("wool.png"))));
        ResultHistory* const history = m_window->desk()->history();
        const std::unique_ptr<QMimeData> data(history->mimeData({history->index(0)}));
        QCOMPARE(draggedResult(*data), history->entries().front().key);
        QVERIFY(data->hasUrls());
        QCOMPARE(data->urls().size(), 1);
        const LoadedImage file = readImage(toPath(data->urls().front().toLocalFile()));
        QVERIFY(file.image.size() == m_window->desk()->result()->synthesis.image.size());
        QVERIFY(!file.info.recipe.empty());
    }

    void runningBringsTheResultToTheFront() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("sand.png"))));
        auto* tabs = child<QTabWidget>(*m_window, "resultTabs");
        for (const int tab : {1, 4}) { // the synthesis map, the lattice
            tabs->setCurrentIndex(tab);
            QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
            trigger(*m_window, "quick");
            QTRY_COMPARE(tabs->currentIndex(), 0);
            QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), kPatience);
        }
        child<QAction>(*m_window, "editExemplar")->setChecked(true);
        QVERIFY(!tabs->isVisible());
        trigger(*m_window, "quick");
        QTRY_VERIFY(tabs->isVisible());
    }

    void theZoomIsSaidAndTaken() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("net.png"))));
        auto* zoom = child<QComboBox>(*m_window, "zoomBox");
        const ImageViewer* const viewer = m_window->results()->viewer(ResultView::ResultTab);
        for (const int percent : {200, 50}) {
            const QString text = QStringLiteral("%1 %").arg(percent);
            Q_EMIT zoom->textActivated(text);
            QCOMPARE(viewer->view().scale() * viewer->devicePixelRatioF(), percent / 100.0);
            QCOMPARE(zoom->currentText(), text);
        }
        trigger(*m_window, "actualSize");
        QCOMPARE(zoom->currentText(), QStringLiteral("100 %"));
        Q_EMIT zoom->textActivated(zoom->itemText(0));
        QVERIFY(viewer->fitted());
    }

    void deletingAPinnedResultAsks() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("cork.png"))));
        ResultHistory* const history = m_window->desk()->history();
        history->setPinned(history->entries().front().key, true);
        child<QListView>(*m_window, "resultList")
            ->setCurrentIndex(child<QListView>(*m_window, "resultList")->model()->index(0, 0));
        trigger(*m_window, "removeResult");
        QTRY_VERIFY(m_window->findChild<QMessageBox*>(QStringLiteral("deletePinned")) != nullptr);
        QCOMPARE(history->rowCount(), 1);
        auto* question = child<QMessageBox>(*m_window, "deletePinned");
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::DestructiveRole)
                button->click();
        QCOMPARE(history->rowCount(), 0);
        trigger(*m_window, "undo");
        QCOMPARE(history->rowCount(), 1);
    }

    void exportFollowsTheExemplarAndCanBeRepeated() {
        const QString folder = newFolder();
        Image bright = testTexture({64, 64});
        for (int x = 0; x < 64; ++x)
            for (int y = 0; y < 64; ++y)
                bright(x, y, 0) += 0.8F;
        WriteOptions half;
        half.depth = Depth::Half;
        half.space = "linear";
        const QString path = folder + QStringLiteral("/lamp.exr");
        writeImage(toPath(path), bright, half);
        QVERIFY(openAndFinish(*m_window, path));
        const auto result = m_window->desk()->result();
        {
            ExportDialog dialog(result, folder);
            QCOMPARE(child<QComboBox>(dialog, "exportFormat")->currentData().toString(),
                     QStringLiteral(".exr"));
            QVERIFY(dialog.options().depth == Depth::Half);
            auto* format = child<QComboBox>(dialog, "exportFormat");
            format->setCurrentIndex(format->findData(QStringLiteral(".png")));
            auto* table = child<QTableWidget>(dialog, "exportTable");
            QTRY_VERIFY2(table->item(0, 1)->text().contains(QStringLiteral("values clipped")),
                         qPrintable(table->item(0, 1)->text()));
            child<QLineEdit>(dialog, "exportFolder")->setText(folder + QStringLiteral("/new/one"));
            auto* make = child<QPushButton>(dialog, "exportMakeFolder");
            QVERIFY(!dialog.refusal().isEmpty() && !make->isHidden());
            make->click();
            QVERIFY2(dialog.refusal().isEmpty(), qPrintable(dialog.refusal()));
            auto* preset = child<QComboBox>(dialog, "exportPreset");
            preset->setCurrentIndex(preset->findData(QStringLiteral("unreal")));
            dialog.remember();
        }
        ExportDialog next(result, folder);
        QCOMPARE(child<QComboBox>(next, "exportPreset")->currentData().toString(), QStringLiteral("unreal"));
        QVERIFY(next.options().depth == Depth::Half); // the source's again
        QSettings().setValue(QStringLiteral("folders/export"), folder);
        m_window->desk()->show(m_window->desk()->last().key);
        trigger(*m_window, "exportAgain");
        QTRY_VERIFY(QFile::exists(folder + QStringLiteral("/T_lamp_BC.png")));
    }

    void cropIsDrawnWithTheMouse() {
        QVERIFY(openAndFinish(*m_window, write(newFolder(), QStringLiteral("wall.png"), {200, 100})));
        child<QAction>(*m_window, "editExemplar")->setChecked(true);
        ExemplarEditor* const editor = m_window->exemplarEditor();
        editor->setMode(QStringLiteral("crop"));
        EditCanvas* const canvas = editor->canvas();
        settle();
        const auto at = [canvas](double x, double y) { return canvas->view().toWidget({x, y}); };
        const auto area = [canvas] { return std::get<Wholes>(canvas->frame()); };
        canvas->setFrame(Wholes{40, 20, 100, 60});
        dragOn(*canvas, at(100, 50), at(110, 55)); // the body
        QCOMPARE(area(), (Wholes{50, 25, 100, 60}));
        dragOn(*canvas, at(150, 55), at(170, 58)); // an edge
        QCOMPARE(area(), (Wholes{50, 25, 120, 60}));
        dragOn(*canvas, at(10, 10), at(50, 40)); // a new one
        QCOMPARE(area(), (Wholes{10, 10, 40, 30}));
        dragOn(*canvas, at(190, 90), at(160, 80), Qt::ShiftModifier); // a square
        QCOMPARE(area(), (Wholes{160, 60, 30, 30}));
        sendMouse(*canvas, QEvent::MouseButtonPress, at(10, 10));
        sendMouse(*canvas, QEvent::MouseMove, at(90, 90));
        QTest::keyClick(canvas, Qt::Key_Escape); // as though it had not begun
        QCOMPARE(area(), (Wholes{160, 60, 30, 30}));
        sendMouse(*canvas, QEvent::MouseButtonRelease, at(90, 90));
        auto* ratio = child<QComboBox>(*editor, "ratio-crop");
        ratio->setCurrentIndex(ratio->findData(2.0));
        Q_EMIT ratio->activated(ratio->currentIndex());
        QCOMPARE(area()[2], 2 * area()[3]);
        dragOn(*canvas, at(10, 10), at(90, 20));
        QCOMPARE(area(), (Wholes{10, 10, 80, 40}));
        QTest::keyClick(canvas, Qt::Key_Return);
        QTRY_VERIFY((m_window->store()->current()->file().image->size() == Size{80, 40}));
        editor->setMode(QStringLiteral("crop"));
        QTest::keyClick(canvas, Qt::Key_Escape);
        QVERIFY(canvas->mode() == EditCanvas::Mode::Look);
    }

    void rectanglesStayInThePicture() {
        const QRectF area(10, 20, 30, 40);
        const Size picture{100, 80};
        QCOMPARE(AreaDrag::heldAt(area, {10.5, 40}, 2), static_cast<int>(AreaDrag::Left));
        QCOMPARE(AreaDrag::heldAt(area, {40, 60}, 2), AreaDrag::Right | AreaDrag::Bottom);
        QCOMPARE(AreaDrag::heldAt(area, {25, 40}, 2), static_cast<int>(AreaDrag::All));
        QCOMPARE(AreaDrag::heldAt(area, {60, 40}, 2), static_cast<int>(AreaDrag::None));
        for (const double ratio : {0.0, 1.0, 16.0 / 9})
            for (int held = 0; held <= AreaDrag::All; ++held) {
                const bool both = (held & 5) == 5 || (held & 10) == 10;
                if (both && held != AreaDrag::All)
                    continue; // opposite edges are never held
                const AreaDrag drag(area, held, {25, 40}, picture);
                for (int i = 0; i < 200; ++i) {
                    const QRectF moved = drag.movedTo({i * 37 % 300 - 100.0, i * 53 % 260 - 90.0}, ratio);
                    QVERIFY(moved.width() >= 1 && moved.height() >= 1);
                    QVERIFY(QRectF(0, 0, 100, 80).contains(moved));
                    if (held == AreaDrag::All)
                        QCOMPARE(moved.size(), area.size());
                    else if (ratio > 0 && moved.width() > 4 && moved.height() > 4)
                        QVERIFY(std::abs(moved.width() - ratio * moved.height()) <= 1 + ratio);
                }
            }
    }

private:
    QString newFolder() {
        const QString path = m_folder.filePath(QString::number(++m_folders));
        QDir().mkpath(path);
        return path;
    }
    static QString write(const QString& folder, const QString& name, Size size = {64, 64}) {
        const QString path = folder + QLatin1Char('/') + name;
        writeImage(toPath(path), testTexture(size, 3, qHash(name)), {});
        return path;
    }
    std::vector<ExemplarFile> companions() const {
        const ExemplarEntry* const entry = m_window->store()->current();
        return entry != nullptr ? entry->exemplar.companions : std::vector<ExemplarFile>();
    }
    static QByteArray little(qsizetype number, int bytes) {
        QByteArray text;
        for (int i = 0; i < bytes; ++i, number >>= 8)
            text += static_cast<char>(number & 0xff);
        return text;
    }
    static void addStored(QByteArray& files, QByteArray& directory, const QByteArray& name,
                          const QByteArray& bytes) {
        quint32 sum = 0xffffffff;
        for (const char byte : bytes) {
            sum ^= static_cast<unsigned char>(byte);
            for (int bit = 0; bit < 8; ++bit)
                sum = sum >> 1U ^ (sum & 1U ? 0xedb88320U : 0U);
        }
        const QByteArray common = little(20, 2) + little(0, 2) + little(0, 2) + little(0, 4) +
                                  little(sum ^ 0xffffffffU, 4) + little(bytes.size(), 4) +
                                  little(bytes.size(), 4) + little(name.size(), 2) + little(0, 2);
        directory += QByteArray("PK\1\2") + little(20, 2) + common + little(0, 6) + little(0, 4) +
                     little(files.size(), 4) + name;
        files += QByteArray("PK\3\4") + common + name + bytes;
    }

    QTemporaryDir m_folder, m_results;
    int m_folders = 0;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(MaterialsTest)
#include "materials_test.moc"
