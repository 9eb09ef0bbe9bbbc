#include "ui/common/menu_keys.h"

#include <QAbstractButton>
#include <QGroupBox>
#include <QKeySequence>
#include <QLabel>
#include <QMenuBar>
#include <QSet>

namespace texloom::ui {

namespace {

/// The letter that a text marks with &, in capitals; null if it marks none.
QChar letterOf(const QString& text) {
    const QKeySequence key = QKeySequence::mnemonic(text);
    return key.isEmpty() ? QChar() : QChar(static_cast<char16_t>(key[0].key()));
}

QString unmarked(QString text) {
    return text.replace(QStringLiteral("&&"), QStringLiteral("\x01"))
        .remove(QLatin1Char('&'))
        .replace(QLatin1Char('\x01'), QStringLiteral("&&"));
}

/// The text with the first of its letters marked that is free.
QString markedAnew(const QString& text, const QSet<QChar>& taken) {
    QString plain = unmarked(text);
    for (qsizetype i = 0; i < plain.size(); ++i)
        if (plain[i].isLetter() && !taken.contains(plain[i].toUpper()))
            return QString(plain).insert(i, QLatin1Char('&'));
    return plain;
}

QSet<QChar> lettersOfMenus(const QMenuBar& bar) {
    QSet<QChar> taken;
    for (QAction* menu : bar.actions()) {
        if (letterOf(menu->text()).isNull() || taken.contains(letterOf(menu->text())))
            menu->setText(markedAnew(menu->text(), taken));
        taken.insert(letterOf(menu->text()));
    }
    return taken;
}

} // namespace

void reserveMenuKeys(QMenuBar* bar, QWidget* window) {
    const QSet<QChar> taken = lettersOfMenus(*bar);
    const auto clashes = [&taken](const QString& text) {
        const QChar letter = letterOf(text);
        return !letter.isNull() && taken.contains(letter);
    };
    for (auto* label : window->findChildren<QLabel*>())
        if (label->buddy() != nullptr && clashes(label->text()))
            label->setText(unmarked(label->text()));
    for (auto* button : window->findChildren<QAbstractButton*>())
        if (button->window() == window && clashes(button->text()))
            button->setText(unmarked(button->text()));
    for (auto* box : window->findChildren<QGroupBox*>())
        if (clashes(box->title()))
            box->setTitle(unmarked(box->title()));
}

} // namespace texloom::ui
