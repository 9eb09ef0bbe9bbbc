#pragma once

#include "ui/paint/painter.h"

class QCheckBox;
class QSpinBox;

namespace texloom::ui {

/// Paints a mask over the picture that it belongs to, and grows, shrinks and softens what is painted. What is
/// painted is a selection; see selections.
class MaskPainter : public Painter {
    Q_OBJECT

public:
    /// @param selection what is painted already, of the picture's size.
    /// @param meaning what the mask is for, in a sentence.
    MaskPainter(std::shared_ptr<const DisplayPicture> picture, Image selection, const QString& meaning,
                QWidget* parent = nullptr);

    /// A selection as a veil, the denser the more it is selected. Called on a worker.
    static QImage veilOf(const Image& selection);

protected:
    Make withShape(std::function<Image(Size)> shape, bool add) const override;
    Veil veil() const override { return &MaskPainter::veilOf; }

private:
    QLayout* makeTakeAway();
    QLayout* makeMeaning(const QString& meaning);
    QLayout* makeEdges();
    QLayout* makeWhole();

    QCheckBox* m_takeAway;
    QSpinBox* m_pixels;
};

} // namespace texloom::ui
