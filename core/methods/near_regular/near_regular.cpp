#include "core/analysis/lattice_detector.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/match/patch_distances.h"
#include "core/match/whole_patches.h"
#include "core/methods/method.h"
#include "core/methods/near_regular/filler.h"
#include "core/methods/near_regular/preparation.h"
#include "core/methods/near_regular/tile_stitcher.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace texloom::near_regular {

namespace {

/// Light more uneven than this shows as patches of different brightness.
constexpr double kTooUneven = 0.5;
constexpr int kSmallestExemplar = 8;
constexpr int kSmallestBlock = 4;
/// The source's block and border on its exemplars of 128 px: 40 and 10 px. A wider border gives better cuts.
constexpr double kBlockShare = 0.3125, kBorderShare = 0.25, kBorderShareOfCut = 0.4;

int even(double length) {
    return 2 * std::max(1, static_cast<int>(std::lround(length / 2)));
}

/// Border of a block: wide enough for the blended band, and at most half the block, so that no two gaps meet.
int borderFor(const Settings& settings, int block) {
    const bool cut = settings.join == Join::Cut;
    const double automatic = (cut ? kBorderShareOfCut : kBorderShare) * block;
    const int asked = settings.border > 0 ? even(settings.border) : even(automatic);
    const int band = cut ? 2 : even(settings.blend + 1);
    return std::clamp(std::max(asked, band), 2, std::max(2, block / 4 * 2));
}

/// The largest block of about the source's share of the exemplar, and not much below it, for which the
/// lattice leaves several patches to choose from, or half of what there are where those are few.
int blockFor(const Settings& settings, Size exemplar, const Lattice& lattice) {
    if (settings.block > 0)
        return settings.block;
    constexpr double kChoices = 6, kLeastShare = 0.4;
    const double wanted = std::min(kChoices, 0.5 * static_cast<double>(exemplar.area()) / lattice.area());
    const double most = kBlockShare * exemplar.shorterSide();
    const auto choices = [&](int block) {
        const int patch = block + borderFor(settings, block);
        return static_cast<double>(exemplar.width - patch + 1) * (exemplar.height - patch + 1) /
               lattice.area();
    };
    // Rows that keep their order need a patch for each place of a period.
    const double left =
        lattice.keepsOrder(exemplar) ? lattice.acrossRows(exemplar) - lattice.area() : exemplar.shorterSide();
    int block = std::max(kSmallestBlock, static_cast<int>(std::lround(most)));
    while (block > kSmallestBlock && (block + borderFor(settings, block) > left ||
                                      (block > kLeastShare * most && choices(block) < wanted)))
        --block;
    return block;
}

int largestBlock(const Settings& settings, Size exemplar) {
    int block = exemplar.shorterSide();
    while (block > kSmallestBlock && block + borderFor(settings, block) > exemplar.shorterSide())
        --block;
    return block;
}

/// Side of a patch, at most; blocks that wrap differ by a pixel.
int patchFor(const Settings& settings, int block) {
    return block + borderFor(settings, block) + 1;
}

/// Fits the lattice to an output that wraps, and adds a note where that changes it visibly.
Lattice closing(const Lattice& lattice, const Request& request, std::vector<Message>& notes) {
    if (!request.wrap.x && !request.wrap.y)
        return lattice;
    const WrappedLattice fitted = wrapped(lattice, request.size, request.wrap);
    constexpr double kTooMuch = 0.6, kWorthSaying = 0.02;
    const Size size = request.size;
    if (fitted.stretch > kTooMuch)
        failUsage(
            "An output of {} × {} px cannot wrap with a lattice of {:.0f} × {:.0f} px; make it at least that "
            "large, or set lattice=none.",
            size.width, size.height, lattice.extent().x, lattice.extent().y);
    const Size whole = wrappingRectangle(lattice, std::max(4096, size.longerSide()));
    if (fitted.stretch > kWorthSaying && !whole.empty())
        notes.push_back(message("To wrap at {} × {} px the lattice was changed by {:.1f} %; a multiple of {} "
                                "× {} px needs no change.",
                                size.width, size.height, 100 * fitted.stretch, whole.width, whole.height));
    return fitted.lattice;
}

void check(const Request& request, const Settings& settings) {
    const Exemplar& exemplar = request.exemplars.front();
    const Size size = exemplar.image->size();
    if (size.shorterSide() < kSmallestExemplar)
        failUsage("{} is {} × {} px; near-regular synthesis needs exemplars of at least {} × {} px.",
                  exemplar.name, size.width, size.height, kSmallestExemplar, kSmallestExemplar);
    checkLattice(settings, exemplar.name, size);
    const int most = largestBlock(settings, size);
    if (settings.block > most)
        failUsage("{} is {} × {} px, too small for blocks of {} px with their borders; choose blocks of at "
                  "most {} px.",
                  exemplar.name, size.width, size.height, settings.block, most);
    const int least = settings.block > 0 ? settings.block : kSmallestBlock;
    const int patch = std::min(patchFor(settings, least) - 1, size.shorterSide());
    if (settings.unit == Unit::Blocks && exemplar.mask() &&
        !leavesWholePatch(exemplar.mask()->view().plane(0), patch))
        failUsage("The mask leaves no whole patch of {} px to copy; choose smaller blocks or mask less.",
                  patch);
    const auto checkWrap = [](bool wraps, int length, const char* side) {
        if (wraps && length < 4 * kSmallestBlock)
            failUsage("To wrap, the output's {} of {} px must be at least {} px.", side, length,
                      4 * kSmallestBlock);
    };
    checkWrap(request.wrap.x, request.size.width, "width");
    checkWrap(request.wrap.y, request.size.height, "height");
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const Size exemplar = request.exemplars.front().image->size(), part = request.part().size;
    const int channels = request.channels();
    // How the lattice will change the block is not known yet: cuts take at most 2¼ bytes for each pixel of a
    // gap.
    const int shapes = request.wrap.x || request.wrap.y ? 16 : 1;
    const auto beyond = static_cast<std::uint64_t>(part.width + 4LL * exemplar.width) *
                        static_cast<std::uint64_t>(part.height + 4LL * exemplar.height);
    Estimate need;
    need.bytes = Image::bytesFor(part, channels) + PositionMap::bytesFor(part) + beyond * 5 / 4 +
                 2 * Image::bytesFor(exemplar, channels) +
                 std::max(latticeBytesFor(exemplar, channels),
                          BorderMatch::bytesFor(exemplar, channels, shapes, settings.match) +
                              static_cast<std::uint64_t>(threads) *
                                  (PatchDistances::scratchBytesFor(exemplar, channels) +
                                   Image::bytesFor(exemplar, channels + 1)));
    const double block = blockFor(settings, exemplar, {});
    const double gaps = 0.5 * static_cast<double>(part.area()) / (block * block) + 4;
    const auto pixels = static_cast<double>(exemplar.area());
    if (settings.unit == Unit::Tiles)
        need.bytes += TileStitcher::bytesFor(request.size, exemplar, channels);
    need.seconds = latticeSecondsFor(exemplar) + 4e-8 * static_cast<double>(part.area()) +
                   gaps * pixels * (3e-9 + 7e-11 * std::log2(pixels) * (channels + 1));
    return need;
}

/// Smaller blocks where the mask leaves no patch of the chosen size.
int fittingMask(const Settings& settings, const Plan& plan) {
    int block = plan.block;
    while (
        settings.block == 0 && plan.mask.data != nullptr && block > kSmallestBlock &&
        !leavesWholePatch(plan.mask, std::min(patchFor(settings, block), plan.exemplar.size().shorterSide())))
        block = std::max(kSmallestBlock, block * 3 / 4);
    return block;
}

/// An interpolated mask: every pixel to which a hidden one contributed is hidden.
Image hardened(Image mask) {
    constexpr float kRounding = 1e-4F;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            mask(x, y, 0) = std::abs(mask(x, y, 0) - 1) < kRounding ? 1.0F : 0.0F;
    return mask;
}

/// 1 where a mask is not 0.
Image binary(const Image& mask) {
    Image result(mask.size(), 1);
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            result(x, y, 0) = mask(x, y, 0) == 0 ? 0.0F : 1.0F;
    return result;
}

/// The exemplar as it is sampled, where the settings change it first.
struct Prepared {
    Image image; ///< empty where the exemplar is sampled as it is
    Image mask;  ///< likewise
    std::optional<Rectification> change;
    bool even = false; ///< slow changes of light were removed
};

/// Changes over more pixels than this count as light: one tile, or one block where there is no lattice.
int lightWidth(const Settings& settings, const Plan& plan) {
    const Vec2 tile = plan.from.extent();
    const double longest = std::max(tile.x, tile.y);
    const int block = blockFor(settings, plan.exemplar.size(), plan.from);
    return static_cast<int>(std::ceil(plan.from.free() ? block : longest));
}

/// Whether the light is to be evened out; adds a note where the exemplar decides.
bool lightGoes(const std::string& exemplar, const Settings& settings, const Plan& plan,
               std::vector<Message>& notes, const std::function<void()>& check) {
    if (settings.flatten != EvenLight::Automatic)
        return settings.flatten == EvenLight::Yes;
    if (plan.from.free() || unevenness(plan.exemplar, lightWidth(settings, plan), check) <= kTooUneven)
        return false;
    notes.push_back(message(
        "The light in {} varies so much that patches would show, so it was evened out; flatten=no keeps it.",
        exemplar));
    return true;
}

Prepared prepared(const Request& request, const Settings& settings, Plan& plan, std::vector<Message>& notes,
                  JobContext& context) {
    Prepared result;
    const auto check = [&] { context.check(); };
    if (settings.rectify && !plan.from.free()) {
        const Rectification change = rectification(plan.from, plan.exemplar.size());
        if (change.size.shorterSide() < kSmallestExemplar) {
            notes.push_back(message("{} was not straightened, since too little of it would be left.",
                                    request.exemplars.front().name));
        } else {
            result.image = rectified(plan.exemplar, change, check);
            result.change = change;
            plan.from = change.lattice;
            plan.exemplar = result.image;
            if (plan.mask.data != nullptr) {
                result.mask = hardened(rectified(binary(*request.exemplars.front().mask()), change, check));
                plan.mask = result.mask.view().plane(0);
            }
        }
    }
    if (lightGoes(request.exemplars.front().name, settings, plan, notes, check)) {
        result.image = flattened(plan.exemplar, lightWidth(settings, plan), check);
        result.even = true;
        plan.exemplar = result.image;
    }
    return result;
}

/// Turns places in the rectified exemplar into those in the exemplar itself.
void mapBack(PositionMap& map, const Rectification& change, Size exemplar, JobContext& context) {
    for (int y = 0; y < map.height(); ++y) {
        context.check();
        for (int x = 0; x < map.width(); ++x) {
            Source& source = map.at(x, y);
            const Vec2 at = change.from(source.x, source.y);
            source.x = static_cast<std::uint16_t>(std::clamp<long>(std::lround(at.x), 0, exemplar.width - 1));
            source.y =
                static_cast<std::uint16_t>(std::clamp<long>(std::lround(at.y), 0, exemplar.height - 1));
        }
    }
}

/// The note for a lattice longer than the blocks.
Message longTiles(const Settings& settings, const Plan& plan) {
    const Vec2 extent = plan.from.extent();
    const int whole = static_cast<int>(std::lround(std::max(extent.x, extent.y)));
    const Message remedy = whole <= largestBlock(settings, plan.exemplar.size())
                               ? message("Blocks of {} px hold whole ones.", whole)
                               : Message(TR("“Regular tile” repeats whole ones."));
    if (plan.from.rowsOnly())
        return message("The rows, {:.0f} px apart, are larger than the blocks of {} px, so new ones are "
                       "pieced together from parts of several. {}",
                       plan.from.area(), plan.block, remedy);
    return message("The lattice's tile of {:.0f} × {:.0f} px is larger than the blocks of {} px, so new ones "
                   "are pieced together from parts of several. {}",
                   extent.x, extent.y, plan.block, remedy);
}

/// The note for rows of which the exemplar shows only the direction.
Message orderedRows(const std::string& exemplar, const Plan& plan) {
    return message("Nothing in {} repeats, but rows run through all of it: they keep the order that they "
                   "have there, and begin again every {:.0f} px. If it does repeat, rectify it where it is "
                   "seen at an angle, or give its vectors yourself.",
                   exemplar, plan.from.area());
}

void describe(const std::string& exemplar, const Settings& settings, const Plan& plan, Synthesis& result) {
    const Vec2 extent = plan.from.extent();
    if (plan.from.keepsOrder(plan.exemplar.size()))
        result.notes.push_back(orderedRows(exemplar, plan));
    else if (settings.unit == Unit::Blocks && !plan.from.free() && std::max(extent.x, extent.y) > plan.block)
        result.notes.push_back(longTiles(settings, plan));
    if (settings.unit == Unit::Blocks)
        result.figures.push_back({TR("Block"), static_cast<double>(plan.block)});
    result.figures.push_back({TR("Lattice, first vector right"), plan.from.v1.x});
    result.figures.push_back({TR("Lattice, first vector down"), plan.from.v1.y});
    result.figures.push_back({TR("Lattice, second vector right"), plan.from.v2.x});
    result.figures.push_back({TR("Lattice, second vector down"), plan.from.v2.y});
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const Exemplar& exemplar = request.exemplars.front();
    Synthesis result;
    context.stage(0.1, TR("Looking for the lattice"));
    Plan plan;
    plan.exemplar = *exemplar.image;
    if (exemplar.mask())
        plan.mask = exemplar.mask()->view().plane(0);
    plan.from = latticeFor(settings, exemplar.name, exemplar.image, result.notes, [&] { context.check(); });
    const Prepared sampled = prepared(request, settings, plan, result.notes, context);
    plan.to = closing(plan.from, request, result.notes);
    plan.block = std::min(blockFor(settings, plan.exemplar.size(), plan.from),
                          largestBlock(settings, plan.exemplar.size()));
    if (settings.unit == Unit::Blocks)
        plan.block = fittingMask(settings, plan);
    plan.border = borderFor(settings, plan.block);
    describe(exemplar.name, settings, plan, result);
    const bool cut = settings.join == Join::Cut || settings.unit == Unit::Tiles;
    if (settings.unit == Unit::Tiles)
        TileStitcher(request, settings, plan, context).fill(result, 0.9);
    else
        Filler(request, settings, plan, context).fill(result, 0.9);
    result.mapKind = cut && !sampled.even ? MapKind::Exact : MapKind::Dominant;
    if (sampled.change) {
        mapBack(result.map, *sampled.change, exemplar.image->size(), context);
        result.mapKind = MapKind::Estimated;
    }
    return result;
}

std::vector<Param> params() {
    std::vector<Param> all = latticeFields<Settings>();
    all.push_back(
        field(&Settings::originX, "origin-x", TR("Origin, right"))
            .role(lattice_role::kOriginRight)
            .range(-65535, 65535)
            .unit("px")
            .group(TR("Lattice"))
            .help(TR("Column of the exemplar's lattice that lies at the output's left side: moves the "
                     "pattern sideways.")));
    all.push_back(
        field(&Settings::originY, "origin-y", TR("Origin, down"))
            .role(lattice_role::kOriginDown)
            .range(-65535, 65535)
            .unit("px")
            .group(TR("Lattice"))
            .help(TR("Row of the exemplar's lattice that lies at the output's top: moves the pattern up or "
                     "down.")));
    all.push_back(
        field(&Settings::unit, "unit", TR("Unit"))
            .choices({{"blocks", TR("Blocks")}, {"tiles", TR("Whole tiles")}})
            .help(TR("Blocks are drawn at random along the lattice and make new tiles of parts of several; "
                     "whole tiles are stitched one after another, each to fit those before.")));
    all.push_back(
        field(&Settings::block, "block", TR("Block size"))
            .range(0, 1024)
            .unit("px")
            .help(TR("Side of the squares that are copied; 0 chooses by the exemplar and its lattice. Larger "
                     "keeps larger stretches, smaller varies more. Whole tiles take it where rows do not "
                     "repeat.")));
    all.push_back(
        field(&Settings::border, "border", TR("Border"))
            .range(0, 512)
            .unit("px")
            .help(TR("Width in which a patch is compared with, and joined to, its neighbours; 0 takes a "
                     "share of the block.")));
    all.push_back(
        field(&Settings::tolerance, "tolerance", TR("Tolerance"))
            .range(0, 64)
            .unit("px")
            .help(TR("How far from the lattice a patch that fills a gap may lie: more joins better where "
                     "the texture is irregular, less keeps the courses straight.")));
    all.push_back(
        field(&Settings::join, "join", TR("Join"))
            .choices({{"cut", TR("Minimum-error cut")}, {"blend", TR("Linear blending")}})
            .when("unit", std::string("blocks"))
            .help(TR("A cut keeps every pixel as it is in the exemplar; blending mixes a band along the "
                     "blocks' edges, as in the source.")));
    all.push_back(
        field(&Settings::blend, "blend", TR("Blended band"))
            .range(1, 256)
            .unit("px")
            .when("join", std::string("blend"))
            .help(TR("Width of the band that is blended: wider hides differences of brightness between "
                     "blocks, narrower is sharper.")));
    all.push_back(
        field(&Settings::match, "match", TR("Fit by"))
            .choices({{"difference", TR("Squared differences")}, {"correlation", TR("Correlation")}})
            .group(TR("Advanced"))
            .help(TR("Differences keep brightness even between blocks; correlation fits edges better where "
                     "brightness differs.")));
    all.push_back(
        field(&Settings::flatten, "flatten", TR("Even out the light"))
            .choices(
                {{"automatic", TR("Where patches would show")}, {"yes", TR("Always")}, {"no", TR("Never")}})
            .group(TR("Exemplar"))
            .help(TR("Takes slow changes of brightness out of the exemplar first, so that blocks from its "
                     "light and dark parts match; pixels change a little.")));
    all.push_back(
        field(&Settings::rectify, "rectify", TR("Straighten"))
            .group(TR("Exemplar"))
            .help(TR("Turns and shears the exemplar so that its courses run along the axes in whole pixels; "
                     "pixels are interpolated.")));
    for (Param& param : latticeSearchFields<Settings>())
        all.push_back(std::move(param));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Near-regular texture"),
     .summary = TR(
         "Finds the lattice of bricks, tiles or weave and samples blocks at random along it, then fills the "
         "gaps with patches that fit: keeps the courses and varies what lies in them."),
     .citation = "López Recas, diploma thesis 2011, chapters 3 to 5; Liu, Tsin & Lin, IJCV 2005",
     .category = Category::NearRegular,
     .suits = {.regular = 5, .grain = 2, .objects = 2, .large = 2},
     .takes = {ports::exemplar(), ports::mask()},
     .gives = {ports::inParts(ports::wrappingImage()), ports::map()}},
    params(), run, check, estimate);

} // namespace texloom::near_regular
