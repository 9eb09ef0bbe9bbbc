#include "ui/lattice/lattice_previews.h"

#include "core/analysis/lattice_values.h"
#include "core/image/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace texloom::ui {

namespace {

/// Lengths in pixels of the exemplar or of a preview.
constexpr double kOutput = 128, kMostOutput = 256, kSource = 384, kLeastShown = 48, kLeastVector = 5;
constexpr double kTiles = 3;

/// The lattice's vectors that are no mere directions.
std::vector<double> lengthsOf(const Lattice& lattice) {
    std::vector<double> lengths;
    for (const Vec2 vector : {lattice.v1, lattice.v2})
        if (!alongRows(vector))
            lengths.push_back(vector.length());
    return lengths;
}

/// A lattice in pixels of an exemplar that was stretched; directions of rows keep their length.
Lattice stretched(const Lattice& lattice, double right, double down) {
    const auto vector = [&](Vec2 v) {
        const Vec2 moved{v.x * right, v.y * down};
        return alongRows(v) ? (v.length() / moved.length()) * moved : moved;
    };
    return {vector(lattice.v1), vector(lattice.v2)};
}

std::shared_ptr<const DisplayPicture> preview(const Method& method, const Image& exemplar,
                                              const Lattice& lattice, const LatticePreviewFrame& frame,
                                              JobContext& context) {
    const auto check = [&] { context.check(); };
    const Region& part = frame.part;
    const ImageView seen = exemplar.view().crop(part.x, part.y, part.size);
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(frame.scale * side)));
    };
    const Size size{scaled(part.size.width), scaled(part.size.height)};
    auto image = std::make_shared<const Image>(size == part.size ? Image(seen) : resized(seen, size, check));
    Request request;
    request.exemplars = {{.name = "exemplar", .image = std::move(image)}};
    request.size = frame.output;
    const Values settings =
        method.resolved(latticeValues(method.params(),
                                      stretched(lattice, double(size.width) / part.size.width,
                                                double(size.height) / part.size.height),
                                      {}),
                        size);
    method.check(request, settings);
    Synthesis made = method.run(request, settings, context);
    return std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(made.image)));
}

} // namespace

LatticePreviewFrame previewFrame(Size exemplar, const std::vector<Lattice>& lattices) {
    double first = 0, shortest = std::numeric_limits<double>::infinity(), widest = 0;
    for (const Lattice& lattice : lattices) {
        const std::vector<double> lengths = lengthsOf(lattice);
        if (lengths.empty())
            continue;
        const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
        first = first > 0 ? first : *most;
        shortest = std::min(shortest, *least);
        widest = std::max({widest, lattice.extent().x, lattice.extent().y});
    }
    const double side = exemplar.shorterSide();
    const double shown = std::clamp(kTiles * first, std::min(kLeastShown, side), std::max(side, kLeastShown));
    LatticePreviewFrame frame;
    frame.scale = std::min(1.0, std::max(kOutput / shown, kLeastVector / shortest));
    const int output = static_cast<int>(std::lround(std::min(kMostOutput, frame.scale * shown)));
    frame.output = {output, output};
    const double source = std::max(kSource / frame.scale, kTiles * widest);
    const auto cut = [&](int length) { return std::min(length, static_cast<int>(std::ceil(source))); };
    frame.part.size = {cut(exemplar.width), cut(exemplar.height)};
    frame.part.x = (exemplar.width - frame.part.size.width) / 2;
    frame.part.y = (exemplar.height - frame.part.size.height) / 2;
    return frame;
}

void LatticePreviews::make(const Method& method, std::shared_ptr<const Image> exemplar,
                           std::vector<Lattice> lattices) {
    m_method = &method;
    m_exemplar = std::move(exemplar);
    m_lattices = std::move(lattices);
    m_next = 0;
    next();
}

void LatticePreviews::cancel() {
    m_task.cancel();
    m_lattices.clear();
    m_exemplar.reset();
}

void LatticePreviews::next() {
    if (m_next >= m_lattices.size()) {
        cancel();
        return;
    }
    const std::size_t index = m_next++;
    JobOptions options;
    options.threads = 1;
    m_task.start(
        options,
        [method = m_method, exemplar = m_exemplar, lattice = m_lattices[index],
         frame = previewFrame(m_exemplar->size(), m_lattices)](JobContext& context) {
            return preview(*method, *exemplar, lattice, frame, context);
        },
        [this, index](const std::shared_ptr<const DisplayPicture>& picture) {
            Q_EMIT made(static_cast<int>(index), picture);
            next();
        },
        [this, index](const QString& why) {
            Q_EMIT failed(static_cast<int>(index), why);
            next();
        });
}

} // namespace texloom::ui
