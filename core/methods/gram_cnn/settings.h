#pragma once

#include "core/methods/descriptor_choice.h"
#include "core/network/texture_loss.h"

namespace texloom::gram_cnn {

enum class Optimiser { Lbfgs, Adam };

/// Parameters of optimising an image on a network's second moments (Gatys, Ecker & Bethge 2015).
struct Settings {
    DescriptorChoice descriptor = DescriptorChoice::Automatic;
    int scales = 4;      ///< from coarse to fine, at most
    int iterations = 50; ///< at each scale
    int levels = 0;      ///< of the picture's pyramid on which the descriptor is used; 0: as it says
    Statistic statistic = Statistic::Normalised;
    PoolingChoice pooling = PoolingChoice::Own;
    int firstTap = 1;
    int lastTap = 16;
    Optimiser optimiser = Optimiser::Lbfgs;
    double rate = 0.05; ///< of Adam
    bool colours = true;
    bool histogram = true;
    double variation = 0;

    TextureLossOptions lossOptions(const Descriptor& used) const;
};

} // namespace texloom::gram_cnn
