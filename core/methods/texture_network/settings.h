#pragma once

#include "core/methods/descriptor_choice.h"
#include "core/methods/generator_loss.h"

namespace texloom::texture_network {

enum class LossChoice { Both, Gram, Patches };
/// What a sample in training finds beyond its edges: more of an endless texture, or its other end.
enum class PaddingChoice { None, Circular };

/// Parameters of training a generator for one exemplar (Ulyanov et al. 2016; Gutierrez 2020, section 4.1).
struct Settings {
    int iterations = 2000;
    bool further = false; ///< goes on training the generator that is given
    int exemplarSide = 128;
    int trainSize = 64; ///< side of the samples that are compared
    int batch = 1;      ///< samples in one iteration
    double rate = 0.01; ///< of Adam
    double decay = 0.8;
    int decayEvery = 0; ///< iterations after which the rate is multiplied by `decay`; 0: a tenth of all
    LossChoice loss = LossChoice::Both;
    DescriptorChoice descriptor = DescriptorChoice::Automatic;
    int levels = 0; ///< 0: as the descriptor says
    bool colours = true;
    Statistic statistic = Statistic::Normalised;
    PoolingChoice pooling = PoolingChoice::Own;
    bool evenGradients = false; ///< the gradient at each tap is scaled to an L1 norm of 1
    PaddingChoice padding = PaddingChoice::None;
    int coarsest = 5;      ///< K
    int step = 6;          ///< M_s
    int noiseChannels = 3; ///< M_i

    bool describes() const { return loss != LossChoice::Patches; }
    GeneratorLossOptions lossOptions(const Descriptor* used) const;
};

} // namespace texloom::texture_network
