#pragma once

#include "core/network/descriptor.h"

#include <filesystem>
#include <string>
#include <vector>

namespace texloom {

/// Which network a file of plain weights is read as.
struct WeightsImport {
    std::string name = {};                 ///< empty: the file's
    std::string licence = {}, credit = {}; ///< as far as the user knows them
    Pooling pooling = Pooling::Average;
    std::vector<std::string> taps = {}; ///< such as relu3_1; empty: the first of each group of layers
};

/// Makes a descriptor of the weights of a network of VGG's kind (Simonyan & Zisserman 2015): convolutions
/// conv1_1, conv1_2, conv2_1 …, each rectified, with a pool before each new group. The weights lie as 32-bit
/// floats in a .bin file, and a .json beside it says which are where (docs/descriptors.md). A convolution
/// called “pre” maps colours from 0 to 1 to what the network wants; without one it is BGR from 0 to 255 less
/// the mean of ImageNet's pictures.
/// @param json the .json; the .bin has its name but for the ending.
/// @throws Error in one sentence if either is missing, cut short, or not what it says, or a tap is not there.
Descriptor importWeights(const std::filesystem::path& json, const WeightsImport& how);

} // namespace texloom
