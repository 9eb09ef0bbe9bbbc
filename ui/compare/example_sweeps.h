#pragma once

#include "core/session/batch/join_input.h"
#include "ui/compare/compare_item.h"
#include "ui/compare/grid_run.h"

#include <QMenu>
#include <QString>

#include <vector>

namespace texloom::ui {

/// The menu of the sweeps that come with the program: batches that show what a setting does.
class ExampleSweeps : public QMenu {
    Q_OBJECT

public:
    explicit ExampleSweeps(QWidget* parent = nullptr);

    /// The shipped batches, as paths; empty if their folder is not there.
    static QStringList files();

Q_SIGNALS:
    /// One was chosen. @param first the pictures that its runs learn from.
    void chosen(const QString& title, const std::vector<texloom::ui::GridEntry>& entries,
                const std::vector<texloom::ui::CompareItem>& first);
    /// One was chosen that joins images by a tool.
    void joinsChosen(const std::vector<texloom::JoinInput>& joins);
    void failed(const QString& sentence);

private:
    void fill();
    void start(const QString& path);
};

} // namespace texloom::ui
