#pragma once

#include "core/job/job_context.h"
#include "core/math/steerable_pyramid.h"
#include "core/methods/portilla_simoncelli/correlations.h"
#include "core/methods/portilla_simoncelli/scale_variables.h"
#include "core/methods/portilla_simoncelli/settings.h"
#include "core/methods/portilla_simoncelli/statistics.h"

#include <functional>
#include <vector>

namespace texloom::portilla_simoncelli {

/// One pass over the components of an image, from the coarsest scale to the finest, that measures all
/// statistics below those of pixels and, with wanted ones, imposes them on the way (Portilla & Simoncelli
/// 2000, section 3.2). Each is measured when it is reached, so the deviations are those that the last pass
/// left. Keeps its memory from pass to pass.
class Sweep {
public:
    /// @param joint how many of the first components have statistics in common.
    /// @param reaches by scale, from 0 to pyramid.scales(): the largest lag of autocorrelations.
    Sweep(const SteerablePyramid& pyramid, int components, int joint, const std::vector<int>& reaches,
          const Settings& settings, JobContext& context);

    /// The largest reaches, up to the settings', for which a scale of an image has room.
    static std::vector<int> reachesFor(Size size, int scales, const Settings& settings);

    /// Called now and then with the share of the pass that is done, and the low-pass image of every component
    /// as it stands.
    using Progress = std::function<void(double share, const std::vector<PlaneView>& components)>;

    /// @param components of the pyramid's size, with mean 0. With `wanted` they come back changed.
    /// @return everything but the moments of channels and components.
    Statistics run(Image& components, const Statistics* wanted, const Progress& progress);

    /// An upper bound of the bytes that an object and its run take.
    static std::uint64_t bytesFor(Size size, int scales, int components, const Settings& settings,
                                  int threads);

private:
    using Complex = SteerablePyramid::Complex;
    using Spectrum = FftBuffer<Complex>;
    using Plane = FftBuffer<float>;

    int bands() const { return m_variables.bands(); }
    bool coarsest(int scale) const { return scale + 1 == m_pyramid.scales(); }
    const ScaleStatistics& wantedAt(int scale) const {
        return m_wanted->scales[static_cast<std::size_t>(scale)];
    }
    ScaleStatistics& measuredAt(int scale) { return m_measured.scales[static_cast<std::size_t>(scale)]; }
    Spectrum& bandAt(int scale, int band);
    void begin();
    void report(int scale, double share);

    void decompose(const Image& components, int component);
    void shapeLow();
    void shapeScale(int scale);
    void keepFamilies(Eigen::MatrixXd& matrix, int rowsEach, int columnsEach) const;
    void relate(int scale, Kind kind);
    void shapeMagnitude(int scale, int band);
    void collect(int scale);
    void shapeImage(int scale, int component);
    void finish(Image& components, int component);

    const SteerablePyramid& m_pyramid;
    int m_components;
    int m_joint;
    const Settings& m_settings;
    JobContext& m_context;
    std::function<void()> m_check;
    std::vector<Autocorrelator> m_autocorrelators; ///< by scale

    const Statistics* m_wanted = nullptr;
    const Progress* m_progress = nullptr;
    Statistics m_measured;
    std::vector<Spectrum> m_high;                 ///< high residuals by component
    std::vector<std::vector<Spectrum>> m_spectra; ///< input of each scale, by component
    std::vector<std::vector<Spectrum>> m_bands;   ///< real bands by scale; of scale 0 a few at a time
    std::vector<std::vector<Spectrum>> m_images;  ///< low-pass images as they become, by scale and component
    ScaleVariables m_variables;                   ///< of the current scale
    std::vector<Plane> m_planes;                  ///< low-pass images, by component
    int m_planeScale = 0;
};

} // namespace texloom::portilla_simoncelli
