#include "ui/exemplar/exemplar_entry.h"

#include "core/session/run/edited_exemplar.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

/// White where the mask hides.
QImage hiddenPicture(const Image& mask) {
    QImage hidden(mask.width(), mask.height(), QImage::Format_Alpha8);
    for (int y = 0; y < mask.height(); ++y) {
        uchar* row = hidden.scanLine(y);
        for (int x = 0; x < mask.width(); ++x)
            row[x] = mask(x, y, 0) == 0 ? 255 : 0;
    }
    return hidden;
}

/// A small picture of a map, by its nearest pixels.
QImage thumbOf(const Image& map) {
    constexpr int kSide = 96;
    const double step = std::max(1.0, static_cast<double>(map.size().longerSide()) / kSide);
    const int width = std::max(1, static_cast<int>(map.width() / step));
    const int height = std::max(1, static_cast<int>(map.height() / step));
    QImage thumb(width, height, QImage::Format_RGB32);
    const auto level = [&](int x, int y, int c) {
        const float value = map(x, y, map.channels() >= 3 ? c : 0);
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int column = static_cast<int>(x * step), row = static_cast<int>(y * step);
            thumb.setPixel(x, y, qRgb(level(column, row, 0), level(column, row, 1), level(column, row, 2)));
        }
    return thumb;
}

/// Whether both have the same pictures for the same ports.
bool samePictures(const InputFiles& a, const InputFiles& b) {
    const auto sameFile = [](const InputFile& one, const InputFile& two) {
        return one.file.image == two.file.image && one.file.path == two.file.path;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const auto& one, const auto& two) {
        return one.first == two.first && std::equal(one.second.begin(), one.second.end(), two.second.begin(),
                                                    two.second.end(), sameFile);
    });
}

/// Whether making the exemplar anew from the state would change no pixel.
bool samePixels(const RunExemplar& exemplar, const ExemplarState& state) {
    const RunExemplar& original = exemplar.original();
    const auto same = [](const ExemplarFile& a, const ExemplarFile& b) {
        return a.image == b.image && a.role == b.role;
    };
    const auto sameMask = [&] {
        return original.mask ? state.original.mask && same(*original.mask, *state.original.mask)
                             : !state.original.mask;
    };
    return exemplar.edits == state.edits && samePictures(original.inputs, state.original.inputs) &&
           same(original.image, state.original.image) && sameMask() &&
           std::equal(original.companions.begin(), original.companions.end(),
                      state.original.companions.begin(), state.original.companions.end(), same);
}

} // namespace

ShownExemplar shown(RunExemplar exemplar, const ShownExemplar* before) {
    ShownExemplar made{std::move(exemplar), nullptr, {}, {}};
    const bool same = before != nullptr && before->file().image == made.exemplar.image.image;
    made.picture = same ? before->picture : std::make_shared<const DisplayPicture>(made.exemplar.image.image);
    if (made.exemplar.mask)
        made.hidden = hiddenPicture(*made.exemplar.mask->image);
    for (const ExemplarFile& companion : made.exemplar.companions)
        made.companionThumbs.push_back(thumbOf(*companion.image));
    return made;
}

ExemplarState stateOf(const RunExemplar& exemplar) {
    return {exemplar.original(), exemplar.edits};
}

RunExemplar madeFrom(const ExemplarState& state, const RunExemplar& known,
                     const std::function<void()>& check) {
    if (!samePixels(known, state))
        return texloom::edited(state.original, state.edits, check);
    RunExemplar made = known;
    made.weight = state.original.weight;
    if (known.source)
        made.source = std::make_shared<const RunExemplar>(state.original);
    return made;
}

void putCompanions(RunExemplar& original, std::vector<ExemplarFile> maps) {
    std::erase_if(original.companions, [&](const ExemplarFile& known) {
        return known.path == maps.front().path && known.layer == maps.front().layer;
    });
    for (ExemplarFile& map : maps)
        original.companions.push_back(std::move(map));
}

} // namespace texloom::ui
