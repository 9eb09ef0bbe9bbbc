#include "core/methods/patchmatch/synthesizer.h"

#include "core/base/text.h"
#include "core/image/half_scale.h"
#include "core/methods/patch_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texloom::patchmatch {

namespace {

/// The coarsest scale holds this many patches side by side at least.
constexpr int kPatchesAcross = 2;
/// Scales below the finest on which an initial image is matched.
constexpr int kInitialLevels = 2;
/// On the finest scales, the matches are nearly final: they need fewer rounds and only a local search.
constexpr int kFineRounds = 4;
constexpr int kFineRadius = 8;
constexpr int kPreviewSide = 640;
/// While patches still disagree, their mean would blur everything, so the best of them decide. Later, the
/// mean gives better joins.
constexpr VoteWeight kDecided{0.05F, 3}, kSettled{0.3F, 2}, kAgreed{1, 1};
/// Rows of the canvas that one thread votes on at a time.
constexpr int kBand = 16;

Size halfUp(Size size) {
    return {(size.width + 1) / 2, (size.height + 1) / 2};
}

} // namespace

Size Synthesizer::canvasFor(Size output, Wrap wrap, int patch) {
    return {wrap.x ? output.width : std::max(output.width, 4 * patch),
            wrap.y ? output.height : std::max(output.height, 4 * patch)};
}

int Synthesizer::levelsFor(const Request& request, const Settings& settings) {
    const int fitting = ExemplarPyramid::levelsFor(request.exemplarSizes(), kPatchesAcross * settings.patch);
    const int wanted = std::min(settings.scales, fitting);
    return request.initial() ? std::min(wanted, kInitialLevels) : wanted;
}

Synthesizer::Synthesizer(const Request& request, const Settings& settings, JobContext& context)
    : m_request(request), m_settings(settings), m_context(context),
      m_pyramid(patchSources(request), levelsFor(request, settings), settings.patch,
                [&context] { context.check(); }) {}

Size Synthesizer::canvas(int level) const {
    Size size = canvasFor(m_request.size, m_request.wrap, m_settings.patch);
    for (; level > 0; --level)
        size = halfUp(size);
    return size;
}

Synthesis Synthesizer::run() {
    double whole = 0;
    for (int level = 0; level < m_pyramid.levels(); ++level)
        whole += std::pow(0.4, level);
    for (int level = m_pyramid.levels() - 1; level >= 0; --level) {
        m_context.stage(0.98 * std::pow(0.4, level) / whole, message("Scale 1/{}", 1 << level));
        const PatchLattice lattice{canvas(level), m_settings.patch, kStride};
        GridMatcher matcher(m_pyramid.level(level), lattice, m_context);
        PatchField field(lattice.count());
        if (level + 1 < m_pyramid.levels()) {
            carryUp(level);
            adopt(matcher, field);
        } else {
            m_map = PositionMap(lattice.canvas, m_pyramid.sizes(level));
            startRandom(matcher, field);
        }
        refine(level, matcher, field);
    }
    m_context.stage(0.02, TR("Copying pixels"));
    m_map.shrink(m_request.size);
    Synthesis result;
    result.image = copied(m_map, m_request, m_context);
    m_context.progress(1);
    result.map = std::move(m_map);
    result.mapKind = MapKind::Exact;
    return result;
}

void Synthesizer::startRandom(GridMatcher& matcher, PatchField& field) {
    // Squares of one source each, so that the first patches hold some structure.
    const int square = m_settings.patch;
    for (int y = 0; y < m_map.height(); ++y)
        for (int x = 0; x < m_map.width(); ++x) {
            const Source corner = matcher.any(x / square, y / square);
            m_map.at(x, y) = {static_cast<std::uint16_t>(corner.x + x % square),
                              static_cast<std::uint16_t>(corner.y + y % square), corner.exemplar};
        }
    m_context.check();
    adopt(matcher, field);
    if (!m_request.initial())
        return;
    Image initial(*m_request.initial());
    for (int level = 1; level < m_pyramid.levels(); ++level)
        initial = halved(initial, [this] { m_context.check(); });
    startFrom(initial, matcher, field);
}

void Synthesizer::startFrom(const ImageView& image, GridMatcher& matcher, PatchField& field) {
    const auto pixels = [&image](int x, int y, Size extent, Interleaved& to) {
        to.load(image, x, y, extent);
    };
    for (int round = 0; round < 2 * m_settings.iterations; ++round)
        matcher.improve(field, pixels, round, image.size().longerSide() + (1 << 14));
    vote(matcher, field, kDecided);
}

/// Takes the matches of the lattice from the map: where the middle pixel of the patch came from.
void Synthesizer::adopt(const GridMatcher& matcher, PatchField& field) const {
    const int middle = m_settings.patch / 2;
    m_context.parallel(0, field.size().height, [&](int y) {
        for (int x = 0; x < field.size().width; ++x) {
            Source source =
                m_map.at((x * kStride + middle) % m_map.width(), (y * kStride + middle) % m_map.height());
            source.x = static_cast<std::uint16_t>(std::max(0, source.x - middle));
            source.y = static_cast<std::uint16_t>(std::max(0, source.y - middle));
            field.at(x, y).source = matcher.allowed(source, x, y);
        }
    });
}

