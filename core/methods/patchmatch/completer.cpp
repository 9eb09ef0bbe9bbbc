#include "core/methods/patchmatch/completer.h"

#include "core/base/text.h"
#include "core/image/mirror.h"
#include "core/methods/fill_join.h"
#include "core/methods/fill_tone.h"
#include "core/methods/patch_request.h"
#include "core/methods/patchmatch/synthesizer.h"
#include "core/methods/pixel_grower.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace texloom::patchmatch {

namespace {

/// What is made counts less by this factor for each pixel away from what is known (Wexler et al.,
/// section 3.2).
constexpr float kTrust = 1.3F;
/// While patches still disagree the best of them decide; later their mean gives better joins.
constexpr VoteWeight kEarly{0.02F, 4}, kLate{0.05F, 3};
constexpr int kRandomReach = 1 << 16;

} // namespace

Completer::Completer(const FillWindow& window, int patch, const Settings& settings, JobContext& context)
    : m_window(window), m_request(window.request()), m_settings(settings), m_context(context), m_patch(patch),
      m_pyramid(patchSources(m_request), settings.scales, m_patch, [&context] { context.check(); }),
      m_scales(fillScales(m_request, m_patch, m_pyramid.levels(), [&context] { context.check(); })),
      m_pixels({1, 1}, m_request.channels()) {}

int Completer::patchFor(const Request& request, const Settings& settings) {
    const int larger = settings.patch * 3 / 2 | 1;
    int shortest = request.size.shorterSide();
    for (const Size& size : request.exemplarSizes())
        shortest = std::min(shortest, size.shorterSide());
    return larger <= shortest && leavesWholePatch(withoutHole(request, settings.context, larger), larger)
               ? larger
               : settings.patch;
}

Synthesis Completer::run() {
    const int coarsest = static_cast<int>(m_scales.size()) - 1;
    grow();
    double whole = 0;
    for (int level = 0; level <= coarsest; ++level)
        whole += std::pow(0.3, level);
    for (int level = coarsest; level >= 0; --level) {
        m_context.stage((m_settings.seams ? 0.7 : 0.8) * std::pow(0.3, level) / whole,
                        message("Scale 1/{}", 1 << level));
        enter(level);
        offer(level);
        refine(level);
        if (m_settings.seams && level > 0)
            joinScale(level);
    }
    if (m_settings.seams)
        join();
    return finish();
}

/// Grows the coarsest scale pixel by pixel.
void Completer::grow() {
    const int level = static_cast<int>(m_scales.size()) - 1;
    const FillScale& scale = m_scales.back();
    const Request request = requestAt(m_request, m_pyramid, level, scale);
    pixel_growth::Settings settings;
    settings.search = pixel_growth::Search::Exact;
    settings.radius = m_settings.radius >> level;
    // Twice the patch as near as it fits: what grows has nothing but its surroundings to go by.
    settings.window = oddSide(2 * m_patch);
    for (const Exemplar& exemplar : request.exemplars)
        settings.window = std::min(settings.window, (exemplar.image->size().shorterSide() - 1) | 1);
    while (settings.window > 3 && !leavesWholePatch(request, settings.window))
        settings.window -= 2;
    pixel_growth::Start start{&scale.picture, &scale.known};
    start.offer = [](const PositionMap&) {};
    m_map = pixel_growth::Grower(request, settings, start, m_context).run(0.1).map;
}

/// Moves the seams of a coarser scale: what lies along the border is looked for in squares that show more
/// there.
void Completer::joinScale(int level) {
    const Request request = requestAt(m_request, m_pyramid, level, m_scales[static_cast<std::size_t>(level)]);
    const int radius = m_settings.radius > 0 ? std::max(1, m_settings.radius >> level) : 0;
    joinCopies(request, kCoarseJoinSide, radius, m_map, m_context);
}

