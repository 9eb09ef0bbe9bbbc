#include "core/methods/pixel_grower.h"

#include "core/base/text.h"
#include "core/match/coherent_candidates.h"
#include "core/methods/fill_request.h"
#include "core/methods/patch_request.h"
#include "core/methods/pixel_request.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace texloom::pixel_growth {

namespace {

/// Windows that are compared exactly where the tree names the likely ones (Aguerrebere et al., IPOL 2013), in
/// so many rounds.
constexpr std::size_t kLikely = 200;
constexpr std::size_t kTreeRounds = 2;
/// How far beside likely windows others are looked at, in pixels, where there is a guess.
constexpr int kNear = 1;
/// Pixels that one thread makes at a time; fewer are not worth a second thread.
constexpr int kShare = 4;
/// Draws at one place, beside that of its candidate.
constexpr std::uint32_t kTie = 1, kSeed = 2;

} // namespace

int Grower::window(const Settings& settings) {
    return oddSide(settings.window);
}

NeighbourhoodTree::Options Grower::treeOptions(const Settings& settings) {
    NeighbourhoodTree::Options options;
    options.axes = settings.components;
    options.variance = 1;
    return options;
}

Grower::Grower(const Request& request, const Settings& settings, const Start& start, JobContext& context)
    : m_request(request), m_settings(settings), m_start(start), m_context(context),
      m_scan(patchSources(request), window(settings), settings.sigma * window(settings),
             [&context] { context.check(); }),
      m_canvas(request.size, request.channels(), request.exemplarSizes()), m_known(request.size) {}

Synthesis Grower::run(double weight) {
    m_context.stage(0.02 * weight, TR("Preparing the exemplar"));
    if (m_settings.search == Search::Pca)
        m_tree = std::make_unique<NeighbourhoodTree>(m_scan.windows(), treeOptions(m_settings), m_context);
    m_turn.assign(m_known.flags.size(), 0);
    m_context.stage(0.96 * weight, TR("Growing pixels"));
    begin();
    if (m_settings.order == Order::Onion)
        growLayers();
    else
        growRows();
    m_context.stage(0.02 * weight, TR("Copying pixels"));
    return finish();
}

void Grower::begin() {
    if (m_start.known)
        keep();
    if (m_made == 0)
        placeSeed();
    if (m_start.guess)
        guess();
    m_wanted = m_request.size.area() - m_made;
    m_made = 0;
}

/// Takes over what is known of the initial image.
void Grower::keep() {
    KnownPicture picture(*m_start.image, *m_start.known, m_request, m_context);
    m_canvas.pixels = m_scan.turned(picture.image, [this] { m_context.check(); });
    m_canvas.map = std::move(picture.map);
    m_known.flags = std::move(picture.known);
    m_made = m_request.size.area() - picture.wanted;
}

/// Copies what is guessed of the rest.
void Grower::guess() {
    for (int y = 0; y < m_request.size.height; ++y) {
        m_context.check();
        for (int x = 0; x < m_request.size.width; ++x) {
            const Source& source = m_start.guess->at(x, y);
            std::uint8_t& flag = m_known.at(x, y);
            if (flag == KnownPixels::kMade || !source.valid())
                continue;
            m_canvas.put(x, y, source, m_scan.pixels(source.exemplar));
            flag = KnownPixels::kGuessed;
        }
    }
}

