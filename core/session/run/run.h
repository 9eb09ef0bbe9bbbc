#pragma once

#include "core/analysis/texture_distance.h"
#include "core/io/recipe.h"
#include "core/job/job.h"
#include "core/methods/method.h"
#include "core/session/run/exemplar_file.h"
#include "core/session/run/input_file.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// The images that a run learns from, as they were loaded.
struct RunExemplar {
    ExemplarFile image;
    std::optional<ExemplarFile> mask;
    std::vector<ExemplarFile> companions; ///< of the exemplar's size; they get the result's layout
    InputFiles inputs = {};               ///< further pictures of the exemplar's size, by port
    /// What was done to the files' pixels to make the images here; see edited().
    ExemplarEdits edits = {};
    double weight = 1; ///< see Exemplar::weight
    /// The files as they were before the edits; null where there are none.
    std::shared_ptr<const RunExemplar> source = nullptr;

    /// What is edited: the files' own pixels.
    const RunExemplar& original() const { return source ? *source : *this; }
};

/// What someone asked for.
struct RunInput {
    /// The methods in order, at least one, with what was set; the rest gets defaults. Each takes up what the
    /// one before it made.
    std::vector<RecipeStep> steps = {{}};
    std::vector<RunExemplar> exemplars; ///< none where the methods learn from none
    InputFiles inputs; ///< what else goes into the methods' ports, such as an image to start from
    Size size;
    Wrap wrap;
    std::uint64_t seed = 0;
    std::optional<Region> region; ///< the part to make, which equals that part of the whole; all if not given
    int threads = 0;              ///< 0: one per core; changes the time and memory it takes, never the result
    bool judged = true;           ///< whether the result is compared with its exemplars: see Result::figures
};

/// One method of a run, with complete settings.
struct RunStep {
    const Method* method = nullptr;
    Values settings;
    Estimate estimate;
    int channels = 0; ///< of the image that it makes; a guess where a model that is still to be made says so
};

/// A run that was checked and can start: the methods in order, an immutable copy of the input, the recipe
/// that makes it again, and what it will need.
struct RunPlan {
    std::vector<RunStep> steps; ///< at least one
    Request request;            ///< with all inputs; companions are channels of it as companionUse() says
    std::vector<std::vector<ExemplarFile>> companions; ///< for each exemplar
    Recipe recipe;
    Estimate estimate; ///< of all steps together
    std::uint64_t memoryBefore =
        0; ///< resident bytes of this process when the run was planned; the estimate comes on top
    int threads = 0;
    /// Where the whole does not fit in memory, but the method makes regions: how many rows at a time do. Else
    /// 0.
    int stripRows = 0;
    bool judged = true;         ///< as RunInput::judged
    ImageFileInfo exemplarInfo; ///< of the first exemplar's file, if there is one
    std::vector<Message> notes; ///< how the files were taken, where someone should know

    const Method& lastMethod() const { return *steps.back().method; }
    /// The methods' ids with `separator` between them.
    std::string methodIds(const std::string& separator) const;
    /// What results are called after: the first exemplar, or else the recipe's name.
    std::string name() const;
    /// Channels of the result, without those of companion maps.
    int resultChannels() const { return steps.back().channels - request.companionChannels; }
    bool hasCompanions() const { return !companions.empty() && !companions.front().empty(); }
    /// What the method of one step is given: of the plan's request what it has ports for. @param info of that
    /// method, which may not be among `steps` yet. @param last whether none follows it: one that cannot wrap
    /// may still come before one that can.
    Request requestFor(std::size_t step, const MethodInfo& info, bool last = true) const;
    /// The same run for one strip of the output, from row `y` on. @param learned by the first strip: see
    /// learnedBy(); null for the first one itself.
    RunPlan strip(int y, const Assets* learned = nullptr) const;
};

/// The models that a method made and can be given again instead of learning anew.
Assets learnedBy(const MethodInfo& info, const Assets& made);

/// Checks everything before anything starts; a method whose check needs a close look at the exemplar may take
/// a moment. @throws Error or UsageError, also where the memory that the run
/// would need is more than `memoryLimit` bytes (0: what this machine has free).
/// @param strips whether an output that does not fit may be made in strips instead, as exportStrips() does.
RunPlan planRun(const RunInput& asked, std::uint64_t memoryLimit = 0, bool strips = false);

/// Checks that a plan made some time ago still fits in the memory that is free. @throws Error with the
/// figures
void checkMemory(const RunPlan& plan);

