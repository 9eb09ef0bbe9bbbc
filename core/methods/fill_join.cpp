#include "core/methods/fill_join.h"

#include "core/base/text.h"
#include "core/methods/fill_offsets.h"
#include "core/methods/fill_seams.h"
#include "core/methods/patch_request.h"

#include <vector>

namespace texloom {

namespace {

/// How many places are taken for each square on the border of a hole.
constexpr int kProposals = 3;

} // namespace

void joinCopies(const Request& hidden, int side, int radius, PositionMap& map, JobContext& context) {
    const std::vector<PatchSource> sources = patchSources(hidden);
    const std::vector<std::uint8_t> made = madeOf(*knownOf(hidden));
    SeamMoves moves;
    moves.radius = radius;
    const CopiedPixels copied{sources, made, hidden.wrap};
    moves.proposals = borderOffsets(copied, *hidden.initial(), side, kProposals, context);
    moveSeams(copied, *hidden.initial(), moves, map, [&context] { context.check(); });
}

std::uint64_t joinBytes(const Request& request, int threads) {
    const std::vector<Size> exemplars = request.exemplarSizes();
    return seamBytes(request.size, exemplars, request.channels()) +
           offsetBytes(exemplars, request.channels(), threads) +
           static_cast<std::uint64_t>(request.size.area());
}

void offerFilled(const FillWindow& window, int level,
                 const std::function<bool(int x, int y, float* values)>& pixel, JobContext& context) {
    const Image &whole = *window.whole().initial(), &known = *knownOf(window.whole());
    const Region part = window.part();
    context.preview(whole.size(), [&](Size size, int step) {
        Image image(size, whole.channels());
        std::vector<float> values(static_cast<std::size_t>(whole.channels()));
        for (int row = 0; row < size.height; ++row)
            for (int column = 0; column < size.width; ++column) {
                const int x = column * step, y = row * step;
                const bool made =
                    known(x, y, 0) == 0 && pixel((x - part.x) >> level, (y - part.y) >> level, values.data());
                for (int c = 0; c < image.channels(); ++c)
                    image(column, row, c) = made ? values[static_cast<std::size_t>(c)] : whole(x, y, c);
            }
        return image;
    });
}

} // namespace texloom