/// Copies a square about a random window's middle to the middle of the output, or, where it grows by rows,
/// to its beginning; where there is a guess, what is guessed thereabouts.
void Grower::placeSeed() {
    const Size size = m_request.size;
    const int side = std::min(m_settings.seedSize, window(m_settings)), reach = side / 2;
    const bool rows = m_settings.order == Order::Raster;
    int left = rows ? 0 : std::max(0, (size.width - side) / 2);
    int top = rows ? 0 : std::max(0, (size.height - side) / 2);
    Source middle = m_scan.windows().drawn(m_context.random().uniform(0, 0, kSeed));
    if (const auto place = guessedNear(left + reach, top + reach, reach)) {
        middle = m_start.guess->at(x(*place), y(*place));
        left = x(*place) - reach;
        top = y(*place) - reach;
    }
    for (int y = 0; y < std::min(side, size.height - top); ++y)
        for (int x = 0; x < std::min(side, size.width - left); ++x) {
            const Continuation source(middle, x - reach, y - reach);
            m_canvas.put(left + x, top + y, source.source(), m_scan.pixels(middle.exemplar));
            m_known.at(left + x, top + y) = 1;
            ++m_made;
        }
}

/// The place nearest to one, at least `reach` from the top and the left, whose guess is a window's middle.
std::optional<Grower::Place> Grower::guessedNear(int x, int y, int reach) const {
    std::optional<Place> nearest;
    if (!m_start.guess)
        return nearest;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    const Size size = m_request.size;
    for (int v = reach; v < size.height; ++v)
        for (int u = reach; u < size.width; ++u) {
            const Source& guess = m_start.guess->at(u, v);
            const std::int64_t dx = u - x, dy = v - y, apart = dx * dx + dy * dy;
            if (apart < least && guess.valid() && m_scan.windows().has(guess.x, guess.y, guess.exemplar)) {
                least = apart;
                nearest = static_cast<Place>(v) * size.width + u;
            }
        }
    return nearest;
}

bool Grower::neighbour(int x, int y, int dx, int dy, Place& found) const {
    const Size size = m_request.size;
    int column = x + dx, row = y + dy;
    if (column < 0 || column >= size.width) {
        if (!m_request.wrap.x)
            return false;
        column = (column % size.width + size.width) % size.width;
    }
    if (row < 0 || row >= size.height) {
        if (!m_request.wrap.y)
            return false;
        row = (row % size.height + size.height) % size.height;
    }
    found = static_cast<Place>(row) * size.width + column;
    return true;
}

/// The unknown pixels that touch one of these, each once.
Grower::Places Grower::unknownBeside(const Places& made) {
    Places beside;
    for (const Place place : made)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                Place near = 0;
                if (!neighbour(x(place), y(place), dx, dy, near))
                    continue;
                const auto at = static_cast<std::size_t>(near);
                if (m_known.flags[at] == KnownPixels::kMade || m_turn[at] != 0)
                    continue;
                m_turn[at] = 1;
                beside.push_back(near);
            }
    for (const Place place : beside)
        m_turn[static_cast<std::size_t>(place)] = 0;
    return beside;
}

int Grower::knownAround(Place place) const {
    const int reach = m_scan.window() / 2;
    int count = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            Place near = 0;
            if (neighbour(x(place), y(place), dx, dy, near))
                count += m_known.flags[static_cast<std::size_t>(near)] == KnownPixels::kMade ? 1 : 0;
        }
    return count;
}

/// Those with the most known pixels in their windows first; a random number of the place settles ties.
void Grower::sortByKnown(Places& layer) const {
    std::vector<std::tuple<int, std::uint32_t, Place>> keys(layer.size());
    inShares(layer.size(), [&](std::size_t i) {
        const Place place = layer[i];
        keys[i] = {-knownAround(place), m_context.random().bits(x(place), y(place), kTie), place};
    });
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < layer.size(); ++i)
        layer[i] = std::get<2>(keys[i]);
}

/// Calls work(i) for all i below a count, some hundreds of them at a time in parallel.
void Grower::inShares(std::size_t count, const std::function<void(std::size_t)>& work) const {
    constexpr std::size_t kAtOnce = 256;
    m_context.parallel(0, static_cast<int>((count + kAtOnce - 1) / kAtOnce), [&](int share) {
        m_context.check();
        const std::size_t begin = static_cast<std::size_t>(share) * kAtOnce;
        for (std::size_t i = begin; i < std::min(count, begin + kAtOnce); ++i)
            work(i);
    });
}

