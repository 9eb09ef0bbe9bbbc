#pragma once

#include "core/network/descriptor.h"

#include <span>
#include <string>
#include <vector>

namespace texloom {

/// How a descriptor is learned.
struct LearningOptions {
    struct Layer {
        int outputs = 0;
        int side = 3;
    };
    std::vector<Layer> layers = {{48, 5}, {96, 3}, {128, 3}}; ///< between them feature maps are halved
    int patches = 20000; ///< of each layer's input that it is learned from
    int rounds = 8;      ///< of k-means
};

/// What a picture takes to be learned from in a moment, for a descriptor of one exemplar.
LearningOptions quickLearning();

/// Learns a network from pictures, layer by layer and without derivatives: of random patches of a layer's
/// input the directions are clustered once they are whitened (spherical k-means: Coates & Ng 2012); each
/// centre becomes a filter whose unit fires on three of ten patches, with a mean square of 1. All layers
/// are taps. Patches are drawn by context.random(), each picture as often as any other.
/// @param pictures with values from 0 to 1 and as many channels. @param context its progress is set.
Descriptor learnDescriptor(std::span<const Tensor> pictures, const LearningOptions& options,
                           JobContext& context);

/// The layers that learnDescriptor() will fill, all weights 0: for estimates.
Descriptor unlearnedDescriptor(const LearningOptions& options, int channels);

/// Rough seconds of it.
double learningSeconds(const LearningOptions& options, int channels);
/// Bytes that it takes beside feature maps.
std::uint64_t learningBytes(const LearningOptions& options, int channels);

} // namespace texloom
