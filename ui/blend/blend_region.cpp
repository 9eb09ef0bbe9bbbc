#include "core/image/selection.h"
#include "core/tools/join_region.h"
#include "ui/blend/blend_window.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/paint/mask_painter.h"

#include <QCheckBox>

/// What the blend window does with a region of the second image.
namespace texloom::ui {

namespace {

/// A picture as it is shown, and what is painted on it already.
struct PaintGround {
    std::shared_ptr<const DisplayPicture> picture;
    Image selection;
};

/// Null if nothing is selected by half or more: then the region is the middle.
std::shared_ptr<const Image> maskOf(const Image& selection) {
    auto mask = std::make_shared<const Image>(selections::inverted(selection));
    return inRegion(valueRange(*mask).smallest) ? mask : nullptr;
}

} // namespace

void BlendWindow::setRegion(const Image& selection) {
    inBackground(
        this,
        [selection] {
            return std::make_shared<const MovableRegion>(movableRegion(selection.size(), maskOf(selection)));
        },
        [this, of = chosen(1)->file.image](const std::shared_ptr<const MovableRegion>& region) {
            m_region = region;
            m_regionOf = of;
            changed();
        },
        [this](const QString& why) { say(why); });
}

/// A region that was painted on another image is forgotten.
void BlendWindow::keepRegionOf(const Shared& second) {
    if (m_regionOf == second)
        return;
    m_region = std::make_shared<const MovableRegion>(movableRegion(second->size(), nullptr));
    m_regionOf = second;
    showHandle();
}

void BlendWindow::showRegion() {
    const Values settings = settingsOf(m_cells.front());
    const QPoint offset(std::get<int>(settings.at("offset-x")), std::get<int>(settings.at("offset-y")));
    for (const Cell& cell : m_cells) {
        auto* const viewer = qobject_cast<RegionViewer*>(cell.viewer);
        viewer->setRegion(m_region, offset);
        viewer->setRegionShown(m_showHandle->isChecked());
    }
}

void BlendWindow::paintRegion() {
    const NamedImage* const second = chosen(1);
    if (second == nullptr)
        return say(tr("Open two images to blend."));
    if (!fetched())
        return;
    inBackground(
        this,
        [image = second->file.image, mask = m_regionOf == second->file.image ? m_region->mask : nullptr] {
            return PaintGround{std::make_shared<const DisplayPicture>(image),
                               mask ? selections::inverted(*mask) : Image(image->size(), 1)};
        },
        [this, title = second->title](PaintGround ground) {
            auto* painter = new MaskPainter(std::move(ground.picture), std::move(ground.selection),
                                            translated(m_tool->info().region->help), this);
            painter->setAttribute(Qt::WA_DeleteOnClose);
            painter->setWindowTitle(tr("%1 · %2").arg(translated(m_tool->info().region->title), title));
            connect(painter, &QDialog::accepted, this, [=, this] { setRegion(painter->painted()); });
            painter->open();
        },
        [this](const QString& why) { say(why); });
}

} // namespace texloom::ui
