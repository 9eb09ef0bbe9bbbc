#include "core/methods/causal_synthesis.h"

#include "core/base/message.h"
#include "core/image/half_scale.h"
#include "core/image/mirror.h"
#include "core/methods/patch_request.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace texloom {

namespace {

/// Leaves of the tree that a search looks into.
constexpr int kLeaves = 4;
/// The coarsest scale of an exemplar holds so many neighbourhoods side by side at least.
constexpr int kAcross = 2;
/// Scales on which an initial image is taken up.
constexpr int kInitialLevels = 2;

constexpr float kFar = std::numeric_limits<float>::infinity();

NeighbourhoodTree::Options treeOptions(const CausalOptions& options) {
    NeighbourhoodTree::Options tree;
    tree.leaf = options.leaf;
    return tree;
}

/// Gaussian weights of sum `whole`; a pixel in the middle of a side of the square weighs about a third of one
/// at the centre.
std::vector<float> falloffWeights(const PixelRuns& runs, double whole) {
    int reach = 1;
    for (const PixelRun& run : runs)
        reach = std::max(reach, -run.dx);
    const double sigma = 0.7 * reach;
    std::vector<double> weights;
    double sum = 0;
    for (const PixelRun& run : runs)
        for (int i = 0; i < run.count; ++i) {
            const double dx = run.dx + i;
            weights.push_back(std::exp(-(dx * dx + run.dy * run.dy) / (2 * sigma * sigma)));
            sum += weights.back();
        }
    std::vector<float> scaled;
    for (const double weight : weights)
        scaled.push_back(static_cast<float>(whole * weight / sum));
    return scaled;
}

/// The variance of pictures taken together, summed over channels.
double varianceOf(const std::vector<const Image*>& pictures, const std::function<void()>& check) {
    const auto channels = static_cast<std::size_t>(pictures.front()->channels());
    std::vector<double> sums(channels, 0.0), squares(channels, 0.0);
    double pixels = 0;
    for (const Image* picture : pictures) {
        const std::vector<double> means = channelMeans(*picture, check);
        const auto area = static_cast<double>(picture->size().area());
        for (std::size_t c = 0; c < channels; ++c) {
            double apart = 0;
            for (int y = 0; y < picture->height(); ++y) {
                check();
                for (int x = 0; x < picture->width(); ++x)
                    apart +=
                        std::pow(static_cast<double>((*picture)(x, y, static_cast<int>(c))) - means[c], 2);
            }
            sums[c] += area * means[c];
            squares[c] += apart + area * means[c] * means[c];
        }
        pixels += area;
    }
    double variance = 0;
    for (std::size_t c = 0; c < channels; ++c)
        variance += squares[c] / pixels - std::pow(sums[c] / pixels, 2);
    return variance;
}

/// A picture that goes on beyond its borders: round them on axes that wrap, else mirrored.
Interleaved withMargin(const Image& image, int margin, Wrap wrap) {
    const auto indices = [margin](int length, bool wraps) {
        std::vector<int> found;
        for (int at = -margin; at < length + margin; ++at)
            found.push_back(wraps ? repeated(at, length) : mirrored(at, length));
        return found;
    };
    const std::vector<int> columns = indices(image.width(), wrap.x), rows = indices(image.height(), wrap.y);
    Interleaved wide({static_cast<int>(columns.size()), static_cast<int>(rows.size())}, image.channels());
    float* to = wide.data.data();
    for (const int y : rows)
        for (const int x : columns) {
            for (int c = 0; c < image.channels(); ++c)
                to[c] = image(x, y, c);
            to += wide.pixel;
        }
    return wide;
}

Size sizeAt(Size size, int level) {
    for (; level > 0; --level)
        size = halvedSize(size);
    return size;
}

} // namespace

int CausalSynthesis::levelsFor() const {
    const int fitting = ExemplarPyramid::levelsFor(m_request.exemplarSizes(), kAcross * m_options.side);
    const int wanted = std::min(m_options.levels, fitting);
    return m_request.initial() ? std::min(wanted, kInitialLevels) : wanted;
}

CausalSynthesis::CausalSynthesis(const Request& request, CausalOptions options, JobContext& context)
    : m_request(request), m_options(std::move(options)), m_context(context),
      m_pyramid(request, levelsFor(), m_options.side, [&context] { context.check(); }),
      m_causal(causalRuns(m_options.side)), m_canvas({1, 1}, 1, {}), m_coarse({1, 1}, 1) {
    for (int level = 0; level < m_pyramid.levels(); ++level)
        m_sizes.push_back(sizeAt(request.size, level));
    if (m_options.guides)
        makeGuides();
}

