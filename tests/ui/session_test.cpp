#include "core/image/map_role.h"
#include "core/io/image_file.h"
#include "core/session/session.h"
#include "core/tools/edits.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/background.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/common/value_editor.h"
#include "ui/exemplar/companion_list.h"
#include "ui/exemplar/exemplar_editor.h"
#include "ui/exemplar/exemplar_panel.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/param_row.h"
#include "ui/jobs/run_panel.h"
#include "ui/maps/result_view.h"
#include "ui/session/document.h"
#include "ui/session/example_sessions.h"
#include "ui/session/missing_files_dialog.h"
#include "ui/session/preset_menu.h"
#include "ui/session/undo_history.h"
#include "ui/window/drop_targets.h"

#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QGroupBox>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>

using namespace texloom;
using namespace texloom::ui;

/// Exemplar edits, companion maps, undo and sessions, in the real window.
class SessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_window = std::make_unique<MainWindow>();
        m_window->document()->recovery()->setFolder(m_folder->filePath(QStringLiteral("recovery")));
        m_window->resize(1200, 800);
        m_window->show();
    }
    void cleanup() { m_window.reset(); }

    void mapsAreRecognisedByTheirNames() {
        openBark(true);
        const RunExemplar& bark = m_window->store()->current()->exemplar;
        QCOMPARE(m_window->store()->entries().size(), 1U);
        QCOMPARE(bark.companions.size(), 1U);
        QVERIFY(bark.companions.front().role == MapRole::NormalGl);
        const QString rough = writeTexture(*m_folder, QStringLiteral("bark_ROUGH.png"), {64, 48}, 3);
        m_window->openFiles({rough});
        QTRY_COMPARE(m_window->store()->current()->exemplar.companions.size(), 2U);
        auto* list = child<QListWidget>(*m_window, "companionList");
        QCOMPARE(list->count(), 2);
        list->setCurrentRow(0);
        auto* role = child<QComboBox>(*m_window, "companionRole");
        role->setCurrentIndex(role->findData(static_cast<int>(MapRole::NormalDx)));
        Q_EMIT role->activated(role->currentIndex());
        QTRY_VERIFY(m_window->store()->current()->exemplar.companions.front().role == MapRole::NormalDx);
        m_window->openFiles({writeTexture(*m_folder, QStringLiteral("bark_ao.png"), {40, 48}, 3)});
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("40 × 48")));
        QCOMPARE(list->count(), 2);
    }

    void editsShowAndAreUndone() {
        openBark(true);
        trigger(*m_window, "editExemplar");
        auto* editor = m_window->exemplarEditor();
        QVERIFY(editor->isVisible());
        child<QToolButton>(*editor, "mode-crop")->click();
        child<QSpinBox>(*editor, "crop-0")->setValue(4);
        child<QSpinBox>(*editor, "crop-1")->setValue(2);
        child<QSpinBox>(*editor, "crop-2")->setValue(50);
        child<QSpinBox>(*editor, "crop-3")->setValue(40);
        child<QPushButton>(*editor, "apply-crop")->click();
        QTRY_VERIFY((current() == Size{50, 40}));
        child<QToolButton>(*editor, "preset-rotate-1")->click();
        child<QToolButton>(*editor, "preset-flip-0")->click(); // before the turn is done
        QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 3U);
        QVERIFY((current() == Size{40, 50}));
        QCOMPARE(child<QListWidget>(*editor, "editList")->count(), 3);
        QVERIFY((m_window->store()->current()->exemplar.companions.front().image->size() == Size{40, 50}));
        QVERIFY(m_window->input(false).exemplars.front().image.image ==
                m_window->store()->current()->file().image);
        for (int i = 0; i < 3; ++i) {
            trigger(*m_window, "undo");
            QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(),
                         static_cast<std::size_t>(2 - i));
        }
        QVERIFY((current() == Size{64, 48}));
        trigger(*m_window, "redo");
        QTRY_VERIFY((current() == Size{50, 40}));
    }

    void everyToolIsUsedFromThePageAndUndone() {
        openBark(true);
        trigger(*m_window, "editExemplar");
        auto* editor = m_window->exemplarEditor();
        const Size whole = current();
        for (const Tool& tool : tools()) {
            if (tool.joins())
                continue;
            const QString id = QString::fromStdString(tool.id());
            if (auto* frame = editor->findChild<QToolButton*>(QStringLiteral("mode-") + id)) {
                frame->click();
                editor->findChild<QPushButton*>(QStringLiteral("apply-") + id)->click();
            } else if (auto* preset =
                           editor->findChild<QToolButton*>(QStringLiteral("preset-%1-0").arg(id))) {
                preset->click();
            } else {
                editor->findChild<QGroupBox*>(QStringLiteral("tool-") + id)->setChecked(true);
            }
            QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 1U);
            const RunExemplar& made = m_window->store()->current()->exemplar;
            QVERIFY2(&toolOf(made.edits.front()) == &tool, qPrintable(id));
            QVERIFY(made.companions.front().image->size() == made.image.image->size());
            QCOMPARE(child<QListWidget>(*editor, "editList")->count(), 1);
            trigger(*m_window, "undo");
            QTRY_VERIFY2(m_window->store()->current()->exemplar.edits.empty(), qPrintable(id));
            QVERIFY(current() == whole);
        }
    }

    void aCornerIsDraggedOrMovedByKeys() {
        openBark(false);
        trigger(*m_window, "editExemplar");
        auto* editor = m_window->exemplarEditor();
        EditCanvas* const canvas = editor->canvas();
        editor->setMode(QStringLiteral("rectify"));
        const PlanePoint before = canvas->corners()[1];
        const QPoint from = canvas->view().toWidget({before.x, before.y}).toPoint();
        QTest::mousePress(canvas, Qt::LeftButton, {}, from);
        QTest::mouseMove(canvas, from + QPoint(-30, 20));
        QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + QPoint(-30, 20));
        QVERIFY(canvas->corners()[1].x < before.x && canvas->corners()[1].y > before.y);
        const PlanePoint next = canvas->corners()[2];
        QTest::keyClick(canvas, Qt::Key_N);
        QTest::keyClick(canvas, Qt::Key_Left);
        QTest::keyClick(canvas, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(canvas->corners()[2].x, next.x - 1);
        QCOMPARE(canvas->corners()[2].y, next.y - 10);
        QCOMPARE(child<QSpinBox>(*editor, "rectify-4")->value(), static_cast<int>(std::lround(next.x - 1)));
        child<QPushButton>(*editor, "apply-rectify")->click();
        QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 1U);
        QVERIFY(m_window->store()->current()->exemplar.edits.front().contains("rectify"));
    }

    void lightAndAngleAreOneStepEach() {
        openBark(false);
        trigger(*m_window, "editExemplar");
        auto* editor = m_window->exemplarEditor();
        const int steps = m_window->undoHistory()->stack()->count();
        child<QGroupBox>(*editor, "tool-flatten")->setChecked(true);
        QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 1U);
        auto* angle = child<ValueEditor>(*editor, "edit-rotate");
        for (const double degrees : {1.0, 2.0, 3.5}) {
            angle->setValue(degrees);
            Q_EMIT angle->edited();
        }
        QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 2U);
        QTRY_VERIFY(m_window->store()->current()->exemplar.edits[0] == (ExemplarEdit{{"rotate", 3.5}}));
        QVERIFY(m_window->store()->current()->exemplar.edits[1].contains("flatten"));
        QCOMPARE(m_window->undoHistory()->stack()->count(), steps + 2);
        angle->setValue(0.0);
        Q_EMIT angle->edited();
        QTRY_COMPARE(m_window->store()->current()->exemplar.edits.size(), 1U);
    }

    void aPaintedMaskIsNeverCopied() {
        openBark(false);
        trigger(*m_window, "editExemplar");
        auto* editor = m_window->exemplarEditor();
        editor->setMode(QStringLiteral("hide"));
        editor->canvas()->setBrushSize(24);
        const QPoint from = editor->canvas()->view().toWidget({0, 24}).toPoint();
        const QPoint to = editor->canvas()->view().toWidget({20, 24}).toPoint();
        QTest::mousePress(editor->canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(editor->canvas(), to);
        QTest::mouseRelease(editor->canvas(), Qt::LeftButton, {}, to);
        QTRY_VERIFY(m_window->store()->current()->exemplar.mask);
        const Image& mask = *m_window->store()->current()->exemplar.mask->image;
        QCOMPARE(mask(10, 24, 0), 0.0F);
        QCOMPARE(mask(10, 2, 0), 1.0F);
        QVERIFY(!editor->canvas()->hidden().isNull());
        m_window->inspector()->setValues({{"patch", 8}});
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        m_window->startRun(false);
        QVERIFY(finished.wait(30'000));
        const PositionMap& map = m_window->desk()->result()->synthesis.map;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x)
                QVERIFY(mask(map.at(x, y).x, map.at(x, y).y, 0) != 0);
        trigger(*m_window, "undo");
        QTRY_VERIFY(!m_window->store()->current()->exemplar.mask);
    }

    void exampleSessionsOpenWithoutAFileAndRun() {
        const QStringList files = ExampleSessions::files();
        QVERIFY(files.size() >= 8);
        for (const QString& file : files) {
            const Session session = readSession(toPath(file));
            trigger(*m_window, qPrintable(QStringLiteral("example-") + QFileInfo(file).completeBaseName()));
            const std::string method = session.settings.steps.front().method;
            QTRY_COMPARE(m_window->inspector()->method()->id(), method);
            QTRY_VERIFY(m_window->store()->current() != nullptr &&
                        m_window->store()->current()->file().path.filename() ==
                            session.settings.exemplars.front().image.path.filename());
            QVERIFY(m_window->document()->file().isEmpty());
            QVERIFY2(m_window->messages()->text().isEmpty(), qPrintable(m_window->messages()->text()));
            QTRY_VERIFY2(m_window->desk()->canRun(), qPrintable(m_window->runPanel()->refusal()));
        }
    }

    void settingsAreUndoneAndOneDragIsOneStep() {
        openBark(false);
        ParamRow* const patch = m_window->inspector()->rows().front();
        const Value before = patch->value();
        QUndoStack* const stack = m_window->undoHistory()->stack();
        const int steps = stack->count();
        for (const int size : {9, 10, 11}) {
            patch->editor()->setValue(size);
            Q_EMIT patch->editor()->edited();
        }
        QCOMPARE(stack->count(), steps + 1);
        auto* method = child<QComboBox>(*m_window, "method");
        method->setCurrentIndex(method->findData(QStringLiteral("random-phase")));
        QCOMPARE(stack->count(), steps + 2);
        stack->undo();
        QCOMPARE(m_window->inspector()->method()->id(), std::string("quilting"));
        QVERIFY(m_window->inspector()->rows().front()->value() == Value(11));
        stack->undo();
        QVERIFY(m_window->inspector()->rows().front()->value() == before);
        stack->redo();
        QVERIFY(m_window->inspector()->rows().front()->value() == Value(11));
    }

    void aSessionComesBackWhole() {
        openBark(true);
        m_window->openFiles({writeTexture(*m_folder, QStringLiteral("moss.png"), {50, 50}, 9)});
        QTRY_COMPARE(m_window->store()->entries().size(), 2U);
        const int bark = m_window->store()->entries().front().id;
        m_window->store()->setEdits(bark, {{{"rotate", 90.0}}}, {});
        QTRY_COMPARE(m_window->store()->find(bark)->exemplar.edits.size(), 1U);
        m_window->store()->setChecked(bark, false);
        m_window->inspector()->setValues({{"patch", 9}});
        m_window->inspector()->output()->setOutputSize({123, 77});
        m_window->inspector()->output()->setSeed(42);
        const QString file = m_folder->filePath(QStringLiteral("work.texloom"));
        m_window->document()->saveTo(file, false);
        QTRY_VERIFY(m_window->windowTitle().contains(QStringLiteral("work")));
        const std::string saved = m_window->session().toJson("/");

        MainWindow other;
        other.show();
        other.openFiles({file});
        QTRY_COMPARE(other.document()->file(), file);
        QCOMPARE(other.session().toJson("/"), saved);
        QVERIFY(!other.document()->modified());
        QVERIFY((other.store()->entries().front().file().image->size() == Size{48, 64}));
        other.inspector()->output()->setSeed(43);
        QVERIFY(other.document()->modified());
        QVERIFY(other.isWindowModified());
        other.document()->saveTo(file, true); // closing would ask
        QTRY_VERIFY(QFile::exists(m_folder->filePath(QStringLiteral("work_files/bark_albedo.png"))));
        QTRY_VERIFY(!other.document()->modified());
    }

    void aNewSessionStartsAfresh() {
        QVERIFY(openAndFinish(*m_window, writeTexture(*m_folder, QStringLiteral("old.png"), {96, 80})));
        m_window->inspector()->output()->setOutputSize({832, 360});
        m_window->inspector()->output()->setSeed(5);
        auto* method = child<QComboBox>(*m_window, "method");
        const QString first = method->currentText();
        method->setCurrentIndex(method->count() - 1);
        QVERIFY(child<QAction>(*m_window, "export")->isEnabled());
        trigger(*m_window, "newSession");
        QTRY_VERIFY(child<QWidget>(*m_window, "startPage")->isVisible());
        QVERIFY(m_window->store()->entries().empty());
        QVERIFY(!m_window->desk()->result() &&
                !m_window->results()->viewer(ResultView::ResultTab)->picture());
        QVERIFY(m_window->results()->title().isEmpty());
        QVERIFY(!child<QAction>(*m_window, "export")->isEnabled());
        QVERIFY(!child<QAction>(*m_window, "undo")->isEnabled());
        QCOMPARE(method->currentText(), first);
        QVERIFY(m_window->inspector()->output()->seed() != 5U);
        QVERIFY(!m_window->document()->modified());

        // The preview comes by itself, and the size is the new exemplar's.
        QVERIFY(openAndFinish(*m_window, writeTexture(*m_folder, QStringLiteral("new.png"), {60, 50})));
        QVERIFY(m_window->desk()->controller()->quick());
        QVERIFY((m_window->inspector()->output()->outputSize() == Size{120, 100}));
    }

    void missingFilesAreAskedForAndTheRestIsKept() {
        openBark(true);
        m_window->openFiles({writeTexture(*m_folder, QStringLiteral("moss.png"), {50, 50}, 9)});
        QTRY_COMPARE(m_window->store()->entries().size(), 2U);
        const QString file = m_folder->filePath(QStringLiteral("work.texloom"));
        m_window->document()->saveTo(file, false);
        QTRY_VERIFY(QFile::exists(file));
        QDir folder(m_folder->path());
        QVERIFY(folder.mkdir(QStringLiteral("moved")));
        for (const char* name : {"bark_albedo.png", "bark_normal.png"})
            QVERIFY(folder.rename(QLatin1String(name), QStringLiteral("moved/") + QLatin1String(name)));
        QVERIFY(folder.remove(QStringLiteral("moss.png")));
        MainWindow other;
        other.show();
        other.openFiles({file});
        QTRY_VERIFY(other.findChild<MissingFilesDialog*>() != nullptr);
        auto* dialog = other.findChild<MissingFilesDialog*>();
        QCOMPARE(dialog->missing().size(), 3);
        dialog->found(m_folder->filePath(QStringLiteral("bark_albedo.png")),
                      m_folder->filePath(QStringLiteral("moved/bark_albedo.png")));
        QCOMPARE(dialog->missing(), QStringList{m_folder->filePath(QStringLiteral("moss.png"))});
        child<QPushButton>(*dialog, "goOn")->click();
        QTRY_COMPARE(other.store()->entries().size(), 1U);
        QCOMPARE(other.store()->current()->exemplar.companions.size(), 1U);
    }

    void somethingDroppedOnATargetGoesThere() {
        openBark(false);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(writeTexture(*m_folder, QStringLiteral("any.png"), {64, 48}, 5))});
        QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        auto* targets = child<DropTargets>(*m_window, "dropTargets");
        QVERIFY(targets->isVisible());
        const auto drop = [&](DropTargets::Target target) {
            targets->open(DropTargets::Dragged::Files, true);
            QDragEnterEvent over(targets->placeOf(target).center(), Qt::CopyAction, &data, Qt::LeftButton,
                                 Qt::NoModifier);
            QApplication::sendEvent(targets, &over);
            QDropEvent event(targets->placeOf(target).center(), Qt::CopyAction, &data, Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(targets, &event);
            QVERIFY(!targets->isVisible());
        };
        drop(DropTargets::Target::Companion);
        QTRY_COMPARE(m_window->store()->current()->exemplar.companions.size(), 1U);
        drop(DropTargets::Target::Mask);
        QTRY_VERIFY(m_window->store()->current()->exemplar.mask);
        drop(DropTargets::Target::Exemplar);
        QTRY_VERIFY(m_window->store()->current()->file().name() == "any");
        QTRY_COMPARE(m_window->store()->entries().size(), 1U);
        targets->open(DropTargets::Dragged::Picture, true); // a picture without a file can be no map
        QVERIFY(!targets->targetAt(targets->placeOf(DropTargets::Target::Mask).center()));
        QVERIFY(targets->targetAt(targets->placeOf(DropTargets::Target::Add).center()));
    }

    void presetsAreKeptImportedAndRefused() {
        auto* menu = child<PresetMenu>(*m_window, "presetMenu");
        m_window->inspector()->setValues({{"patch", 9}});
        menu->keep(QStringLiteral("Fine bark"));
        auto* kept = child<QAction>(*menu, "own-preset-fine-bark");
        m_window->inspector()->resetAll();
        kept->trigger();
        QVERIFY(m_window->inspector()->changedValues() == (Values{{"patch", 9}}));
        m_window->inspector()->setValues({{"patch", 11}});
        menu->keep(QStringLiteral("Fine bark"));
        QVERIFY(m_window->messages()->text().contains(QStringLiteral("already")));
        child<QPushButton>(*m_window, "messageAction")->click();
        m_window->inspector()->resetAll();
        trigger(*menu, "own-preset-fine-bark");
        QVERIFY(m_window->inspector()->changedValues() == (Values{{"patch", 11}}));
        const QString file = m_folder->filePath(QStringLiteral("coarse.json"));
        menu->exportTo(file, QStringLiteral("Coarse"));
        menu->importFrom(file);
        QVERIFY(menu->findChild<QAction*>(QStringLiteral("own-preset-coarse")) != nullptr);
        menu->remove(QStringLiteral("coarse"));
        menu->remove(QStringLiteral("fine-bark"));
        QFile newer(file);
        QVERIFY(newer.open(QIODevice::WriteOnly));
        newer.write(R"({"preset": 2, "title": "", "summary": "", "steps": []})");
        newer.close();
        menu->importFrom(file);
        QVERIFY(m_window->messages()->text().contains(QStringLiteral("newer")));
    }

    void aNewerSessionIsRefusedInWords() {
        const QString file = m_folder->filePath(QStringLiteral("new.texloom"));
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(R"({"session": 99})");
        out.close();
        m_window->openFiles({file});
        QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("newer")));
        QVERIFY(m_window->document()->file().isEmpty());
    }

    void ticksAreUndone() {
        openBark(false);
        ExemplarStore* const store = m_window->store();
        const int id = store->current()->id;
        auto* undo = child<QAction>(*m_window, "undo");
        store->setChecked(id, false);
        QVERIFY(undo->text().contains(QStringLiteral("Leave exemplar out")));
        undo->trigger();
        QVERIFY(store->current()->checked);
        trigger(*m_window, "redo");
        QVERIFY(!store->current()->checked);
    }

    void masksThatNobodyNamesAreRemovedInTime() {
        openBark(false);
        m_window->store()->paintMask(m_window->store()->current()->id, Image({64, 48}, 1), true);
        QTRY_VERIFY(m_window->store()->current()->exemplar.mask);
        const QString named = toQString(m_window->store()->current()->exemplar.mask->path);
        const QString old = ownFolder() + QStringLiteral("/old_mask.png");
        QVERIFY(QFile::copy(named, old));
        for (const QString& path : {named, old}) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadWrite));
            QVERIFY(file.setFileTime(QDateTime::currentDateTime().addDays(-9),
                                     QFileDevice::FileModificationTime));
        }
        removeOldFiles({m_window->session().settings}, m_folder->filePath(QStringLiteral("recovery")));
        QVERIFY(QFile::exists(named));
        QVERIFY(!QFile::exists(old));
    }

private:
    /// bark_albedo.png, 64 × 48 px, with its normal map if wanted; its first quick run has ended.
    void openBark(bool normal) {
        QStringList files{writeTexture(*m_folder, QStringLiteral("bark_albedo.png"), {64, 48})};
        if (normal)
            files += writeTexture(*m_folder, QStringLiteral("bark_normal.png"), {64, 48}, 2);
        QSignalSpy finished(m_window->desk()->controller(), &RunController::finished);
        m_window->openFiles(files);
        QVERIFY(finished.wait(30'000));
    }
    Size current() const { return m_window->store()->current()->file().image->size(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(SessionTest)
#include "session_test.moc"
