#pragma once

#include "core/image/position_map.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texloom {

/// Writes a position map, in the format that the name asks for:
/// .exr, the STMap convention of compositors in float32: R = (x + 0.5) / W, G = 1 − (y + 0.5) / H with the
/// origin at the bottom left, B = exemplar (from 0), A = 1 where there is a source; .png, 16-bit RGB: exact x
/// and y from the top left, exemplar; 65535 = none.
/// @param recipe embedded in the file, or empty. @param check as in WriteOptions. @throws Error or UsageError
void writePositionMap(const std::filesystem::path& path, const PositionMap& map,
                      const std::string& recipe = {}, const std::function<void()>& check = {});

/// Reads what writePositionMap() wrote, or an STMap of another program.
/// @param exemplarSizes sizes of the images it will be applied to; used, and needed, when the file does not
/// say them. @param layer as ReadOptions::layer
/// @throws Error if it is no such file, addresses pixels outside the exemplars, or lies between pixels.
PositionMap readPositionMap(const std::filesystem::path& path, const std::vector<Size>& exemplarSizes = {},
                            const std::string& layer = {});

/// Reads an STMap whose places lie between pixels (see kStMapPort), such as an anamorphosis gives; nothing if
/// the file is none, so that readPositionMap() is for it. @param exemplarSizes of the images it will be
/// applied to. @throws Error if it cannot be read
std::optional<Image> readFractionalMap(const std::filesystem::path& path,
                                       const std::vector<Size>& exemplarSizes, const std::string& layer = {});

/// One sentence that states the convention of a map file, for sidecars.
std::string mapConvention(const std::filesystem::path& path);

} // namespace texloom
