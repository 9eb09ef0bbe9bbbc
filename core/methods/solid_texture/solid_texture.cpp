#include "core/base/at.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/generator/generator_source.h"
#include "core/image/channel_text.h"
#include "core/job/voxel_random.h"
#include "core/methods/generator_training.h"
#include "core/methods/method.h"
#include "core/methods/solid_texture/slice_loss.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace texloom::solid_texture {

namespace {

constexpr const char* kVolume = "volume";
constexpr double kTraining = 0.93; ///< share of the run
constexpr double kLastRate = 0.05; ///< at the end, as a share of the first one
constexpr int kFarthest = 1 << 20; ///< slices for training lie no further from 0
constexpr int kSmallestExemplar = 32;

/// The box of a slice square to an axis.
Box sliceBox(Axis axis, const Voxel& first, int side) {
    const SliceVoxel last = sliceVoxel(axis, side - 1, side - 1, 0);
    return {first.x, first.y, first.z, {last.x + 1, last.y + 1, last.z + 1}};
}

class Training {
public:
    Training(const Request& request, const Settings& settings, JobContext& context)
        : m_request(request), m_settings(settings), m_context(context), m_loss(request, settings, context),
          m_training(startingWeights(), settings.iterations, context) {}

    const GeneratorTraining& training() const { return m_training; }
    bool describes() const { return m_loss.pictures().describes(); }
    /// There is nothing to learn of one colour.
    bool constant() const { return m_loss.pictures().constant(); }

    void run() {
        if (!constant())
            m_training.run([this](int n) { return iteration(n); },
                           [this](int n) {
                               const double late = static_cast<double>(n) / m_settings.iterations;
                               return m_settings.rate * std::pow(kLastRate, late);
                           });
    }

private:
    GeneratorWeights startingWeights() const {
        if (const auto model = m_request.inputs.first<Model>(kSolidGenerator))
            return GeneratorWeights::from(*model);
        GeneratorShape shape;
        shape.channels = m_request.channels();
        GeneratorWeights weights = GeneratorWeights::drawn(shape, m_request.seed);
        weights.mean = m_loss.pictures().mean();
        weights.mix = m_loss.pictures().mix();
        return weights;
    }

    /// One slice of each direction at a place drawn anew, so that all of the 2^K kinds of slices are met,
    /// with fresh noise.
    double iteration(int number) {
        double sum = 0;
        const VoxelRandom random(m_request.seed, 1);
        GeneratorTrainer& trainer = m_training.trainer();
        Volume gradient;
        for (std::size_t goal = 0; goal < m_loss.axes().size(); ++goal)
            for (int n = 0; n < m_settings.slices; ++n) {
                const Voxel draws{number, static_cast<std::int64_t>(goal), n};
                const auto draw = [&](std::uint32_t axis) {
                    return static_cast<std::int64_t>(random.below(kFarthest, draws, axis));
                };
                const Voxel first{draw(0), draw(1), draw(2)};
                const GeneratorNoise noise(random.bits(draws, 3));
                const Axis axis = m_loss.axes()[goal];
                const Volume& slice =
                    trainer.forward(sliceBox(axis, first, m_settings.trainSide), noise, m_context);
                m_training.show(m_request.size, [&] { return m_loss.pictureOf(slice, axis); });
                sum += m_loss.evaluate(goal, slice,
                                       (number * m_settings.slices + n) * 4 + static_cast<int>(goal),
                                       gradient, m_context);
                trainer.backward(gradient, m_context);
            }
        return sum / m_settings.slices;
    }

    const Request& m_request;
    const Settings& m_settings;
    JobContext& m_context;
    SliceLoss m_loss;
    GeneratorTraining m_training;
};

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    context.stage(0.02, TR("Preparing the exemplar"));
    Training trained(request, settings, context);
    context.stage(kTraining, TR("Training"));
    trained.run();
    const GeneratorTraining& training = trained.training();
    Synthesis made;
    if (!trained.constant())
        made.notes = training.notes();
    if (!trained.describes())
        made.notes.emplace_back(
            TR("Only the patches of slices were compared: the descriptor sees grey pictures "
               "and those of three channels."));
    context.stage(0.05, TR("Cutting a slice"));
    const auto generator = std::make_shared<const Generator>(training.weights());
    const auto solid = std::make_shared<const GeneratorSource>(generator, request.seed);
    made.image = planeOf(*solid, {0, 0, request.size}, context);
    made.outputs.add(kSolidGenerator, training.weights().model());
    made.outputs.add(kVolume, solid);
    made.figures = {{TR("Loss"), training.loss()}};
    context.progress(1);
    return made;
}

