#pragma once

#include <QSet>
#include <QString>

namespace texloom::ui {

/// Gives the labels of a form letters to reach them with Alt, no letter twice.
class Mnemonics {
public:
    /// @param taken letters that menus and other labels have already.
    explicit Mnemonics(const QString& taken);

    /// The label with & before the first letter that is still free; without if none is.
    QString mark(const QString& label);

private:
    QSet<QChar> m_taken;
};

} // namespace texloom::ui
