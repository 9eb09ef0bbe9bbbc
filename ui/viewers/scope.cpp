#include "ui/viewers/scope.h"

#include "ui/picture/display_picture.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kValues = 256;
constexpr double kMostPixels = 1 << 20;
constexpr QRgb kColours[] = {0xffff5050, 0xff50e050, 0xff6090ff};

int channelOf(QRgb pixel, int channel) {
    return channel == 0 ? qRed(pixel) : channel == 1 ? qGreen(pixel) : qBlue(pixel);
}

/// Calls visit(x, pixel) for pixels on a grid that leaves about kMostPixels of them.
template <class Visit> void forSome(const QImage& shown, const Visit& visit) {
    const QImage image = shown.convertToFormat(QImage::Format_ARGB32);
    const double all = static_cast<double>(image.width()) * image.height();
    const int step = std::max(1, static_cast<int>(std::sqrt(all / kMostPixels)));
    for (int y = 0; y < image.height(); y += step) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); x += step)
            if (qAlpha(row[x]) > 0)
                visit(x, row[x]);
    }
}

} // namespace

Histogram histogramOf(const QImage& shown) {
    Histogram counts;
    for (std::vector<int>& channel : counts)
        channel.assign(kValues, 0);
    forSome(shown, [&](int, QRgb pixel) {
        for (int c = 0; c < 3; ++c)
            ++counts[static_cast<std::size_t>(c)][static_cast<std::size_t>(channelOf(pixel, c))];
    });
    return counts;
}

QImage waveformOf(const QImage& shown, int columns) {
    const auto wide = static_cast<std::size_t>(columns);
    std::vector<int> counts(3 * wide * kValues, 0);
    forSome(shown, [&](int x, QRgb pixel) {
        const auto column = static_cast<std::size_t>(x) * wide / static_cast<std::size_t>(shown.width());
        for (int c = 0; c < 3; ++c)
            ++counts[(static_cast<std::size_t>(c) * wide + column) * kValues +
                     static_cast<std::size_t>(channelOf(pixel, c))];
    });
    const int most = std::max(1, *std::max_element(counts.begin(), counts.end()));
    QImage picture(3 * columns, kValues, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (int x = 0; x < 3 * columns; ++x)
        for (int value = 0; value < kValues; ++value) {
            const int count = counts[static_cast<std::size_t>(x) * kValues + static_cast<std::size_t>(value)];
            if (count > 0) { // the root lets rare values be seen, too
                QColor colour(kColours[x / columns]);
                colour.setAlphaF(static_cast<float>(std::sqrt(static_cast<double>(count) / most)));
                picture.setPixelColor(x, kValues - 1 - value, colour);
            }
        }
    return picture;
}

Scope::Scope(QWidget* viewer) : QWidget(viewer) {
    setObjectName(QStringLiteral("scope"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void Scope::cycle() {
    m_kind = m_kind == ScopeKind::None        ? ScopeKind::Histogram
             : m_kind == ScopeKind::Histogram ? ScopeKind::Waveform
                                              : ScopeKind::None;
    setVisible(m_kind != ScopeKind::None && m_picture);
    measure();
}

void Scope::setPicture(std::shared_ptr<const DisplayPicture> picture) {
    m_picture = std::move(picture);
    setVisible(m_kind != ScopeKind::None && m_picture);
    measure();
}

void Scope::showEvent(QShowEvent*) {
    measure();
}

void Scope::measure() {
    if (!isVisible() || !m_picture)
        return;
    constexpr int kColumns = 120;
    if (m_kind == ScopeKind::Histogram)
        m_histogram = histogramOf(m_picture->image());
    else
        m_waveform = waveformOf(m_picture->image(), kColumns);
    update();
}

void Scope::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 190));
    painter.drawRoundedRect(rect(), 4, 4);
    const int margin = fontMetrics().height() / 2;
    const int line = fontMetrics().height();
    const QRectF place = QRectF(rect()).adjusted(margin, margin + line, -margin, -margin);
    painter.setPen(Qt::white);
    painter.drawText(QRect(margin, margin / 2, width() - 2 * margin, line), Qt::AlignLeft | Qt::AlignVCenter,
                     m_kind == ScopeKind::Histogram ? tr("Histogram, 0 to 255")
                                                    : tr("Waveform: red, green, blue"));
    if (m_kind == ScopeKind::Histogram)
        paintHistogram(painter, place);
    else
        painter.drawImage(place, m_waveform);
}

/// The counts of each channel against the second largest of all: one value that very many pixels have, such
/// as black, would leave nothing of the rest.
void Scope::paintHistogram(QPainter& painter, const QRectF& place) const {
    std::vector<int> all;
    for (const std::vector<int>& channel : m_histogram)
        all.insert(all.end(), channel.begin(), channel.end());
    if (all.empty())
        return;
    constexpr int kCut = 6; // the largest two of three channels
    std::nth_element(all.begin(), all.begin() + kCut, all.end(), std::greater<>());
    const double most = std::max(1, all[kCut]);
    painter.setCompositionMode(QPainter::CompositionMode_Plus);
    for (std::size_t c = 0; c < m_histogram.size(); ++c) {
        QPainterPath path(place.bottomLeft());
        for (int value = 0; value < kValues; ++value)
            path.lineTo(place.left() + place.width() * value / (kValues - 1),
                        place.bottom() -
                            place.height() *
                                std::min(1.0, m_histogram[c][static_cast<std::size_t>(value)] / most));
        path.lineTo(place.bottomRight());
        QColor colour(kColours[c]);
        colour.setAlpha(150);
        painter.fillPath(path, colour);
    }
}

} // namespace texloom::ui
