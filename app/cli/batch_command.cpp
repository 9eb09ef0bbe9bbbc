#include "app/cli/batch_command.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "app/cli/join_commands.h"
#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/session/batch/batch.h"
#include "core/session/export/export.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct BatchOptions {
    fs::path file;
    std::string shard = "1/1";
    fs::path summary;
    std::string rank; ///< name of a figure, or empty
    fs::path outputs;
    int threads = 0;
    bool list = false;
    bool skipExisting = false;
    bool overwrite = false;
    bool quiet = false;
};

/// How one run ended.
struct Ending {
    std::string problem; ///< why it failed, or empty
    std::vector<Figure> figures = {};
};

/// A run's place by a figure.
struct Ranked {
    double value;
    std::string label;
};

/// How the runs of a batch ended.
struct Tally {
    Json runs = Json::array();
    std::vector<Ranked> ranked;    ///< those that have the figure that was asked for
    std::set<std::string> figures; ///< all names
    std::vector<std::string> failed;
    int done = 0;
    int skipped = 0;

    void add(std::size_t number, const BatchItem& item, const char* status, const Ending& ending = {}) {
        Json run = {{"run", number}, {"output", item.output.string()}, {"status", status}};
        if (!item.cell.empty())
            run["cell"] = item.cell;
        if (!ending.problem.empty())
            run["problem"] = ending.problem;
        for (const Figure& figure : ending.figures)
            run["figures"][figure.name.text()] = figure.value;
        runs.push_back(std::move(run));
    }

    void rank(const std::string& name, const std::string& label, const Ending& ending) {
        for (const Figure& figure : ending.figures) {
            figures.insert(figure.name.text());
            if (figure.name.text() == name)
                ranked.push_back({figure.value, label});
        }
    }
};

OutputOptions outputOf(const BatchItem& item, const BatchOptions& options, const OutputGuard& around) {
    OutputOptions out;
    out.output = item.output;
    out.maps = item.maps;
    out.depth = item.depth;
    out.space = item.space;
    out.report = item.report;
    out.noSidecar = !item.sidecar;
    out.threads = options.threads;
    out.overwrite = options.overwrite;
    out.around = &around;
    out.quiet = options.quiet;
    return out;
}

/// @throws Cancelled
Ending attempt(const BatchItem& item, const BatchOptions& options, const OutputGuard& around) {
    try {
        if (!item.problem.empty())
            throw Error(item.problem);
        if (item.join != nullptr) // what it may replace was checked before anything ran
            writeJoin(loadJoin(item), item.output, options.threads, options.quiet);
        else
            return {{}, runInput(loadAndWarn(item.whole()), outputOf(item, options, around))};
        return {};
    } catch (const std::exception& error) {
        return {messageOf(error).text()};
    }
}

bool skipped(const BatchItem& item, const BatchOptions& options) {
    std::error_code error;
    return options.skipExisting && fs::exists(item.output, error);
}

void runItem(std::size_t number, const BatchItem& item, const BatchOptions& options,
             const OutputGuard& around, Tally& tally) {
    checkInterrupt();
    if (skipped(item, options)) {
        ++tally.skipped;
        tally.add(number, item, "skipped");
        return;
    }
    const Ending ending = attempt(item, options, around);
    if (ending.problem.empty()) {
        ++tally.done;
        tally.add(number, item, "done", ending);
        tally.rank(options.rank, item.label(number), ending);
        return;
    }
    fmt::print(messages(), "texloom-cli: {}: {}\n", item.label(number), ending.problem);
    tally.failed.push_back(std::to_string(number));
    tally.add(number, item, "failed", ending);
}

void printItems(const Batch& batch, const Shard& shard) {
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (shard.holds(i)) {
            const BatchItem item = batch.item(i);
            fmt::print("{}: {}\n", item.label(i + 1), item.output.string());
        }
}