void Synthesizer::refine(int level, GridMatcher& matcher, PatchField& field) {
    const bool first = level + 1 == m_pyramid.levels();
    const int rounds = first        ? 2 * m_settings.iterations
                       : level == 0 ? std::min(kFineRounds, m_settings.iterations)
                                    : m_settings.iterations;
    const int radius = level == 0 && !first ? kFineRadius : 1 << 16;
    const auto pixels = [&](int x, int y, Size extent, Interleaved& to) {
        gather(matcher, x, y, extent, to);
    };
    for (int round = 0; round < rounds; ++round) {
        matcher.improve(field, pixels, 2 * round, radius);
        if (level > 1 || first)
            matcher.improve(field, pixels, 2 * round + 1, radius);
        const bool late = 2 * round >= rounds;
        vote(matcher, field, level == 0 || (late && !first) ? kAgreed : late || !first ? kSettled : kDecided);
        matcher.discourage(field, m_settings.uniformity);
        m_context.curve(TR("Mean distance of the patches"), field.meanDistance());
        offer(level);
        m_context.progress((round + 1.0) / rounds);
    }
}

void Synthesizer::gather(const GridMatcher& matcher, int x, int y, Size extent, Interleaved& to) const {
    const int pixel = to.pixel;
    for (int row = 0; row < extent.height; ++row) {
        float* at = to.data.data() + row * to.stride();
        const int fromY = (y + row) % m_map.height();
        for (int column = 0; column < extent.width; ++column, at += pixel) {
            const Source& source = m_map.at((x + column) % m_map.width(), fromY);
            std::copy_n(matcher.target(source.exemplar).pixels().at(source.x, source.y), pixel, at);
        }
    }
}

void Synthesizer::vote(const GridMatcher& matcher, const PatchField& field, const VoteWeight& weight) {
    PatchProposals proposals{{}, matcher.lattice(), &field, {}, {}, {}, {}, 1, nullptr};
    for (int e = 0; e < matcher.exemplars(); ++e)
        proposals.images.push_back(&matcher.target(e).pixels());
    const Size count = field.size();
    proposals.weights.resize(static_cast<std::size_t>(count.area()));
    const auto unit = static_cast<float>(1 / std::max(field.meanDistance(), 1e-12));
    m_context.parallel(0, count.height, [&](int y) {
        float* to = proposals.weights.data() + static_cast<std::ptrdiff_t>(y) * count.width;
        for (int x = 0; x < count.width; ++x)
            to[x] = weight.of(unit * field.at(x, y).distance);
    });
    struct Row {
        ProposalRow proposals;
        std::vector<float> pixels;
    };
    Pool<Row> rows;
    const int height = m_map.height();
    m_context.parallel(0, (height + kBand - 1) / kBand, [&](int band) {
        const auto row = rows.borrow([&] {
            const int floats = m_map.width() * proposals.images.front()->pixel;
            return Row{ProposalRow(proposals), std::vector<float>(static_cast<std::size_t>(floats))};
        });
        for (int y = band * kBand; y < std::min(height, (band + 1) * kBand); ++y) {
            row->proposals.mean(y, row->pixels.data());
            row->proposals.nearest(y, row->pixels.data(), &m_map.at(0, y));
        }
    });
}

/// The map in the pixels of the next finer scale, `level`.
void Synthesizer::carryUp(int level) {
    const PositionMap coarse = std::move(m_map);
    m_map = PositionMap(canvas(level), m_pyramid.sizes(level));
    m_context.parallel(0, m_map.height(), [&](int y) {
        for (int x = 0; x < m_map.width(); ++x) {
            const Source& source = coarse.at(x / 2, y / 2);
            m_map.at(x, y) = {static_cast<std::uint16_t>(2 * source.x + x % 2),
                              static_cast<std::uint16_t>(2 * source.y + y % 2), source.exemplar};
        }
    });
}

/// Makes a preview of the map, if one is wanted.
void Synthesizer::offer(int level) {
    if (!m_context.previewDue())
        return;
    const int step = (m_map.size().longerSide() + kPreviewSide - 1) / kPreviewSide;
    const Size size{(m_map.width() + step - 1) / step, (m_map.height() + step - 1) / step};
    PositionMap sources(size, m_pyramid.sizes(level)), full(size, m_request.exemplarSizes());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Source& source = m_map.at(x * step, y * step);
            sources.at(x, y) = source;
            full.at(x, y) = {static_cast<std::uint16_t>(source.x << level),
                             static_cast<std::uint16_t>(source.y << level), source.exemplar};
        }
    std::vector<ImageView> images;
    for (const PatchSource& source : m_pyramid.level(level))
        images.push_back(source.image);
    m_context.preview(sources.apply(images), &full);
}

} // namespace texloom::patchmatch
