#pragma once

#include "core/image/image.h"
#include "core/image/position_map.h"

#include <QImage>
#include <QString>

#include <memory>
#include <vector>

namespace texloom::ui {

/// How values are shown.
struct DisplayLook {
    double exposure = 0; ///< in stops: each doubles the light
    int channel = -1;    ///< the only channel shown, as grey; −1 for colour

    friend bool operator==(const DisplayLook&, const DisplayLook&) = default;
};

/// A picture ready for the screen: its values, and what an sRGB display shows of them in ever halved sizes,
/// so that painting costs what the window is large, not what the picture is. Never changed once made.
class DisplayPicture {
public:
    /// Made on a worker: converts strip by strip, so that no second float copy of the image is ever whole in
    /// memory. Grey becomes equal red, green and blue; two channels red and green; a fourth is alpha.
    explicit DisplayPicture(std::shared_ptr<const Image> values, const DisplayLook& look = {});
    /// A partial result: every `step`-th pixel of a picture of `fullSize`.
    /// @param made pixels without a source in it are not made yet and stay transparent; none if null or
    /// empty.
    DisplayPicture(std::shared_ptr<const Image> values, Size fullSize, int step, const PositionMap* made);

    const Image& values() const { return *m_values; }
    /// The size of what is shown, in pixels of the whole picture.
    Size size() const { return m_fullSize; }
    /// How many pixels of the whole picture one pixel of values() stands for, in each direction.
    int step() const { return m_step; }
    /// Whether something behind the picture shows through.
    bool transparent() const { return m_transparent; }
    /// The picture in its own size, for the clipboard and thumbnails.
    const QImage& image() const { return m_levels.front(); }
    /// The smallest version that still has a pixel for each device pixel at this scale.
    /// @param scale device pixels for one pixel of the whole picture.
    const QImage& levelFor(double scale) const;
    /// "0.502 0.413 0.250 · 128 105 64 · #806940": the values at a pixel of the whole picture, as they are,
    /// in 8 bits, and those of colours as people write them.
    QString valueText(int x, int y) const;

private:
    void makeLevels();

    std::shared_ptr<const Image> m_values;
    Size m_fullSize;
    int m_step = 1;
    bool m_transparent = false;
    std::vector<QImage> m_levels;
};

} // namespace texloom::ui
