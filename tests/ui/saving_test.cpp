#include "core/image/image.h"
#include "core/io/image_file.h"
#include "core/session/run/exemplar_file.h"
#include "core/session/session.h"
#include "core/volume/volume_source.h"
#include "tests/ui/window_fixture.h"
#include "ui/blend/blend_window.h"
#include "ui/common/message_bar.h"
#include "ui/common/save_guard.h"
#include "ui/common/text.h"
#include "ui/compare/comparisons.h"
#include "ui/export/export_dialog.h"
#include "ui/maps/result_view.h"
#include "ui/material/material_page.h"
#include "ui/material/material_view.h"
#include "ui/session/document.h"
#include "ui/session/preset_menu.h"
#include "ui/volume/slice_view.h"
#include "ui/volume/volume_page.h"

#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <memory>

using namespace texloom;
using namespace texloom::ui;

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& content) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}

} // namespace

/// No save of the window takes a file that is in use, nor one of somebody else's that nobody asked about.
class SavingTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_picture;
    QByteArray m_before;
    std::unique_ptr<MainWindow> m_window;

    QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    VolumePage* volumes() const { return m_window->findChild<VolumePage*>(); }

    /// Whether a sentence names a file that is in use, which is as it was.
    bool isKept(const QString& sentence, const QString& path, const QByteArray& before) const {
        return sentence.contains(QStringLiteral("would be overwritten")) && sentence.contains(path) &&
               contentOf(path) == before;
    }
    bool isKept(const QString& sentence) const { return isKept(sentence, m_picture, m_before); }

