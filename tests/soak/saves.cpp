// Saves what the window saves, to be killed while it does:
//   soak_saves save FOLDER SEED    a session with its pictures, a result, a copy for recovery
//   soak_saves check FOLDER        ends with 1, and says why, unless all that is there can be read again

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/decoder_process.h"
#include "core/session/results/result_files.h"
#include "core/session/run/run.h"
#include "core/session/session.h"
#include "tests/support/textures.h"

#include <cstdio>
#include <string_view>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

Result made(const fs::path& folder, std::uint64_t seed) {
    const fs::path bark = folder / "bark.png";
    if (!fs::exists(bark))
        writeImage(bark, blobs({48, 44}, 3), {});
    RunInput input;
    input.steps.front() = {"quilting", {{"patch", 12}}};
    input.exemplars.push_back({loadExemplar(bark), {}, {}});
    input.size = {64, 60};
    input.seed = seed;
    Outcome<Result> outcome = startRun(planRun(input), false)->take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        throw Error(failure->message);
    return std::get<Result>(std::move(outcome));
}

void save(const fs::path& folder, std::uint64_t seed) {
    const Result result = made(folder, seed);
    Session session;
    session.settings = result.plan.recipe;
    session.used = {true};
    writeSession(folder / "recovery.texloom", session);
    packSession(folder / "work.texloom", session);
    ResultFolder(folder / "results").write(entryFor(result, false), result);
}

/// Counts the results, which must all be whole.
std::size_t check(const fs::path& folder) {
    for (const char* name : {"recovery.texloom", "work.texloom"})
        if (fs::exists(folder / name))
            if (const SessionFiles files = checkFiles(readSession(folder / name));
                !files.missing.empty() || !files.changed.empty())
                fail("{} misses files, or has others.", name);
    const ResultFolder results(folder / "results");
    const ResultFolder::Scan scan = results.scan();
    if (!scan.problems.empty())
        throw Error(scan.problems.front());
    for (const ResultEntry& entry : scan.entries)
        if (const StoredResult stored = results.read(entry); !stored.problem.empty())
            throw Error(stored.problem);
    return scan.entries.size();
}

} // namespace

} // namespace texloom::test

int main(int argc, char** argv) {
    using namespace texloom;
    DecoderProcess::start();
    const std::string_view what = argc > 1 ? argv[1] : "";
    std::uint64_t seed = 0;
    try {
        if (what == "save" && argc == 4 && parseUnsigned(argv[3], seed))
            test::save(argv[2], seed);
        else if (what == "check" && argc == 3)
            std::printf("%zu\n", test::check(argv[2]));
        else
            failUsage("Call it as save FOLDER SEED, or check FOLDER.");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "soak_saves: %s\n", messageOf(error).text().c_str());
        return 1;
    }
}
