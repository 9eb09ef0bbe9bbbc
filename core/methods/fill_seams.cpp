#include "core/methods/fill_seams.h"

#include "core/image/mirror.h"
#include "core/match/interleaved.h"
#include "core/math/grid_flow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace texloom {

namespace {

/// The cost of a difference over the whole range in every channel.
constexpr float kSeamUnit = 1e5F;
/// Rounds end where seams get cheaper by less than this share.
constexpr double kLeastGain = 0.01;

struct Step {
    int dx, dy;
    GridFlow::Side side;
};
constexpr std::array<Step, 4> kSteps{Step{1, 0, GridFlow::Right}, Step{0, 1, GridFlow::Down},
                                     Step{-1, 0, GridFlow::Left}, Step{0, -1, GridFlow::Up}};

/// From a pixel to its source.
struct Offset {
    int exemplar = 0, dx = 0, dy = 0;
    friend bool operator<(const Offset& a, const Offset& b) {
        return std::tuple(a.exemplar, a.dx, a.dy) < std::tuple(b.exemplar, b.dx, b.dy);
    }
};

struct Rectangle {
    int left = 0, top = 0, right = 0, bottom = 0;
};

class SeamMover {
public:
    SeamMover(const CopiedPixels& copied, const ImageView& picture, const SeamMoves& moves, PositionMap& map,
              const std::function<void()>& check);
    SeamCosts run();

private:
    /// A pixel's pieces of energy if it keeps its source and if it takes the offset.
    using Pair = std::array<std::int64_t, 2>;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size.width) +
               static_cast<std::size_t>(x);
    }
    bool made(int x, int y) const { return m_copied.isMade(x, y, m_size.width); }
    bool place(int& x, int& y) const;
    const float* pixel(int exemplar, int x, int y) const;
    float difference(const float* a, const float* b) const;
    std::int64_t seam(const Step& step, const Source& near, const Source& far) const;
    std::int64_t border(const Step& step, const Source& source, int x, int y) const;
    bool shifted(const Offset& offset, int x, int y, Source& source) const;
    std::vector<std::pair<Offset, Rectangle>> frequent() const;
    Rectangle widened(const Rectangle& box) const;
    void spread(const Offset& offset, const Rectangle& where);
    void findNodes(const Offset& offset, const Rectangle& where);
    Pair connect(GridFlow& flow, int x, int y, const Source& taken) const;
    std::int64_t cost(const Rectangle& where) const;

    const CopiedPixels& m_copied;
    const SeamMoves& m_moves;
    PositionMap& m_map;
    const std::function<void()>& m_check;
    Size m_size;
    int m_channels;
    float m_unit = 1;
    Interleaved m_picture;
    std::vector<Interleaved> m_exemplars;
    Rectangle m_all; ///< around all that was made
    /// Of the present move: by pixel of the picture the node, or −1; by node the pixel and its new source.
    std::vector<int> m_nodes;
    struct Node {
        int x, y;
        Source taken;
    };
    std::vector<Node> m_order;
};

SeamMover::SeamMover(const CopiedPixels& copied, const ImageView& picture, const SeamMoves& moves,
                     PositionMap& map, const std::function<void()>& check)
    : m_copied(copied), m_moves(moves), m_map(map), m_check(check), m_size(picture.size()),
      m_channels(picture.channels), m_picture(m_size, m_channels), m_all{m_size.width, m_size.height, 0, 0},
      m_nodes(static_cast<std::size_t>(m_size.area()), -1) {
    m_picture.load(picture, 0, 0, m_size);
    ValueRange range = valueRange(picture);
    for (const PatchSource& exemplar : copied.exemplars) {
        check();
        m_exemplars.emplace_back(exemplar.image.size(), m_channels)
            .load(exemplar.image, 0, 0, exemplar.image.size());
        const ValueRange own = valueRange(exemplar.image);
        range = {std::min(range.smallest, own.smallest), std::max(range.largest, own.largest)};
    }
    if (range.largest > range.smallest)
        m_unit = kSeamUnit / ((range.largest - range.smallest) * static_cast<float>(m_channels));
    for (int y = 0; y < m_size.height; ++y)
        for (int x = 0; x < m_size.width; ++x)
            if (made(x, y))
                m_all = {std::min(m_all.left, x), std::min(m_all.top, y), std::max(m_all.right, x + 1),
                         std::max(m_all.bottom, y + 1)};
}

/// A pixel on the axes that wrap. @return whether it lies in the picture.
bool SeamMover::place(int& x, int& y) const {
    if (m_copied.wrap.x)
        x = repeated(x, m_size.width);
    if (m_copied.wrap.y)
        y = repeated(y, m_size.height);
    return x >= 0 && y >= 0 && x < m_size.width && y < m_size.height;
}