private Q_SLOTS:
    void initTestCase() {
        m_picture = writeTexture(m_folder, QStringLiteral("bark.png"), {64, 64});
        m_before = contentOf(m_picture);
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(openAndFinish(*m_window, m_picture));
    }
    void cleanupTestCase() { m_window.reset(); }

    void aBlendLeavesItsPicturesAndTheExemplars() {
        const QString other = writeTexture(m_folder, QStringLiteral("other.png"), {64, 64}, 2);
        const QByteArray before = contentOf(other);
        BlendWindow blend({{QStringLiteral("a"), loadExemplar(toPath(m_picture))},
                           {QStringLiteral("b"), loadExemplar(toPath(other))}});
        blend.show();
        QTRY_VERIFY_WITH_TIMEOUT(blend.viewer(0)->picture(), kPatience);
        blend.save(0, m_picture);
        QTRY_VERIFY2(isKept(blend.message()), qPrintable(blend.message()));
        blend.save(0, other);
        QTRY_VERIFY2(isKept(blend.message(), other, before), qPrintable(blend.message()));
        // What the user was asked about may be replaced.
        put(file("theirs.png"), "of somebody else");
        blend.save(0, file("theirs.png"));
        QTRY_VERIFY_WITH_TIMEOUT(blend.message().contains(QStringLiteral("Wrote")), kPatience);
    }

    void partsOfAVolumeLeaveThem() {
        const auto grey = std::make_shared<DenseSource>(Volume({4, 4, 4}, 1), DenseSource::Edge::Repeats);
        volumes()->setVolumes({{QStringLiteral("grey"), {grey, {}}}});
        volumes()->saveSlice(*volumes()->slice(Axis::Z), m_picture);
        QTRY_VERIFY2(isKept(volumes()->message()), qPrintable(volumes()->message()));
        put(file("box.raw"), "of somebody else");
        volumes()->saveBox({0, 0, 0, {2, 2, 2}}, file("box.json"));
        QTRY_VERIFY2(volumes()->message().contains(QStringLiteral("box.raw is there")),
                     qPrintable(volumes()->message()));
        QCOMPARE(contentOf(file("box.raw")), QByteArray("of somebody else"));
        QVERIFY(!QFile::exists(file("box.json")));
        put(file("part-0001.png"), "of somebody else");
        volumes()->saveBox({0, 0, 0, {2, 2, 2}}, file("part.png"));
        QTRY_VERIFY2(volumes()->message().contains(QStringLiteral("part-0001.png is there")),
                     qPrintable(volumes()->message()));
        QVERIFY(!QFile::exists(file("part-0000.png")));
    }

    void picturesOfAMaterialLeaveThem() {
        auto* page = m_window->findChild<MaterialPage*>();
        m_window->results()->showPage(page);
        QTRY_VERIFY_WITH_TIMEOUT(page->view()->material() && page->view()->light() && page->view()->mesh(),
                                 kPatience);
        page->savePicture(m_picture);
        QTRY_VERIFY2(isKept(page->message()), qPrintable(page->message()));
        const QString panorama = writeTexture(m_folder, QStringLiteral("sky.png"), {32, 16});
        const QByteArray before = contentOf(panorama);
        const auto light = page->view()->light();
        page->openPanorama(panorama);
        QTRY_VERIFY_WITH_TIMEOUT(page->view()->light() != light, kPatience);
        page->savePicture(panorama);
        QTRY_VERIFY2(isKept(page->message(), panorama, before), qPrintable(page->message()));
    }

    void aContactSheetLeavesThem() {
        auto* comparisons = m_window->findChild<Comparisons*>();
        const QSignalSpy failures(comparisons, &Comparisons::failed);
        comparisons->saveSheet(m_picture);
        QTRY_COMPARE(failures.count(), 1);
        QVERIFY(isKept(failures[0][0].toString()));
    }

    void aPresetLeavesThem() {
        auto* presets = m_window->findChild<PresetMenu*>();
        const QSignalSpy failures(presets, &PresetMenu::failed);
        presets->exportTo(m_picture, QStringLiteral("Bark"));
        QCOMPARE(failures.count(), 1);
        QVERIFY(isKept(failures[0][0].toString()));
    }

    void aSessionLeavesThemAndIsSavedAgain() {
        m_window->document()->saveTo(m_picture, false);
        QTRY_VERIFY2(isKept(m_window->messages()->text()), qPrintable(m_window->messages()->text()));
        const QString session = file("work.texloom");
        for (int times = 0; times < 2; ++times) {
            m_window->messages()->dismiss();
            m_window->document()->saveTo(session, false);
            QTRY_VERIFY(m_window->messages()->text().contains(QStringLiteral("Saved work.texloom")));
            QVERIFY(readSession(toPath(session)).settings.exemplars.size() == 1);
        }
        const QByteArray before = contentOf(session);
        m_window->findChild<Comparisons*>()->saveSheet(session); // by whom it is not
        QTRY_VERIFY2(isKept(m_window->messages()->text(), session, before),
                     qPrintable(m_window->messages()->text()));
    }

    void anExportLeavesWhatIsOpen() {
        const QString open = writeTexture(m_folder, QStringLiteral("beside.png"), {40, 40}, 3);
        m_window->openFiles({open});
        QTRY_COMPARE_WITH_TIMEOUT(m_window->store()->entries().size(), std::size_t{2}, kPatience);
        ExportDialog dialog(m_window->desk()->result(), m_folder.path(), m_window.get());
        child<QLineEdit>(dialog, "exportName")->setText(QStringLiteral("beside"));
        QVERIFY2(dialog.refusal().contains(QStringLiteral("beside.png would be overwritten")),
                 qPrintable(dialog.refusal()));
    }

    void aNameHasItsEndingBeforeTheUserIsAsked() {
        put(file("kept.texloom"), "of somebody else");
        bool asked = false;
        QTimer typist;
        connect(&typist, &QTimer::timeout, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                asked = true;
                box->button(QMessageBox::Yes)->click();
            } else if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                child<QLineEdit>(*dialog, "fileNameEdit")->setText(QStringLiteral("kept"));
                // Later: a timer does not fire again within its own event.
                QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
            }
        });
        typist.start(50);
        const QString chosen = askWhereToSave(nullptr, QStringLiteral("Save"), m_folder.path(), {},
                                              {QStringLiteral("texloom"), true});
        QVERIFY(asked);
        QCOMPARE(QFileInfo(chosen).fileName(), QStringLiteral("kept.texloom"));
    }
};

TEXLOOM_UI_TESTS(SavingTest)
#include "saving_test.moc"
