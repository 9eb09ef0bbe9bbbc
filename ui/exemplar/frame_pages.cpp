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

FramePage::FramePage(EditCanvas* canvas, QWidget* parent)
    : QWidget(parent), m_canvas(canvas), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    connect(canvas, &EditCanvas::frameMoved, this, &FramePage::showFrame);
}

void FramePage::addPair(const QString& title, const std::array<std::pair<QString, QString>, 2>& names) {
    std::array<QSpinBox*, 2> pair{};
    for (std::size_t i = 0; i < pair.size(); ++i) {
        pair[i] = makePixels(names[i].first, names[i].second, this);
        connect(pair[i], &QSpinBox::valueChanged, this, &FramePage::take);
        m_numbers.push_back(pair[i]);
    }
    m_form->addRow(title, pairOf(pair[0], pair[1]));
}

void FramePage::addEnd(const QString& note, const QString& button, const QString& name) {
    auto* apply = new QPushButton(button, this);
    apply->setObjectName(name);
    connect(apply, &QPushButton::clicked, this, &FramePage::applied);
    m_form->addRow(noteLabel(note));
    m_form->addRow(apply);
}

void FramePage::showFrame() {
    const std::vector<int> values = frame();
    for (std::size_t i = 0; i < m_numbers.size(); ++i)
        setQuietly(m_numbers[i], values[i]);
}

void FramePage::take() {
    if (!m_canvas->picture())
        return;
    std::vector<int> values;
    for (const QSpinBox* pixels : m_numbers)
        values.push_back(pixels->value());
    setFrame(values);
    showFrame();
}

CropPage::CropPage(EditCanvas* canvas, QWidget* parent) : FramePage(canvas, parent) {
    addPair(tr("Left, top"), {{{QStringLiteral("cropX"), tr("Left edge of the crop")},
                               {QStringLiteral("cropY"), tr("Upper edge of the crop")}}});
    addPair(tr("Width, height"), {{{QStringLiteral("cropWidth"), tr("Width of the crop")},
                                   {QStringLiteral("cropHeight"), tr("Height of the crop")}}});
    addEnd(tr("Drag the corners; N takes the next one, the arrow keys move it."), tr("Cr&op"),
           QStringLiteral("applyCrop"));
}

std::vector<int> CropPage::frame() const {
    const QRect frame = canvas()->cropFrame();
    return {frame.x(), frame.y(), frame.width(), frame.height()};
}

void CropPage::setFrame(const std::vector<int>& values) {
    const Size size = canvas()->picture()->size();
    const int x = std::clamp(values[0], 0, size.width - 1);
    const int y = std::clamp(values[1], 0, size.height - 1);
    canvas()->setCropFrame(
        {x, y, std::clamp(values[2], 1, size.width - x), std::clamp(values[3], 1, size.height - y)});
}

CornersPage::CornersPage(EditCanvas* canvas, QWidget* parent) : FramePage(canvas, parent) {
    const QString titles[] = {tr("Top left"), tr("Top right"), tr("Bottom right"), tr("Bottom left")};
    for (int i = 0; i < 4; ++i)
        addPair(titles[i], {{{QStringLiteral("corner%1x").arg(i), tr("%1 corner, across").arg(titles[i])},
                             {QStringLiteral("corner%1y").arg(i), tr("%1 corner, down").arg(titles[i])}}});
    addEnd(tr("Put the corners on four that are a rectangle in reality. N takes the next one, the arrow keys "
              "move it."),
           tr("Recti&fy"), QStringLiteral("applyRectify"));
}

std::vector<int> CornersPage::frame() const {
    std::vector<int> values;
    for (const PlanePoint& corner : canvas()->corners()) {
        values.push_back(static_cast<int>(std::lround(corner.x)));
        values.push_back(static_cast<int>(std::lround(corner.y)));
    }
    return values;
}

void CornersPage::setFrame(const std::vector<int>& values) {
    std::array<PlanePoint, 4> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {static_cast<double>(values[2 * i]), static_cast<double>(values[2 * i + 1])};
    canvas()->setCorners(corners);
}

} // namespace texloom::ui