/// Squares of guides about every pixel of their scale lie within them, so that guides take no pixel of the
/// exemplar away.
int CausalSynthesis::guideMargin() const {
    return std::max(m_options.side, m_options.parent) / 2;
}

void CausalSynthesis::makeGuides() {
    const auto check = [this] { m_context.check(); };
    std::vector<const Image*> pictures;
    for (const Exemplar& exemplar : m_request.exemplars)
        pictures.push_back(exemplar.image.get());
    const double own = varianceOf(pictures, check), spread = varianceOf(m_options.guides->exemplars, check);
    m_guideWeight = m_options.guides->weight * (own > 0 && spread > 0 ? own / spread : 1);
    std::vector<Image> guides;
    for (const Image* guide : m_options.guides->exemplars)
        guides.push_back(*guide);
    Image output = *m_options.guides->output;
    for (int level = 0; level < m_pyramid.levels(); ++level) {
        std::vector<Interleaved>& scaled = m_exemplarGuides.emplace_back();
        for (Image& guide : guides) {
            m_context.check();
            scaled.push_back(withMargin(guide, guideMargin(), {}));
            guide = halved(guide, [this] { m_context.check(); });
        }
        m_outputGuides.push_back(withMargin(output, guideMargin(), m_request.wrap));
        output = halved(output, [this] { m_context.check(); });
    }
}

Synthesis CausalSynthesis::run(ScanOrder::Order order) {
    double whole = 0;
    for (int level = 0; level < m_pyramid.levels(); ++level)
        whole += std::pow(0.25, level);
    for (int level = m_pyramid.levels() - 1; level >= 0; --level)
        makeLevel(level, 0.98 * std::pow(0.25, level) / whole, order);
    m_context.stage(0.02, TR("Copying pixels"));
    Synthesis result;
    result.map = std::move(m_canvas.map);
    result.image = copied(result.map, m_request, m_context);
    m_context.progress(1);
    result.mapKind = MapKind::Exact;
    return result;
}

/// The pixels that the first rows see before they are made: on the coarsest scale pixels of the exemplar
/// drawn at random, white noise with its colours; on finer ones what the coarser scale's sources give.
void CausalSynthesis::begin(int level) {
    const bool first = level + 1 == m_pyramid.levels();
    PixelCanvas canvas(m_sizes[static_cast<std::size_t>(level)], m_request.channels(),
                       m_pyramid.sizes(level));
    const NeighbourhoodSet allowed = set(level, {{0, 0, 1}}, false);
    const Size size = canvas.size();
    m_context.parallel(0, size.height, [&](int y) {
        for (int x = 0; x < size.width; ++x) {
            Source source;
            if (!first) {
                const PositionMap& coarse = m_canvas.map;
                source = coarse.at(std::min(x / 2, coarse.width() - 1), std::min(y / 2, coarse.height() - 1));
                source.x = static_cast<std::uint16_t>(2 * source.x + x % 2);
                source.y = static_cast<std::uint16_t>(2 * source.y + y % 2);
            } else {
                source = allowed.drawn(m_context.random().uniform(x, y));
            }
            canvas.put(x, y, source, m_pyramid.pixels(level, source.exemplar));
        }
    });
    m_coarse = std::move(m_canvas.pixels);
    m_canvas = std::move(canvas);
    if (first && m_request.initial())
        loadInitial(level);
}

void CausalSynthesis::loadInitial(int level) {
    Image initial(*m_request.initial());
    for (int i = 0; i < level; ++i) {
        m_context.check();
        initial = halved(initial, [this] { m_context.check(); });
    }
    m_canvas.pixels.load(initial, 0, 0, initial.size());
}

NeighbourhoodSet CausalSynthesis::set(int level, const PixelRuns& runs, bool withParent) const {
    std::vector<NeighbourhoodPart> parts{{runs, false, {}}};
    std::vector<int> pixels{m_pyramid.pixels(level, 0).pixel};
    const auto add = [&](const PixelRuns& more, bool halvedPart, int pixel, int margin) {
        parts.push_back({more, halvedPart, {}, margin});
        pixels.push_back(pixel);
    };
    if (withParent)
        add(squareRuns(m_options.parent), true, pixels.front(), 0);
    const std::size_t own = parts.size();
    if (m_options.guides) {
        const int pixel = m_outputGuides.front().pixel;
        add(squareRuns(m_options.side), false, pixel, guideMargin());
        if (withParent)
            add(squareRuns(m_options.parent), true, pixel, guideMargin());
    }
    for (std::size_t p = 0; p < parts.size() && m_options.falloff; ++p)
        parts[p].weights = falloffWeights(parts[p].runs, p < own ? 1 : m_guideWeight);
    std::vector<NeighbourhoodSource> sources;
    for (int e = 0; e < m_pyramid.exemplars(); ++e)
        sources.push_back(source(level, e, withParent));
    return {Neighbourhood(parts, pixels), std::move(sources), [this] { m_context.check(); }};
}

