#include "ui/ports/port_painting.h"

#include "core/image/extension.h"
#include "core/image/selection.h"
#include "core/methods/method.h"
#include "core/session/run/run.h"
#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/exemplar/exemplar_store.h"
#include "ui/exemplar/files.h"
#include "ui/inspector/inspector.h"
#include "ui/inspector/output_group.h"
#include "ui/inspector/port_pairs.h"
#include "ui/paint/extend_dialog.h"
#include "ui/paint/label_painter.h"
#include "ui/paint/mask_painter.h"
#include "ui/runs/run_desk.h"

#include <algorithm>
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

const char* spaceOf(bool data) {
    return data ? "raw" : "srgb";
}

/// An edited exemplar is in no file: what is shown of it is written to one. Called on a worker.
InputFile exemplarInput(const RunExemplar& exemplar, const Port& port) {
    RecipeFile file = recipeFile(exemplar.image);
    if (!exemplar.edits.empty()) {
        file = {};
        file.path = toPath(savePicture(*exemplar.image.image, exemplar.image.name(),
                                       spaceOf(exemplar.image.space == "raw")));
    }
    return loadInput(port, file, {});
}

/// What is known of a picture that is extended: what was known before. Called on a worker.
Image knownOf(const Image& picture, const std::shared_ptr<const Image>& before, const Margins& margins) {
    const bool fits = before && before->size() == picture.size();
    return extended(fits ? *before : selections::inverted(Image(picture.size(), 1)), margins, {0});
}

/// Mean colours beyond the edges: nobody takes them for a part of the picture. Called on a worker.
Image enlarged(const Image& picture, const Margins& margins) {
    const std::vector<double> means = channelMeans(picture);
    return extended(picture, margins, {means.begin(), means.end()});
}

/// Titles of the methods that complete a picture, by their declarations.
QStringList completingMethods() {
    QStringList titles;
    for (const Method* method : methodsByCategory()) {
        const std::vector<Port>& takes = method->info().takes;
        if (std::any_of(takes.begin(), takes.end(), [&takes](const Port& port) {
                return port.kind == AssetKind::Mask && pictureBefore(takes, port.id) != nullptr &&
                       port.extent == Extent::Output;
            }))
            titles += translated(method->info().title);
    }
    return titles;
}

} // namespace

/// What a painter of flat colours begins with.
struct PortPainting::Labels {
    std::shared_ptr<const Image> ground; ///< what is painted over; null for nothing
    Size size;                           ///< of the picture
    std::shared_ptr<const Image> before; ///< what is painted already; null for nothing
    std::shared_ptr<const Image> other;  ///< whose colours it shares; null if there is none
    bool onlyOthers = false;             ///< whether colours that the other has not are of no use
    bool anew = false;                   ///< whether what is there cannot be painted on
    std::shared_ptr<const DisplayPicture> picture = nullptr;
    labels::Palette palette = {};
    Image indices = {};

    /// Called on a worker.
    void prepare();
};

void PortPainting::Labels::prepare() {
    constexpr std::size_t kUsual = 8;
    using labels::kMostColours;
    const auto flat = [](const std::shared_ptr<const Image>& image) {
        return image ? labels::flatColours(*image, kMostColours) : std::nullopt;
    };
    const auto others = flat(other);
    const int channels = other ? other->channels() : before ? before->channels() : 3;
    auto own =
        before && before->size() == size && before->channels() == channels ? flat(before) : std::nullopt;
    anew = before && !own;
    palette =
        labels::joined(others.value_or(labels::Palette()), own.value_or(labels::Palette()), kMostColours);
    if (!others || !onlyOthers)
        palette = labels::joined(palette, labels::usualColours(channels), std::max(kUsual, palette.size()));
    indices = own ? labels::indicesOf(*before, palette) : Image(size, 1);
    picture =
        std::make_shared<const DisplayPicture>(ground ? ground : std::make_shared<const Image>(size, 1));
}

PortPainting::PortPainting(const RunDesk* desk, const ExemplarStore* store, Inspector* inspector,
                           QWidget* window)
    : QObject(window), m_desk(desk), m_store(store), m_inspector(inspector), m_window(window) {
    connect(m_inspector->output(), &OutputGroup::paintWanted, this, &PortPainting::paint);
    connect(m_inspector->output(), &OutputGroup::extendWanted, this, &PortPainting::extendPicture);
}

/// What is known of an image to start from stands behind that image. Exemplars have masks of their own, which
/// are painted where exemplars are edited, and what a later method starts from is not there before the run.
std::optional<Port> PortPainting::pictureBeside(const std::string& mask) const {
    const std::vector<Port> rows = m_inspector->output()->ports();
    for (const RecipeStep& step : m_inspector->steps()) {
        const std::vector<Port>& takes = findMethod(step.method).info().takes;
        if (findPort(takes, mask) == nullptr)
            continue;
        const Port* const found = pictureBefore(takes, mask);
        const bool first = step.method == m_inspector->method()->id();
        const bool given = found != nullptr && findPort(rows, found->id) != nullptr;
        return !given || (!first && found->id == kInitialPort) ? std::nullopt : std::optional(*found);
    }
    return {};
}

