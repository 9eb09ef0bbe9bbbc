#include "core/methods/portilla_simoncelli/synthesizer.h"

#include "core/base/text.h"
#include "core/image/mirror.h"
#include "core/math/periodic_component.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace texloom::portilla_simoncelli {

namespace {

/// Rows that one thread projects at a time.
constexpr int kRows = 32;

std::vector<double> sharesOf(const Request& request, const Settings& settings) {
    if (request.exemplars.size() == 1)
        return {1.0};
    const double first = (1 - settings.weight) * request.exemplars.front().weight;
    const double second = settings.weight * request.exemplars.back().weight;
    return {first / (first + second), second / (first + second)};
}

std::vector<Image> learnedFrom(const Request& request, const Settings& settings,
                               const std::function<void()>& check) {
    std::vector<Image> learned;
    for (const Exemplar& exemplar : request.exemplars)
        learned.push_back(settings.periodic ? periodicComponent(*exemplar.image, check) : *exemplar.image);
    return learned;
}

/// Of the mixture of the exemplars, each about its own mean.
Eigen::MatrixXd mixedCovariance(const std::vector<Image>& images, const std::vector<double>& shares,
                                const std::function<void()>& check) {
    Eigen::MatrixXd sum = shares.front() * channelCovariance(images.front(), check);
    for (std::size_t i = 1; i < images.size(); ++i)
        sum += shares[i] * channelCovariance(images[i], check);
    return sum;
}

std::vector<int> commonReaches(const Request& request, const Settings& settings) {
    const int scales = Synthesizer::scalesFor(request, settings);
    std::vector<int> reaches = Sweep::reachesFor(Synthesizer::canvasFor(request, settings), scales, settings);
    for (const Exemplar& exemplar : request.exemplars) {
        const std::vector<int> own = Sweep::reachesFor(exemplar.image->size(), scales, settings);
        std::transform(reaches.begin(), reaches.end(), own.begin(), reaches.begin(),
                       [](int a, int b) { return std::min(a, b); });
    }
    return reaches;
}

} // namespace

int Synthesizer::scalesFor(const Request& request, const Settings& settings) {
    int scales = settings.scales;
    for (const Exemplar& exemplar : request.exemplars)
        scales = commonScales(scales, exemplar.image->size(), request.size, request.wrap.x, request.wrap.y);
    return scales;
}

Size Synthesizer::canvasFor(const Request& request, const Settings& settings) {
    return pyramidCanvas(request.size, request.wrap.x, request.wrap.y, scalesFor(request, settings));
}

Synthesizer::Synthesizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_check([&context] { context.check(); }),
      m_shares(sharesOf(request, settings)), m_learned(learnedFrom(request, settings, m_check)),
      m_pca(mixedCovariance(m_learned, m_shares, m_check), settings.jointChannels),
      m_reaches(commonReaches(request, settings)) {
    if (m_pca.components() == 0)
        return;
    const Size canvas = canvasFor(request, settings);
    m_components = Image(canvas, m_pca.components());
    m_check();
    m_image = Image(canvas, request.channels());
    m_check();
    m_result = Image(canvas, request.channels());
}

Synthesis Synthesizer::run() {
    m_context.stage(0.03, TR("Measuring the exemplar"));
    measureExemplars();
    if (m_pca.components() == 0)
        return constant();
    m_context.stage(0.95, TR("Imposing statistics"));
    start();
    const SteerablePyramid pyramid(m_image.size(), scalesFor(m_request, m_settings), m_settings.orientations,
                                   m_check);
    Sweep sweep(pyramid, m_pca.components(), m_pca.leadingComponents(), m_reaches, m_settings, m_context);
    for (int iteration = 0; iteration < m_settings.iterations; ++iteration)
        iterate(sweep, iteration);
    m_context.stage(0.02, TR("Measuring the result"));
    Synthesis result;
    addFigures(measured(m_result, m_components, sweep), result);
    m_result.shrink(m_request.size);
    result.image = std::move(m_result);
    m_context.progress(1);
    return result;
}

void Synthesizer::overRows(int height, const std::function<void(int first, int last)>& body) const {
    m_context.parallel(0, (height + kRows - 1) / kRows,
                       [&](int block) { body(block * kRows, std::min(height, (block + 1) * kRows)); });
}

void Synthesizer::project(const Image& image, Image& components) const {
    const std::vector<double> means = channelMeans(image, m_check);
    overRows(image.height(),
             [&](int first, int last) { m_pca.project(image, means, first, last, components); });
}

