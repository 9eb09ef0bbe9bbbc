#include "core/base/text.h"
#include "core/math/anamorphosis.h"
#include "core/math/anamorphosis_fields.h"
#include "core/tools/tool.h"

#include <cmath>

namespace texloom::warp {

namespace {

struct Settings {
    AnamorphosisKind kind = AnamorphosisKind::Sinusoid;
    AnamorphosisAxis axis = AnamorphosisAxis::X;
    double amplitude = 0.5;
    int frequency = 3;
    double scale = 64;
    int seed = 0;
};

/// A place along an axis that goes back at its ends, and the sign of a step there.
struct Mirrored {
    double at, step;

    Mirrored(double place, double length) {
        const double rest = place - 2 * length * std::floor(place / (2 * length));
        at = rest <= length ? rest : 2 * length - rest;
        step = rest <= length ? 1 : -1;
    }
};

/// The deformation, mirrored where it leads out of the picture.
class Inside : public WarpField {
public:
    Inside(Size size, const Settings& settings)
        : m_size(size),
          m_warp(size, anamorphosisOptions(settings), {}, Random(static_cast<std::uint64_t>(settings.seed))) {
    }

    PlanePoint toSource(PlanePoint point) const override {
        const PlanePoint source = m_warp.toSource(point);
        return {Mirrored(source.x, m_size.width).at, Mirrored(source.y, m_size.height).at};
    }
    Eigen::Matrix2d jacobian(PlanePoint point) const override {
        const PlanePoint source = m_warp.toSource(point);
        Eigen::Matrix2d derivative = m_warp.jacobian(point);
        derivative.row(0) *= Mirrored(source.x, m_size.width).step;
        derivative.row(1) *= Mirrored(source.y, m_size.height).step;
        return derivative;
    }

private:
    Size m_size;
    Anamorphosis m_warp;
};

Warp deformed(const Settings& settings, Size before) {
    if (settings.amplitude == 0)
        return Placement(before);
    return {before, std::make_shared<const Inside>(before, settings)};
}

} // namespace

extern const Tool self;
const Tool self = tool<Settings>(
    {.title = TR("Warp"),
     .summary = TR("Deforms the exemplar lightly and without folds, so that several of it look less alike."),
     .citation = "Raad, thesis 2016, section 5.5",
     .adjusts = true},
    {anamorphosisKindField(&Settings::kind, "warp"), anamorphosisAxisField(&Settings::axis),
     anamorphosisAmplitudeField(&Settings::amplitude),
     anamorphosisFrequencyField(&Settings::frequency, "warp"),
     anamorphosisScaleField(&Settings::scale, "warp"),
     field(&Settings::seed, "seed", TR("Seed"))
         .range(0, 9999)
         .help(TR("Another number draws another deformation of the same kind."))},
    deformed);

} // namespace texloom::warp
