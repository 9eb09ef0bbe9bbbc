#pragma once

#include "core/session/export/export_options.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace texloom {

/// One file to write and how; nothing where it is written with the one after it.
struct ExportStep {
    ExportEntry entry;
    std::function<void()> write;
};

/// NAME_SUFFIX.ext beside NAME.ext.
std::filesystem::path beside(const std::filesystem::path& image, const std::string& suffix,
                             const std::string& extension);

/// The files of the companion maps: those of the preset, then what it leaves over, each in a file like its
/// own; maps that came packed in one file are packed again. The steps refer to both arguments.
std::vector<ExportStep> companionSteps(const Result& result, const ExportOptions& options);

} // namespace texloom
