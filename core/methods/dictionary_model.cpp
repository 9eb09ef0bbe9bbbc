#include "core/methods/dictionary_model.h"

#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/methods/patch_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom {

namespace {

constexpr const char* kLayout = "layout"; ///< patch side, channels, scales
constexpr std::int64_t kLargestLayout = 4096;

std::string nameOf(std::size_t scale, const char* what) {
    return fmt::format("scale-{}/{}", scale, what);
}

std::int64_t atomsIn(const Model& model, const std::string& name) {
    const auto found = model.arrays.find(name);
    if (found == model.arrays.end() || found->second.shape.size() != 2 || found->second.shape.front() < 1)
        fail("The model has no array {} with atoms in it.", name);
    return found->second.shape.front();
}

} // namespace

std::shared_ptr<const Model> TextureDictionaries::model() const {
    auto made = std::make_shared<Model>();
    made->kind = kDictionaryPort;
    const auto count = static_cast<std::int64_t>(scales.size());
    made->arrays[kLayout] = {{3}, std::vector<std::int64_t>{patch, channels(), count}};
    made->arrays["origin"] = {{channels()}, origin};
    for (std::size_t j = 0; j < scales.size(); ++j) {
        const Dictionary& scale = scales[j];
        made->arrays[nameOf(j, "atoms")] = {
            {scale.count(), scale.length()},
            std::vector<float>(scale.atoms.data(), scale.atoms.data() + scale.atoms.size())};
        made->arrays[nameOf(j, "uses")] = {{scale.count()}, scale.uses};
        made->arrays[nameOf(j, "signals")] = {{1}, std::vector<std::int64_t>{scale.signals}};
    }
    return made;
}

TextureDictionaries TextureDictionaries::from(const Model& model) {
    model.checkKind(kDictionaryPort);
    const auto& layout = model.values<std::int64_t>(kLayout, {3});
    if (std::any_of(layout.begin(), layout.end(), [](auto n) { return n < 1 || n > kLargestLayout; }))
        fail("The dictionary says that it has {} scales of {} channels in patches of {} px.", layout[2],
             layout[1], layout[0]);
    TextureDictionaries read;
    read.patch = static_cast<int>(layout[0]);
    read.origin = model.values<float>("origin", {layout[1]});
    const std::int64_t length = layout[0] * layout[0] * layout[1];
    for (std::size_t j = 0; j < static_cast<std::size_t>(layout[2]); ++j) {
        const std::int64_t count = atomsIn(model, nameOf(j, "atoms"));
        const auto& atoms = model.values<float>(nameOf(j, "atoms"), {count, length});
        Dictionary& scale = read.scales.emplace_back();
        scale.atoms = Eigen::Map<const Eigen::MatrixXf>(atoms.data(), length, count);
        scale.uses = model.values<std::int64_t>(nameOf(j, "uses"), {count});
        scale.signals = model.values<std::int64_t>(nameOf(j, "signals"), {1}).front();
        if (scale.signals < 1 || std::any_of(scale.uses.begin(), scale.uses.end(),
                                             [&](auto n) { return n < 0 || n > scale.signals; }))
            fail("The dictionary's counts of uses at scale {} make no sense.", j);
    }
    return read;
}

Port dictionaryOutput() {
    return {.id = std::string(kDictionaryPort),
            .title = TR("Dictionary"),
            .help = TR("The learnt atoms of each scale, and how often each is used."),
            .kind = AssetKind::Model,
            .least = 1};
}

Port dictionaryInput() {
    return {.id = std::string(kDictionaryPort),
            .title = TR("Dictionary"),
            .help = TR("A learnt dictionary of this exemplar, so that none is learned again."),
            .kind = AssetKind::Model};
}

void checkDictionaries(const TextureDictionaries& dictionaries, int patch, int channels) {
    if (dictionaries.patch != patch)
        failUsage("The dictionary has patches of {} px, and the patch size is {} px; they need the same.",
                  dictionaries.patch, patch);
    if (dictionaries.channels() != channels)
        failUsage("The dictionary was learnt from {}, and the exemplar with its companions has {}; "
                  "they need the same number.",
                  channelText(dictionaries.channels()), channels);
}

std::vector<float> dictionaryOrigin(const Exemplar& exemplar, bool centred, const JobContext& context) {
    const Image& image = *exemplar.image;
    std::vector<float> origin(at(image.channels()), 0.0F);
    if (!centred)
        return origin;
    for (int c = 0; c < image.channels(); ++c) {
        double sum = 0;
        std::int64_t count = 0;
        for (int y = 0; y < image.height(); ++y) {
            context.check();
            for (int x = 0; x < image.width(); ++x)
                if (!exemplar.mask() || (*exemplar.mask())(x, y, 0) != 0) {
                    sum += static_cast<double>(image(x, y, c));
                    ++count;
                }
        }
        origin[at(c)] = static_cast<float>(sum / static_cast<double>(std::max<std::int64_t>(count, 1)));
    }
    return origin;
}

Image shifted(const ImageView& image, const std::vector<float>& origin, float sign, JobContext& context) {
    Image made(image.size(), image.channels);
    context.parallel(0, image.height, [&](int y) {
        for (int c = 0; c < image.channels; ++c)
            std::transform(image.plane(c).row(y), image.plane(c).row(y) + image.width, made.plane(c).row(y),
                           [&](float value) { return value + sign * origin[at(c)]; });
    });
    return made;
}

int dictionaryScales(int wanted, int patch, Size exemplar, Size output, Wrap wrap) {
    int side = exemplar.shorterSide();
    if (wrap.x)
        side = std::min(side, output.width);
    if (wrap.y)
        side = std::min(side, output.height);
    int scales = 1;
    for (; scales < wanted && side / 2 >= 2 * patch; side /= 2)
        ++scales;
    return scales;
}

AtomSheetStyle sheetStyle(const Request& request, int patch, const std::vector<float>& origin,
                          const JobContext& context) {
    const Exemplar& exemplar = request.exemplars.front();
    AtomSheetStyle style{patch, origin, dictionaryOrigin(exemplar, true, context), 0};
    for (int c = 0; c < shownChannels(request); ++c) {
        const ValueRange range = valueRange(exemplar.image->view().channelRange(c, 1));
        const float zero = origin[at(c)];
        style.reach =
            std::max({style.reach, std::abs(range.largest - zero), std::abs(range.smallest - zero)});
    }
    return style;
}

int shownChannels(const Request& request) {
    return request.resultChannels() >= 3 ? 3 : 1;
}

void checkDictionaryRequest(const Request& request, int patch, int sparsity) {
    checkPatchRequest(request, patch);
    const int length = request.channels() * patch * patch;
    if (sparsity > length)
        failUsage("A patch of {} px has {} values, so that it cannot have {} atoms; choose at most {}.",
                  patch, length, sparsity, length);
}

} // namespace texloom
