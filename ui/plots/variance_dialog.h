#pragma once

#include "core/analysis/patch_variance.h"
#include "ui/exemplar/named_image.h"
#include "ui/jobs/task.h"

#include <QDialog>

#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace texloom::ui {

class Plot;
class TaskBar;

/// How much patches vary that are alike, over their size n and number m (Raad, thesis 2016, figure 2.2):
/// which patch sizes Gaussian models suit an image with.
class VarianceDialog : public QDialog {
    Q_OBJECT

public:
    /// @param images to choose from; at least one.
    explicit VarianceDialog(std::vector<NamedImage> images, QWidget* parent = nullptr);

    /// Begins with the settings as they stand.
    void compute();
    bool computing() const { return m_task.running(); }
    Plot* plot() const { return m_plot; }
    QString message() const;

private:
    void showVariance(const PatchVariance& variance);
    void say(const QString& text);

    std::vector<NamedImage> m_images;
    QComboBox* m_image;
    QLineEdit* m_sizes;
    QLineEdit* m_neighbours;
    QSpinBox* m_patches;
    QPushButton* m_compute;
    Plot* m_plot;
    QLabel* m_message;
    TaskBar* m_bar;
    Task<PatchVariance> m_task;
};

} // namespace texloom::ui