/// Takes the map to a scale: as it is on the coarsest, else in the pixels of the next finer one.
void Completer::enter(int level) {
    const FillScale& scale = m_scales[static_cast<std::size_t>(level)];
    const auto check = [this] { m_context.check(); };
    m_known = &scale.known;
    m_pixels = Interleaved(scale.size(), m_request.channels());
    m_pixels.load(scale.picture, 0, 0, scale.size());
    m_trust.clear();
    for (const int depth : depths(scale.known, check))
        m_trust.push_back(std::pow(kTrust, -static_cast<float>(std::min(depth, 200))));
    if (m_map.size() != scale.size())
        m_map = finer(m_map, scale.known, m_pyramid.sizes(level), check);
    for (int y = 0; y < m_map.height(); ++y) {
        m_context.check();
        for (int x = 0; x < m_map.width(); ++x) {
            if (!made(x, y))
                continue;
            const Source& source = m_map.at(x, y);
            const ImageView& image = m_pyramid.level(level)[source.exemplar].image;
            float* const to = m_pixels.data.data() + y * m_pixels.stride() + x * m_pixels.pixel;
            for (int c = 0; c < image.channels; ++c)
                to[c] = image(source.x, source.y, c);
        }
    }
}

void Completer::refine(int level) {
    const FillScale& scale = m_scales[static_cast<std::size_t>(level)];
    const std::vector<std::uint8_t> flags = wanted(scale);
    const PatchLattice lattice{scale.size(), m_patch, 1};
    GridMatcher matcher(m_pyramid.level(level), lattice, m_context);
    matcher.limit({&flags, m_settings.radius >> level});
    PatchField field(lattice.count());
    adopt(matcher, flags, field);
    const auto pixels = [this](int x, int y, Size extent, Interleaved& to) { gather(x, y, extent, to); };
    for (int round = 0; round < m_settings.iterations; ++round) {
        matcher.improve(field, pixels, 2 * round, kRandomReach);
        matcher.improve(field, pixels, 2 * round + 1, kRandomReach);
        vote(matcher, flags, field, 2 * round >= m_settings.iterations);
        offer(level);
        m_context.progress((round + 1.0) / m_settings.iterations);
    }
}

/// Which patches, by their top left, show something that is made, and lie in the picture.
std::vector<std::uint8_t> Completer::wanted(const FillScale& scale) const {
    const Size size = scale.size();
    const int patch = m_patch;
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(size.area()), 0), flags = rows;
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    };
    for (int y = 0; y < size.height; ++y) {
        m_context.check();
        for (int x = 0; x < size.width; ++x)
            if (made(x, y))
                for (int i = 0; i < patch; ++i)
                    if (x >= i || m_request.wrap.x)
                        rows[index(repeated(x - i, size.width), y)] = 1;
    }
    const int right = m_request.wrap.x ? size.width : size.width - patch + 1;
    const int bottom = m_request.wrap.y ? size.height : size.height - patch + 1;
    for (int y = 0; y < size.height; ++y) {
        m_context.check();
        for (int x = 0; x < right; ++x)
            if (rows[index(x, y)] != 0)
                for (int j = 0; j < patch; ++j)
                    if (const int top = repeated(y - j, size.height);
                        (y >= j || m_request.wrap.y) && top < bottom)
                        flags[index(x, top)] = 1;
    }
    return flags;
}

/// A pixel on the axes that wrap. @return whether it lies in the picture.
bool Completer::place(int& x, int& y) const {
    const Size size = m_map.size();
    if (m_request.wrap.x)
        x = repeated(x, size.width);
    if (m_request.wrap.y)
        y = repeated(y, size.height);
    return x >= 0 && y >= 0 && x < size.width && y < size.height;
}

/// What the map makes of the patch with this top left: the source of its made pixel nearest to the middle.
Source Completer::match(const GridMatcher& matcher, int x, int y) const {
    const int middle = m_patch / 2;
    int nearest = std::numeric_limits<int>::max();
    Source found;
    for (int j = 0; j < m_patch; ++j)
        for (int i = 0; i < m_patch; ++i) {
            int u = x + i, v = y + j;
            const int apart = (i - middle) * (i - middle) + (j - middle) * (j - middle);
            if (apart >= nearest || !place(u, v) || !made(u, v))
                continue;
            const Source& source = m_map.at(u, v);
            const int left = source.x - i, top = source.y - j;
            if (!matcher.target(source.exemplar).has(left, top))
                continue;
            nearest = apart;
            found = {static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(top), source.exemplar};
        }
    return found.valid() ? found : matcher.any(x, y);
}

void Completer::adopt(const GridMatcher& matcher, const std::vector<std::uint8_t>& flags,
                      PatchField& field) const {
    const int width = field.size().width;
    m_context.parallel(0, field.size().height, [&](int y) {
        for (int x = 0; x < width; ++x)
            if (flags[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)] != 0)
                field.at(x, y).source = match(matcher, x, y);
    });
}

