#pragma once

#include "core/session/export/export_options.h"
#include "core/session/export/output_guard.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// Every file that a recipe is made from.
std::vector<std::filesystem::path> sourcesOf(const Recipe& recipe);

/// Tells a guard, before a plan is run, which files it reads and which an export of its result would write.
void announce(const RunPlan& plan, const ExportOptions& options, OutputGuard& guard);

/// The files that exportResult() would write, in order. @throws UsageError, also where one is a file that the
/// result was made from.
std::vector<ExportEntry> exportEntries(const Result& result, const ExportOptions& options);

/// The samples that files of whole numbers cut off: below 0 or above 1. @param check called for every row.
std::uint64_t clippedSamples(
    const ImageView& image, const std::function<void()>& check = [] {});

/// Writes a picture that was made from images like `source`: in that one's depth where the format holds it,
/// and as colours or data as that one is. @param check called for every row; what it throws leaves no file.
/// @throws Error, UsageError
void exportPicture(const std::filesystem::path& path, const ImageView& picture, const ExemplarFile& source,
                   const std::function<void()>& check = {});

/// Writes them; each whole or not at all. If one fails or `check` throws, files that this call made new are
/// removed.
/// @return the entries written. @throws Error, UsageError
std::vector<ExportEntry> exportResult(const Result& result, const ExportOptions& options);

/// Makes a plan with stripRows strip by strip and writes the image as it comes, so that it is never in memory
/// whole, and the recipe beside it. There are no position maps of such outputs, nor companion maps.
/// @param make runs one strip, as startRun() would. @return the plan with the time all strips took, and what
/// the first had to say. @throws what `make` throws, Error, UsageError
Result exportStrips(const RunPlan& plan, const ExportOptions& options,
                    const std::function<Result(RunPlan)>& make);

/// Recipe, timings by stage, peak memory, figures and curves as JSON: the command line's --report.
std::string reportJson(const Result& result, const std::filesystem::path& folder);

} // namespace texloom
