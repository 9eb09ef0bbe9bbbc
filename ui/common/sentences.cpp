#include "ui/common/sentences.h"

#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <optional>
#include <vector>

namespace texloom::ui {

namespace {

const QRegularExpression& valueInPattern() {
    static const QRegularExpression value(QStringLiteral("\\{[^}]*\\}"));
    return value;
}

QString inLanguage(const QString& text) {
    return QCoreApplication::translate("core", text.toUtf8().constData());
}

/// One of core's sentences with {} where its values go.
struct Pattern {
    QString text;
    QRegularExpression whole;
    qsizetype letters = 0; ///< apart from values: of two that fit, the one with more says more

    explicit Pattern(const QString& line) : text(line) {
        QString expression;
        qsizetype end = 0;
        for (auto values = valueInPattern().globalMatch(line); values.hasNext();) {
            const QRegularExpressionMatch value = values.next();
            expression += QRegularExpression::escape(line.mid(end, value.capturedStart() - end)) +
                          QStringLiteral("(.*?)");
            letters += value.capturedStart() - end;
            end = value.capturedEnd();
        }
        expression += QRegularExpression::escape(line.mid(end));
        letters += line.size() - end;
        whole = QRegularExpression(QRegularExpression::anchoredPattern(expression),
                                   QRegularExpression::DotMatchesEverythingOption);
    }
};

std::vector<Pattern> readPatterns() {
    QFile file(QStringLiteral(":/translations/sentences.txt"));
    std::vector<Pattern> patterns;
    if (file.open(QIODevice::ReadOnly))
        for (const QString& line :
             QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
            patterns.emplace_back(line);
    std::stable_sort(patterns.begin(), patterns.end(),
                     [](const Pattern& a, const Pattern& b) { return a.letters > b.letters; });
    return patterns;
}

/// The translation with the values in place of {}, which may be numbered to stand in another order.
QString filled(const QString& translation, const QStringList& values) {
    QString text;
    qsizetype end = 0, next = 0;
    for (auto places = valueInPattern().globalMatch(translation); places.hasNext();) {
        const QRegularExpressionMatch place = places.next();
        bool numbered = false;
        const qsizetype number = place.captured().mid(1, place.capturedLength() - 2).toInt(&numbered);
        text += translation.mid(end, place.capturedStart() - end) + values.value(numbered ? number : next++);
        end = place.capturedEnd();
    }
    return text + translation.mid(end);
}

/// A value, such as the title of a method; with the name of a file before a colon, where there is one.
QString valueInLanguage(const QString& value) {
    const qsizetype colon = value.lastIndexOf(QStringLiteral(": "));
    return colon < 0 ? inLanguage(value) : value.left(colon + 2) + inLanguage(value.mid(colon + 2));
}

std::optional<QString> fromPattern(const QString& sentence) {
    static const std::vector<Pattern> patterns = readPatterns();
    for (const Pattern& pattern : patterns)
        if (const QRegularExpressionMatch match = pattern.whole.match(sentence); match.hasMatch()) {
            QStringList values = match.capturedTexts().mid(1);
            for (QString& value : values)
                value = valueInLanguage(value);
            return filled(inLanguage(pattern.text), values);
        }
    return std::nullopt;
}

} // namespace

QString translatedSentence(const QString& sentence) {
    if (QString whole = inLanguage(sentence); whole != sentence)
        return whole;
    if (const auto translated = fromPattern(sentence))
        return *translated;
    const qsizetype colon = sentence.indexOf(QStringLiteral(": "));
    if (colon < 0)
        return sentence;
    const QString rest = sentence.mid(colon + 2);
    return sentence.left(colon + 2) + fromPattern(rest).value_or(inLanguage(rest));
}

} // namespace texloom::ui
