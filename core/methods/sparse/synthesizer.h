#pragma once

#include "core/match/exemplar_pyramid.h"
#include "core/match/patch_columns.h"
#include "core/methods/dictionary_model.h"
#include "core/methods/sparse/settings.h"
#include "core/methods/sparse/terms.h"

#include <optional>
#include <string>
#include <vector>

namespace texloom::sparse {

/// Constrained sparse synthesis (Tartavel, Gousseau & Peyré 2013): at each scale, from coarse to fine, the
/// image and the sparse code of its patches in the exemplar's dictionary are improved by turns (algorithm 1).
/// All values are those from which the dictionaries' origin was subtracted.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context);

    Synthesis run();

    /// A step of the gradient that always leads down: 0.5 / (ρ + α + β + γ). The source prints 4 / (1 + α +
    /// β), which diverges: the gradient's Lipschitz constant is 2 (ρ + α + β + γ), so that steps must be
    /// below 1 / (ρ + α + β + γ). @param covering largest number of patches over a pixel, divided by Z.
    static double stepFor(const Settings& settings, double covering);

private:
    /// What the work at one scale needs.
    struct Level;

    void prepare();
    void learn(int scale, double weight);
    Image firstDraft(int scale) const;
    Image nextDraft(int scale, const Eigen::MatrixXf& atoms) const;
    float flatness(int scale) const;
    void work(int scale, double weight);
    void begin(int scale);
    void startFromNoise(int scale);
    double iterate(Level& level);
    double descend(Level& level, const SparseCode& code, const Image& joined);
    double codingError(const Level& level, const SparseCode& code) const;
    Image target(int scale) const;
    Image filled() const;
    std::string state(int iteration) const;
    void resume(const std::string& state);
    void show() const;
    void addDictionaries(Synthesis& result) const;
    Synthesis finished();

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    TextureDictionaries m_dictionaries; ///< those learnt so far
    bool m_given = false;               ///< rather than learnt
    std::vector<PatchSource> m_sources; ///< the exemplar from its origin
    Image m_exemplar, m_filled;         ///< the latter without what the mask hides
    std::optional<ExemplarPyramid> m_pyramid;
    int m_scale = 0; ///< of m_image
    Image m_image;
    int m_iteration = 0;    ///< to go on with
    int m_waited = 0;       ///< iterations since the energy fell last
    double m_energy = 0;    ///< the least of the scale so far, of a pixel
    bool m_resumed = false; ///< m_image is what a checkpoint held
};

} // namespace texloom::sparse