void writeSummary(const BatchOptions& options, const Tally& tally) {
    if (options.summary.empty())
        return;
    const Json json = {{"texloomReport", 1},       {"batch", options.file.string()},
                       {"shard", options.shard},   {"done", tally.done},
                       {"skipped", tally.skipped}, {"failed", tally.failed.size()},
                       {"runs", tally.runs}};
    writeText(options.summary, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// The runs by the figure that was asked for, the least first.
void printRanking(const BatchOptions& options, Tally& tally) {
    if (options.rank.empty())
        return;
    if (tally.ranked.empty())
        failUsage("No run that was made now has a figure \"{}\"; there are: {}.", options.rank,
                  tally.figures.empty() ? "none" : fmt::format("{}", fmt::join(tally.figures, ", ")));
    std::stable_sort(tally.ranked.begin(), tally.ranked.end(),
                     [](const Ranked& a, const Ranked& b) { return a.value < b.value; });
    for (const Ranked& run : tally.ranked)
        fmt::print("{} {:.6g}: {}\n", options.rank, run.value, run.label);
}

void announce(const BatchItem& item, OutputGuard& guard) {
    guard.writes(item.output, "result");
    for (const fs::path& map : item.maps)
        guard.writes(map, "position map");
    if (item.sidecar)
        guard.writes(fs::path(item.output).replace_extension(".json"), "recipe");
    if (!item.report.empty())
        guard.writes(item.report, "report");
}

/// Refuses before anything runs what would replace a file that any run reads, or one of others.
/// @return what the whole batch reads.
OutputGuard checkOutputs(const Batch& batch, const Shard& shard, const BatchOptions& options) {
    OutputGuard guard;
    guard.reads(options.file, "the batch itself");
    guard.reads(batch.recipes(), "a recipe of the batch");
    guard.reads(batch.sources(), "a source of the batch");
    if (!options.summary.empty())
        guard.writes(options.summary, "summary");
    for (std::size_t i = 0; i < batch.size(); ++i)
        if (shard.holds(i))
            if (const BatchItem item = batch.item(i); item.problem.empty() && !skipped(item, options))
                announce(item, guard);
    guard.check(options.overwrite);
    return guard;
}

void run(const BatchOptions& options) {
    const fs::path folder = options.file.has_parent_path() ? options.file.parent_path() : fs::path(".");
    const Batch batch = Batch::fromJson(readText(options.file), folder, options.outputs);
    const Shard shard = Shard::parse(options.shard);
    if (options.list) {
        printItems(batch, shard);
        return;
    }
    if (!options.summary.empty())
        checkFolder(options.summary);
    const OutputGuard around = checkOutputs(batch, shard, options);
    Tally tally;
    try {
        for (std::size_t i = 0; i < batch.size(); ++i)
            if (shard.holds(i))
                runItem(i + 1, batch.item(i), options, around, tally);
    } catch (const Cancelled&) {
        writeSummary(options, tally);
        throw;
    }
    writeSummary(options, tally);
    const std::string skipped = tally.skipped > 0 ? fmt::format(", {} skipped", tally.skipped) : "";
    if (!tally.failed.empty())
        fail("{} of {} runs failed: {}; {} done{}.", tally.failed.size(), tally.runs.size(),
             fmt::join(tally.failed, ", "), tally.done, skipped);
    if (!options.quiet)
        fmt::print("{} runs done{}.\n", tally.done, skipped);
    printRanking(options, tally);
}

} // namespace

void addBatch(CLI::App& app) {
    static BatchOptions options;
    CLI::App* command = app.add_subcommand("batch", "Run many recipes, sweeps included, or a shard of them");
    command->add_option("file", options.file, "JSON file with the runs; see README.md")->required();
    command->add_option("--shard", options.shard, "Make only every Nth run, beginning with the Ith, as I/N");
    command->add_option("--summary", options.summary, "JSON file that says how each run ended");
    command->add_option("--rank", options.rank,
                        "Name of a figure, such as Loss: lists the runs by it at the end, the least first");
    command->add_option("--to", options.outputs,
                        "Folder for outputs with relative names, rather than that of the batch");
    command->add_option("--threads", options.threads, "Number of threads; one per core if not given")
        ->check(CLI::Range(1, 1024));
    addMemory(*command);
    addReproducible(*command, true);
    command->add_flag("--list", options.list, "Only list the runs");
    command->add_flag("--skip-existing", options.skipExisting, "Leave out runs whose output is there");
    addOverwrite(*command, options.overwrite);
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { run(options); });
}

} // namespace texloom::cli
