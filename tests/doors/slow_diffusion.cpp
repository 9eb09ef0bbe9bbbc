// A method that works in rounds, shows them, draws a curve, and can be taken up again from a checkpoint.

#include "core/base/text.h"
#include "core/methods/registry.h"

#include <cmath>
#include <cstring>
#include <thread>
#include <utility>

namespace texloom::slow_diffusion {

namespace {

struct Settings {
    int rounds = 8; ///< how often every pixel is mixed with a neighbour
    int pause = 0;  ///< ms of sleep in each round, to be interrupted in
};

/// What a round leaves behind: its number and the pixels, bit for bit.
std::string stateOf(int round, const Image& image) {
    std::string state(sizeof round, '\0');
    std::memcpy(state.data(), &round, sizeof round);
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            state.append(reinterpret_cast<const char*>(image.plane(c).row(y)),
                         static_cast<std::size_t>(image.width()) * sizeof(float));
    return state;
}

/// @return the round to go on with.
int takeUp(const std::string& state, Image& image) {
    int round = 0;
    std::memcpy(&round, state.data(), sizeof round);
    const char* at = state.data() + sizeof round;
    const std::size_t bytes = static_cast<std::size_t>(image.width()) * sizeof(float);
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y, at += bytes)
            std::memcpy(image.plane(c).row(y), at, bytes);
    return round;
}

/// Mixes every pixel with the one to its right or below it, as the round's random numbers say.
/// @param next of the image's size.
void mix(const Image& image, int round, const JobContext& context, Image& next) {
    const Random& random = context.random();
    for (int y = 0; y < image.height(); ++y, context.check())
        for (int x = 0; x < image.width(); ++x) {
            const bool right = random.bits(x, y, static_cast<std::uint32_t>(round)) % 2 == 0;
            const int u = (x + (right ? 1 : 0)) % image.width(), v = (y + (right ? 0 : 1)) % image.height();
            for (int c = 0; c < image.channels(); ++c)
                next(x, y, c) = 0.5F * (image(x, y, c) + image(u, v, c));
        }
}

Synthesis run(const Request& request, const Settings& settings, JobContext& context) {
    const ImageView exemplar = *request.exemplars.front().image;
    Synthesis made;
    made.image = Image(request.size, request.channels());
    Image next = made.image;
    for (int c = 0; c < exemplar.channels; ++c)
        for (int y = 0; y < request.size.height; ++y)
            for (int x = 0; x < request.size.width; ++x)
                made.image(x, y, c) = exemplar(x % exemplar.width, y % exemplar.height, c);
    context.stage(1, TR("Mixing"));
    const std::string* const earlier = context.resumed();
    for (int round = earlier ? takeUp(*earlier, made.image) : 0; round < settings.rounds; ++round) {
        mix(made.image, round, context, next);
        std::swap(made.image, next);
        for (int slept = 0; slept < settings.pause; ++slept, context.check())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        context.curve(TR("Round"), round + 1);
        context.preview(made.image);
        context.progress((round + 1.0) / settings.rounds);
        context.checkpoint(std::chrono::milliseconds(0), [&] { return stateOf(round + 1, made.image); });
    }
    context.progress(1);
    return made;
}

Estimate estimate(const Request& request, const Settings& settings, int) {
    return {4 * Image::bytesFor(request.size, request.channels()) + (1U << 20U),
            settings.rounds * (1e-7 * static_cast<double>(request.size.area()) + settings.pause / 1000.0)};
}

} // namespace

const Method self = method<Settings>(
    {.title = TR("Slow diffusion"),
     .summary = TR("Mixes the pixels of the repeated exemplar round by round."),
     .citation = "None: an example that can be taken up again",
     .category = Category::Tools,
     .takes = {ports::exemplar()},
     .gives = {ports::image()},
     .keepsCheckpoints = true},
    {field(&Settings::rounds, "rounds", TR("Rounds"))
         .range(0, 1000)
         .help(TR("How often every pixel is mixed with one beside it: more blur more.")),
     field(&Settings::pause, "pause", TR("Pause"))
         .range(0, 1000)
         .unit("ms")
         .help(TR("How long each round waits before the next: longer can be watched at leisure."))},
    run, [](const Request&, const Settings&) {}, estimate);

namespace {
const Registration registered("slow-diffusion", self);
}

} // namespace texloom::slow_diffusion
