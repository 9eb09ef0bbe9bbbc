#include "ui/exemplar/edit_list.h"

#include "ui/common/text.h"

#include <QCoreApplication>

#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("texloom::ui::EditText", text);
}

struct EditText {
    QString operator()(const CropEdit& edit) const {
        return tr("Cropped to %1 at %2, %3").arg(sizeText(edit.area.size)).arg(edit.area.x).arg(edit.area.y);
    }
    QString operator()(const RotateEdit& edit) const { return tr("Turned by %1°").arg(edit.degrees); }
    QString operator()(const FlipEdit& edit) const {
        return edit.axis == FlipEdit::Axis::Horizontal ? tr("Mirrored left to right")
                                                       : tr("Mirrored top to bottom");
    }
    QString operator()(const RectifyEdit&) const { return tr("Rectified by four corners"); }
    QString operator()(const FlattenEdit& edit) const {
        return tr("Light evened out by %1 %").arg(std::lround(edit.strength * 100));
    }
};

ExemplarEdits::iterator beforeLight(ExemplarEdits& edits) {
    return lightOf(edits) != nullptr ? edits.end() - 1 : edits.end();
}

} // namespace

QString editText(const ExemplarEdit& edit) {
    return std::visit(EditText{}, edit);
}

const FlattenEdit* lightOf(const ExemplarEdits& edits) {
    return edits.empty() ? nullptr : std::get_if<FlattenEdit>(&edits.back());
}

double angleOf(const ExemplarEdits& edits) {
    const std::size_t light = lightOf(edits) != nullptr ? 1 : 0;
    if (edits.size() <= light)
        return 0;
    const auto* rotation = std::get_if<RotateEdit>(&edits[edits.size() - 1 - light]);
    return rotation != nullptr && std::fmod(rotation->degrees, 90) != 0 ? rotation->degrees : 0;
}

ExemplarEdits withEdit(ExemplarEdits edits, const ExemplarEdit& edit) {
    edits.insert(beforeLight(edits), edit);
    return edits;
}

ExemplarEdits withAngle(ExemplarEdits edits, double degrees) {
    if (angleOf(edits) != 0)
        edits.erase(beforeLight(edits) - 1);
    if (degrees != 0)
        edits.insert(beforeLight(edits), RotateEdit{degrees});
    return edits;
}

ExemplarEdits withLight(ExemplarEdits edits, const std::optional<FlattenEdit>& light) {
    if (lightOf(edits) != nullptr)
        edits.pop_back();
    if (light)
        edits.emplace_back(*light);
    return edits;
}

} // namespace texloom::ui
