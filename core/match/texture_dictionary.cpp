#include "core/match/texture_dictionary.h"

#include "core/base/at.h"
#include "core/match/whole_patches.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace texloom {

namespace {

/// Patches on the grid of `step` pixels that the mask leaves whole, as y × width + x.
std::vector<int> positionsOf(const PatchSource& source, const TextureDictionaryOptions& options,
                             const JobContext& context) {
    std::vector<int> positions;
    const auto add = [&](int x, int y) {
        if (x % options.step == 0 && y % options.step == 0)
            positions.push_back(y * source.image.width + x);
        return false;
    };
    if (source.mask.data)
        anyWholePatch(source.mask, options.patch, add, [&] { context.check(); });
    else
        for (int y = 0; y + options.patch <= source.image.height; y += options.step)
            for (int x = 0; x + options.patch <= source.image.width; x += options.step)
                add(x, y);
    if (positions.empty()) // all of them lie between the grid's points
        anyWholePatch(source.mask, options.patch, [&](int x, int y) {
            positions.push_back(y * source.image.width + x);
            return false;
        });
    return positions;
}

/// As many as are learnt from, drawn at random, in the order of the exemplar.
void drawFew(std::vector<int>& positions, const TextureDictionaryOptions& options, const Random& random) {
    const auto most = at(options.learning.atoms) * kPatchesPerAtom;
    if (positions.size() <= most)
        return;
    constexpr int kRow = -1 << 20; // of the random numbers: no atom's and no round's
    for (std::size_t i = 0; i < most; ++i)
        std::swap(positions[i],
                  positions[i + random.below(static_cast<std::uint32_t>(positions.size() - i),
                                             static_cast<int>(i), kRow - options.learning.draw)]);
    positions.resize(most);
    std::sort(positions.begin(), positions.end());
}

/// Draws atoms into cells of `side` pixels whose corners are `pitch` apart.
void drawAtoms(const Eigen::MatrixXf& atoms, std::span<const int> order, const AtomSheetStyle& style,
               int columns, int side, int pitch, int margin, Image& to) {
    std::vector<float> scales;
    for (const int n : order) {
        const float largest = atoms.col(n).cwiseAbs().maxCoeff();
        const float sign = atoms.col(n).sum() < 0 ? -1.0F : 1.0F;
        scales.push_back(largest > 0 ? sign * style.reach / largest : 0);
    }
    const int area = style.patch * style.patch;
    for (int c = 0; c < to.channels(); ++c) {
        for (int y = 0; y < to.height(); ++y)
            std::fill_n(to.plane(c).row(y), to.width(), style.background[at(c)]);
        for (int i = 0; i < static_cast<int>(order.size()); ++i) {
            const int left = margin + i % columns * pitch, top = margin + i / columns * pitch;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x)
                    to(left + x, top + y, c) =
                        style.zero[at(c)] +
                        scales[at(i)] *
                            atoms(c * area + y * style.patch / side * style.patch + x * style.patch / side,
                                  order[at(i)]);
        }
    }
}

} // namespace

Dictionary
learnTexture(const PatchSource& source, const TextureDictionaryOptions& options, JobContext& context,
             const std::function<void(int rounds, double error, const Eigen::MatrixXf& atoms)>& watch) {
    std::vector<int> positions = positionsOf(source, options, context);
    drawFew(positions, options, context.random());
    Eigen::MatrixXf signals(source.image.channels * options.patch * options.patch,
                            static_cast<Eigen::Index>(positions.size()));
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (k % 1024 == 0)
            context.check();
        const int left = positions[k] % source.image.width, top = positions[k] / source.image.width;
        float* value = signals.col(static_cast<Eigen::Index>(k)).data();
        for (int c = 0; c < source.image.channels; ++c)
            for (int y = 0; y < options.patch; ++y, value += options.patch)
                std::copy_n(source.image.plane(c).row(top + y) + left, options.patch, value);
    }
    return learnDictionary(signals, options.learning, context, watch);
}

std::int64_t learntPatches(Size exemplar, const TextureDictionaryOptions& options) {
    const std::int64_t across = (exemplar.width - options.patch) / options.step + 1;
    const std::int64_t down = (exemplar.height - options.patch) / options.step + 1;
    return std::min(across * down, static_cast<std::int64_t>(options.learning.atoms) * kPatchesPerAtom);
}

std::uint64_t textureDictionaryBytes(Size exemplar, int channels, const TextureDictionaryOptions& options,
                                     int threads) {
    return static_cast<std::uint64_t>(exemplar.area()) * 8 +
           dictionaryBytes(learntPatches(exemplar, options), channels * options.patch * options.patch,
                           options.learning, threads);
}

double textureDictionarySeconds(Size exemplar, int channels, const TextureDictionaryOptions& options) {
    const auto signals = static_cast<double>(learntPatches(exemplar, options));
    const double products = static_cast<double>(channels) * options.patch * options.patch *
                            static_cast<double>(options.learning.atoms);
    const double sparsity = options.learning.sparsity;
    return options.learning.iterations *
           (signals * (products * 1.3e-10 + sparsity * (2e-9 * options.learning.atoms + 1e-6)) +
            products * options.learning.atoms * 2e-10);
}

Image atomSheet(const Eigen::MatrixXf& atoms, std::span<const int> order, const AtomSheetStyle& style,
                int shown) {
    const int count = static_cast<int>(order.size()), pitch = style.patch + 1;
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
    const int rows = (count + columns - 1) / columns;
    Image sheet({columns * pitch + 1, rows * pitch + 1}, shown);
    drawAtoms(atoms, order, style, columns, style.patch, pitch, 1, sheet);
    return sheet;
}

Image atomSheet(const Eigen::MatrixXf& atoms, std::span<const int> order, const AtomSheetStyle& style,
                int shown, Size size) {
    Image sheet(size, shown);
    const int count = static_cast<int>(order.size());
    int pitch = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(size.area()) / count)));
    const auto margin = [&pitch] { return pitch > 3 ? 1 : 0; };
    const auto columns = [&] { return std::max(0, size.width - margin()) / pitch; };
    const auto rows = [&] { return std::max(0, size.height - margin()) / pitch; };
    while (pitch > 1 && columns() * rows() < count)
        --pitch;
    const auto fitting = static_cast<std::size_t>(std::min(count, columns() * rows()));
    drawAtoms(atoms, order.first(fitting), style, std::max(1, columns()), pitch - margin(), pitch, margin(),
              sheet);
    return sheet;
}

} // namespace texloom
