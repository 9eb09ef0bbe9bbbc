#include "ui/window/mask_painting.h"

#include "core/image/selection.h"
#include "core/methods/method.h"
#include "core/session/run/run.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/paint/mask_painter.h"
#include "ui/runs/run_desk.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace texloom::ui {

namespace {

/// A picture as it is shown, and what is painted on it already.
struct Painted {
    std::shared_ptr<const DisplayPicture> picture;
    Image selection;
};

/// A mask of another size was painted on another picture: it is begun anew. Called on a worker.
Painted painted(const std::shared_ptr<const Image>& image, const std::shared_ptr<const Image>& mask) {
    const bool fits = mask && mask->size() == image->size();
    return {std::make_shared<const DisplayPicture>(image),
            fits ? selections::inverted(*mask) : Image(image->size(), 1)};
}

/// An edited exemplar is in no file: what is shown of it is written to one. Called on a worker.
InputFile exemplarInput(const RunExemplar& exemplar, const Port& port) {
    RecipeFile file = recipeFile(exemplar.image);
    if (!exemplar.edits.empty()) {
        file = {};
        file.path = toPath(savePicture(*exemplar.image.image, exemplar.image.name(),
                                       exemplar.image.space == "raw" ? "raw" : "srgb"));
    }
    return loadInput(port, file, {});
}

} // namespace

MaskPainting::MaskPainting(const RunDesk* desk, const ExemplarStore* store, Inspector* inspector,
                           QWidget* window)
    : QObject(window), m_desk(desk), m_store(store), m_inspector(inspector), m_window(window) {
    connect(m_inspector->output(), &OutputGroup::paintWanted, this, &MaskPainting::paint);
}

/// A mask belongs to the picture that its method declares before it with the same extent, the nearest if
/// there are several: what is known of an image to start from stands behind that image. Exemplars have masks
/// of their own, which are painted where exemplars are edited, and what a later method starts from is not
/// there before the run.
std::optional<Port> MaskPainting::pictureBeside(const std::string& mask) const {
    const std::vector<Port> rows = m_inspector->output()->ports();
    for (const RecipeStep& step : m_inspector->steps()) {
        const std::vector<Port>& takes = findMethod(step.method).info().takes;
        const auto own =
            std::find_if(takes.begin(), takes.end(), [&](const Port& port) { return port.id == mask; });
        if (own == takes.end())
            continue;
        const auto found = std::find_if(std::make_reverse_iterator(own), takes.rend(), [&](const Port& port) {
            return port.kind == AssetKind::Image && port.extent == own->extent && findPort(rows, port.id);
        });
        const bool first = step.method == m_inspector->method()->id();
        return found == takes.rend() || (!first && found->id == kInitialPort) ? std::nullopt
                                                                              : std::optional(*found);
    }
    return {};
}

/// The image of the picture's port; where that is empty, the result that is shown, else the exemplar.
std::optional<MaskPainting::Ground> MaskPainting::groundFor(const std::optional<Port>& picture) const {
    const InputFiles inputs = m_inspector->output()->inputs();
    if (const ExemplarFile* given = picture ? pictureOf(inputs, picture->id) : nullptr)
        return Ground{given->image, given->name(), nullptr};
    if (const auto& result = m_desk->result(); result && !result->synthesis.image.empty()) {
        const std::shared_ptr<const Image> image(result, &result->synthesis.image);
        return Ground{image, result->fileName(), [result, image](const Port& port) {
                          return loadInput(port, {toPath(saveInput(*result, port, image)), "", ""}, {});
                      }};
    }
    if (const ExemplarEntry* entry = m_store->current())
        return Ground{
            entry->file().image, entry->file().name(),
            [exemplar = entry->exemplar](const Port& port) { return exemplarInput(exemplar, port); }};
    return {};
}

void MaskPainting::paint(const std::string& port) {
    const std::vector<Port> ports = m_inspector->output()->ports();
    const Port* const mask = findPort(ports, port);
    const std::optional<Port> picture = pictureBeside(port);
    const std::optional<Ground> ground = groundFor(picture);
    if (mask == nullptr || !ground)
        return Q_EMIT failed(
            tr("There is no picture to paint on yet; open an exemplar, or choose the image first."));
    open(*mask, picture, *ground);
}

void MaskPainting::open(const Port& mask, const std::optional<Port>& picture, const Ground& ground) {
    const InputFiles inputs = m_inspector->output()->inputs();
    const ExemplarFile* const before = pictureOf(inputs, mask.id);
    inBackground(
        this,
        [image = ground.image, given = before ? before->image : nullptr] { return painted(image, given); },
        [this, mask, picture, ground](Painted now) {
            auto* painter = new MaskPainter(std::move(now.picture), std::move(now.selection),
                                            translated(mask.help), m_window);
            painter->setAttribute(Qt::WA_DeleteOnClose);
            painter->setWindowTitle(
                tr("%1 · %2").arg(translated(mask.title), QString::fromStdString(ground.name)));
            connect(painter, &QDialog::accepted, this, [=, this] { keep(*painter, mask, picture, ground); });
            painter->open();
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void MaskPainting::keep(const MaskPainter& painter, const Port& mask, const std::optional<Port>& picture,
                        const Ground& ground) {
    // A mask of the output's size was painted on a picture of that size, whatever size was set before.
    const Size size = mask.extent == Extent::Output ? ground.image->size() : Size{};
    inBackground(
        this,
        [mask, picture, ground, selection = painter.selection()] {
            InputFiles made;
            made[mask.id] = {InputFile(saveMask(selections::inverted(selection), ground.name))};
            if (picture && ground.file)
                made[picture->id] = {ground.file(*picture)};
            return made;
        },
        [this, size](const InputFiles& made) { m_inspector->output()->replaceInputs(made, size); },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
