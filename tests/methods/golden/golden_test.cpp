// The bits of every method's results, so that work on shared code is known to change none of them.
//
// hashes.tsv holds them: for each method and exemplar one hash of a run that ends at the borders and one of a
// run that wraps, with each of two seeds, and one of a run from all that a method may take. "-" stands for
// what the method refuses. Where a result is meant to change, put the line that the test prints in the
// table's place and say in the commit why it changed.

#include "core/base/error.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/session/run/exemplar_file.h"
#include "tests/methods/every_method.h"
#include "tests/methods/golden/rounding.h"
#include "tests/methods/made_up_ports.h"
#include "tests/methods/process_memory.h"
#include "tests/support/textures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace texloom::test {
namespace {

constexpr Size kExemplar{96, 88};
constexpr Size kOutput{112, 100};
constexpr const char* kTable = TEXLOOM_SOURCE_DIR "/tests/methods/golden/hashes.tsv";

std::shared_ptr<const Image> shared(Image image) {
    return std::make_shared<const Image>(std::move(image));
}

/// Part of a bundled picture, as its file has it: colour conversion would bring in another library's
/// rounding.
std::shared_ptr<const Image> partOf(const char* file) {
    const auto whole = loadData(bundled(file)).image;
    return shared(Image(whole->view().crop(40, 60, kExemplar)));
}

const std::map<std::string, std::shared_ptr<const Image>>& exemplars() {
    static const std::map<std::string, std::shared_ptr<const Image>> all = {
        {"blobs", shared(blobs(kExemplar, 3))},
        {"bricks", partOf("brick_pavement_gray.png")},
        {"paving", partOf("crazy_paving.png")},
        {"ripples", partOf("sand_ripples.png")},
    };
    return all;
}

Request requestFor(const std::string& exemplar, bool wraps, std::uint64_t seed) {
    Request request;
    request.exemplars.push_back({exemplar, exemplars().at(exemplar)});
    request.size = kOutput;
    request.wrap = {wraps, wraps};
    request.seed = seed;
    return request;
}

std::uint64_t hashOf(const Synthesis& synthesis) {
    Hash hash;
    const Image& image = synthesis.image;
    for (int c = 0; c < image.channels(); ++c)
        for (int y = 0; y < image.height(); ++y)
            hash.addAll(
                std::span<const float>(image.plane(c).row(y), static_cast<std::size_t>(image.width())));
    for (int y = 0; y < synthesis.map.height(); ++y)
        hash.addAll(std::span<const Source>(&synthesis.map.at(0, y),
                                            static_cast<std::size_t>(synthesis.map.width())));
    return hash.value();
}

/// The defaults, but with no more than two iterations: a changed bit shows in the first.
Values briefSettings(const Method& method) {
    Values settings = method.resolved({}, kExemplar);
    for (auto& [name, value] : settings)
        if (name.ends_with("iterations"))
            value = std::min(std::get<int>(value), 2);
    return settings;
}

/// The hash of what the method makes, or "-" where it refuses.
std::string made(const Method& method, Request request) {
    fillPorts(method.info(), request);
    const Values settings = briefSettings(method);
    try {
        method.check(request, settings);
    } catch (const UsageError&) {
        return "-";
    }
    Job<Synthesis> job({request.seed, 0, false},
                       [&](JobContext& context) { return method.run(request, settings, context); });
    Outcome<Synthesis> outcome = job.take();
    if (const auto* failure = std::get_if<Failure>(&outcome))
        return "failed: " + failure->message.text();
    return fmt::format("{:016x}", hashOf(std::get<Synthesis>(outcome)));
}

/// A line of the table: what the method makes of each request.
std::string lineFor(const Method& method, const std::string& exemplar, const std::vector<Request>& requests) {
    std::string line = method.id() + "\t" + exemplar;
    for (const Request& request : requests)
        line += fmt::format("\t{}", made(method, request));
    return line;
}

/// To the borders and closed on itself, with each of two seeds.
std::vector<Request> plainRequests(const std::string& exemplar) {
    return {requestFor(exemplar, false, 1), requestFor(exemplar, false, 2), requestFor(exemplar, true, 1),
            requestFor(exemplar, true, 2)};
}

/// With a mask, with two exemplars of different weight, and from an initial image.
std::vector<Request> fullerRequests() {
    Request masked = requestFor("blobs", false, 3), several = masked, initial = masked;
    Image mask = constant(kExemplar, 1, 1);
    for (int y = 60; y < kExemplar.height; ++y)
        for (int x = 0; x < 30; ++x)
            mask(x, y, 0) = 0;
    masked.exemplars.front().inputs.set(kMaskPort, shared(std::move(mask)));
    several.exemplars.push_back({"paving", exemplars().at("paving")});
    several.exemplars.back().weight = 3;
    initial.inputs.set(kInitialPort, shared(blobs(kOutput, 3, 9)));
    return {masked, several, initial};
}

/// The table's lines by method and exemplar, and how the machine that it was made on rounds.
struct Table {
    std::string rounding;
    std::map<std::string, std::string> lines;
};

Table readTable() {
    Table table;
    std::ifstream file(kTable);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string first, second;
        words >> first >> second;
        if (first == "rounding")
            table.rounding = second;
        else if (!line.empty() && !line.starts_with('#'))
            table.lines[fmt::format("{}\t{}", first, second)] = line;
    }
    return table;
}

const Table& table() {
    static const Table read = readTable();
    return read;
}

class Golden : public testing::TestWithParam<std::string> {
protected:
    static void compare(const std::string& line) {
        const std::string key = line.substr(0, line.find('\t', line.find('\t') + 1));
        const auto known = table().lines.find(key);
        if (known == table().lines.end())
            ADD_FAILURE() << "add this line to " << kTable << ":\n" << line;
        else
            EXPECT_EQ(known->second, line);
    }
};

TEST_P(Golden, resultsHaveTheBitsThatTheyHad) {
    if (kSanitized)
        GTEST_SKIP() << "skipped: a sanitizer finds nothing here that it does not find elsewhere sooner";
    const std::string rounding = fmt::format("{:016x}", roundingOfThisMachine());
    if (table().rounding != rounding)
        GTEST_SKIP()
            << "skipped: this machine rounds otherwise (" << rounding
            << ") than the one that the table was made on; to compare two builds here, write this number "
               "in the table and take the lines that the first build prints";
    const Method& method = findMethod(GetParam());
    for (const auto& [exemplar, image] : exemplars())
        compare(lineFor(method, exemplar, plainRequests(exemplar)));
    compare(lineFor(method, "more", fullerRequests()));
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, Golden, testing::ValuesIn(everyMethod()), testName);

} // namespace
} // namespace texloom::test
