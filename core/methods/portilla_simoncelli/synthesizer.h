#pragma once

#include "core/job/job_context.h"
#include "core/math/channel_pca.h"
#include "core/methods/portilla_simoncelli/settings.h"
#include "core/methods/portilla_simoncelli/statistics.h"
#include "core/methods/portilla_simoncelli/sweep.h"
#include "core/methods/synthesis.h"

#include <vector>

namespace texloom::portilla_simoncelli {

/// Makes one texture (Portilla & Simoncelli 2000, section 3; Vacher & Briand, IPOL 2021, algorithm 5):
/// measures one exemplar or two, and imposes their statistics on noise or an image again and again.
class Synthesizer {
public:
    Synthesizer(const Request& request, const Settings& settings, JobContext& context);

    Synthesis run();

    /// The number of scales, of those requested, that the exemplars and the output allow.
    static int scalesFor(const Request& request, const Settings& settings);
    /// Size at which the texture is made; the output is cut from it.
    static Size canvasFor(const Request& request, const Settings& settings);

private:
    void measureExemplars();
    Statistics measured(const Image& image, Image& components, Sweep& sweep) const;
    void start();
    void iterate(Sweep& sweep, int iteration);
    void shapeComponents(Statistics& measured);
    void decorrelate();
    void stepOn();
    void shapeChannels(Statistics& measured);
    void show(int iteration, double share, const std::vector<PlaneView>& components);
    void addFigures(const Statistics& result, Synthesis& synthesis) const;
    Synthesis constant() const;
    void project(const Image& image, Image& components) const;
    void overRows(int height, const std::function<void(int first, int last)>& body) const;
    std::vector<double> wantedMeans() const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    std::function<void()> m_check;
    std::vector<double> m_shares; ///< of the exemplars
    std::vector<Image> m_learned; ///< the exemplars as they are measured
    ChannelPca m_pca;
    std::vector<int> m_reaches;
    Statistics m_wanted;
    Image m_image, m_components; ///< channels and components of the canvas
    Image m_result;              ///< of the last iteration; m_image is a step ahead of it
};

} // namespace texloom::portilla_simoncelli
