#pragma once

#include "core/base/param.h"
#include "core/base/text.h"
#include "core/match/texture_dictionary.h"

#include <vector>

namespace texloom {

/// Parameters that methods with dictionaries of patches have in common, declared once. Their settings have
/// the members patch, scales, sparsity, atoms, learner, learningIterations, learnStep and centred; the
/// defaults are those of Tartavel, Gousseau & Peyré (2013), section 5, where it states them.

template <class Settings> std::vector<Param> dictionaryPatchFields() {
    return {field(&Settings::patch, "patch", TR("Patch size"))
                .range(4, 32)
                .unit("px")
                .symbol("τ")
                .help(TR("Side of the patches at each scale: larger keeps larger features whole and takes "
                         "longer.")),
            field(&Settings::scales, "scales", TR("Scales"))
                .range(1, 6)
                .symbol("J")
                .help(TR("Most scales, each half the size of the one before: more keep larger structures.")),
            field(&Settings::sparsity, "sparsity", TR("Atoms of a patch"))
                .range(1, 32)
                .symbol("S")
                .help(TR("How many atoms make up a patch: more follow the exemplar more closely, fewer keep "
                         "edges clean.")),
            field(&Settings::atoms, "atoms", TR("Atoms"))
                .range(16, 2048)
                .symbol("N")
                .help(TR("Atoms of the dictionary at each scale: more tell more features apart, and take "
                         "longer to learn."))};
}

template <class Settings> std::vector<Param> dictionaryLearningFields() {
    return {
        field(&Settings::learner, "learner", TR("Learning"))
            .choices({{"ksvd", TR("K-SVD")}, {"online", TR("Online")}})
            .group(TR("Learning"))
            .help(TR("K-SVD improves every atom for all patches that use it, and learns better; online "
                     "learning looks at few patches at a time.")),
        field(&Settings::learningIterations, "learning-iterations", TR("Learning rounds"))
            .range(1, 200)
            .group(TR("Learning"))
            .help(TR("Rounds over all patches that are learnt from: more learn better, and take longer.")),
        field(&Settings::learnStep, "learn-step", TR("Learning step"))
            .range(1, 32)
            .unit("px")
            .group(TR("Learning"))
            .help(TR("From one patch that is learnt from to the next: wider steps in a small exemplar "
                     "leave so few patches that the atoms merely repeat them. At most 20 patches for "
                     "each atom are used.")),
        field(&Settings::centred, "centred", TR("From the mean"))
            .group(TR("Learning"))
            .help(TR("Atoms describe how patches differ from the exemplar's mean colour, rather than from "
                     "black, as published: of use for maps with values far from 0, and blurrier for "
                     "pictures."))};
}

/// How to learn the dictionary of a scale with these settings.
template <class Settings> TextureDictionaryOptions learningOf(const Settings& settings, int scale) {
    return {settings.patch,
            settings.learnStep,
            {settings.atoms, settings.sparsity, settings.learningIterations, settings.learner, scale}};
}

} // namespace texloom