/// Divides an order into turns: a pixel comes in the turn after the last of those that its window shows and
/// that come before it. So those of one turn do not see each other.
std::vector<Grower::Places> Grower::inTurns(const Places& order) {
    const int reach = m_scan.window() / 2;
    std::vector<Places> turns;
    std::size_t looked = 0;
    for (const Place place : order) {
        if (++looked % 1024 == 0)
            m_context.check();
        std::int32_t last = 0;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                Place near = 0;
                if (neighbour(x(place), y(place), dx, dy, near))
                    last = std::max(last, m_turn[static_cast<std::size_t>(near)]);
            }
        m_turn[static_cast<std::size_t>(place)] = last + 1;
        if (turns.size() <= static_cast<std::size_t>(last))
            turns.emplace_back();
        turns[static_cast<std::size_t>(last)].push_back(place);
    }
    for (const Place place : order)
        m_turn[static_cast<std::size_t>(place)] = 0;
    return turns;
}

/// For each pixel of an order the earlier ones that its window shows.
std::vector<std::vector<int>> Grower::shownBefore(const Places& order) {
    const int reach = m_scan.window() / 2;
    std::vector<std::vector<int>> before(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        m_turn[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i) + 1;
    inShares(order.size(), [&](std::size_t i) {
        std::vector<int>& earlier = before[i];
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                Place near = 0;
                if (!neighbour(x(order[i]), y(order[i]), dx, dy, near))
                    continue;
                const std::int32_t turn = m_turn[static_cast<std::size_t>(near)];
                if (turn > 0 && turn <= static_cast<std::int32_t>(i))
                    earlier.push_back(turn - 1);
            }
        // Round the borders of a small output, a window may show a pixel twice.
        std::sort(earlier.begin(), earlier.end());
        earlier.erase(std::unique(earlier.begin(), earlier.end()), earlier.end());
    });
    for (const Place place : order)
        m_turn[static_cast<std::size_t>(place)] = 0;
    return before;
}

/// Each pixel as soon as those are made that it shows, so that threads wait for each other only here and
/// there.
void Grower::makeLayer(const Places& layer) {
    const std::vector<std::vector<int>> before = shownBefore(layer);
    m_context.parallelAfter(
        static_cast<int>(layer.size()), [&](int index) { return before[static_cast<std::size_t>(index)]; },
        [&](int index) {
            const auto work = m_pool.borrow([] { return Workspace{}; });
            makePixel(layer[static_cast<std::size_t>(index)], *work);
        },
        [&](int done) { show(m_made + done); });
    m_made += static_cast<std::int64_t>(layer.size());
}

/// Tells how much is made, and offers it to be looked at.
void Grower::show(std::int64_t made) {
    m_context.progress(static_cast<double>(made) / static_cast<double>(m_wanted));
    if (m_start.offer)
        m_start.offer(m_canvas.map);
    else if (!m_start.image)
        previewMap(m_canvas.map, patchSources(m_request), 0, m_request, m_context);
    else if (m_context.previewDue())
        m_context.preview(shown());
}

void Grower::growLayers() {
    Places made;
    for (Place place = 0; place < m_request.size.area(); ++place)
        if (m_known.flags[static_cast<std::size_t>(place)] == KnownPixels::kMade)
            made.push_back(place);
    for (;;) {
        m_context.check();
        Places layer = unknownBeside(made);
        if (layer.empty())
            return;
        sortByKnown(layer);
        makeLayer(layer);
        made = std::move(layer);
    }
}

void Grower::growRows() {
    Places order;
    for (Place place = 0; place < m_request.size.area(); ++place)
        if (m_known.flags[static_cast<std::size_t>(place)] != KnownPixels::kMade)
            order.push_back(place);
    make(inTurns(order));
}

