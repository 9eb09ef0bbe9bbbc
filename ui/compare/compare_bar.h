#pragma once

#include "core/analysis/difference.h"
#include "ui/picture/display_picture.h"

#include <QWidget>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QMenu;

namespace texloom::ui {

/// How a comparison is looked at.
enum class CompareMode { Grid, Wipe, Toggle, Difference };

/// What can be done with a comparison, once each, for the menu and the bar.
struct CompareActions {
    /// Makes them as children of `window`.
    explicit CompareActions(QWidget* window);

    QAction* mode(CompareMode mode) const;

    QAction* grid;
    QAction* wipe;
    QAction* toggle;
    QAction* difference;
    QAction* input;    ///< the result that is shown beside the image that it was made from
    QAction* exemplar; ///< whether the exemplar is among the pictures
    QAction* link;
    QMenu* exemplars; ///< every open exemplar, to be shown or not; filled by whoever knows them
    QAction* sheet;
};

/// The controls over a comparison: the way it is looked at, which two pictures, their exposure and channel.
class CompareBar : public QWidget {
    Q_OBJECT

public:
    explicit CompareBar(const CompareActions& actions, QWidget* parent = nullptr);

    /// The pictures that the two choosers offer.
    void setLabels(const QStringList& labels);
    void setMode(CompareMode mode);
    int first() const;
    int second() const;
    void setPair(int first, int second);
    DifferenceKind kind() const;
    const DisplayLook& look() const { return m_look; }
    void setLook(const DisplayLook& look);
    /// What the difference amounts to, or what else there is to say of the pair.
    void say(const QString& text);
    QString said() const;

Q_SIGNALS:
    void pairChanged();
    void kindChanged();
    void lookChanged();

private:
    QWidget* makeModes(const CompareActions& actions);
    QWidget* makePair();
    QComboBox* makeChooser(const QString& name, const QString& title);

    QComboBox* m_first;
    QComboBox* m_second;
    QComboBox* m_kind;
    QComboBox* m_channel;
    QDoubleSpinBox* m_exposure;
    QLabel* m_said;
    QWidget* m_pair = nullptr;
    DisplayLook m_look;
};

} // namespace texloom::ui
