#include "ui/exemplar/frame_pages.h"

#include "ui/exemplar/edit_canvas.h"
#include "ui/exemplar/edit_fields.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace texloom::ui {

namespace {

QSpinBox* makePixels(const QString& name, const QString& label, QWidget* parent) {
    auto* pixels = new QSpinBox(parent);
    pixels->setObjectName(name);
    pixels->setAccessibleName(label);
    pixels->setRange(0, 65535);
    pixels->setKeyboardTracking(false);
    return pixels;
}

QWidget* pairOf(QWidget* first, QWidget* second) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(first, 1);
    layout->addWidget(second, 1);
    return row;
}

void setQuietly(QSpinBox* pixels, int value) {
    const QSignalBlocker blocker(pixels);
    pixels->setValue(value);
}

} // namespace

CropPage::CropPage(EditCanvas* canvas, QWidget* parent)
    : QWidget(parent),
      m_canvas(canvas), m_numbers{makePixels(QStringLiteral("cropX"), tr("Left edge of the crop"), this),
                                  makePixels(QStringLiteral("cropY"), tr("Upper edge of the crop"), this),
                                  makePixels(QStringLiteral("cropWidth"), tr("Width of the crop"), this),
                                  makePixels(QStringLiteral("cropHeight"), tr("Height of the crop"), this)} {
    auto* apply = new QPushButton(tr("Cr&op"), this);
    apply->setObjectName(QStringLiteral("applyCrop"));
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(tr("Left, top"), pairOf(m_numbers[0], m_numbers[1]));
    form->addRow(tr("Width, height"), pairOf(m_numbers[2], m_numbers[3]));
    form->addRow(noteLabel(tr("Drag the corners; N takes the next one, the arrow keys move it.")));
    form->addRow(apply);
    for (QSpinBox* pixels : m_numbers)
        connect(pixels, &QSpinBox::valueChanged, this, &CropPage::take);
    connect(apply, &QPushButton::clicked, this, &CropPage::applied);
    connect(canvas, &EditCanvas::frameMoved, this, &CropPage::showFrame);
}

void CropPage::showFrame() {
    const QRect frame = m_canvas->cropFrame();
    const std::array<int, 4> values{frame.x(), frame.y(), frame.width(), frame.height()};
    for (std::size_t i = 0; i < m_numbers.size(); ++i)
        setQuietly(m_numbers[i], values[i]);
}

void CropPage::take() {
    if (!m_canvas->picture())
        return;
    const Size size = m_canvas->picture()->size();
    const int x = std::clamp(m_numbers[0]->value(), 0, size.width - 1);
    const int y = std::clamp(m_numbers[1]->value(), 0, size.height - 1);
    m_canvas->setCropFrame({x, y, std::clamp(m_numbers[2]->value(), 1, size.width - x),
                            std::clamp(m_numbers[3]->value(), 1, size.height - y)});
    showFrame();
}

CornersPage::CornersPage(EditCanvas* canvas, QWidget* parent) : QWidget(parent), m_canvas(canvas) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    const QString names[] = {tr("Top left"), tr("Top right"), tr("Bottom right"), tr("Bottom left")};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            QSpinBox* const pixels = makePixels(
                QStringLiteral("corner%1%2").arg(i).arg(axis == 0 ? QLatin1Char('x') : QLatin1Char('y')),
                axis == 0 ? tr("%1 corner, across").arg(names[i]) : tr("%1 corner, down").arg(names[i]),
                this);
            m_numbers[2 * i + axis] = pixels;
            connect(pixels, &QSpinBox::valueChanged, this, &CornersPage::take);
        }
        form->addRow(names[i], pairOf(m_numbers[2 * i], m_numbers[2 * i + 1]));
    }
    auto* apply = new QPushButton(tr("Recti&fy"), this);
    apply->setObjectName(QStringLiteral("applyRectify"));
    form->addRow(
        noteLabel(tr("Put the corners on four that are a rectangle in reality. N takes the next one, "
                     "the arrow keys move it.")));
    form->addRow(apply);
    connect(apply, &QPushButton::clicked, this, &CornersPage::applied);
    connect(canvas, &EditCanvas::frameMoved, this, &CornersPage::showFrame);
}

void CornersPage::showFrame() {
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        const PlanePoint& corner = m_canvas->corners()[i / 2];
        setQuietly(m_numbers[i], static_cast<int>(std::lround(i % 2 == 0 ? corner.x : corner.y)));
    }
}

void CornersPage::take() {
    std::array<PlanePoint, 4> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {static_cast<double>(m_numbers[2 * i]->value()),
                      static_cast<double>(m_numbers[2 * i + 1]->value())};
    m_canvas->setCorners(corners);
}

} // namespace texloom::ui