Statistics Synthesizer::measured(const Image& image, Image& components, Sweep& sweep) const {
    project(image, components);
    Statistics statistics = sweep.run(components, nullptr, [](double, const std::vector<PlaneView>&) {});
    statistics.components.resize(static_cast<std::size_t>(components.channels()));
    statistics.channels.resize(static_cast<std::size_t>(image.channels()));
    m_context.parallel(0, components.channels() + image.channels(), [&](int i) {
        const int channel = i - components.channels();
        if (channel < 0)
            statistics.components[static_cast<std::size_t>(i)] =
                momentsOf(components.view().plane(i), m_check);
        else
            statistics.channels[static_cast<std::size_t>(channel)] =
                momentsOf(image.view().plane(channel), m_check);
    });
    return statistics;
}

/// The range is that of the exemplar itself, which its periodic component may exceed.
void Synthesizer::measureExemplars() {
    for (std::size_t i = 0; i < m_learned.size(); ++i) {
        const Image& image = m_learned[i];
        Statistics statistics;
        if (m_pca.components() > 0) {
            const SteerablePyramid pyramid(image.size(), scalesFor(m_request, m_settings),
                                           m_settings.orientations, m_check);
            Sweep sweep(pyramid, m_pca.components(), m_pca.leadingComponents(), m_reaches, m_settings,
                        m_context);
            Image components(image.size(), m_pca.components());
            statistics = measured(image, components, sweep);
        } else {
            for (int c = 0; c < image.channels(); ++c)
                statistics.channels.push_back(momentsOf(image.view().plane(c), m_check));
        }
        for (int c = 0; c < image.channels(); ++c) {
            const Moments own = momentsOf(m_request.exemplars[i].image->view().plane(c), m_check);
            statistics.channels[static_cast<std::size_t>(c)].smallest = own.smallest;
            statistics.channels[static_cast<std::size_t>(c)].largest = own.largest;
        }
        if (i == 0)
            m_wanted = std::move(statistics);
        else
            m_wanted.mix(statistics, m_shares[i]);
        m_context.progress(static_cast<double>(i + 1) / static_cast<double>(m_learned.size()));
    }
    m_learned.clear();
}

std::vector<double> Synthesizer::wantedMeans() const {
    std::vector<double> means;
    for (const Moments& moments : m_wanted.channels)
        means.push_back(moments.mean);
    return means;
}

Synthesis Synthesizer::constant() const {
    Synthesis result;
    result.image = Image(m_request.size, m_request.channels());
    for (int c = 0; c < m_request.channels(); ++c)
        for (int y = 0; y < m_request.size.height; ++y)
            std::fill_n(result.image.plane(c).row(y), m_request.size.width,
                        static_cast<float>(m_wanted.channels[static_cast<std::size_t>(c)].mean));
    m_context.stage(0.97, TR("Imposing statistics"));
    m_context.progress(1);
    return result;
}

/// Beyond the output, an initial image is continued by its mirror image, which has no jump.
void Synthesizer::start() {
    if (m_request.initial()) {
        const Image& initial = *m_request.initial();
        overRows(m_image.height(), [&](int first, int last) {
            for (int c = 0; c < initial.channels(); ++c)
                for (int y = first; y < last; ++y)
                    for (int x = 0; x < m_image.width(); ++x)
                        m_image(x, y, c) = m_result(x, y, c) =
                            initial(mirrored(x, initial.width()), mirrored(y, initial.height()), c);
        });
        return;
    }
    const std::vector<double> means = wantedMeans();
    overRows(m_image.height(), [&](int first, int last) {
        for (int c = 0; c < m_components.channels(); ++c)
            for (int y = first; y < last; ++y)
                for (int x = 0; x < m_image.width(); ++x)
                    m_components(x, y, c) =
                        static_cast<float>(m_context.random().normal(x, y, static_cast<std::uint32_t>(c)));
        m_pca.unproject(m_components, means, first, last, m_image);
        m_pca.unproject(m_components, means, first, last, m_result);
    });
}

