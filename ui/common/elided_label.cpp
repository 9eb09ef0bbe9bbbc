#include "ui/common/elided_label.h"

#include <QEvent>

namespace texloom::ui {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
    setTextFormat(Qt::PlainText);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ElidedLabel::setFullText(const QString& text, const QString& toolTip) {
    m_text = text;
    setToolTip(toolTip.isEmpty() ? text : toolTip);
    setAccessibleName(text);
    elide();
    updateGeometry();
}

void ElidedLabel::setElideMode(Qt::TextElideMode mode) {
    m_elideMode = mode;
    elide();
}

void ElidedLabel::setTwoLines() {
    m_twoLines = true;
    setMinimumHeight(2 * fontMetrics().lineSpacing());
    elide();
}

/// As many words as fit on the first line, but no more than the first part.
QString ElidedLabel::inTwoLines() const {
    const int width = contentsRect().width();
    const QString mark = QStringLiteral(" · ");
    const QString first = m_text.section(mark, 0, 0);
    QString line = first;
    while (fontMetrics().horizontalAdvance(line) > width && line.contains(QLatin1Char(' ')))
        line = line.left(line.lastIndexOf(QLatin1Char(' ')));
    QString rest = m_text.mid(line.size());
    if (rest.startsWith(mark))
        rest = rest.mid(mark.size());
    return fontMetrics().elidedText(line, Qt::ElideRight, width) + QLatin1Char('\n') +
           fontMetrics().elidedText(rest.trimmed(), Qt::ElideRight, width);
}

QSize ElidedLabel::minimumSizeHint() const {
    return {fontMetrics().horizontalAdvance(QStringLiteral("mmmm")), QLabel::minimumSizeHint().height()};
}

QSize ElidedLabel::sizeHint() const {
    return {fontMetrics().horizontalAdvance(m_text) + fontMetrics().averageCharWidth(),
            QLabel::sizeHint().height()};
}

void ElidedLabel::resizeEvent(QResizeEvent* event) {
    QLabel::resizeEvent(event);
    elide();
}

void ElidedLabel::changeEvent(QEvent* event) {
    QLabel::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        elide();
}

void ElidedLabel::elide() {
    setText(m_twoLines ? inTwoLines()
                       : fontMetrics().elidedText(m_text, m_elideMode, contentsRect().width()));
}

} // namespace texloom::ui
