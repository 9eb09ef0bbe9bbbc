#include "core/io/image_file.h"
#include "core/io/map_file.h"
#include "tests/support/textures.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/export/export_dialog.h"
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
#include <QPushButton>
#include <QTableWidget>

using namespace texloom;
using namespace texloom::ui;

class ExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
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
