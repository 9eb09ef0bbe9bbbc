#include "ui/inspector/mnemonics.h"

namespace texloom::ui {

Mnemonics::Mnemonics(const QString& taken) {
    for (const QChar letter : taken.toLower())
        m_taken.insert(letter);
}

QString Mnemonics::mark(const QString& label) {
    QString escaped = label;
    escaped.replace(QLatin1Char('&'), QStringLiteral("&&"));
    if (escaped != label)
        return escaped;
    for (int i = 0; i < label.size(); ++i) {
        const QChar letter = label[i].toLower();
        if (!letter.isLetter() || m_taken.contains(letter))
            continue;
        m_taken.insert(letter);
        return escaped.insert(i, QLatin1Char('&'));
    }
    return escaped;
}

} // namespace texloom::ui
