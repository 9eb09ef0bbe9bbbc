#include "ui/window/zoom_box.h"

#include "ui/viewers/image_viewer.h"

#include <QLineEdit>
#include <QLocale>

#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kSteps[] = {12, 25, 50, 100, 200, 400, 800};

QString percent(double value) {
    return ZoomBox::tr("%1 %").arg(QLocale().toString(std::round(value)));
}

} // namespace

ZoomBox::ZoomBox(std::function<ImageViewer*()> viewer, QWidget* parent)
    : QComboBox(parent), m_viewer(std::move(viewer)) {
    setObjectName(QStringLiteral("zoomBox"));
    setAccessibleName(tr("Zoom"));
    setToolTip(tr("The picture's size on the screen: 100 % is one screen pixel for each of its own."));
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setFocusPolicy(Qt::ClickFocus);
    addItem(tr("Fit"));
    for (const int step : kSteps)
        addItem(percent(step));
    connect(this, &QComboBox::textActivated, this, &ZoomBox::take);
    connect(lineEdit(), &QLineEdit::editingFinished, this, [this] { take(currentText()); });
    refresh();
}

void ZoomBox::follow(ImageViewer* viewer) {
    const auto say = [this, viewer] {
        if (m_viewer() == viewer)
            refresh();
    };
    connect(viewer, &ImageViewer::viewChanged, this, say);
    connect(viewer, &ImageViewer::viewSettled, this, say);
}

void ZoomBox::refresh() {
    const ImageViewer* const viewer = m_viewer();
    const bool shows = viewer != nullptr && viewer->picture() != nullptr;
    setEnabled(shows);
    const double scale = shows ? viewer->view().scale() * viewer->devicePixelRatioF() : 1;
    setEditText(percent(100 * scale));
}

void ZoomBox::take(const QString& text) {
    ImageViewer* const viewer = m_viewer();
    if (viewer == nullptr || !viewer->picture())
        return;
    QString number = text;
    number.remove(QLatin1Char('%'));
    bool ok = false;
    const double value = QLocale().toDouble(number.trimmed(), &ok);
    if (text == itemText(0))
        viewer->fit();
    else if (ok && value > 0 && text != percent(100 * viewer->view().scale() * viewer->devicePixelRatioF()))
        viewer->setZoom(value / 100);
    refresh();
}

} // namespace texloom::ui
