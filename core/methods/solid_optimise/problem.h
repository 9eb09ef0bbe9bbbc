#pragma once

#include "core/job/job_context.h"
#include "core/math/channel_pca.h"
#include "core/methods/solid_optimise/settings.h"
#include "core/volume/volume.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace texloom::solid_optimise {

/// A solid to be made: what its slices are to look like, in the colours in which it is worked on, and how it
/// is shown and kept on the way.
class Problem {
public:
    /// @param principal whether it is worked on in the exemplars' principal colours, each of variance 1, or
    /// in their own channels.
    Problem(const Request& request, const Settings& settings, bool principal, JobContext& context);

    const Settings& settings() const { return m_settings; }
    const std::vector<SliceGoal>& goals() const { return m_goals; }
    double wholeWeight() const { return m_wholeWeight; }
    /// Channels in which it is worked on; 0 where the exemplars are of one colour.
    int channels() const { return m_principal ? m_colours.components() : m_request.channels(); }
    JobContext& context() const { return m_context; }

    /// Offers a solid of any side as a picture: its slice at z = 0, laid out over the output.
    void show(const Volume& solid) const;
    /// The slice at z = 0 in the exemplars' colours, `step` pixels of the output from one pixel to the next.
    Image picture(const Volume& solid, Size size, int step) const;
    /// The solid in the exemplars' colours.
    Volume coloured(const Volume& solid) const;

private:
    /// Where the exemplars are of one colour, that.
    void toColours(const ImageView& components, Image& to) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    bool m_principal;
    std::vector<SliceGoal> m_goals;
    double m_wholeWeight = 0;
    std::vector<double> m_means;
    ChannelPca m_colours;
};

/// How far a solid had come: the scale (0 the finest), the iterations done at it, and what is in memory.
struct Progress {
    int scale = 0;
    int iteration = 0;
    Volume solid;
    std::vector<std::int32_t> matches; ///< of methods that keep any

    std::string bytes() const;
    /// @throws Error if `text` is not what bytes() wrote.
    static Progress from(const std::string& text);
};

/// Side of a solid at a scale, at least as long as a neighbourhood.
int sideAt(const Settings& settings, int scale);
/// Scales at which both the exemplars and the solid are larger than a few neighbourhoods.
int scalesFor(const Request& request, const Settings& settings);
/// Independent normal numbers in every voxel.
Volume noise(int side, int channels, const JobContext& context);
/// The solid at another side by trilinear interpolation, as one that repeats.
Volume enlarged(const Volume& solid, int side, JobContext& context);
/// Gives each channel the distribution of the exemplars' pixels.
void matchColours(const Problem& problem, Volume& solid);

/// Each makes the solid of a problem, in the colours in which that works, and takes stages of weight 0.9.
Volume matchPatches(const Problem& problem, int scales);
Volume matchPyramids(const Problem& problem, int scales);
Volume matchNeighbourhoods(const Problem& problem, int scales);
Volume scanned(const Problem& problem, int scales);

} // namespace texloom::solid_optimise
