#include "core/tools/edits.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/background.h"
#include "ui/common/elided_label.h"
#include "ui/common/reading_bar.h"
#include "ui/common/readings.h"
#include "ui/exemplar/edit_preview.h"
#include "ui/exemplar/exemplar_editor.h"

#include <QListWidget>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>

#include <memory>

using namespace texloom;
using namespace texloom::ui;

namespace {

constexpr Size kLarge{1700, 1500};

/// Holds all workers up while it exists, so that what they are to do stays undone.
class BusyWorkers {
public:
    BusyWorkers() {
        for (int i = 0; i < m_count; ++i)
            workers().start([gate = m_gate] { gate->acquire(); });
    }
    ~BusyWorkers() { release(); }
    BusyWorkers(const BusyWorkers&) = delete;
    BusyWorkers& operator=(const BusyWorkers&) = delete;

    void release() {
        m_gate->release(m_count);
        m_count = 0;
    }

private:
    int m_count = workers().maxThreadCount();
    std::shared_ptr<QSemaphore> m_gate = std::make_shared<QSemaphore>();
};

} // namespace

/// Edits of exemplars that are so large that one waits for them.
class EditingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        QVERIFY(openAndFinish(*m_window, writeTexture(m_folder, QStringLiteral("large.png"), kLarge)));
        trigger(*m_window, "editExemplar");
        QVERIFY(EditPreview::worthwhile(kLarge));
    }

    void cleanupTestCase() { m_window.reset(); }

    void cleanup() {
        workers().waitForDone();
        QTRY_VERIFY(wanted() == made());
        set({});
        QTRY_VERIFY_WITH_TIMEOUT(made().empty() && m_window->store()->loading() == 0, kPatience);
    }

    void whatIsAskedForIsListedAndPreviewedAtOnce() {
        BusyWorkers busy;
        set({{{"rotate", 90.0}}});
        auto* list = child<QListWidget>(*m_window, "editList");
        QCOMPARE(list->count(), 1);
        QVERIFY2(list->item(0)->text().contains(QStringLiteral("being made")),
                 qPrintable(list->item(0)->text()));
        QVERIFY(made().empty());
        ImageViewer* const canvas = m_window->exemplarEditor()->canvas();
        const Size turned{kLarge.height, kLarge.width};
        QTRY_VERIFY_WITH_TIMEOUT(canvas->picture()->size() == turned, kPatience);
        QVERIFY(canvas->picture()->step() > 1);
        QCOMPARE(canvas->badge(), QStringLiteral("Preview"));
        // A further edit adds to what is under way.
        set(withFlip(m_window->store()->wantedEdits(id())));
        QCOMPARE(list->count(), 2);
        busy.release();
        QTRY_COMPARE_WITH_TIMEOUT(made().size(), std::size_t{2}, kPatience);
        QVERIFY(canvas->picture() == m_window->store()->current()->picture);
        QVERIFY(canvas->badge().isEmpty());
        QVERIFY(!list->item(0)->text().contains(QStringLiteral("being made")));
    }

    void cancelTakesBackWhatIsNotMade() {
        BusyWorkers busy;
        set({{{"rotate", 7.0}}});
        set(withFlip(m_window->store()->wantedEdits(id())));
        auto* bar = child<ReadingBar>(*m_window, "readingBar");
        QTRY_VERIFY(bar->isVisible());
        QVERIFY(
            child<ElidedLabel>(*bar, "readingText")->fullText().startsWith(QStringLiteral("Editing large")));
        child<QPushButton>(*bar, "cancelReading")->click();
        busy.release();
        auto* list = child<QListWidget>(*m_window, "editList");
        QTRY_COMPARE(list->count(), 0);
        QVERIFY(wanted().empty() && made().empty());
        QTRY_VERIFY(bar->isHidden());
        ImageViewer* const canvas = m_window->exemplarEditor()->canvas();
        QTRY_VERIFY(canvas->picture() == m_window->store()->current()->picture);
        QVERIFY(canvas->badge().isEmpty());
    }

    void anEditUnderWayIsBrokenOff() {
        set({{{"rotate", 11.0}}});
        QTest::qWait(20); // it is being made by now, which takes longer than that
        Readings::all().stop();
        QTRY_COMPARE_WITH_TIMEOUT(Readings::all().count(), 0, kPatience);
        QVERIFY(made().empty());
    }

    void aDraggedSliderMakesItsLastValueAlone() {
        QSignalSpy edited(m_window->store(), &ExemplarStore::edited);
        BusyWorkers busy;
        for (const double angle : {2.0, 3.0, 4.0, 5.0})
            m_window->store()->setEdits(id(), {{{"rotate", angle}}}, QStringLiteral("Turn"),
                                        QStringLiteral("turn"));
        busy.release();
        QTRY_VERIFY_WITH_TIMEOUT((made() == ExemplarEdits{{{"rotate", 5.0}}}), kPatience);
        QCOMPARE(edited.count(), 1);
        trigger(*m_window, "undo");
        QTRY_VERIFY_WITH_TIMEOUT(made().empty(), kPatience);
    }

private:
    int id() const { return m_window->store()->current()->id; }
    const ExemplarEdits& made() const { return m_window->store()->current()->exemplar.edits; }
    ExemplarEdits wanted() const { return m_window->store()->wantedEdits(id()); }
    void set(const ExemplarEdits& edits) { m_window->store()->setEdits(id(), edits, QStringLiteral("Edit")); }
    static ExemplarEdits withFlip(ExemplarEdits edits) {
        edits.push_back({{"flip", std::string("vertical")}});
        return edits;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

TEXLOOM_UI_TESTS(EditingTest)
#include "editing_test.moc"
