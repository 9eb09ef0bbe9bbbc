#include "app/cli/batch_command.h"

#include "app/cli/commands.h"
#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/io/image_file.h"
#include "core/session/batch/batch.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace texloom::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct BatchOptions {
    fs::path file;
    std::string shard = "1/1";
    fs::path summary;
    int threads = 0;
    int memory = 0;
    bool list = false;
    bool skipExisting = false;
    bool quiet = false;
};

/// How the runs of a batch ended.
struct Tally {
    Json runs = Json::array();
    std::vector<std::string> failed;
    int done = 0;
    int skipped = 0;

    void add(std::size_t number, const BatchItem& item, const char* status, const std::string& problem = {}) {
        Json run = {{"run", number}, {"output", item.output.string()}, {"status", status}};
        if (!item.cell.empty())
            run["cell"] = item.cell;
        if (!problem.empty())
            run["problem"] = problem;
        runs.push_back(std::move(run));
    }
};

OutputOptions outputOf(const BatchItem& item, const BatchOptions& options) {
    OutputOptions out;
    out.output = item.output;
    out.maps = item.maps;
    out.depth = item.depth;
    out.space = item.space;
    out.report = item.report;
    out.noSidecar = !item.sidecar;
    out.threads = options.threads;
    out.memory = options.memory;
    out.quiet = options.quiet;
    return out;
}

/// @return why it failed, or an empty text. @throws Cancelled
std::string attempt(const BatchItem& item, const BatchOptions& options) {
    try {
        if (!item.problem.empty())
            throw Error(item.problem);
        runInput(loadAndWarn(item.recipe), outputOf(item, options));
        return {};
    } catch (const std::exception& error) {
        return messageOf(error).text();
    }
}

void runItem(std::size_t number, const BatchItem& item, const BatchOptions& options, Tally& tally) {
    checkInterrupt();
    std::error_code error;
    if (options.skipExisting && fs::exists(item.output, error)) {
        ++tally.skipped;
        tally.add(number, item, "skipped");
        return;
    }
    const std::string problem = attempt(item, options);
    if (problem.empty()) {
        ++tally.done;
        tally.add(number, item, "done");
        return;
    }
    fmt::print(messages(), "texloom-cli: {}: {}\n", item.label(number), problem);
    tally.failed.push_back(std::to_string(number));
    tally.add(number, item, "failed", problem);
}

void printItems(const Batch& batch, const Shard& shard) {
    for (std::size_t i = 0; i < batch.items.size(); ++i)
        if (shard.holds(i))
            fmt::print("{}: {}\n", batch.items[i].label(i + 1), batch.items[i].output.string());
}

void writeSummary(const BatchOptions& options, const Tally& tally) {
    if (options.summary.empty())
        return;
    const Json json = {
        {"batch", options.file.string()}, {"shard", options.shard},        {"done", tally.done},
        {"skipped", tally.skipped},       {"failed", tally.failed.size()}, {"runs", tally.runs}};
    writeText(options.summary, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

void run(const BatchOptions& options) {
    const fs::path folder = options.file.has_parent_path() ? options.file.parent_path() : fs::path(".");
    const Batch batch = Batch::fromJson(readText(options.file), folder);
    const Shard shard = Shard::parse(options.shard);
    if (options.list) {
        printItems(batch, shard);
        return;
    }
    if (!options.summary.empty())
        checkFolder(options.summary);
    Tally tally;
    try {
        for (std::size_t i = 0; i < batch.items.size(); ++i)
            if (shard.holds(i))
                runItem(i + 1, batch.items[i], options, tally);
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
}

} // namespace

void addBatch(CLI::App& app) {
    static BatchOptions options;
    CLI::App* command = app.add_subcommand("batch", "Run many recipes, sweeps included, or a shard of them");
    command->add_option("file", options.file, "JSON file with the runs; see README.md")->required();
    command->add_option("--shard", options.shard, "Make only every Nth run, beginning with the Ith, as I/N");
    command->add_option("--summary", options.summary, "JSON file that says how each run ended");
    command->add_option("--threads", options.threads, "Number of threads; one per core if not given")
        ->check(CLI::Range(1, 1024));
    command
        ->add_option("--memory", options.memory,
                     "Most memory in MiB that a run may take; what is free if not given")
        ->check(CLI::Range(1, 1 << 24));
    command->add_flag("--list", options.list, "Only list the runs");
    command->add_flag("--skip-existing", options.skipExisting, "Leave out runs whose output is there");
    command->add_flag("--quiet", options.quiet, "Print nothing but errors");
    command->callback([] { run(options); });
}

} // namespace texloom::cli
