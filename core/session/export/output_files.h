#pragma once

#include "core/session/run/asset_file.h"
#include "core/session/run/run.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texloom {

/// One of a result's further outputs, such as a model or a volume, and where it is to be written.
struct OutputFile {
    const Port* port;
    const Asset* asset; ///< the result's
    std::filesystem::path path;

    /// "Colour moments, 12 numbers, 48 B": what lists of files say of it.
    Message content() const;
};

/// The port that an output of a run comes from, that of the last method to have it; null if none has.
const Port* outputPort(const RunPlan& plan, std::string_view id);

/// The extension that files of an output have unless someone wants another: .exr of an STMap, else its
/// kind's.
std::string usualExtension(const Port& port);

/// Checks before a run that it gives this output and that the file's name suits it. @throws Error, UsageError
void checkOutput(const RunPlan& plan, const std::string& id, const std::filesystem::path& file);

/// The outputs to be written, one by one. @param wanted as in ExportOptions. @throws UsageError where the
/// result has no such output.
std::vector<OutputFile> outputFiles(const Result& result,
                                    const std::map<std::string, std::filesystem::path>& wanted);

/// What a result has that can go into a port: its picture, its position map, or the first of its outputs of
/// the port's kind, of which one with the port's own id comes first. Of a model, the port's id must be the
/// kind. None if it has no such thing. What is found keeps the result in memory.
std::optional<Asset> assetFor(const std::shared_ptr<const Result>& result, const Port& port);

/// How an output is exported: in the result's colours, with its recipe; an STMap as floats that nothing
/// converts. @param depth of pictures.
AssetWriteOptions outputOptions(const Result& result, const OutputFile& output, Depth depth = Depth::Bits8);

/// All further outputs as a list in JSON, with the SHA-1 of models, for reports.
std::string outputsReport(const Result& result);

} // namespace texloom
