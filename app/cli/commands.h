#pragma once

#include "core/analysis/lattice_candidate.h"
#include "core/session/export/output_guard.h"
#include "core/session/run/run.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texloom::cli {

/// Options that `synth` and `run` share.
struct OutputOptions {
    std::filesystem::path output;
    std::vector<std::filesystem::path> maps;
    std::vector<std::string> saves; ///< "NAME=FILE" for further outputs of the methods, such as a model
    std::string depth;              ///< "8", "16", "half", "float", or empty for the exemplar's
    std::string space;              ///< of the output, or empty for what the format's users expect
    std::string exportPreset;       ///< id or file; empty: maps are written as they came
    std::filesystem::path report;
    int threads = 0;
    bool overwrite = false;              ///< whether files that Texloom did not write may be replaced
    const OutputGuard* around = nullptr; ///< of what the call reads beside the recipe's files
    bool noSidecar = false;
    bool resume = false; ///< go on from the checkpoint beside the output, if there is one
    bool quiet = false;
};

struct SynthOptions {
    std::string method;            ///< or a preset
    std::string preset;            ///< of the method: "published" for METHOD-published; empty for none
    std::vector<std::string> then; ///< methods that follow
    std::vector<std::filesystem::path> exemplars;
    std::string exemplarSpace;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::optional<Size> size;        ///< twice the exemplar, or the initial image's size, if not given
    std::uint64_t seed = 0;
    std::vector<std::string> settings; ///< "name=value", or "method.name=value" for one that follows
    Wrap wrap;
    std::optional<Region> region; ///< all of the output if not given
    std::vector<std::string>
        edits; ///< of the exemplars: "tool=value name=value", perhaps with "2:" before it
    std::vector<std::filesystem::path> companions;
    std::vector<std::filesystem::path> masks;
    std::vector<double> weights;                  ///< of the exemplars, in order; empty: all alike
    std::optional<std::filesystem::path> initial; ///< the input `initial` by its short name
    std::vector<std::string> inputs;              ///< "NAME=FILE" for further ports of the methods
    OutputOptions out;
};

struct RunOptions {
    std::filesystem::path recipe;
    OutputOptions out;
};

struct ApplyOptions {
    std::filesystem::path map;
    std::vector<std::filesystem::path> exemplars;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::filesystem::path output;
    bool overwrite = false;
    bool quiet = false;
};

struct LatticeOptions {
    std::filesystem::path exemplar;
    std::string exemplarSpace;
    std::vector<std::string> layers; ///< as LayerChoice takes them
    std::filesystem::path picture;   ///< file for the autocorrelation, or empty
    LatticeCriteria criteria;
    bool overwrite = false;
    bool json = false;
};

struct StressOptions {
    SynthOptions synth;
    int rounds = 5;
};

/// Runs an input to the end and writes what was asked for. @return the method's figures, none for an output
/// that is made in strips. @throws Error, UsageError, Cancelled
std::vector<Figure> runInput(RunInput input, const OutputOptions& out);
/// loadRecipe() that tells of files that have changed, and of another build that made the recipe.
RunInput loadAndWarn(const Recipe& recipe);
/// Checks that one command's only output replaces nothing that it reads, nor a file of others.
/// @throws UsageError
void checkOnlyOutput(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& output,
                     bool overwrite);

/// What the options of `synth` ask for, with its images loaded. @throws Error, UsageError
RunInput inputFor(const SynthOptions& options);
/// Runs a plan with a progress bar. @throws Error, Cancelled
Result runToEnd(RunPlan plan, bool quiet);

/// Each does one command. @throws Error, UsageError, Cancelled
void listMethods(const std::string& id, bool json);
void listTools(const std::string& id, bool json);
void synth(const SynthOptions& options);
void runRecipe(const RunOptions& options);
void applyMap(const ApplyOptions& options);
void printLattice(const LatticeOptions& options);
void stress(const StressOptions& options);

} // namespace texloom::cli
