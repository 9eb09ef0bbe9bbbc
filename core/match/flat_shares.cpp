#include "core/match/flat_shares.h"

#include "core/base/at.h"
#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>

namespace texloom {

namespace {

/// Share of the exemplars' range by which the pixels of a flat part may differ from their neighbours: one
/// step of 8 bits.
constexpr float kFlatStep = 1.0F / 255;

float rangeOf(std::span<const PatchSource> exemplars) {
    ValueRange whole = valueRange(exemplars.front().image);
    for (const PatchSource& exemplar : exemplars) {
        const ValueRange range = valueRange(exemplar.image);
        whole = {std::min(whole.smallest, range.smallest), std::max(whole.largest, range.largest)};
    }
    return whole.largest - whole.smallest;
}

/// Whether a pixel is as its right and its lower neighbour, as far as there are any.
bool flatAt(const ImageView& image, int x, int y, float step) {
    for (int c = 0; c < image.channels; ++c)
        if ((x + 1 < image.width && !(std::abs(image(x, y, c) - image(x + 1, y, c)) <= step)) ||
            (y + 1 < image.height && !(std::abs(image(x, y, c) - image(x, y + 1, c)) <= step)))
            return false;
    return true;
}

/// The share of flat pixels in each patch, from sums over columns that slide down.
Image sharesOf(const ImageView& image, int patch, float step, const std::function<void()>& check) {
    Image shares({image.width - patch + 1, image.height - patch + 1}, 1);
    std::vector<int> columns(static_cast<std::size_t>(image.width), 0);
    const auto add = [&](int y, int sign) {
        for (int x = 0; x < image.width; ++x)
            columns[at(x)] += flatAt(image, x, y, step) ? sign : 0;
    };
    const float area = static_cast<float>(patch) * static_cast<float>(patch);
    for (int y = 0; y < image.height; ++y) {
        check();
        add(y, 1);
        if (y >= patch)
            add(y - patch, -1);
        if (y < patch - 1)
            continue;
        int sum = 0;
        for (int x = 0; x < image.width; ++x) {
            sum += columns[at(x)] - (x >= patch ? columns[at(x - patch)] : 0);
            if (x >= patch - 1)
                shares(x - patch + 1, y - patch + 1, 0) = static_cast<float>(sum) / area;
        }
    }
    return shares;
}

} // namespace

FlatShares::FlatShares(std::span<const PatchSource> exemplars, int patch,
                       const std::function<void()>& check) {
    const float step = kFlatStep * rangeOf(exemplars);
    double sum = 0, count = 0;
    for (const PatchSource& exemplar : exemplars) {
        const Image& shares = m_shares.emplace_back(sharesOf(exemplar.image, patch, step, check));
        const auto add = [&](int x, int y) {
            m_largest = std::max(m_largest, shares(x, y, 0));
            sum += exemplar.weight * static_cast<double>(shares(x, y, 0));
            count += exemplar.weight;
            return false;
        };
        if (exemplar.mask.data)
            anyWholePatch(exemplar.mask, patch, add, check);
        else
            for (int y = 0; y < shares.height(); ++y)
                for (int x = 0; x < shares.width(); ++x)
                    add(x, y);
    }
    m_usual = count > 0 ? sum / count : 0;
}

std::uint64_t FlatShares::bytesFor(Size exemplar, int patch) {
    return Image::bytesFor({exemplar.width - patch + 1, exemplar.height - patch + 1}, 1);
}

} // namespace texloom