NeighbourhoodSource CausalSynthesis::source(int level, int exemplar, bool withParent) const {
    const auto l = static_cast<std::size_t>(level), e = static_cast<std::size_t>(exemplar);
    NeighbourhoodSource source{{&m_pyramid.pixels(level, exemplar)}, m_pyramid.level(level)[e].mask};
    if (withParent)
        source.pictures.push_back(&m_pyramid.pixels(level + 1, exemplar));
    if (m_options.guides) {
        source.pictures.push_back(&m_exemplarGuides[l][e]);
        if (withParent)
            source.pictures.push_back(&m_exemplarGuides[l + 1][e]);
    }
    return source;
}

/// The pictures that the neighbourhood of an output's pixel shows, in the order of set().
std::vector<const Interleaved*> CausalSynthesis::outputPictures(int level, bool withParent) const {
    const auto l = static_cast<std::size_t>(level);
    std::vector<const Interleaved*> pictures{&m_canvas.pixels};
    if (withParent)
        pictures.push_back(&m_coarse);
    if (m_options.guides) {
        pictures.push_back(&m_outputGuides[l]);
        if (withParent)
            pictures.push_back(&m_outputGuides[l + 1]);
    }
    return pictures;
}

CausalSynthesis::Matcher CausalSynthesis::matcher(int level, const PixelRuns& runs) const {
    const bool parent = m_options.parent > 0 && level + 1 < m_pyramid.levels();
    Matcher found{set(level, runs, parent), nullptr, parent};
    // Small or masked exemplars may leave nothing that shows the parents too.
    return parent && found.set.sources().empty() ? Matcher{set(level, runs, false), nullptr, false}
                                                 : std::move(found);
}

void CausalSynthesis::makeLevel(int level, double weight, ScanOrder::Order order) {
    m_context.stage(weight, message("Scale 1/{}", 1 << level));
    begin(level);
    const bool first = level + 1 == m_pyramid.levels();
    const Size size = m_canvas.size();
    const int n = m_options.side, reach = n / 2;
    // The tree refers to the set, which stays where it is from here on.
    const auto grow = [&](Matcher& made) {
        if (!m_options.exact)
            made.tree = std::make_unique<NeighbourhoodTree>(made.set, treeOptions(m_options), m_context);
    };
    {
        // An initial image is there from the beginning, so that all of it can be compared.
        Matcher causal = matcher(level, first && m_request.initial() ? squareRuns(n) : m_causal);
        grow(causal);
        scan(level, causal, ScanOrder(size, reach, {true, true}), order);
    }
    if (m_options.passes == 1 && !m_request.wrap.y)
        return;
    Matcher whole = matcher(level, aroundRuns(n));
    grow(whole);
    for (int pass = 1; pass < m_options.passes; ++pass)
        scan(level, whole, ScanOrder(size, reach, {true, true}), order);
    if (!m_request.wrap.y)
        return;
    // The last rows were made without a look at the first ones: where the output is to close, those about the
    // border are made once more from all that surrounds them.
    const int rows = std::min(size.height, 4 * reach);
    scan(level, whole, ScanOrder(size, reach, {true, true}, {size.height - rows / 2, rows}), order);
}

void CausalSynthesis::scan(int level, const Matcher& matcher, const ScanOrder& scan, ScanOrder::Order order) {
    const Neighbourhood& neighbourhood = matcher.set.neighbourhood();
    const std::vector<const Interleaved*> pictures = outputPictures(level, matcher.parent);
    m_rowErrors.assign(static_cast<std::size_t>(m_canvas.size().height), 0.0);
    const auto body = [&](int y, int begin, int count) {
        const auto work = m_pool.borrow([] { return Workspace(); });
        work->wanted.resize(static_cast<std::size_t>(neighbourhood.length()));
        for (int x = begin; x < begin + count; ++x) {
            neighbourhood.gather(pictures, x, y, work->wanted.data());
            const Found found = choose(level, matcher, x, y, *work);
            m_rowErrors[static_cast<std::size_t>(y)] += static_cast<double>(found.distance);
            m_canvas.put(x, y, found.source, m_pyramid.pixels(level, found.source.exemplar));
        }
    };
    const auto between = [&](double done) {
        m_context.progress(done);
        previewMap(m_canvas.map, m_pyramid.level(level), level, m_request, m_context);
    };
    scan.run(m_context, body, between, order);
    m_context.curve(TR("Mean distance of the neighbourhoods"),
                    std::accumulate(m_rowErrors.begin(), m_rowErrors.end(), 0.0) /
                        static_cast<double>(m_canvas.size().area()));
}