void Completer::gather(int x, int y, Size extent, Interleaved& to) const {
    const Size size = m_pixels.size;
    for (int row = 0; row < extent.height; ++row) {
        float* at = to.data.data() + row * to.stride();
        const int fromY = (y + row) % size.height;
        for (int column = 0; column < extent.width; ++column, at += to.pixel)
            std::copy_n(m_pixels.at((x + column) % size.width, fromY), to.pixel, at);
    }
}

/// Every made pixel becomes the one, of those that its patches propose, that is nearest to their weighted
/// mean.
void Completer::vote(const GridMatcher& matcher, const std::vector<std::uint8_t>& flags,
                     const PatchField& field, bool late) {
    const Size size = field.size();
    const int patch = m_patch, middle = patch / 2, pixel = m_pixels.pixel;
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
               static_cast<std::size_t>(x);
    };
    double sum = 0, patches = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            if (flags[index(x, y)] != 0) {
                sum += static_cast<double>(field.at(x, y).distance);
                ++patches;
            }
    const auto unit = static_cast<float>(patches / std::max(sum, 1e-12));
    m_context.curve(TR("Mean distance of the patches"), patches > 0 ? sum / patches : 0);
    const VoteWeight& weights = late ? kLate : kEarly;
    /// Calls visit(source, weight) for what each patch over a pixel proposes.
    const auto everyProposal = [&](int x, int y, const auto& visit) {
        for (int j = 0; j < patch; ++j)
            for (int i = 0; i < patch; ++i) {
                int left = x - i, top = y - j, u = left + middle, v = top + middle;
                if (!place(left, top) || flags[index(left, top)] == 0 || !place(u, v))
                    continue;
                const PatchMatch& one = field.at(left, top);
                visit(Source{static_cast<std::uint16_t>(one.source.x + i),
                             static_cast<std::uint16_t>(one.source.y + j), one.source.exemplar},
                      weights.of(unit * one.distance) * m_trust[index(u, v)]);
            }
    };
    const auto pixelOf = [&](const Source& source) {
        return matcher.target(source.exemplar).pixels().at(source.x, source.y);
    };
    m_context.parallel(0, size.height, [&](int y) {
        std::vector<float> mean(static_cast<std::size_t>(pixel));
        for (int x = 0; x < size.width; ++x) {
            if (!made(x, y))
                continue;
            std::fill(mean.begin(), mean.end(), 0.0F);
            float whole = 0;
            everyProposal(x, y, [&](const Source& source, float weight) {
                for (std::size_t c = 0; c < mean.size(); ++c)
                    mean[c] += weight * pixelOf(source)[c];
                whole += weight;
            });
            float least = std::numeric_limits<float>::infinity();
            everyProposal(x, y, [&](const Source& source, float) {
                float distance = 0;
                for (std::size_t c = 0; c < mean.size(); ++c) {
                    const float difference = pixelOf(source)[c] - mean[c] / whole;
                    distance += difference * difference;
                }
                if (distance < least) {
                    least = distance;
                    m_map.at(x, y) = source;
                }
            });
            std::copy_n(pixelOf(m_map.at(x, y)), pixel,
                        m_pixels.data.data() + y * m_pixels.stride() + x * pixel);
        }
    });
}

std::uint64_t Completer::bytesFor(const Request& request, const Settings& settings, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const int channels = request.channels();
    const auto area = static_cast<std::uint64_t>(request.size.area());
    // Pictures and masks of all scales, and of the one whose seams are moved; pixels, maps, matches, flags
    // and trust of the finest two.
    const std::uint64_t scales = Image::bytesFor(request.size, channels + 1) * 2;
    const std::uint64_t present =
        Interleaved::bytesFor(request.size, channels) + 3 * PositionMap::bytesFor(request.size) +
        PatchField::bytesFor(request.size) + area * (2 * sizeof(std::uint8_t) + sizeof(float) + sizeof(int));
    return scales + present * 5 / 4 + 2 * Image::bytesFor(request.size, channels) +
           2 * ExemplarPyramid::bytesFor(exemplars, channels) + FillWindow::bytesFor(request) +
           joinBytes(request, threads) + (settings.tone ? toneBytes(request) : 0) +
           GridMatcher::bytesFor(exemplars, channels, patchFor(request, settings), 1, threads) +
           fillMaskBytes(request) + (24U << 20U);
}

} // namespace texloom::patchmatch