void Grower::make(const std::vector<Places>& turns) {
    const auto makeSome = [&](const Places& turn, std::size_t begin, std::size_t end) {
        const auto work = m_pool.borrow([] { return Workspace{}; });
        for (std::size_t i = begin; i < end; ++i) {
            m_context.check();
            makePixel(turn[i], *work);
        }
    };
    for (const Places& turn : turns) {
        const int shares = static_cast<int>(turn.size() + kShare - 1) / kShare;
        if (shares == 1 || m_context.threads() == 1)
            makeSome(turn, 0, turn.size());
        else
            m_context.parallel(0, shares, [&](int share) {
                const auto begin = static_cast<std::size_t>(share) * kShare;
                makeSome(turn, begin, std::min(turn.size(), begin + kShare));
            });
        m_made += static_cast<std::int64_t>(turn.size());
        show(m_made);
    }
}

void Grower::makePixel(Place place, Workspace& work) {
    const Source source = choose(x(place), y(place), work);
    m_canvas.put(x(place), y(place), source, m_scan.pixels(source.exemplar));
    m_known.flags[static_cast<std::size_t>(place)] = KnownPixels::kMade;
}

/// What continues the copies around is likely to fit; with the tree, what it finds too.
void Grower::findLikely(int x, int y, Workspace& work) const {
    static const PixelRuns around = aroundRuns(3);
    coherentCandidates(m_canvas.map, around, x, y, m_request.wrap, work.coherent);
    work.likely.clear();
    if (const Source& own = m_canvas.map.at(x, y);
        own.valid() && m_scan.windows().has(own.x, own.y, own.exemplar))
        work.likely.push_back(own); // what is guessed
    for (const Continuation& one : work.coherent)
        if (m_scan.windows().has(one.x, one.y, one.exemplar))
            work.likely.push_back(one.source());
    if (m_tree)
        findInTree(x, y, work);
    else if (searchesNear())
        findNear(work);
}

/// Windows beside those that are likely: a guess is known to two pixels of its scale.
void Grower::findNear(Workspace& work) const {
    const std::size_t count = work.likely.size();
    for (std::size_t i = 0; i < count; ++i)
        for (int dy = -kNear; dy <= kNear; ++dy)
            for (int dx = -kNear; dx <= kNear; ++dx) {
                const Continuation one(work.likely[i], dx, dy);
                if (m_scan.windows().has(one.x, one.y, one.exemplar))
                    work.likely.push_back(one.source());
            }
    std::sort(work.likely.begin(), work.likely.end(), [](const Source& a, const Source& b) {
        return std::tuple(a.exemplar, a.y, a.x) < std::tuple(b.exemplar, b.y, b.x);
    });
    work.likely.erase(std::unique(work.likely.begin(), work.likely.end()), work.likely.end());
}

/// The tree compares whole windows. What is not known of this one is taken from the best window found so far:
/// a mean in its place would find windows that are flat there, from which flat areas grow.
void Grower::findInTree(int x, int y, Workspace& work) const {
    const std::size_t coherent = work.likely.size();
    work.leaves.clear();
    for (std::size_t round = 1; round <= kTreeRounds; ++round) {
        const Source best = work.likely.empty() ? Source{} : m_scan.nearestOf(work.likely, work.query);
        m_scan.complete(m_canvas, m_known, x, y, m_request.wrap, best, work.vector);
        NeighbourhoodTree::Lookup lookup(*m_tree, work.vector.data());
        while (work.likely.size() < coherent + kLikely * round / kTreeRounds) {
            const std::span<const Source> leaf = lookup.next();
            if (leaf.empty())
                break;
            if (std::find(work.leaves.begin(), work.leaves.end(), leaf.data()) != work.leaves.end())
                continue;
            work.leaves.push_back(leaf.data());
            for (const Source& source : leaf)
                if (std::find(work.likely.begin(),
                              work.likely.begin() + static_cast<std::ptrdiff_t>(coherent),
                              source) == work.likely.begin() + static_cast<std::ptrdiff_t>(coherent))
                    work.likely.push_back(source);
        }
    }
}

