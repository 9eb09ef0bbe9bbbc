#pragma once

#include "core/image/extension.h"
#include "ui/picture/display_picture.h"

#include <QDialog>

#include <array>
#include <memory>

class QLabel;
class QPushButton;
class QSpinBox;

namespace texloom::ui {

/// Asks by how many pixels a picture is to be extended at each side, and shows where it will lie.
class ExtendDialog : public QDialog {
    Q_OBJECT

public:
    /// @param most the longest side that the extended picture may have.
    ExtendDialog(std::shared_ptr<const DisplayPicture> picture, int most, QWidget* parent = nullptr);

    Margins margins() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QSpinBox* addSide(const char* name, const QString& title, int most);
    void show(Size size);

    std::shared_ptr<const DisplayPicture> m_picture;
    int m_most;
    QWidget* m_place;
    QLabel* m_size;
    std::array<QSpinBox*, 4> m_sides{}; ///< left, top, right, bottom
    QPushButton* m_ok = nullptr;
};

} // namespace texloom::ui
