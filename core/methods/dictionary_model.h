#pragma once

#include "core/io/model_file.h"
#include "core/match/texture_dictionary.h"
#include "core/methods/method.h"

#include <memory>
#include <string_view>
#include <vector>

namespace texloom {

/// The kind of model that a TextureDictionaries is as a file, and the id of ports for it.
inline constexpr std::string_view kDictionaryPort = "sparse-dictionary";

/// What is learnt from an exemplar for sparse synthesis: a dictionary for each scale, the finest first, of
/// patches from which `origin` was subtracted.
struct TextureDictionaries {
    int patch = 12;
    std::vector<float> origin; ///< for each channel, the value that counts as 0
    std::vector<Dictionary> scales;

    int channels() const { return static_cast<int>(origin.size()); }

    std::shared_ptr<const Model> model() const;
    /// @throws Error if arrays are missing or do not fit together.
    static TextureDictionaries from(const Model& model);
};

/// The port that gives such a model, and the one that takes it.
Port dictionaryOutput();
Port dictionaryInput();

/// Checks that dictionaries suit patches of this size and images of so many channels. @throws UsageError
void checkDictionaries(const TextureDictionaries& dictionaries, int patch, int channels);

/// The values that count as 0: the exemplar's mean of what its mask leaves, or black.
std::vector<float> dictionaryOrigin(const Exemplar& exemplar, bool centred, const JobContext& context);
/// The image with `origin` subtracted (sign −1) or added (sign 1), in parallel.
Image shifted(const ImageView& image, const std::vector<float>& origin, float sign, JobContext& context);

/// Scales that an exemplar and an output are large enough for: at the coarsest two patches side by side in
/// the exemplar, and in the output where it wraps.
int dictionaryScales(int wanted, int patch, Size exemplar, Size output, Wrap wrap);

/// How the atoms of a request's exemplar are shown. @param origin of the dictionaries.
AtomSheetStyle sheetStyle(const Request& request, int patch, const std::vector<float>& origin,
                          const JobContext& context);
/// Colours are shown as they are, other numbers of channels by their first.
int shownChannels(const Request& request);

/// Checks what methods with dictionaries have in common. @throws UsageError
void checkDictionaryRequest(const Request& request, int patch, int sparsity);

} // namespace texloom
