#include "core/session/run/stress.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/io/json_field.h"
#include "core/session/export/export.h"

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;
using Json = JsonField::Json;

fs::path outputOf(const StressOptions& options, int round) {
    return fmt::format("{}_{}.png", options.synth.out.output.string(), round);
}

void checkOutputs(const RunInput& input, const StressOptions& options) {
    OutputGuard guard;
    for (const RunExemplar& exemplar : input.exemplars) {
        guard.reads(exemplar.image.path, "a source of the result");
        if (exemplar.mask)
            guard.reads(exemplar.mask->path, "a source of the result");
    }
    checkFolder(outputOf(options, 1));
    for (int round = 1; round <= options.rounds; ++round)
        guard.writes(outputOf(options, round), "result");
    if (!options.synth.out.report.empty()) {
        checkFolder(options.synth.out.report);
        guard.writes(options.synth.out.report, "report");
    }
    guard.check(options.synth.out.overwrite);
}

/// The figures of one round: the run's own, and how far its image is from the first exemplars.
Json figuresOf(const Result& result, const TextureDistance& distance) {
    Json json;
    for (const Figure& figure : result.figures)
        json["run"][figure.name.text()] = figure.value;
    for (const Figure& figure : distanceFigures(distance))
        json["fromTheFirst"][figure.name.text()] = figure.value;
    return json;
}

void printRound(int round, const TextureDistance& distance) {
    fmt::print("{:5} {:8.4f} {:8.4f} {:8.4f} {:8.4f} {:8.4f} {:8.4f}\n", round, distance.color,
               distance.components[0], distance.components[1], distance.wasserstein[0],
               distance.wasserstein[1], distance.wasserstein[2]);
}

} // namespace

void stress(const StressOptions& options) {
    RunInput input = inputFor(options.synth);
    input.threads = options.synth.out.threads;
    if (input.exemplars.empty())
        failUsage("stress: {} learns from no exemplar, so that no round could learn from the one before.",
                  methodIds(input.steps, " + "));
    if (!input.exemplars.front().companions.empty() || !input.inputs.empty())
        failUsage("stress: --companion and --init belong to a single run; leave them out.");
    checkOutputs(input, options);
    const std::vector<RunExemplar> first = input.exemplars;
    Json rounds = Json::array();
    if (!options.synth.out.quiet)
        fmt::print("round   colour     PCA1     PCA2      SW 1    SW 1/2    SW 1/4\n");
    for (int round = 1; round <= options.rounds; ++round) {
        const RunPlan plan = planRun(input);
        Job<StressRound> job({plan.request.seed, plan.threads, false},
                             [&](JobContext& context) { return stressRound(plan, first, context); });
        const auto [result, distance] = followed(job, options.synth.out.quiet);
        ExportOptions file;
        file.image = outputOf(options, round);
        file.sidecar = false;
        file.check = checkInterrupt;
        exportResult(result, file);
        rounds.push_back(figuresOf(result, distance));
        if (!options.synth.out.quiet)
            printRound(round, distance);
        learnFrom(result.synthesis.image, input);
    }
    if (!options.synth.out.report.empty())
        writeText(options.synth.out.report, Json{{"texloomReport", 1}, {"rounds", rounds}}.dump(2) + "\n");
}

} // namespace texloom::cli
