#pragma once

#include <QWidget>

class QLabel;
class QStatusBar;

namespace texloom::ui {

class ElidedLabel;

/// The status bar's texts about the pixel under the cursor. Nothing that matters is said only here.
class Readout : public QWidget {
    Q_OBJECT

public:
    explicit Readout(QWidget* parent = nullptr);

    /// @param place "x 10, y 20 → bark x 3, y 4"; @param values the pixel's; @param kind colour space and
    /// depth.
    void show(const QString& place, const QString& values, const QString& kind);
    /// Says more of the place.
    void addToPlace(const QString& text);
    void clear();
    /// All of it in one line.
    QString text() const;

private:
    ElidedLabel* m_place;
    QLabel* m_values;
    QLabel* m_kind;
};

} // namespace texloom::ui
