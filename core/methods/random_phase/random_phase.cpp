#include "core/base/text.h"
#include "core/math/fft.h"
#include "core/math/phase_spot.h"
#include "core/methods/method.h"
#include "core/methods/random_phase/settings.h"
#include "core/methods/spectrum_fields.h"

#include <algorithm>
#include <cmath>

namespace texloom::random_phase {

namespace {

using Complex = std::complex<float>;

constexpr int kBlock = RealFft2d::kBlock;
/// Rows between two moments for progress and previews.
constexpr int kRowsAtOnce = 1024;

/// The torus on which the noise is drawn.
Size torusFor(const Request& request) {
    return PhaseSpot::torusFor(request.exemplars.front().image->size(), request.size, request.wrap);
}

/// Draws one texture: multiplies the spectrum of every channel of the spot by the same random factors.
class Field {
public:
    Field(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_fft(torusFor(request)),
          m_factors(m_fft.spectrumSize()), m_spectrum(m_fft.spectrumSize()),
          m_image(m_fft.size(), request.channels()) {}

    Synthesis run();

private:
    void fill(const PhaseSpot& spot, int channel);
    void finishRows(const PhaseSpot& spot, int channel);
    void show(int channel, double share);

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    RealFft2d m_fft;
    FftBuffer<Complex> m_factors;
    FftBuffer<Complex> m_spectrum;
    Image m_image;
};

Synthesis Field::run() {
    m_context.stage(0.1, TR("Preparing the exemplar"));
    const ImageView exemplar = *m_request.exemplars.front().image;
    const PhaseSpot spot(exemplar, m_fft.size(), {m_settings.periodic, m_settings.transition},
                         [this] { m_context.check(); });
    m_context.stage(0.2, TR("Drawing phases"));
    const RandomPhases phases(m_settings.model, m_fft.size(), m_context.random());
    m_context.parallel(0, m_fft.columns(), [&](int column) {
        phases.draw(column, m_factors.data() + column * m_fft.columnStride());
    });
    m_context.stage(0.7, TR("Filtering"));
    for (int c = 0; c < m_image.channels(); ++c)
        fill(spot, c);
    m_image.shrink(m_request.size);
    Synthesis result;
    result.image = std::move(m_image);
    m_context.progress(1);
    return result;
}

void Field::fill(const PhaseSpot& spot, int channel) {
    const PlaneSpan plane = m_image.plane(channel);
    spot.write(channel, plane);
    for (int column = 0; column < m_fft.columns(); ++column)
        std::fill(m_spectrum.data() + column * m_fft.columnStride() + spot.rows(),
                  m_spectrum.data() + column * m_fft.columnStride() + m_fft.size().height, Complex(0, 0));
    m_context.parallel(0, RealFft2d::blocksFor(spot.rows()), [&](int block) {
        m_fft.forwardRows(plane.data, block * kBlock, std::min(spot.rows(), (block + 1) * kBlock),
                          m_spectrum.data());
    });
    show(channel, 0.3);
    const float scale = 1 / static_cast<float>(m_fft.size().area());
    m_context.parallel(0, RealFft2d::blocksFor(m_fft.columns()), [&](int block) {
        const int first = block * kBlock, last = std::min(m_fft.columns(), first + kBlock);
        m_fft.forwardColumns(m_spectrum.data(), first, last);
        for (int column = first; column < last; ++column) {
            Complex* values = m_spectrum.data() + column * m_fft.columnStride();
            const Complex* factors = m_factors.data() + column * m_fft.columnStride();
            for (int row = 0; row < m_fft.size().height; ++row)
                values[row] = Complex(
                    (values[row].real() * factors[row].real() - values[row].imag() * factors[row].imag()) *
                        scale,
                    (values[row].real() * factors[row].imag() + values[row].imag() * factors[row].real()) *
                        scale);
        }
        m_fft.backwardColumns(m_spectrum.data(), first, last);
    });
    show(channel, 0.7);
    finishRows(spot, channel);
}

void Field::finishRows(const PhaseSpot& spot, int channel) {
    const PlaneSpan plane = m_image.plane(channel);
    const auto mean = static_cast<float>(spot.mean(channel));
    for (int top = 0; top < plane.height; top += kRowsAtOnce) {
        const int bottom = std::min(plane.height, top + kRowsAtOnce);
        m_context.parallel(0, RealFft2d::blocksFor(bottom - top), [&](int block) {
            const int first = top + block * kBlock, last = std::min(bottom, first + kBlock);
            m_fft.backwardRows(m_spectrum.data(), first, last, plane.data);
            for (int y = first; y < last; ++y)
                std::transform(plane.row(y), plane.row(y) + plane.width, plane.row(y),
                               [mean](float value) { return value + mean; });
        });
        show(channel, 0.7 + 0.3 * bottom / plane.height);
    }
}

void Field::show(int channel, double share) {
    m_context.progress((channel + share) / m_image.channels());
    m_context.preview(m_image.view().crop(0, 0, m_request.size));
}

Estimate estimate(const Request& request, const Settings&, int) {
    const Size torus = torusFor(request);
    const RealFft2d fft(torus);
    Estimate need;
    need.bytes = Image::bytesFor(torus, request.channels()) + 2 * fft.spectrumSize() * sizeof(Complex) +
                 PhaseSpot::bytesFor(request.exemplars.front().image->size(), request.channels());
    need.bytes += need.bytes / 16; // plans, threads and what the allocator keeps back
    const auto pixels = static_cast<double>(torus.area());
    need.seconds = pixels * (3e-8 + request.channels() * (1e-8 + 6e-10 * std::log2(pixels)));
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    return Field(request, settings, context).run();
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Random phase"),
     .summary = TR("Keeps the strength of each frequency of the exemplar and draws its phase at random. "
                   "Instant, and without any repetition; suits fine-grained textures such as sand, plaster "
                   "or cloth, and loses edges and objects."),
     .citation = "Galerne, Gousseau & Morel, IEEE TIP 2011; Moisan, J. Math. Imaging Vis. 2011",
     .category = Category::Statistics,
     .suits = {.grain = 3},
     .takes = {ports::exemplar()},
     .gives = {ports::wrappingImage()}},
    {field(&Settings::model, "model", TR("Model"))
         .choices({{"phase-noise", TR("Random phase noise")}, {"spot-noise", TR("Asymptotic spot noise")}})
         .help(
             TR("Random phase noise keeps each frequency's strength exactly; spot noise lets it vary as in a "
                "Gaussian field.")),
     periodicField(&Settings::periodic)
         .help(TR("Learns from the exemplar's periodic component, without which its borders draw horizontal "
                  "and vertical streaks.")),
     transitionField(&Settings::transition)},
    run, estimate);

} // namespace texloom::random_phase
