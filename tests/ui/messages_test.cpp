// What core has to say, in the user's language: patterns, values, and what was stored in another language.

#include "core/base/error.h"
#include "core/io/message_json.h"
#include "core/methods/method.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/background.h"
#include "ui/common/language.h"
#include "ui/common/message_bar.h"
#include "ui/common/text.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/param_row.h"
#include "ui/jobs/run_panel.h"
#include "ui/runs/result_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>

using namespace texloom;
using namespace texloom::ui;

namespace {

/// The window's own language for a while.
class Speaking {
public:
    explicit Speaking(const char* language) { useLanguage(QLocale(QLatin1String(language))); }
    ~Speaking() { useLanguage(QLocale::c()); }
    Speaking(const Speaking&) = delete;
    Speaking& operator=(const Speaking&) = delete;
};

/// Every pattern of a message in the sources.
QStringList patternsOfTheSources() {
    const QString root = QStringLiteral(TEXLOOM_SOURCE_DIR);
    QProcess collector;
    collector.start(QStringLiteral("python3"),
                    {root + QStringLiteral("/resources/translations/collect_core.py"), root,
                     QStringLiteral("--patterns")});
    if (!collector.waitForFinished())
        return {};
    QStringList patterns;
    for (const QJsonValue& pattern : QJsonDocument::fromJson(collector.readAllStandardOutput()).array())
        patterns += pattern.toString();
    return patterns;
}

/// A message of this pattern whose values are told from all else.
Message filled(const QString& pattern) {
    const std::string text = pattern.toStdString();
    std::vector<Message> values;
    for (std::size_t i = 0; i < placesIn(text).size(); ++i)
        values.push_back(Message::verbatim("‹" + std::to_string(i) + "›"));
    return Message(text, std::move(values));
}

/// The sentence of what `failing` throws.
template <class Failing> QString refusalOf(const Failing& failing) {
    try {
        failing();
    } catch (const std::exception& error) {
        return sentence(error);
    }
    return {};
}

QString wrongPatch() {
    return refusalOf([] { findMethod("quilting").param("patch").checked(9999); });
}

} // namespace

class MessagesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyPatternKeepsItsValuesInEveryLanguage() {
        const QStringList patterns = patternsOfTheSources();
        QVERIFY2(patterns.size() > 100, "the collector found no patterns");
        for (const char* language : {"de", "fr"}) {
            const Speaking speaking(language);
            for (const QString& pattern : patterns) {
                const Message message = filled(pattern);
                const QString text = translated(message);
                for (const Message& value : message.values())
                    QCOMPARE(text.count(QString::fromStdString(value.text())), 1);
                QVERIFY2(!text.contains(QLatin1Char('{')), qPrintable(text));
                const bool words = pattern.count(QLatin1Char(' ')) > 3;
                QVERIFY2(!words || text != QString::fromStdString(message.text()), qPrintable(text));
            }
        }
    }

    void anErrorIsTranslatedWithItsValues() {
        QCOMPARE(wrongPatch(), QStringLiteral("patch = 9999: Patch size goes from 4 to 512 px."));
        {
            const Speaking german("de");
            QCOMPARE(wrongPatch(), QStringLiteral("patch = 9999: Patchgröße geht von 4 bis 512 px."));
        }
        const Speaking french("fr");
        QCOMPARE(wrongPatch(), QStringLiteral("patch = 9999 : Taille du patch va de 4 à 512 px."));
    }

    void valuesStandInAnotherOrderWhereTheLanguageWantsIt() {
        const auto refused = [] {
            failUsage("The {} {} is {} × {} px, but {} is {} × {} px; they must be the same size.",
                      Message(TR("companion")), "moss", 2, 3, "bark", 4, 5);
        };
        QCOMPARE(refusalOf(refused),
                 QStringLiteral(
                     "The companion moss is 2 × 3 px, but bark is 4 × 5 px; they must be the same size."));
        const Speaking german("de");
        QCOMPARE(
            refusalOf(refused),
            QStringLiteral("moss (Begleitkarte) ist 2 × 3 px groß, bark aber 4 × 5 px; sie müssen gleich "
                           "sein."));
    }

    void whatStandsBeforeAColonStays() {
        const Message inner = message("{} learns from one exemplar, but {} were given.",
                                      Message(findMethod("quilting").info().title), 3);
        const Message message = texloom::message("{}: {}", "no {} of mine.json", inner);
        const Speaking german("de");
        QCOMPARE(translated(message),
                 QStringLiteral("no {} of mine.json: Bild-Quilting lernt von einer Vorlage, "
                                "gegeben wurden aber 3."));
    }

    void whatWasStoredIsShownInTheLanguageOfToday() {
        ResultEntry entry;
        entry.recipe.steps = {{"quilting", {}}};
        entry.notes = {message("{} was not straightened, since too little of it would be left.", "bark"),
                       Message("A sentence of an earlier version about 3 px.")};
        entry.figures = {{message("Deviation, {}", Message(TR("Marginals"))), 0.5}};
        entry.notes = messagesFrom(toJson(entry.notes));
        QVERIFY(detailsText(entry).contains(QStringLiteral("bark was not straightened")));
        const Speaking german("de");
        const QString details = detailsText(entry);
        QVERIFY2(details.contains(QStringLiteral("bark wurde nicht gerade gerichtet")), qPrintable(details));
        QVERIFY2(details.contains(QStringLiteral("A sentence of an earlier version")), qPrintable(details));
        QVERIFY2(details.contains(QStringLiteral("Abweichung, Randverteilungen")), qPrintable(details));
    }

    void theWindowRefusesInItsLanguage() {
        const Speaking german("de");
        MainWindow window;
        window.show();
        QVERIFY(openAndFinish(window, writeTexture(m_folder, QStringLiteral("bark.png"), {48, 40})));
        window.inspector()->rows().front()->setValue(512);
        Q_EMIT window.inspector()->edited();
        QTRY_VERIFY2(window.runPanel()->refusal().contains(QStringLiteral(
                         "48 × 40 px groß, kleiner als der Patch von 512 px; wählen Sie einen")),
                     qPrintable(window.runPanel()->refusal()));
        window.openFiles({QStringLiteral("/no/such/picture.png")});
        QTRY_COMPARE(window.messages()->text(), QStringLiteral("Es gibt keine Datei /no/such/picture.png."));
    }

private:
    QTemporaryDir m_folder;
};

TEXLOOM_UI_TESTS(MessagesTest)

#include "messages_test.moc"
