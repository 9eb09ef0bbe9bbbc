#include "ui/picture/display_picture.h"

#include "core/color/color_pipeline.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kStripRows = 64;
/// Levels are halved until the longer side is about this long.
constexpr int kSmallestLevel = 64;

int byteOf(float value) {
    const float rounded = std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F;
    return static_cast<int>(rounded);
}

/// Writes a row of a strip that is already as the display shows it.
void writeRow(const Image& strip, int row, const ImageView& source, int y, QRgb* to) {
    const int channels = strip.channels();
    const int alpha = source.channels == 4 ? 3 : -1;
    for (int x = 0; x < strip.width(); ++x) {
        const int red = byteOf(strip(x, row, 0));
        const int green = channels > 1 ? byteOf(strip(x, row, 1)) : red;
        const int blue = channels > 2 ? byteOf(strip(x, row, 2)) : channels == 2 ? 0 : red;
        const QRgb color = qRgba(red, green, blue, alpha < 0 ? 255 : byteOf(source(x, y, alpha)));
        to[x] = alpha < 0 ? color : qPremultiply(color);
    }
}

/// Multiplies light; alpha is not among the channels.
void expose(Image& strip, double stops) {
    color::fromWorking(strip, "linear");
    const float factor = static_cast<float>(std::exp2(stops));
    for (int c = 0; c < strip.channels(); ++c)
        for (int y = 0; y < strip.height(); ++y)
            for (int x = 0; x < strip.width(); ++x)
                strip(x, y, c) *= factor;
    color::toWorking(strip, "linear");
}

/// The channels that a look shows.
ImageView shownPart(const Image& image, const DisplayLook& look) {
    if (look.channel >= 0)
        return image.view().channelRange(std::min(look.channel, image.channels() - 1), 1);
    return image.view().channelRange(0, std::min(image.channels(), 3));
}

QImage render(const Image& image, const DisplayLook& look = {}) {
    QImage shown(image.width(), image.height(), QImage::Format_ARGB32_Premultiplied);
    if (shown.isNull())
        throw std::bad_alloc();
    const ImageView colors = shownPart(image, look);
    const ImageView& alpha = look.channel >= 0 ? colors : image.view();
    for (int top = 0; top < image.height(); top += kStripRows) {
        const int rows = std::min(kStripRows, image.height() - top);
        Image strip(colors.crop(0, top, {image.width(), rows}));
        if (look.exposure != 0)
            expose(strip, look.exposure);
        color::toDisplay(strip);
        for (int row = 0; row < rows; ++row)
            writeRow(strip, row, alpha, top + row, reinterpret_cast<QRgb*>(shown.scanLine(top + row)));
    }
    return shown;
}

QRgb mean(QRgb a, QRgb b, QRgb c, QRgb d) {
    const auto of = [&](int shift) {
        return ((((a >> shift) & 255U) + ((b >> shift) & 255U) + ((c >> shift) & 255U) +
                 ((d >> shift) & 255U) + 2U) /
                4U)
               << shift;
    };
    return of(0) | of(8) | of(16) | of(24);
}

QImage halved(const QImage& image) {
    QImage half((image.width() + 1) / 2, (image.height() + 1) / 2, image.format());
    if (half.isNull())
        throw std::bad_alloc();
    for (int y = 0; y < half.height(); ++y) {
        const auto* upper = reinterpret_cast<const QRgb*>(image.constScanLine(2 * y));
        const auto* lower =
            reinterpret_cast<const QRgb*>(image.constScanLine(std::min(2 * y + 1, image.height() - 1)));
        auto* to = reinterpret_cast<QRgb*>(half.scanLine(y));
        for (int x = 0; x < half.width(); ++x) {
            const int right = std::min(2 * x + 1, image.width() - 1);
            to[x] = mean(upper[2 * x], upper[right], lower[2 * x], lower[right]);
        }
    }
    return half;
}

/// Clears the pixels that are not made yet. @return whether there are any.
bool clearUnmade(QImage& image, const PositionMap& made) {
    bool any = false;
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x)
            if (!made.at(x, y).valid()) {
                row[x] = 0;
                any = true;
            }
    }
    return any;
}

} // namespace

DisplayPicture::DisplayPicture(std::shared_ptr<const Image> values, const DisplayLook& look)
    : m_values(std::move(values)), m_fullSize(m_values->size()),
      m_transparent(m_values->channels() == 4 && look.channel < 0) {
    m_levels.push_back(render(*m_values, look));
    makeLevels();
}

DisplayPicture::DisplayPicture(std::shared_ptr<const Image> values, Size fullSize, int step,
                               const PositionMap* made)
    : m_values(std::move(values)), m_fullSize(fullSize), m_step(step),
      m_transparent(m_values->channels() == 4) {
    m_levels.push_back(render(*m_values));
    if (made != nullptr && made->size() == m_values->size() && clearUnmade(m_levels.front(), *made))
        m_transparent = true;
    makeLevels();
}

void DisplayPicture::makeLevels() {
    while (std::max(m_levels.back().width(), m_levels.back().height()) > kSmallestLevel)
        m_levels.push_back(halved(m_levels.back()));
}

const QImage& DisplayPicture::levelFor(double scale) const {
    const double reduction = 1 / (scale * m_step);
    const int level = reduction < 1 ? 0 : static_cast<int>(std::floor(std::log2(reduction)));
    return m_levels[std::min(static_cast<std::size_t>(level), m_levels.size() - 1)];
}

QString DisplayPicture::valueText(int x, int y) const {
    x /= m_step;
    y /= m_step;
    if (x < 0 || y < 0 || x >= m_values->width() || y >= m_values->height())
        return {};
    QStringList numbers, levels;
    QString code = QStringLiteral("#");
    const int shown = m_values->channels() >= 3 ? 3 : 1;
    for (int channel = 0; channel < m_values->channels(); ++channel) {
        const auto value = static_cast<double>((*m_values)(x, y, channel));
        numbers += QString::number(value, 'f', 3);
        if (channel >= shown)
            continue;
        const auto level = static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
        levels += QString::number(level);
        code += QStringLiteral("%1").arg(level, 2, 16, QLatin1Char('0')).toUpper();
    }
    QStringList texts = {numbers.join(QLatin1Char(' ')), levels.join(QLatin1Char(' '))};
    if (shown == 3)
        texts += code;
    return texts.join(QStringLiteral(" · "));
}

} // namespace texloom::ui
