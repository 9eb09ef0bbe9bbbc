#include "core/methods/sparse/cost.h"

#include "core/base/at.h"
#include "core/match/exemplar_pyramid.h"
#include "core/match/patch_columns.h"
#include "core/methods/dictionary_fields.h"
#include "core/methods/dictionary_model.h"
#include "core/methods/patch_request.h"
#include "core/methods/sparse/terms.h"

#include <algorithm>
#include <cmath>

namespace texloom::sparse {

int scalesFor(const Request& request, const Settings& settings) {
    return dictionaryScales(settings.scales, settings.patch, request.exemplars.front().image->size(),
                            request.size, request.wrap);
}

Size canvasFor(const Request& request, const Settings& settings) {
    const int least = settings.patch << (scalesFor(request, settings) - 1);
    return {request.wrap.x ? request.size.width : std::max(request.size.width, least),
            request.wrap.y ? request.size.height : std::max(request.size.height, least)};
}

Size sizeAt(int scale, Size size) {
    return {std::max(1, size.width >> scale), std::max(1, size.height >> scale)};
}

std::uint64_t bytesFor(const Request& request, const Settings& settings, int threads) {
    const Size exemplar = request.exemplars.front().image->size(), canvas = canvasFor(request, settings);
    const int channels = request.channels(), length = channels * settings.patch * settings.patch;
    const std::int64_t patches =
        PatchColumns::countFor(canvas, request.wrap, settings.patch, settings.spacing);
    const std::uint64_t image = Image::bytesFor(canvas, channels);
    const std::uint64_t dictionaries = 3 * sizeof(float) * at(length) * at(settings.atoms);
    const std::uint64_t coding = pursuitBytes(patches, length, settings.atoms, settings.sparsity, threads);
    const std::uint64_t joining = PatchColumns::joinBytes(canvas, channels, settings.patch, settings.spacing);
    std::uint64_t terms = 0, targets = 0;
    if (settings.histogram)
        terms += HistogramTerm::bytesFor(exemplar, canvas, channels, threads);
    if (settings.lowPass) {
        terms += LowPassTerm::bytesFor(canvas, channels, settings.patch);
        targets = randomPhaseBytes(exemplar, canvas, request.wrap, channels);
    }
    if (settings.spectrum)
        terms += SpectrumTerm::bytesFor(exemplar, canvas, channels);
    return 4 * Image::bytesFor(exemplar, channels) + 4 * image + dictionaries + terms +
           ExemplarPyramid::bytesFor(request.exemplarSizes(), channels) +
           std::max({coding, joining + SparseCode::bytesFor(patches, settings.sparsity), targets,
                     textureDictionaryBytes(exemplar, channels, learningOf(settings, 0), threads)}) +
           (8U << 20U);
}

double secondsFor(const Request& request, const Settings& settings) {
    const Size exemplar = request.exemplars.front().image->size(), canvas = canvasFor(request, settings);
    const int channels = request.channels();
    const double length = static_cast<double>(channels) * settings.patch * settings.patch;
    const double patches = PatchColumns::countFor(canvas, request.wrap, settings.patch, settings.spacing);
    const auto pixels = static_cast<double>(canvas.area()) * channels;
    const double coding = patches * settings.atoms * (length * 1.1e-10 + 4e-9 * settings.sparsity);
    const double joining = patches * length * (2e-9 * settings.sparsity + 8e-9);
    const double descent = settings.gradientSteps * pixels *
                           (4e-9 + (settings.histogram ? 4e-8 : 0) + (settings.lowPass ? 1.5e-8 : 0) +
                            (settings.spectrum ? 1e-9 * std::log2(pixels) : 0));
    double seconds = settings.iterations * (coding + joining + descent) * 4 / 3;
    if (!request.inputs.first<Model>(kDictionaryPort))
        for (int j = 0; j < scalesFor(request, settings); ++j)
            seconds += textureDictionarySeconds(sizeAt(j, exemplar), channels, learningOf(settings, j));
    return seconds;
}

} // namespace texloom::sparse
