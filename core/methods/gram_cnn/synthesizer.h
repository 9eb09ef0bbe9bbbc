#pragma once

#include "core/methods/gram_cnn/principal_colours.h"
#include "core/methods/gram_cnn/settings.h"
#include "core/methods/method.h"
#include "core/network/texture_loss.h"

#include <span>
#include <string>
#include <vector>

namespace texloom::gram_cnn {

/// Scales that the exemplars and the output are large enough for.
int scalesFor(const Request& request, const Settings& settings);
/// What is optimised at a scale: the output, which closes on itself, and where it need not wrap is larger so
/// that every tap has whole pixels.
Size canvasAt(const Request& request, int scale);

/// Makes the image from coarse to fine.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context);

    Synthesis run();

private:
    void prepare();
    Tensor start(int scale);
    void enlarge(int scale);
    TextureLoss lossAt(int scale);
    /// @param first iteration to make. @param earlier state of the minimiser to go on from, or null.
    void optimise(int scale, int first, const std::string* earlier);
    double evaluate(TextureLoss& loss, std::span<const float> x, std::span<float> gradient);
    void report(const TextureLoss& loss, int scale, int iteration);
    void show(int scale);
    void matchHistograms();
    Image image();
    Image constant() const;
    Synthesis finish();

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    PrincipalColours m_colours;
    Descriptor m_descriptor;
    int m_scales;
    std::vector<std::vector<Tensor>> m_exemplars; ///< at each scale, the finest first
    Tensor m_components;                          ///< what is optimised
    Tensor m_picture, m_pictureGradient, m_gradient;
    double m_value = 0;
    bool m_brokeDown = false; ///< a step gave what is no number
};

} // namespace texloom::gram_cnn
