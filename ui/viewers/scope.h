#pragma once

#include <QImage>
#include <QWidget>

#include <array>
#include <memory>
#include <vector>

namespace texloom::ui {

class DisplayPicture;

/// What a scope shows of a picture.
enum class ScopeKind { None, Histogram, Waveform };

/// Counts of a picture's displayed values: red, green and blue, in 8 bits each.
using Histogram = std::array<std::vector<int>, 3>;

/// How often each of the 256 values is shown, from at most about a million pixels on a regular grid; pixels
/// that are wholly transparent are left out.
Histogram histogramOf(const QImage& shown);

/// Red, green and blue side by side: for each of `columns` parts of the picture from left to right how often
/// each value is shown, bright for often; value 255 at the top, 256 rows.
QImage waveformOf(const QImage& shown, int columns);

/// The histogram or the waveform of what a viewer shows, in its corner. Lets the mouse through.
class Scope : public QWidget {
    Q_OBJECT

public:
    explicit Scope(QWidget* viewer);

    /// Histogram, waveform, nothing, in turn.
    void cycle();
    ScopeKind kind() const { return m_kind; }
    void setPicture(std::shared_ptr<const DisplayPicture> picture);

protected:
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void measure();
    void paintHistogram(QPainter& painter, const QRectF& place) const;

    ScopeKind m_kind = ScopeKind::None;
    std::shared_ptr<const DisplayPicture> m_picture;
    Histogram m_histogram;
    QImage m_waveform;
};

} // namespace texloom::ui
