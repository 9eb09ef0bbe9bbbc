#pragma once

#include "core/image/position_map.h"
#include "core/methods/synthesis.h"
#include "core/session/run/exemplar_file.h"

#include <CLI/App.hpp>

#include <vector>

namespace texloom::cli {

/// Adds `analyze quality`: how closely a texture resembles its exemplars, and what its map says was copied.
void addAnalyzeQuality(CLI::App& analyze);

/// Writes figures to stdout, a line each, or as one JSON object.
void printFigures(const std::vector<Figure>& figures, bool asJson);
/// @throws UsageError if two images that are to be compared differ in channels.
void checkSameChannels(const ExemplarFile& result, const ExemplarFile& exemplar);
/// @throws Error if maps of a result and their figures would not fit into memory.
void checkMemoryForMaps(const ExemplarFile& result, const std::vector<ExemplarFile>& exemplars);
/// @throws UsageError if a map is not of a result's size.
void checkMapOf(const PositionMap& map, const ExemplarFile& result);

} // namespace texloom::cli
