#include "core/methods/ashikhmin/synthesizer.h"

#include "core/base/text.h"
#include "core/base/wide_vectors.h"
#include "core/methods/patch_request.h"

#include <limits>

namespace texloom::ashikhmin {

namespace {

/// Draws of one pass at one place begin here.
constexpr std::uint32_t kDraws = 1024;
/// So often the rows about a border that closes are mended.
constexpr std::uint32_t kClosings = 2;

/// The first of the candidates that is nearest.
TEXLOOM_WIDE_VECTORS Source nearestOf(const std::vector<Source>& candidates,
                                      const Neighbourhood& neighbourhood, const NeighbourhoodSet& set,
                                      const float* wanted) {
    Source best = candidates.front();
    float least = std::numeric_limits<float>::infinity();
    for (const Source& one : candidates) {
        const auto& pictures = set.exemplars()[one.exemplar].pictures;
        const float found = neighbourhood.distance(wanted, pictures, one.x, one.y, least);
        if (found < least) {
            least = found;
            best = one;
        }
    }
    return best;
}

/// Everything that a candidate is ever compared on lies within the exemplar.
NeighbourhoodSet candidatesOf(const PixelPyramid& pyramid, int side, const std::function<void()>& check) {
    std::vector<NeighbourhoodSource> sources;
    for (int e = 0; e < pyramid.exemplars(); ++e) {
        const Interleaved* pixels = &pyramid.pixels(0, e);
        const PatchSource& source = pyramid.level(0)[static_cast<std::size_t>(e)];
        sources.push_back({{pixels, pixels, pixels}, source.mask, source.weight});
    }
    return {Neighbourhood({{squareRuns(side), false, {}}}, {pyramid.pixels(0, 0).pixel}), std::move(sources),
            check};
}

} // namespace

Synthesizer::Synthesizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context), m_reach(settings.neighbourhood / 2),
      m_pyramid(request, 1, oddSide(settings.neighbourhood), [&context] { context.check(); }),
      m_set(candidatesOf(m_pyramid, oddSide(settings.neighbourhood), [&context] { context.check(); })),
      m_canvas(request.size, request.channels(), request.exemplarSizes()),
      m_causal(causalRuns(oddSide(settings.neighbourhood))),
      m_following(followingRuns(oddSide(settings.neighbourhood))),
      m_around(aroundRuns(oddSide(settings.neighbourhood))), m_targeted(m_following) {
    m_targeted.insert(m_targeted.begin(), PixelRun{0, 0, 1});
    if (const Image* const target = request.inputs.image(kTargetPort))
        m_target.emplace(request.size, request.channels()).load(*target, 0, 0, request.size);
}

Synthesis Synthesizer::run(ScanOrder::Order order) {
    m_context.stage(0.98, TR("Copying pixels one by one"));
    drawSources();
    const auto passes = static_cast<std::uint32_t>(m_settings.passes);
    const double share = 1.0 / m_settings.passes;
    const ScanOrder all(m_request.size, m_reach, m_request.wrap);
    for (std::uint32_t pass = 0; pass < passes; ++pass)
        scan({pass, false, pass * share, share}, all, order);
    if (m_request.wrap.y) {
        // Copies only grow downwards, so that those of the last rows end where the first rows begin, in a
        // straight line.
        const int height = m_request.size.height, rows = std::min(height, 4 * m_reach);
        const ScanOrder border(m_request.size, m_reach, m_request.wrap, {height - rows / 2, rows});
        for (std::uint32_t closing = 0; closing < kClosings; ++closing)
            scan({passes + closing, true, 1, 0}, border, order);
    }
    m_context.stage(0.02, TR("Copying pixels"));
    Synthesis result;
    result.map = std::move(m_canvas.map);
    result.image = copied(result.map, m_request, m_context);
    m_context.progress(1);
    result.mapKind = MapKind::Exact;
    return result;
}

void Synthesizer::drawSources() {
    m_context.parallel(0, m_canvas.size().height, [this](int y) {
        for (int x = 0; x < m_canvas.size().width; ++x) {
            const Source& source = m_set.drawn(m_context.random().uniform(x, y));
            m_canvas.put(x, y, source, m_pyramid.pixels(0, source.exemplar));
        }
    });
}