void Synthesizer::iterate(Sweep& sweep, int iteration) {
    m_context.preview(m_result.view().crop(0, 0, m_request.size));
    project(m_image, m_components);
    Statistics measured =
        sweep.run(m_components, &m_wanted, [&](double share, const std::vector<PlaneView>& planes) {
            show(iteration, 0.95 * share, planes);
        });
    shapeComponents(measured);
    decorrelate();
    const std::vector<double> means = wantedMeans();
    overRows(m_image.height(),
             [&](int first, int last) { m_pca.unproject(m_components, means, first, last, m_image); });
    shapeChannels(measured);
    stepOn();
    const Deviations left = deviations(measured, m_wanted);
    for (std::size_t group = 0; group < kGroups; ++group)
        m_context.curve(titleOf(static_cast<Group>(group)), left[group]);
    m_context.progress((iteration + 1.0) / m_settings.iterations);
}

/// Steps beyond the result in the direction of the last change (momentum), as the authors' code does.
void Synthesizer::stepOn() {
    const auto share = static_cast<float>(m_settings.momentum);
    overRows(m_image.height(), [&](int first, int last) {
        for (int c = 0; c < m_image.channels(); ++c)
            for (int y = first; y < last; ++y) {
                float *ahead = m_image.plane(c).row(y), *result = m_result.plane(c).row(y);
                for (int x = 0; x < m_image.width(); ++x) {
                    const float now = ahead[x];
                    ahead[x] += share * (now - result[x]);
                    result[x] = now;
                }
            }
    });
}

void Synthesizer::shapeComponents(Statistics& measured) {
    measured.components.resize(m_wanted.components.size());
    m_context.parallel(0, m_components.channels(), [&](int c) {
        const auto nth = static_cast<std::size_t>(c);
        const PlaneSpan plane = m_components.plane(c);
        measured.components[nth] = momentsOf(plane, m_check);
        if (!m_settings.marginals)
            return;
        Moments wanted = m_wanted.components[nth];
        wanted.mean = 0;
        wanted.smallest = -std::numeric_limits<double>::infinity();
        wanted.largest = std::numeric_limits<double>::infinity();
        imposeMoments(plane, measured.components[nth], wanted, m_check);
    });
}

/// Components are not correlated in the exemplar.
void Synthesizer::decorrelate() {
    if (m_components.channels() == 1 || !m_settings.crossChannel)
        return;
    const Eigen::MatrixXd covariance = channelCovariance(m_components, m_check);
    const Eigen::MatrixXf map =
        leastMap(covariance, Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols())).cast<float>();
    overRows(m_components.height(), [&](int first, int last) {
        Eigen::VectorXf pixel(m_components.channels());
        for (int y = first; y < last; ++y)
            for (int x = 0; x < m_components.width(); ++x) {
                for (int c = 0; c < m_components.channels(); ++c)
                    pixel(c) = m_components(x, y, c);
                for (int c = 0; c < m_components.channels(); ++c)
                    m_components(x, y, c) = map.row(c).dot(pixel);
            }
    });
}

void Synthesizer::shapeChannels(Statistics& measured) {
    measured.channels.resize(m_wanted.channels.size());
    m_context.parallel(0, m_image.channels(), [&](int c) {
        const auto nth = static_cast<std::size_t>(c);
        const PlaneSpan plane = m_image.plane(c);
        const Moments& wanted = m_wanted.channels[nth];
        measured.channels[nth] = momentsOf(plane, m_check);
        if (m_settings.marginals)
            imposeMoments(plane, measured.channels[nth], wanted, m_check);
    });
}

void Synthesizer::show(int iteration, double share, const std::vector<PlaneView>& components) {
    m_context.progress((iteration + share) / m_settings.iterations);
    if (iteration > 0)
        return;
    m_context.preview(m_request.size, [&](Size size, int step) {
        Image sampled(size, m_pca.components()), image(size, m_request.channels());
        for (int c = 0; c < sampled.channels(); ++c) {
            const PlaneView& plane = components[static_cast<std::size_t>(c)];
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    sampled(x, y, c) =
                        plane(static_cast<int>(std::int64_t{x} * step * plane.width / m_image.width()),
                              static_cast<int>(std::int64_t{y} * step * plane.height / m_image.height()));
        }
        m_pca.unproject(sampled, wantedMeans(), 0, size.height, image);
        return image;
    });
}

void Synthesizer::addFigures(const Statistics& result, Synthesis& synthesis) const {
    synthesis.figures.push_back({TR("Scales used"), static_cast<double>(scalesFor(m_request, m_settings))});
    const Deviations left = deviations(result, m_wanted);
    for (std::size_t group = 0; group < kGroups; ++group)
        synthesis.figures.push_back(
            {message("Deviation, {}", titleOf(static_cast<Group>(group))), left[group]});
}

} // namespace texloom::portilla_simoncelli
