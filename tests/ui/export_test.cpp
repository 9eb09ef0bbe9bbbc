#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/export/export_dialog.h"
#include "ui/export/own_presets.h"
#include "ui/export/preset_editor.h"
#include "ui/export/preset_files_table.h"
#include "ui/inspector/output_group.h"
#include "ui/maps/result_view.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>

using namespace texloom;
using namespace texloom::ui;

class ExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        QDir(OwnExportPresets::folder()).removeRecursively(); // of a run that was broken off
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("felt.png"), {48, 48})));
    }

    void cleanupTestCase() { m_window.reset(); }

    void listsThenWritesTheFiles() {
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        child<QCheckBox>(*dialog, "exportStMap")->setChecked(true);
        child<QCheckBox>(*dialog, "exportExactMap")->setChecked(true);
        auto* table = child<QTableWidget>(*dialog, "exportTable");
        QStringList listed;
        for (int row = 0; row < table->rowCount(); ++row) {
            listed += table->item(row, 0)->text();
            QCOMPARE(table->item(row, 3)->text(), QStringLiteral("new"));
        }
        QCOMPARE(listed.size(), 4);
        QVERIFY(QDir(target.path()).isEmpty());
        child<QPushButton>(*dialog, "exportWrite")->click();
        QTRY_VERIFY(m_window->messages()->text().startsWith(QStringLiteral("Wrote 4 files")));
        QVERIFY(m_window->messages()->text().contains(target.path()));
        listed.sort();
        QCOMPARE(QDir(target.path()).entryList(QDir::Files, QDir::Name), listed);
        for (const QString& file : listed)
            if (file.endsWith(QStringLiteral("_map.png")))
                QVERIFY(readPositionMap(toPath(target.filePath(file))) ==
                        m_window->desk()->result()->synthesis.map);
    }

    void namesFollowTheTemplateAndThePreset() {
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        auto* name = child<QLineEdit>(*dialog, "exportName");
        auto* table = child<QTableWidget>(*dialog, "exportTable");
        name->setText(QStringLiteral("$name-$w-$map"));
        QCOMPARE(table->item(0, 0)->text(), QStringLiteral("felt-96-.png"));
        name->setText(QStringLiteral("$nam"));
        QVERIFY(dialog->refusal().contains(QStringLiteral("$name")));
        QCOMPARE(table->rowCount(), 0);
        auto* preset = child<QComboBox>(*dialog, "exportPreset");
        preset->setCurrentIndex(preset->findData(QStringLiteral("unreal")));
        QCOMPARE(table->item(0, 0)->text(), QStringLiteral("T_felt_BC.png"));
        dialog->reject();
    }

    void presetsOfOnesOwnAreMadeChangedAndDeleted() {
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        auto* presets = child<QComboBox>(*dialog, "exportPreset");
        presets->setCurrentIndex(presets->findData(QStringLiteral("unreal")));
        const auto open = [&] {
            // The one before it goes away later.
            if (!QTest::qWaitFor([&] { return dialog->findChild<PresetEditor*>() == nullptr; }))
                qFatal("the editor stays");
            child<QToolButton>(*dialog, "exportEditPresets")->click();
            auto* editor = child<PresetEditor>(*dialog, "presetEditor");
            settle();
            return editor;
        };
        PresetEditor* editor = open();
        auto* list = child<QListWidget>(*editor, "presetList");
        QCOMPARE(list->currentItem()->text(), QStringLiteral("Unreal Engine"));
        QVERIFY(!child<QLineEdit>(*editor, "presetPattern")->isEnabled()); // Texloom's own
        child<QPushButton>(*editor, "addPreset")->click();
        const auto type = [&](const char* name, const QString& text) {
            auto* field = child<QLineEdit>(*editor, name);
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
        };
        type("presetTitle", QStringLiteral("Our engine"));
        QCOMPARE(list->currentItem()->text(), QStringLiteral("Our engine"));
        auto* keep = child<QPushButton>(*editor, "keepPresets");
        type("presetPattern", QStringLiteral("tex_$name"));
        QVERIFY2(!keep->isEnabled(), "maps would have one name");
        QVERIFY(child<QLabel>(*editor, "presetNote")->text().contains(QStringLiteral("$map")));
        type("presetPattern", QStringLiteral("tex_$name_$map"));
        type("presetColor", QStringLiteral("col"));
        auto* files = child<PresetFilesTable>(*editor, "presetFiles");
        const std::vector<PresetFile> unreal = findExportPreset("unreal").files;
        QCOMPARE(files->rowCount(), static_cast<int>(unreal.size()));
        child<QPushButton>(*editor, "addPresetFile")->click();
        files->item(files->rowCount() - 1, PresetFilesTable::Word)->setText(QStringLiteral("rough"));
        auto* holds =
            qobject_cast<QComboBox*>(files->cellWidget(files->rowCount() - 1, PresetFilesTable::Holds));
        holds->setCurrentIndex(holds->findData(static_cast<int>(MapRole::Roughness)));
        Q_EMIT holds->activated(holds->currentIndex());
        QVERIFY(keep->isEnabled());
        keep->click();

        QCOMPARE(presets->currentText(), QStringLiteral("Our engine"));
        ExportPreset kept = dialog->options().preset;
        QVERIFY((kept.files.back() == PresetFile{"rough", MapRole::Roughness}));
        kept.files.pop_back();
        QVERIFY(kept.files.size() == unreal.size() && kept.files[1] == unreal[1]);
        QCOMPARE(child<QTableWidget>(*dialog, "exportTable")->item(0, 0)->text(),
                 QStringLiteral("tex_felt_col.png"));
        const QString file = OwnExportPresets::fileOf(kept);
        QVERIFY(exportPresetFrom(file.toStdString()) == dialog->options().preset);

        editor = open();
        list = child<QListWidget>(*editor, "presetList");
        QCOMPARE(list->currentItem()->text(), QStringLiteral("Our engine"));
        child<QPushButton>(*editor, "removePreset")->click();
        QTest::keyClick(editor, Qt::Key_Escape);
        QVERIFY2(QFile::exists(file), "not before it is kept");
        editor = open();
        child<QPushButton>(*editor, "removePreset")->click();
        child<QPushButton>(*editor, "keepPresets")->click();
        QVERIFY(!QFile::exists(file));
        QVERIFY(presets->findText(QStringLiteral("Our engine")) < 0);
        dialog->reject();
    }

    void marksWhatWillBeReplaced() {
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        child<QCheckBox>(*dialog, "exportSidecar")->setChecked(false);
        QFile there(toQString(dialog->options().image));
        QVERIFY(there.open(QIODevice::WriteOnly));
        there.write("mine");
        there.close();
        child<QLineEdit>(*dialog, "exportName")->textChanged({});
        auto* table = child<QTableWidget>(*dialog, "exportTable");
        QCOMPARE(table->rowCount(), 1);
        QVERIFY(table->item(0, 3)->text().contains(QStringLiteral("not Texloom's")));
        auto* write = child<QPushButton>(*dialog, "exportWrite");
        auto* foreign = child<QCheckBox>(*dialog, "exportForeign");
        QVERIFY(!write->isEnabled() && foreign->isVisible());
        foreign->setChecked(true);
        QVERIFY(write->isEnabled());
        foreign->setChecked(false);
        writeImage(toPath(there.fileName()), test::constant({8, 8}, 3, 0.5F), {});
        child<QLineEdit>(*dialog, "exportName")->textChanged({});
        QVERIFY(table->item(0, 3)->text().contains(QStringLiteral("replaces the file there")));
        QVERIFY(write->isEnabled() && !foreign->isVisible());
        dialog->reject();
    }

    void offersTheDepthsOfTheFormat() {
        const QTemporaryDir target;
        ExportDialog* const dialog = openDialog(target.path());
        auto* format = child<QComboBox>(*dialog, "exportFormat");
        auto* depth = child<QComboBox>(*dialog, "exportDepth");
        for (int i = 0; i < format->count(); ++i) {
            format->setCurrentIndex(i);
            const auto depths = depthsFor(dialog->options().image);
            QCOMPARE(depth->count(), static_cast<int>(depths.size()));
            QCOMPARE(dialog->options().depth, depths.front());
        }
        dialog->reject();
    }

    void saysWhyItCannotBeWritten() {
        ExportDialog* const dialog = openDialog(m_folder.path());
        auto* write = child<QPushButton>(*dialog, "exportWrite");
        QVERIFY(write->isEnabled());
        for (const auto& [field, value] : {std::pair("exportName", ""), std::pair("exportName", "a/b"),
                                           std::pair("exportFolder", "/not/there")}) {
            auto* edit = child<QLineEdit>(*dialog, field);
            const QString before = edit->text();
            edit->setText(QLatin1String(value));
            QVERIFY(!write->isEnabled());
            QVERIFY(child<QLabel>(*dialog, "exportProblem")->text().size() > 10);
            edit->setText(before);
            QVERIFY(write->isEnabled());
        }
        dialog->reject();
    }

    void copyPutsTheResultOnTheClipboard() {
        trigger(*m_window, "copyResult");
        const QImage copied = QApplication::clipboard()->image();
        const QImage& shown = m_window->results()->viewer(ResultView::ResultTab)->picture()->image();
        QCOMPARE(copied.convertToFormat(QImage::Format_RGB32), shown.convertToFormat(QImage::Format_RGB32));
    }

private:
    ExportDialog* openDialog(const QString& folder) {
        trigger(*m_window, "export");
        ExportDialog* dialog = child<ExportDialog>(*m_window, "exportDialog");
        for (auto* opened : m_window->findChildren<ExportDialog*>())
            if (opened->isVisible())
                dialog = opened;
        child<QLineEdit>(*dialog, "exportFolder")->setText(folder);
        return dialog;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(ExportTest)
#include "export_test.moc"
