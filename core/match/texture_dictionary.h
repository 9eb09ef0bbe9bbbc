#pragma once

#include "core/match/patch_source.h"
#include "core/math/dictionary_learning.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace texloom {

/// How the patches of a texture are chosen to learn a dictionary from.
struct TextureDictionaryOptions {
    int patch = 12; ///< τ
    int step = 1;   ///< pixels from one patch to the next
    DictionaryOptions learning;
};

/// At most this many patches for each atom are learnt from; of more, so many are drawn.
inline constexpr int kPatchesPerAtom = 20;

/// A dictionary of the patches of an exemplar. Its columns are laid out as those of PatchColumns.
/// @param source of values from which what is to count as 0 was subtracted already; its mask leaves a whole
/// patch. @param watch as learnDictionary()
Dictionary
learnTexture(const PatchSource& source, const TextureDictionaryOptions& options, JobContext& context,
             const std::function<void(int rounds, double error, const Eigen::MatrixXf& atoms)>& watch);

/// How many patches are learnt from, at most.
std::int64_t learntPatches(Size exemplar, const TextureDictionaryOptions& options);
/// Bytes that learnTexture() takes.
std::uint64_t textureDictionaryBytes(Size exemplar, int channels, const TextureDictionaryOptions& options,
                                     int threads);
/// Rough time on one thread, in seconds.
double textureDictionarySeconds(Size exemplar, int channels, const TextureDictionaryOptions& options);

/// How atoms are shown: each as bright as it can be, and with the sign that makes it bright rather than dark.
struct AtomSheetStyle {
    int patch = 12;
    std::vector<float> zero;       ///< for each channel, the value that 0 in an atom is shown as
    std::vector<float> background; ///< between the atoms
    float reach = 0.5F;            ///< how far from zero the largest value of each atom is shown
};

/// The atoms side by side, row by row, with a pixel of space around each. @param atoms their numbers in the
/// order in which they are shown. @param shown how many of the first channels are shown.
Image atomSheet(const Eigen::MatrixXf& atoms, std::span<const int> order, const AtomSheetStyle& style,
                int shown);
/// The same, with cells that fill a picture of this size as far as they can. Its border is free, so that it
/// closes on itself, unless it is too small for that.
Image atomSheet(const Eigen::MatrixXf& atoms, std::span<const int> order, const AtomSheetStyle& style,
                int shown, Size size);

} // namespace texloom
