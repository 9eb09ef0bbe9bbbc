#pragma once

#include "core/image/image.h"
#include "ui/inspector/drop_field.h"

#include <QToolButton>

#include <memory>

class QHBoxLayout;

namespace texloom::ui {

class ElidedLabel;

/// A cell that shows a picture: a letter and a name, the picture as a button, and further buttons below it.
class PictureTile : public DropField {
    Q_OBJECT

public:
    /// @param letter such as "A′". @param name shows what is in it. @param title what it is for.
    PictureTile(const QString& letter, ElidedLabel* name, const QString& title, QWidget* parent = nullptr);

    /// What is clicked: the picture, or what it is for in words while there is none.
    QToolButton* picture() const { return m_picture; }
    /// Puts a button below the picture.
    void add(QToolButton* button);
    /// Shows a picture; null for none.
    void setImage(const std::shared_ptr<const Image>& image);

private:
    QToolButton* m_picture;
    QHBoxLayout* m_buttons;
    std::shared_ptr<const Image> m_image;
};

} // namespace texloom::ui
