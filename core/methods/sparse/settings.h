#pragma once

#include "core/math/dictionary_learning.h"

namespace texloom::sparse {

/// How patches are put together.
enum class Reconstruction { Cut, Average };

/// Along which axes colours are matched.
enum class Axes { Pca, Channels };

/// What low frequencies are drawn towards.
enum class LowPassTarget { Auto, Exemplar, RandomPhase };

/// Parameters of constrained sparse synthesis (Tartavel, Gousseau & Peyré 2013). Those of the dictionary are
/// explained in core/methods/dictionary_fields.h.
struct Settings {
    int patch = 12;
    int spacing = 4; ///< Δ: from one patch to the next; the source has 6
    int scales = 3;
    int sparsity = 4;
    int atoms = 384;
    int iterations = 30; ///< at most, at each scale
    int gradientSteps = 5;
    Pursuit pursuit = Pursuit::Plain;
    bool frequency = true; ///< C_rows: no atom is used more often than in the exemplar
    Reconstruction reconstruction = Reconstruction::Cut;
    bool histogram = true;
    double alpha = 1;
    Axes colours = Axes::Pca;
    bool lowPass = true;
    double beta = 1;
    LowPassTarget lowPassTarget = LowPassTarget::Auto;
    bool spectrum = true;
    double gamma = 0.3;
    DictionaryLearner learner = DictionaryLearner::Ksvd;
    int learningIterations = 20;
    int learnStep = 1;
    bool centred = false;

    /// Weights of the terms; 0 where a term is off.
    double histogramWeight() const { return histogram ? alpha : 0; }
    double lowPassWeight() const { return lowPass ? beta : 0; }
    double spectrumWeight() const { return spectrum ? gamma : 0; }
};

} // namespace texloom::sparse