Source Grower::choose(int x, int y, Workspace& work) const {
    m_scan.look(m_canvas, m_known, x, y, m_request.wrap, work.query);
    if (work.query.blank())
        return m_scan.windows().drawn(m_context.random().uniform(x, y));
    findLikely(x, y, work);
    const WindowScan::Nearby nearby{m_request.size, x, y, m_settings.radius};
    if (m_tree || (searchesNear() && !work.likely.empty())) {
        const auto far = [&](const Source& one) { return !m_scan.lies(one, nearby); };
        if (!std::all_of(work.likely.begin(), work.likely.end(), far))
            std::erase_if(work.likely, far);
        m_scan.withinOf(work.likely, m_settings.tolerance, work.query, work.found);
    } else
        m_scan.within(m_settings.tolerance, nearby, work.likely, work.query, work.found,
                      [this] { m_context.check(); });
    return draw(work.found, x, y);
}

/// One of the candidates, each as likely as its exemplar weighs.
Source Grower::draw(const std::vector<WindowScan::Found>& found, int x, int y) const {
    const auto weight = [&](const WindowScan::Found& one) {
        return m_request.exemplars[one.source.exemplar].weight;
    };
    double whole = 0;
    for (const WindowScan::Found& one : found)
        whole += weight(one);
    double left = m_context.random().uniform(x, y) * whole;
    for (const WindowScan::Found& one : found)
        if ((left -= weight(one)) < 0)
            return one.source;
    return found.back().source;
}

/// The initial image with what was made.
Image Grower::shown() const {
    Image image = *m_start.image;
    m_context.parallel(0, image.height(), [&](int y) {
        for (int x = 0; x < image.width(); ++x) {
            const Source& source = m_canvas.map.at(x, y);
            for (int c = 0; source.valid() && c < image.channels(); ++c)
                image(x, y, c) = (*m_request.exemplars[source.exemplar].image)(source.x, source.y, c);
        }
    });
    return image;
}

Synthesis Grower::finish() {
    Synthesis result;
    result.image = m_start.image ? shown() : copied(m_canvas.map, m_request, m_context);
    result.mapKind = m_start.image ? filledMapKind(m_canvas.map) : MapKind::Exact;
    result.map = std::move(m_canvas.map);
    m_context.progress(1);
    return result;
}

std::uint64_t Grower::bytesFor(const Request& request, const Settings& settings, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    const auto area = static_cast<std::uint64_t>(request.size.area());
    std::uint64_t windows = 0;
    for (const Size& size : exemplars)
        windows += static_cast<std::uint64_t>(size.area());
    // Known pixels and turns; by rows, the order and its turns too, in lists that grow.
    const std::uint64_t places = settings.order == Order::Raster ? 4 * sizeof(Place) : 0;
    const auto window = static_cast<std::uint64_t>(Grower::window(settings));
    // What each pixel of a layer waits for, in lists that grow.
    const std::uint64_t layer = static_cast<std::uint64_t>(request.size.width + request.size.height) * 4;
    const std::uint64_t waits = layer * (2 * sizeof(std::vector<int>) + 8 * window * sizeof(int));
    std::uint64_t bytes = waits + PixelCanvas::bytesFor(request.size, request.channels()) +
                          Image::bytesFor(request.size, request.channels()) + area * (5 + places) +
                          WindowScan::bytesFor(exemplars, request.channels()) + (8U << 20U) +
                          static_cast<std::uint64_t>(threads) *
                              (window * window * static_cast<std::uint64_t>(request.channels()) * 64 +
                               3 * windows * sizeof(WindowScan::Found));
    if (settings.search == Search::Pca)
        bytes += NeighbourhoodTree::bytesFor(exemplars, treeOptions(settings));
    return bytes;
}

} // namespace texloom::pixel_growth