/// What is compared: the causal half with what is made; and the rest with the target, or, where there is none
/// and it was made by the pass before, with that.
Neighbourhood Synthesizer::compared(const Pass& pass, const PixelRuns& causal, const PixelRuns& following,
                                    const PixelRuns& targeted) const {
    std::vector<NeighbourhoodPart> parts{{causal, false, {}}};
    const bool seesAll = pass.closes || (pass.number > 0 && !m_target);
    parts.push_back({seesAll ? following : PixelRuns{}, false, {}});
    if (m_target)
        parts.push_back({targeted, false,
                         std::vector<float>(static_cast<std::size_t>(pixelCount(targeted)),
                                            static_cast<float>(m_settings.targetWeight))});
    return {parts, std::vector<int>(parts.size(), m_canvas.pixels.pixel)};
}

Neighbourhood Synthesizer::clipped(const Pass& pass, int x, int y) const {
    const auto seen = [&](const PixelRuns& runs) {
        return clippedRuns(runs, x, y, m_request.size, m_request.wrap);
    };
    return compared(pass, seen(m_causal), seen(m_following), seen(m_targeted));
}

bool Synthesizer::inside(int x, int y) const {
    const Size size = m_request.size;
    return (m_request.wrap.x || (x >= m_reach && x < size.width - m_reach)) &&
           (m_request.wrap.y || (y >= m_reach && y < size.height - m_reach));
}

/// The continuations of what surrounds the pixel: of its causal half in the first pass, of all in later ones,
/// since pieces that only grow rightwards and downwards would push out better ones that lie there already.
/// Those that the exemplar does not hold, or hides, are replaced by random pixels.
void Synthesizer::collect(const Pass& pass, int x, int y, Workspace& work) const {
    const Random& random = m_context.random();
    auto draw = kDraws * (pass.number + 1);
    coherentCandidates(m_canvas.map, pass.number > 0 ? m_around : m_causal, x, y, m_request.wrap,
                       work.coherent);
    work.candidates.clear();
    for (const Continuation& one : work.coherent)
        work.candidates.push_back(
            m_set.has(one.x, one.y, one.exemplar) ? one.source() : m_set.drawn(random.uniform(x, y, draw++)));
    if (work.candidates.empty())
        work.candidates.push_back(m_canvas.map.at(x, y));
    draw = kDraws * (pass.number + 2) - 2;
    if (m_settings.jump > 0 && random.uniform(x, y, draw) < m_settings.jump)
        work.candidates.push_back(m_set.drawn(random.uniform(x, y, draw + 1)));
}

void Synthesizer::scan(const Pass& pass, const ScanOrder& scan, ScanOrder::Order order) {
    const Neighbourhood whole = compared(pass, m_causal, m_following, m_targeted);
    const Interleaved* const pictures[] = {&m_canvas.pixels, &m_canvas.pixels,
                                           m_target ? &*m_target : &m_canvas.pixels};
    const auto body = [&](int y, int begin, int count) {
        const auto work = m_pool.borrow([] { return Workspace{}; });
        work->wanted.resize(static_cast<std::size_t>(whole.length()));
        for (int x = begin; x < begin + count; ++x) {
            collect(pass, x, y, *work);
            Source best = work->candidates.front();
            if (work->candidates.size() > 1) {
                const std::optional<Neighbourhood> cut =
                    inside(x, y) ? std::nullopt : std::optional(clipped(pass, x, y));
                const Neighbourhood& seen = cut ? *cut : whole;
                seen.gather(pictures, x, y, work->wanted.data());
                best = nearestOf(work->candidates, seen, m_set, work->wanted.data());
            }
            m_canvas.put(x, y, best, m_pyramid.pixels(0, best.exemplar));
        }
    };
    const auto between = [&](double done) {
        m_context.progress(pass.begun + pass.share * done);
        previewMap(m_canvas.map, m_pyramid.level(0), 0, m_request, m_context);
    };
    scan.run(m_context, body, between, order);
}

} // namespace texloom::ashikhmin
