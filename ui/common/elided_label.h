#pragma once

#include <QLabel>

namespace texloom::ui {

/// A label of one line, or two, that shortens a long text, in its middle unless told otherwise, where file
/// names differ least; the tooltip has the whole. It never makes its window wider.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    /// @param toolTip what hovering shows; the text itself if empty.
    void setFullText(const QString& text, const QString& toolTip = {});
    const QString& fullText() const { return m_text; }
    /// In two lines: what stands before the first " · " on the first as far as that fits, the rest on the
    /// second, whose end is shortened.
    void setTwoLines();
    /// Where it is shortened, if not in the middle.
    void setElideMode(Qt::TextElideMode mode);

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void elide();

    QString m_text;
    QString inTwoLines() const;

    bool m_twoLines = false;
    Qt::TextElideMode m_elideMode = Qt::ElideMiddle;
};

} // namespace texloom::ui