/// The image of the picture's port; where that is empty, the result that is shown, else the exemplar.
std::optional<PortPainting::Ground> PortPainting::groundFor(const std::optional<Port>& picture) const {
    const InputFiles inputs = m_inspector->output()->inputs();
    if (const ExemplarFile* given = picture ? pictureOf(inputs, picture->id) : nullptr)
        return Ground{given->image, given->name(), given->space == "raw", nullptr};
    if (const auto& result = m_desk->result(); result && !result->synthesis.image.empty()) {
        const std::shared_ptr<const Image> image(result, &result->synthesis.image);
        const std::vector<RecipeExemplar>& made = result->plan.recipe.exemplars;
        const bool data = !made.empty() && made.front().image.space == "raw";
        return Ground{image, result->fileName(), data, [result, image](const Port& port) {
                          return loadInput(port, {toPath(saveInput(*result, port, image)), "", ""}, {});
                      }};
    }
    if (const ExemplarEntry* entry = m_store->current())
        return Ground{
            entry->file().image, entry->file().name(), entry->file().space == "raw",
            [exemplar = entry->exemplar](const Port& port) { return exemplarInput(exemplar, port); }};
    return {};
}

void PortPainting::paint(const std::string& port) {
    const std::vector<Port> ports = m_inspector->output()->ports();
    const Port* const own = findPort(ports, port);
    if (own == nullptr)
        return;
    if (own->kind == AssetKind::Mask)
        paintMask(*own);
    else
        paintLabels(*own);
}

void PortPainting::show(Painter* painter, const Port& port, const std::string& name) {
    painter->setAttribute(Qt::WA_DeleteOnClose);
    painter->setWindowTitle(tr("%1 · %2").arg(translated(port.title), QString::fromStdString(name)));
    painter->open();
}

void PortPainting::paintMask(const Port& mask) {
    const std::optional<Port> picture = pictureBeside(mask.id);
    const std::optional<Ground> ground = groundFor(picture);
    if (!ground)
        return Q_EMIT failed(
            tr("There is no picture to paint on yet; open an exemplar, or choose the image first."));
    openMask(mask, picture, *ground);
}