/// Loads one exemplar's files, without its edits. `changed` as in loadRecipe(). @param steps whose ports its
/// inputs go into; one for a port that none of the methods has is taken to be a picture.
/// @throws Error, UsageError
RunExemplar loadFiles(const RecipeExemplar& entry, const std::vector<RecipeStep>& steps,
                      const std::function<void(const std::filesystem::path&)>& changed = {});

/// The port of this id that one of the methods has: the first to have it. Only the first method of a run
/// can be given an image to start from.
/// @throws UsageError if there is none, or a method is not known.
const Port& portOf(const std::vector<RecipeStep>& steps, std::string_view id);

/// Loads what goes into the ports of a run's methods. `changed` as in loadRecipe(). @throws Error, UsageError
InputFiles loadInputs(const RecipeInputs& wanted, const std::vector<RecipeStep>& steps,
                      const std::vector<RunExemplar>& exemplars,
                      const std::function<void(const std::filesystem::path&)>& changed = {});

/// What recipes say of an exemplar.
RecipeExemplar recipeExemplar(const RunExemplar& exemplar);
RecipeFile recipeFile(const ExemplarFile& file);
RecipeInputs recipeInputs(const InputFiles& inputs);

/// Loads what a recipe names. `changed` is told of each file whose bytes are not those that the recipe was
/// made with.
/// @throws Error, UsageError
RunInput loadRecipe(const Recipe& recipe,
                    const std::function<void(const std::filesystem::path&)>& changed = {});

/// A finished run: everything that an export, a report or a history needs.
struct Result {
    RunPlan plan;
    Synthesis synthesis;           ///< its image without the companions' channels
    std::vector<Image> companions; ///< as they were made, where they do not follow from the map
    std::vector<Figure> figures;   ///< the method's, and the quality figures that every result gets
    std::vector<StageTime> stages;
    double seconds = 0; ///< of the methods' work, on plan.threads threads; judging the result is not in it
    /// Of a run that was stopped and kept: how far it had come, 0 to 1. Its image is as it was then.
    std::optional<double> stoppedAt = {};

    /// Companion map `index` of the plan's exemplars in the result's layout. There must be one, and either a
    /// map of the result or companions made with it.
    Image companion(std::size_t index) const;
    /// "quilting · seed 1 · 512 × 512"
    std::string label() const;
    /// "bark_quilting_s1_512x512": the name of an exported file, without its extension.
    std::string fileName() const;
};

/// Takes companion maps off a run that was stopped before there was a map to lay them out by.
/// @return whether there were any.
bool leaveOutCompanions(Result& result);

/// What a map says of a result, under the names that reports and the window show.
/// @param occurrences as occurrencesOf() gives them.
std::vector<Figure> mapFigures(const PositionMap& map, MapKind kind, const std::vector<Image>& occurrences,
                               const std::function<void()>& check);
/// How a result's pieces meet and whether one of them grew over all of it, under the names that reports and
/// the window show.
std::vector<Figure> pieceFigures(const ImageView& result, const std::vector<ImageView>& exemplars,
                                 const PositionMap& map, const std::vector<Image>& occurrences,
                                 const std::function<void()>& check);
/// How far contrast and layout were kept, under the names that reports and the window show.
/// @param exemplars with the result's channels. @param first of them, in which a lattice is looked for.
std::vector<Figure> layoutFigures(const ImageView& result, const std::vector<ImageView>& exemplars,
                                  const std::shared_ptr<const Image>& first,
                                  const std::function<void()>& check);
/// The distances under the names that reports and the window show.
std::vector<Figure> distanceFigures(const TextureDistance& distance);

using SynthesisJob = Job<Result>;

/// Runs a plan to its end: what startRun() does on the job's thread. @throws Error, Cancelled
Result runPlan(const RunPlan& plan, JobContext& context);

/// What becomes of a run's checkpoints, and the one that it goes on from.
struct Checkpoints {
    std::function<void(const Checkpoint&)> keep = {}; ///< see JobOptions::keep
    std::shared_ptr<const Checkpoint> resumed = nullptr;
};

/// Starts a planned run, with the plan's seed and threads.
/// @param previews whether anyone will look at them. @param onFinished called on the job's thread.
std::unique_ptr<SynthesisJob> startRun(RunPlan plan, bool previews, std::function<void()> onFinished = {},
                                       Checkpoints checkpoints = {});

} // namespace texloom
