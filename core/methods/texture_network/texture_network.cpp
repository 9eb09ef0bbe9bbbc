#include "core/base/error.h"
#include "core/base/text.h"
#include "core/generator/generator_source.h"
#include "core/image/channel_text.h"
#include "core/methods/method.h"
#include "core/methods/texture_network/training.h"

#include <algorithm>
#include <memory>

namespace texloom::texture_network {

namespace {

constexpr int kSmallestExemplar = 16, kMostChannels = 64;
/// Where the picture begins in the texture: amid the cells of all scales, so that no edge of theirs lies at
/// the seam where it closes on itself.
constexpr int kFirst = 11;

std::shared_ptr<const Model> givenModel(const Request& request) {
    return request.inputs.first<Model>(kPictureGenerator);
}

bool trains(const Request& request, const Settings& settings) {
    return !request.continues && (settings.further || !givenModel(request));
}

void checkTraining(const Request& request, const Settings& settings) {
    if (request.exemplars.empty())
        failUsage(
            "There is neither an exemplar to learn from nor a trained generator to make a texture with.");
    if (request.channels() > kMostChannels)
        failUsage("The exemplar has {} channels with its maps; a generator makes at most {}.",
                  request.channels(), kMostChannels);
    int least = kSmallestExemplar;
    if (settings.describes()) {
        checkDescriptor(request, settings.descriptor);
        const Descriptor descriptor = plannedDescriptor(request, settings.descriptor);
        least = TextureLoss::leastSide(descriptor, settings.lossOptions(&descriptor).texture.levels);
    }
    const Size size = trainedSize(request, settings);
    if (size.shorterSide() < least)
        failUsage("The exemplar has {} × {} px here; its sides must have at least {} px.", size.width,
                  size.height, least);
    if (settings.trainSize < least)
        failUsage("Samples of {} px are too small for the network, which needs {} px a side.",
                  settings.trainSize, least);
}

void check(const Request& request, const Settings& settings) {
    if (const auto model = givenModel(request)) {
        const int made = GeneratorWeights::from(*model).shape.channels;
        if (!request.exemplars.empty() && made != request.channels())
            failUsage("The generator makes {}, and the exemplar has {}.", channelText(made),
                      request.channels());
    } else if (settings.further) {
        failUsage("There is no generator to train further: give one, or train a new one.");
    }
    if (trains(request, settings))
        checkTraining(request, settings);
}

int channels(const Request& request, const Settings&) {
    const auto model = givenModel(request);
    return model ? GeneratorWeights::from(*model).shape.channels : 0;
}

Estimate estimate(const Request& request, const Settings& settings, int threads) {
    const auto model = givenModel(request);
    const GeneratorShape shape = model ? GeneratorWeights::from(*model).shape
                                       : GeneratorShape{2, settings.coarsest, settings.noiseChannels,
                                                        settings.step, request.channels()};
    const Size part = request.part().size;
    constexpr int kBlock = 4 * GeneratorSource::kBlock;
    const VolumeSize block{std::min(part.width, kBlock), std::min(part.height, kBlock), 1};
    Estimate need;
    need.bytes = Generator::bytesFor(shape, block) + Image::bytesFor(part, shape.channels) +
                 2 * Image::bytesFor({part.width, std::min(part.height, kBlock)}, shape.channels) +
                 (16U << 20U);
    const double blocks = static_cast<double>(part.area()) / static_cast<double>(block.voxels());
    need.seconds = 1e-10 * blocks * Generator::productsFor(shape, {0, 0, 0, block});
    if (trains(request, settings) && !request.exemplars.empty()) {
        need.bytes += Training::bytesFor(request, settings, threads);
        need.seconds += Training::secondsFor(request, settings);
    }
    return need;
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    Synthesis made;
    std::shared_ptr<const Model> model = givenModel(request);
    GeneratorWeights weights;
    if (trains(request, settings)) {
        context.stage(0.02, TR("Preparing the exemplar"));
        Training training(request, settings, context);
        context.stage(0.9, TR("Training"));
        training.run();
        made.notes = training.notes();
        made.figures = {{TR("Loss"), training.loss()}};
        weights = training.weights();
        model = training.model();
        context.stage(0.08, TR("Making the texture"));
    } else {
        weights = GeneratorWeights::from(*model);
        if (!request.exemplars.empty() && !request.continues)
            made.notes.emplace_back(
                TR("The texture is made by the generator that was given, and the exemplar is "
                   "not looked at; to teach it the exemplar, train it further."));
        context.stage(1, TR("Making the texture"));
    }
    const VolumeSize period{request.wrap.x ? request.size.width : 0, request.wrap.y ? request.size.height : 0,
                            0};
    const GeneratorSource texture(std::make_shared<const Generator>(weights), request.seed, period);
    const Region part = request.part();
    made.image = planeOf(texture, {part.x + kFirst, part.y + kFirst, part.size}, context);
    made.outputs.add(kPictureGenerator, model);
    context.progress(1);
    return made;
}

std::vector<Param> trainingFields() {
    return {
        field(&Settings::iterations, "iterations", TR("Iterations"))
            .range(1, 100000)
            .help(TR(
                "Steps of training: a few hundred show what becomes of it, some thousands make it sharper. "
                "It can be stopped at any time and keeps what it has learned.")),
        field(&Settings::further, "further", TR("Train further"))
            .help(
                TR("Goes on training the generator that is given; else it only makes the texture, at once.")),
        field(&Settings::exemplarSide, "exemplar-side", TR("Exemplar's side"))
            .range(16, 1024)
            .unit("px")
            .help(
                TR("An exemplar with a longer one is scaled down to this, and features with it: larger keeps "
                   "more detail and takes much longer to learn.")),
        field(&Settings::trainSize, "train-size", TR("Side of samples"))
            .range(16, 512)
            .unit("px")
            .help(TR("Of the textures that are made and compared in training: larger ones say more of large "
                     "features, and take longer.")),
        field(&Settings::batch, "batch", TR("Batch"))
            .range(1, 32)
            .help(TR("Samples in one iteration: more make each step surer and longer.")),
        field(&Settings::rate, "rate", TR("Learning rate"))
            .range(0.0001, 1)
            .group(TR("Advanced"))
            .help(TR("How far each step goes at the beginning. Too large, and the loss jumps; too small, and "
                     "it falls slowly.")),
        field(&Settings::decay, "decay", TR("Decay"))
            .range(0.01, 1)
            .group(TR("Advanced"))
            .help(TR("What the learning rate is multiplied by each time that it falls.")),
        field(&Settings::decayEvery, "decay-every", TR("Decay every"))
            .range(0, 100000)
            .group(TR("Advanced"))
            .help(TR("Iterations after which the learning rate falls; 0 for a tenth of them all."))};
}

std::vector<Param> lossFields() {
    return {
        field(&Settings::loss, "loss", TR("Compare by"))
            .choices({{"both", TR("Both")}, {"gram", TR("Descriptor")}, {"patches", TR("Patches")}})
            .help(TR("What of samples and exemplar is compared: the feature maps of a descriptor, the "
                     "distribution of small patches, which makes edges sharper, or both.")),
        descriptorField(&Settings::descriptor),
        networkLevelsField(&Settings::levels),
        coloursField(&Settings::colours),
        statisticField(&Settings::statistic),
        poolingField(&Settings::pooling),
        field(&Settings::evenGradients, "even-gradients", TR("Even gradients"))
            .group(TR("Advanced"))
            .help(TR("Gives the gradient at each tap of the descriptor the same norm, so that all have their "
                     "say, whatever their loss.")),
    };
}

std::vector<Param> networkFields() {
    return {
        field(&Settings::padding, "padding", TR("Padding"))
            .choices({{"none", TR("None")}, {"circular", TR("Circular")}})
            .group(TR("Advanced"))
            .help(TR("What samples find beyond their edges in training: more of an endless texture, or their "
                     "other end, as published. Either generator makes any part of any size, and wraps.")),
        field(&Settings::coarsest, "scales", TR("Halvings"))
            .range(0, 7)
            .symbol("K")
            .group(TR("Advanced"))
            .help(TR("How often the generator's noise is halved in size: each scale more lets features be "
                     "twice as large.")),
        field(&Settings::step, "channels", TR("Channels"))
            .range(1, 32)
            .group(TR("Advanced"))
            .help(TR("Feature maps that each scale adds, 8 as published: more hold more of the texture, and "
                     "take longer by "
                     "their square.")),
        field(&Settings::noiseChannels, "noise-channels", TR("Noise channels"))
            .range(1, 16)
            .group(TR("Advanced"))
            .help(TR("Of the random numbers that each scale begins with."))};
}

std::vector<Param> fields() {
    std::vector<Param> all = trainingFields();
    for (std::vector<Param> some : {lossFields(), networkFields()})
        std::move(some.begin(), some.end(), std::back_inserter(all));
    return all;
}

Port optionalExemplar() {
    Port port = ports::exemplar();
    port.least = 0;
    return port;
}

} // namespace

extern const Method self;
const Method self = method<Settings>(
    {.title = TR("Texture network"),
     .summary =
         TR("Trains a small network until what it makes of noise looks like the exemplar; trained, it makes "
            "textures of any size at once. For patterns without strict order."),
     .citation = "Ulyanov, Lebedev, Vedaldi & Lempitsky, ICML 2016; Gutierrez, PhD thesis 2020, section 4.1",
     .category = Category::Networks,
     .suits = {.regular = 1, .grain = 3, .objects = 2, .large = 1},
     .takes = {optionalExemplar(),
               {.id = std::string(kPictureGenerator),
                .title = TR("Generator"),
                .help = TR("A trained generator to make the texture with, or to train further."),
                .kind = AssetKind::Model},
               descriptorInput()},
     .gives = {ports::inParts(ports::wrappingImage()),
               {.id = std::string(kPictureGenerator),
                .title = TR("Generator"),
                .help = TR("What was learned, under half a megabyte: given to this method, it makes any size "
                           "and any part of the texture without training."),
                .kind = AssetKind::Model,
                .least = 1}},
     .keepsCheckpoints = true},
    fields(), run, check, estimate, channels);

} // namespace texloom::texture_network