void PortPainting::openMask(const Port& mask, const std::optional<Port>& picture, const Ground& ground) {
    const InputFiles inputs = m_inspector->output()->inputs();
    const ExemplarFile* const before = pictureOf(inputs, mask.id);
    inBackground(
        this,
        [image = ground.image, given = before ? before->image : nullptr] { return painted(image, given); },
        [this, mask, picture, ground](Painted now) {
            QString meaning = translated(mask.help);
            if (picture && mask.extent == Extent::Output)
                meaning +=
                    QLatin1Char(' ') + tr("To make more of the picture beyond its edges, choose “Extend a "
                                          "picture…” from the menu Tools instead.");
            auto* painter =
                new MaskPainter(std::move(now.picture), std::move(now.selection), meaning, m_window);
            connect(painter, &QDialog::accepted, this,
                    [=, this] { keepMask(*painter, mask, picture, ground); });
            show(painter, mask, ground.name);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void PortPainting::keepMask(const MaskPainter& painter, const Port& mask, const std::optional<Port>& picture,
                            const Ground& ground) {
    // A mask of the output's size was painted on a picture of that size, whatever size was set before.
    const Size size = mask.extent == Extent::Output ? ground.image->size() : Size{};
    inBackground(
        this,
        [mask, picture, ground, selection = painter.painted()] {
            InputFiles made;
            made[mask.id] = {InputFile(saveMask(selections::inverted(selection), ground.name))};
            if (picture && ground.file)
                made[picture->id] = {ground.file(*picture)};
            return made;
        },
        [this, size](const InputFiles& made) { m_inspector->output()->replaceInputs(made, size); },
        [this](const QString& why) { Q_EMIT failed(why); });
}

/// A is painted over the exemplar, B over the result if it has the output's size. Both share their colours.
void PortPainting::paintLabels(const Port& port) {
    const OutputGroup* const output = m_inspector->output();
    const std::optional<AnalogyPorts> pair = analogyAmong(output->ports());
    const ExemplarEntry* const entry = m_store->current();
    if (entry == nullptr || !pair)
        return Q_EMIT failed(tr("There is no exemplar yet whose colours could be painted; open one first."));
    const RunExemplar& original = entry->exemplar.original();
    const InputFiles outputs = output->inputs();
    const auto imageOf = [](const InputFiles& inputs, const Port& of) {
        const ExemplarFile* const file = pictureOf(inputs, of.id);
        return file != nullptr ? file->image : nullptr;
    };
    const auto ofA = imageOf(original.inputs, pair->exemplars), ofB = imageOf(outputs, pair->output);
    const std::string name = entry->file().name();
    if (port.id == pair->exemplars.id)
        return openLabels(port, name, ofB ? translated(pair->output.title) : QString(),
                          {original.image.image, original.image.image->size(), ofA, ofB});
    Labels labels{nullptr, output->outputSize(), ofB, ofA, true};
    const auto& result = m_desk->result();
    if (result && result->synthesis.image.size() == labels.size)
        labels.ground = {result, &result->synthesis.image};
    openLabels(port, name, ofA ? translated(pair->exemplars.title) : QString(), std::move(labels));
}

/// @param colours the title of the picture whose colours are shared, or empty.
void PortPainting::openLabels(const Port& port, const std::string& name, const QString& colours,
                              Labels labels) {
    inBackground(
        this,
        [labels = std::move(labels)]() mutable {
            labels.prepare();
            return std::move(labels);
        },
        [this, port, name, colours](Labels now) {
            QStringList meaning = {translated(port.help)};
            if (!colours.isEmpty())
                meaning += tr("The first colours are those of %1.").arg(colours);
            if (now.anew)
                meaning += tr("What is there has another size or more than %1 colours, so it is begun anew.")
                               .arg(labels::kMostColours);
            const bool ground = now.ground != nullptr;
            auto* painter =
                new LabelPainter(std::move(now.picture), ground, std::move(now.indices),
                                 std::move(now.palette), meaning.join(QLatin1Char(' ')), m_window);
            connect(painter, &QDialog::accepted, this, [=, this] { keepLabels(*painter, port, name); });
            show(painter, port, name);
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void PortPainting::keepLabels(const LabelPainter& painter, const Port& port, const std::string& name) {
    inBackground(
        this,
        [port, name, indices = painter.painted(), colours = painter.colours()] {
            const QString path =
                savePicture(labels::pictureOf(indices, colours), name + "_" + port.id, spaceOf(false));
            return loadInput(port, {toPath(path), "", ""}, {});
        },
        [this, port](const InputFile& made) { m_inspector->output()->addInput(port.id, made); },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void PortPainting::extend() {
    for (const Port& port : m_inspector->output()->ports())
        if (port.kind == AssetKind::Mask && port.extent == Extent::Output && pictureBeside(port.id))
            return extendPicture(port.id);
    Q_EMIT failed(tr("%1 completes no picture; choose a method that does: %2.")
                      .arg(translated(m_inspector->method()->info().title),
                           completingMethods().join(QStringLiteral(", "))));
}

void PortPainting::extendPicture(const std::string& mask) {
    const std::vector<Port> ports = m_inspector->output()->ports();
    const Port* const own = findPort(ports, mask);
    const std::optional<Port> picture = pictureBeside(mask);
    const std::optional<Ground> ground = groundFor(picture);
    if (own == nullptr || !picture || !ground)
        return Q_EMIT failed(
            tr("There is no picture to extend yet; open an exemplar, or choose the image first."));
    inBackground(
        this, [image = ground->image] { return std::make_shared<const DisplayPicture>(image); },
        [this, port = *own, picture = *picture,
         ground = *ground](const std::shared_ptr<const DisplayPicture>& shown) {
            auto* dialog = new ExtendDialog(shown, kLargestSide, m_window);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            connect(dialog, &QDialog::accepted, this,
                    [=, this] { keepExtended(port, picture, ground, dialog->margins()); });
            dialog->open();
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

void PortPainting::keepExtended(const Port& mask, const Port& picture, const Ground& ground,
                                const Margins& margins) {
    const InputFiles inputs = m_inspector->output()->inputs();
    const ExemplarFile* const before = pictureOf(inputs, mask.id);
    const Size size = extendedSize(ground.image->size(), margins);
    inBackground(
        this,
        [=, known = before ? before->image : nullptr] {
            InputFiles made;
            const Image& image = *ground.image;
            made[mask.id] = {InputFile(saveMask(knownOf(image, known, margins), ground.name))};
            const QString path =
                savePicture(enlarged(image, margins), ground.name + "_extended", spaceOf(ground.data));
            made[picture.id] = {loadInput(picture, {toPath(path), ground.data ? "raw" : "", ""}, {})};
            return made;
        },
        [this, size](const InputFiles& made) {
            m_inspector->output()->replaceInputs(made, size);
            Q_EMIT told(tr("The picture has %1 px now; press Run to make what lies beyond its edges.")
                            .arg(sizeText(size)));
        },
        [this](const QString& why) { Q_EMIT failed(why); });
}

} // namespace texloom::ui
