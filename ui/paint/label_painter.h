#pragma once

#include "core/image/labels.h"
#include "ui/paint/painter.h"

#include <QRgb>

#include <vector>

class QButtonGroup;
class QSlider;

namespace texloom::ui {

/// Paints a picture in a few flat colours, each of which stands for a material. What is painted is the index
/// of each pixel's colour; see labels. Beside the usual tools it fills areas and picks colours, and the
/// picture painted over can show through.
class LabelPainter : public Painter {
    Q_OBJECT

public:
    /// @param picture that is painted over. @param ground whether there is anything to see of it.
    /// @param indices what is painted already, of the picture's size. @param palette the colours, at least
    /// one.
    /// @param meaning what the picture is for, in sentences.
    LabelPainter(std::shared_ptr<const DisplayPicture> picture, bool ground, Image indices,
                 labels::Palette palette, const QString& meaning, QWidget* parent = nullptr);

    const labels::Palette& colours() const { return m_palette; }
    /// The index of the colour that is painted with.
    int colour() const { return m_colour; }
    void setColour(int index);

protected:
    Make withShape(std::function<Image(Size)> shape, bool add) const override;
    Veil veil() const override;

private:
    QLayout* makePalette();
    QLayout* makeShowing();
    QLayout* makeWhole();
    void pointedAt(QPoint pixel, PaintCanvas::Tool tool);

    labels::Palette m_palette;
    std::vector<QRgb> m_colours; ///< the palette as it is shown
    int m_colour = 0;
    QButtonGroup* m_swatches;
    QSlider* m_showing;
};

} // namespace texloom::ui