/// The distance of the nearer of two neighbourhoods that are likely to be near: those that continue the
/// copies to the left and above.
float CausalSynthesis::bound(const Matcher& matcher, const float* wanted, int x, int y) const {
    const Size size = m_canvas.size();
    float least = kFar;
    const Continuation likely[] = {{m_canvas.map.at((x + size.width - 1) % size.width, y), 1, 0},
                                   {m_canvas.map.at(x, (y + size.height - 1) % size.height), 0, 1}};
    for (const Continuation& one : likely)
        if (matcher.set.has(one.x, one.y, one.exemplar))
            least = std::min(least, matcher.set.distance(wanted, one.source(), least));
    return least;
}

/// The nearest of those that continue the copies around.
CausalSynthesis::Found CausalSynthesis::mostCoherent(const Matcher& matcher, int x, int y,
                                                     Workspace& work) const {
    Found best{{}, kFar};
    coherentCandidates(m_canvas.map, m_causal, x, y, {true, true}, work.coherent);
    for (const Continuation& one : work.coherent) {
        if (!matcher.set.has(one.x, one.y, one.exemplar))
            continue;
        const float found = matcher.set.distance(work.wanted.data(), one.source(), best.distance);
        if (found < best.distance)
            best = {one.source(), found};
    }
    return best;
}

CausalSynthesis::Found CausalSynthesis::choose(int level, const Matcher& matcher, int x, int y,
                                               Workspace& work) const {
    const float* const wanted = work.wanted.data();
    Found nearest{{}, kFar};
    if (matcher.tree)
        nearest.source = matcher.tree->nearest(wanted, kLeaves);
    else
        nearest.source =
            matcher.set.nearest(wanted, bound(matcher, wanted, x, y), [this] { m_context.check(); });
    nearest.distance = matcher.set.distance(wanted, nearest.source, kFar);
    if (m_options.coherence <= 0)
        return nearest;
    const Found coherent = mostCoherent(matcher, x, y, work);
    const double factor = 1 + std::pow(0.5, level) * m_options.coherence;
    const bool enough =
        static_cast<double>(coherent.distance) <= static_cast<double>(nearest.distance) * factor;
    return coherent.source.valid() && enough ? coherent : nearest;
}

Estimate CausalSynthesis::estimate(const Request& request, const CausalOptions& options, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    double found = 0;
    for (const Size& size : exemplars)
        found += static_cast<double>(size.area());
    Estimate need;
    // The canvas with the next coarser one, and the result.
    need.bytes = PixelCanvas::bytesFor(request.size, channels) * 5 / 4 +
                 Image::bytesFor(request.size, channels) + ScanOrder::bytesFor(request.size) +
                 PixelPyramid::bytesFor(request) + 2 * NeighbourhoodSet::bytesFor(exemplars) + (8U << 20U) +
                 static_cast<std::uint64_t>(threads) * 65536;
    if (!options.exact)
        need.bytes += NeighbourhoodTree::bytesFor(exemplars, treeOptions(options));
    if (request.initial())
        need.bytes += Image::bytesFor(request.size, channels) * 3 / 2;
    if (options.guides) {
        const int own = options.guides->output->channels();
        const int margin = std::max(options.side, options.parent) / 2;
        const auto add = [&](Size size) {
            const Size wide{size.width + 2 * margin, size.height + 2 * margin};
            need.bytes += Interleaved::bytesFor(wide, own) * 4 / 3 + Image::bytesFor(size, own) * 2;
        };
        std::for_each(exemplars.begin(), exemplars.end(), add);
        add(request.size);
    }
    const double floats = 0.5 * options.side * options.side * channels;
    const double looked = options.exact ? found / 8 : 32 + 8 * std::log2(found);
    need.seconds =
        static_cast<double>(request.size.area()) * 4 / 3 * options.passes * floats * looked * 2e-10 +
        (options.exact ? 0 : found * 4e-6);
    return need;
}

} // namespace texloom