/// Beyond the exemplar, its border goes on: what an offset shows there is given by the offset alone, so that
/// costs remain a metric of offsets.
const float* SeamMover::pixel(int exemplar, int x, int y) const {
    const Interleaved& from = m_exemplars[static_cast<std::size_t>(exemplar)];
    return from.at(std::clamp(x, 0, from.size.width - 1), std::clamp(y, 0, from.size.height - 1));
}

float SeamMover::difference(const float* a, const float* b) const {
    float sum = 0;
    for (int c = 0; c < m_channels; ++c)
        sum += std::abs(a[c] - b[c]);
    return sum;
}

/// The cost of a seam between a pixel and its neighbour.
std::int64_t SeamMover::seam(const Step& step, const Source& near, const Source& far) const {
    if (near.exemplar == far.exemplar && near.x + step.dx == far.x && near.y + step.dy == far.y)
        return 0;
    const float sum = difference(pixel(near.exemplar, near.x, near.y),
                                 pixel(far.exemplar, far.x - step.dx, far.y - step.dy)) +
                      difference(pixel(near.exemplar, near.x + step.dx, near.y + step.dy),
                                 pixel(far.exemplar, far.x, far.y));
    return 1 + static_cast<std::int64_t>(sum * m_unit);
}

/// The cost of a seam between a pixel and a neighbour that was not made.
std::int64_t SeamMover::border(const Step& step, const Source& source, int x, int y) const {
    const float sum =
        difference(pixel(source.exemplar, source.x + step.dx, source.y + step.dy), m_picture.at(x, y));
    return static_cast<std::int64_t>(2 * sum * m_unit);
}

/// @return whether what the offset shows at a pixel may be copied.
bool SeamMover::shifted(const Offset& offset, int x, int y, Source& source) const {
    const PatchSource& exemplar = m_copied.exemplars[static_cast<std::size_t>(offset.exemplar)];
    const int u = x + offset.dx, v = y + offset.dy;
    if (u < 0 || v < 0 || u >= exemplar.image.width || v >= exemplar.image.height)
        return false;
    if (exemplar.mask.data && exemplar.mask(u, v) == 0)
        return false;
    if (m_moves.radius > 0 && exemplar.image.size() == m_size &&
        (std::abs(offset.dx) > m_moves.radius || std::abs(offset.dy) > m_moves.radius))
        return false;
    source = {static_cast<std::uint16_t>(u), static_cast<std::uint16_t>(v),
              static_cast<std::uint16_t>(offset.exemplar)};
    return true;
}

/// The offsets of most pixels, the most frequent first, and where they are.
std::vector<std::pair<Offset, Rectangle>> SeamMover::frequent() const {
    struct Piece {
        int pixels = 0;
        Rectangle box;
    };
    std::map<Offset, Piece> pieces;
    for (int y = m_all.top; y < m_all.bottom; ++y)
        for (int x = m_all.left; x < m_all.right; ++x) {
            if (!made(x, y))
                continue;
            const Source& source = m_map.at(x, y);
            Piece& piece = pieces[{source.exemplar, source.x - x, source.y - y}];
            const Rectangle box = piece.pixels++ > 0 ? piece.box : Rectangle{x, y, x, y};
            piece.box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
                         std::max(box.bottom, y + 1)};
        }
    std::vector<std::pair<Offset, Piece>> order;
    for (const auto& entry : pieces)
        if (entry.second.pixels >= m_moves.least)
            order.emplace_back(entry);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.second.pixels > b.second.pixels; });
    std::vector<std::pair<Offset, Rectangle>> found;
    for (const auto& [offset, piece] : order)
        if (static_cast<int>(found.size()) < m_moves.offsets)
            found.emplace_back(offset, widened(piece.box));
    return found;
}

/// By the reach, within what was made.
Rectangle SeamMover::widened(const Rectangle& box) const {
    return {std::max(m_all.left, box.left - m_moves.reach), std::max(m_all.top, box.top - m_moves.reach),
            std::min(m_all.right, box.right + m_moves.reach),
            std::min(m_all.bottom, box.bottom + m_moves.reach)};
}

/// The pixels that may take the offset and have another.
void SeamMover::findNodes(const Offset& offset, const Rectangle& where) {
    for (const Node& node : m_order)
        m_nodes[index(node.x, node.y)] = -1;
    m_order.clear();
    for (int y = where.top; y < where.bottom; ++y)
        for (int x = where.left; x < where.right; ++x) {
            Source source;
            if (!made(x, y) || !shifted(offset, x, y, source) || m_map.at(x, y) == source)
                continue;
            m_nodes[index(x, y)] = static_cast<int>(m_order.size());
            m_order.push_back({x, y, source});
        }
}