void check(const Request& request, const Settings& settings) {
    checkSliceGoals(request, settings, kSmallestExemplar);
    if (const auto model = request.inputs.first<Model>(kSolidGenerator)) {
        const GeneratorWeights weights = GeneratorWeights::from(*model);
        if (weights.shape.channels != request.channels())
            failUsage("The generator makes {}, and the exemplars have {}.",
                      channelText(weights.shape.channels), request.channels());
    }
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    GeneratorShape shape;
    shape.channels = request.channels();
    const VolumeSize slice{settings.trainSide, settings.trainSide, 1};
    const VolumeSize slab{request.size.width, std::min(request.size.height, 4 * GeneratorSource::kBlock), 1};
    Estimate need;
    need.bytes = GeneratorTrainer::bytesFor(shape, slice) + SliceLoss::bytesFor(request, settings, threads) +
                 Generator::bytesFor(shape, slab) + 3 * Image::bytesFor(request.size, request.channels()) +
                 (32U << 20U);
    const double each = 3 * Generator::productsFor(shape, {0, 0, 0, slice}) * 1e-10;
    const auto goals = static_cast<double>(sliceGoalSizes(request, settings).size());
    need.seconds =
        settings.iterations * settings.slices * (goals * each + SliceLoss::secondsFor(request, settings)) +
        3e-6 * static_cast<double>(request.size.area());
    return need;
}

std::vector<Param> fields() {
    std::vector<Param> all = {
        field(&Settings::iterations, "iterations", TR("Iterations"))
            .range(1, 100000)
            .help(TR(
                "Steps of training: a few hundred show what becomes of it, some thousands make it sharper. "
                "It can be stopped at any time and keeps what it has learned.")),
        field(&Settings::trainSide, "train-side", TR("Side of the slices"))
            .range(32, 256)
            .unit("voxels")
            .help(TR(
                "Of the slices that are made and compared: larger ones say more of large features, and take "
                "longer.")),
        field(&Settings::slices, "slices", TR("Slices"))
            .range(1, 32)
            .help(TR("Of each direction in one iteration: more make each step surer and longer.")),
        field(&Settings::rate, "rate", TR("Learning rate"))
            .range(0.0001, 1)
            .group(TR("Advanced"))
            .help(TR(
                "How far each step goes at the beginning; it falls to a twentieth. Too large, and the loss "
                "jumps; too small, and it falls slowly.")),
        field(&Settings::descriptorWeight, "descriptor-weight", TR("Weight of the descriptor"))
            .range(0, 100)
            .group(TR("Advanced"))
            .help(TR(
                "How much the features count that the descriptor sees in slices; 0 compares patches alone.")),
        field(&Settings::patchWeight, "patch-weight", TR("Weight of patches"))
            .range(0, 100)
            .group(TR("Advanced"))
            .help(TR("How much the distribution of small patches counts, which makes edges sharper; 0 leaves "
                     "it to "
                     "the descriptor."))};
    for (Param& one : sliceFields<Settings>())
        all.push_back(std::move(one));
    return all;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Solid texture"),
     .summary =
         TR("Trains a small network on single slices, which then makes any part of an endless solid at once. "
            "For grain and blobs that look alike in all directions, and, with one axis free, for what runs "
            "along it."),
     .citation = "Gutierrez, PhD thesis 2020, chapter 4; Gutierrez, Rabin, Galerne & Hurtut, 2020",
     .category = Category::Solids,
     .takes = {solidExemplars(),
               {.id = std::string(kSolidGenerator),
                .title = TR("Generator"),
                .help = TR("A trained generator to go on from."),
                .kind = AssetKind::Model}},
     .gives = {ports::image(),
               {.id = std::string(kSolidGenerator),
                .title = TR("Generator"),
                .help = TR(
                    "What was learned, under half a megabyte: `texloom-cli sample` makes boxes, slices and "
                    "coloured meshes of it."),
                .kind = AssetKind::Model,
                .least = 1},
               {.id = kVolume,
                .title = TR("Volume"),
                .help = TR("The solid in space, without end; the picture is its slice at z = 0."),
                .kind = AssetKind::Volume,
                .least = 1}},
     .keepsCheckpoints = true},
    fields(), run, check, estimate);

} // namespace texloom::solid_texture
