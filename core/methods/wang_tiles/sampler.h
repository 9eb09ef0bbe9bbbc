#pragma once

#include "core/job/job_context.h"
#include "core/job/random.h"
#include "core/methods/synthesis.h"
#include "core/methods/wang_tiles/samples.h"

#include <functional>
#include <vector>

namespace texloom::wang_tiles {

/// The places that samples may be taken from.
class SamplePlaces {
public:
    SamplePlaces(const Request& request, int side, JobContext& context);

    /// One of them, exemplars by weight, by the random numbers at (x, y) from the n-th on.
    PatchPosition drawn(const Random& random, int x, int y, std::uint32_t n) const;

private:
    struct Own {
        Size positions;
        std::vector<PatchPosition> allowed; ///< where there is a mask
        double until;                       ///< sum of weights up to this exemplar
    };
    std::vector<Own> m_exemplars;
    double m_whole = 0;
};

/// Draws the samples of a set: those that join best. Samples of corners keep apart from each other. What of
/// them stays at the borders of tiles is as lively as the exemplars usually are, and without marks, such as a
/// lone stone, as far as they have such places: it comes back at every corner of a colour, so that a mark, or
/// a lack of life, would be seen in rows.
class Sampler {
public:
    Sampler(const Request& request, const Settings& settings, JobContext& context);

    /// Draws until the worst cut is good enough: all samples a few times, then one after the other of the
    /// best so far. In a stage of its own. @param worstError of the worst cut between these samples.
    Samples draw(double weight, const std::function<double(const Samples&)>& worstError);

    int tries() const { return m_tries; }
    /// Of the worst cut, over that of unlike pixels.
    double error() const { return m_error; }

private:
    Samples drawn(int n) const;
    Samples withAnother(Samples samples, int n) const;
    PatchPosition another(const Samples& others, int n, int i) const;
    template <class Visit> void forShown(const PatchPosition& sample, Visit visit) const;
    double liveliness(const PatchPosition& sample) const;
    double strongestMark(const PatchPosition& sample) const;
    bool suits(const PatchPosition& place, const Samples& others) const;

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    SamplePlaces m_places;
    std::vector<double> m_means;  ///< of the first exemplar's channels
    double m_unlike;              ///< error of two unlike pixels
    std::vector<Image> m_blurred; ///< the exemplars, without what is too small to be a mark
    double m_usual = 0;           ///< liveliness of samples
    double m_mostMarked = 0;      ///< the strongest mark that a sample may have
    int m_apart;                  ///< what samples of corners keep from each other
    double m_error = 0;
    int m_tries = 0;
};

} // namespace texloom::wang_tiles