/// Links a node to those on its right and below. @return what is left of its own: the costs if it keeps its
/// source and if it takes the new one (Kolmogorov & Zabih, IEEE PAMI 26, 2004, section 4.1).
SeamMover::Pair SeamMover::connect(GridFlow& flow, int x, int y, const Source& taken) const {
    const Source& kept = m_map.at(x, y);
    Pair own{0, 0};
    for (const Step& step : kSteps) {
        int u = x + step.dx, v = y + step.dy;
        if (!place(u, v))
            continue;
        if (!made(u, v)) {
            own[0] += border(step, kept, u, v);
            own[1] += border(step, taken, u, v);
            continue;
        }
        const Source& other = m_map.at(u, v);
        const int node = m_nodes[index(u, v)];
        if (node < 0) {
            own[0] += seam(step, kept, other);
            own[1] += seam(step, taken, other);
            continue;
        }
        const Source& far = m_order[static_cast<std::size_t>(node)].taken;
        const std::int64_t both = seam(step, kept, other), farTakes = seam(step, kept, far),
                           takes = seam(step, taken, other), neither = seam(step, taken, far);
        if (step.dx + step.dy > 0) {
            own[1] += takes - both;
            const std::int64_t link = std::max<std::int64_t>(0, farTakes + takes - both - neither);
            flow.link(m_nodes[index(x, y)], step.side, node, static_cast<std::int32_t>(link), 0);
        } else
            own[1] += neither - farTakes;
    }
    return own;
}

/// What the seams of the pixels of a rectangle cost.
std::int64_t SeamMover::cost(const Rectangle& where) const {
    std::int64_t sum = 0;
    for (int y = where.top; y < where.bottom; ++y)
        for (int x = where.left; x < where.right; ++x) {
            if (!made(x, y))
                continue;
            for (const Step& step : kSteps) {
                int u = x + step.dx, v = y + step.dy;
                if (!place(u, v))
                    continue;
                if (!made(u, v))
                    sum += border(step, m_map.at(x, y), u, v);
                else if (step.dx + step.dy > 0)
                    sum += seam(step, m_map.at(x, y), m_map.at(u, v));
            }
        }
    return sum;
}

/// Gives an offset to the pixels of a rectangle that it costs least to give it.
void SeamMover::spread(const Offset& offset, const Rectangle& where) {
    m_check();
    findNodes(offset, where);
    if (m_order.empty())
        return;
    GridFlow flow(m_order.size());
    for (std::size_t i = 0; i < m_order.size(); ++i)
        flow.add();
    for (const Node& node : m_order) {
        const Pair own = connect(flow, node.x, node.y, node.taken);
        const auto tie = static_cast<std::int32_t>(own[1] - own[0]);
        const int number = m_nodes[index(node.x, node.y)];
        if (tie > 0)
            flow.tieToFirst(number, tie);
        else
            flow.tieToSecond(number, -tie);
    }
    flow.solve(m_check);
    for (std::size_t i = 0; i < m_order.size(); ++i)
        if (!flow.first(static_cast<int>(i)))
            std::swap(m_map.at(m_order[i].x, m_order[i].y), m_order[i].taken);
}

SeamCosts SeamMover::run() {
    SeamCosts costs;
    std::int64_t now = cost(m_all);
    costs.before = static_cast<double>(now) / static_cast<double>(m_unit);
    const PositionMap given = m_map;
    for (const OffsetProposal& one : m_moves.proposals)
        spread({one.exemplar, one.dx, one.dy}, widened({one.x, one.y, one.x + one.side, one.y + one.side}));
    if (const std::int64_t spreadCost = cost(m_all); spreadCost <= now)
        now = spreadCost;
    else
        m_map = given;
    for (int round = 0; round < m_moves.rounds; ++round) {
        const std::int64_t before = now;
        const PositionMap earlier = m_map;
        for (const auto& [offset, where] : frequent())
            spread(offset, where);
        now = cost(m_all);
        if (now > before) { // where axes wrap, costs are no metric
            m_map = earlier;
            now = before;
        }
        if (static_cast<double>(before - now) < kLeastGain * static_cast<double>(before))
            break;
    }
    costs.after = static_cast<double>(now) / static_cast<double>(m_unit);
    return costs;
}

} // namespace

SeamCosts moveSeams(const CopiedPixels& copied, const ImageView& picture, const SeamMoves& moves,
                    PositionMap& map, const std::function<void()>& check) {
    return SeamMover(copied, picture, moves, map, check).run();
}

std::uint64_t seamBytes(Size picture, std::span<const Size> exemplars, int channels) {
    std::uint64_t bytes = Interleaved::bytesFor(picture, channels) + PositionMap::bytesFor(picture) +
                          static_cast<std::uint64_t>(picture.area()) * (sizeof(int) + 2 * sizeof(Source)) +
                          GridFlow::bytesFor(static_cast<std::size_t>(picture.area()));
    for (const Size& size : exemplars)
        bytes += Interleaved::bytesFor(size, channels);
    return bytes;
}

} // namespace texloom
