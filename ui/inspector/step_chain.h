#pragma once

#include "core/io/recipe.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QVBoxLayout;

namespace texloom::ui {

class MethodForm;

/// The methods that follow the first one: a chooser "Then", the chosen method's form, the next chooser, and
/// so on, until one says that nothing follows.
class StepChain : public QWidget {
    Q_OBJECT

public:
    explicit StepChain(QWidget* parent = nullptr);

    /// The methods chosen, with all their parameters.
    std::vector<RecipeStep> steps() const;
    /// The same with only what was set by hand: the rest follows from the exemplar.
    std::vector<RecipeStep> changedSteps() const;
    /// Each must be able to follow some method.
    void setSteps(const std::vector<RecipeStep>& steps);
    /// Brings every parameter back to its default; the methods stay.
    void resetAll();
    void setExemplarSide(int side);

Q_SIGNALS:
    void edited();
    void helpWanted(const QString& html);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Link {
        QWidget* box;
        QComboBox* chooser;
        MethodForm* form;
    };

    void addLink();
    void removeLinksAfter(std::size_t index);
    void methodChosen(const QComboBox* chooser);

    QVBoxLayout* m_column;
    std::vector<Link> m_links; ///< the last one has no form
    int m_side = 0;
};

} // namespace texloom::ui
