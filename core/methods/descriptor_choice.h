#pragma once

#include "core/methods/method.h"
#include "core/network/descriptor.h"
#include "core/network/texture_loss.h"

#include <optional>
#include <string>

namespace texloom {

/// What methods that compare textures by a network's feature maps have in common: which network that is.
enum class DescriptorChoice {
    Automatic, ///< the file that is given; else Own for colours and grey, Exemplar for other channels
    Own,
    Exemplar,
    Random,
    Wavelet,
};

/// How its feature maps are halved.
enum class PoolingChoice { Own, Average, Maximum };
/// None: as the descriptor says.
std::optional<Pooling> poolingOf(PoolingChoice choice);

/// The port that takes a descriptor.
Port descriptorInput();

template <class Settings> Param descriptorField(DescriptorChoice Settings::*member) {
    return field(member, "descriptor", TR("Descriptor"))
        .choices({{"automatic", TR("Automatic")},
                  {"own", TR("Texloom's own")},
                  {"exemplar", TR("Learned from the exemplar")},
                  {"random", TR("Random filters")},
                  {"wavelet", TR("Wavelets")}})
        .help(TR(
            "The network whose feature maps are compared: the file that is given, else Texloom's own; "
            "maps beside colours need one that sees them: learned from the exemplar, random or wavelets."));
}

template <class Settings> Param networkLevelsField(int Settings::*member) {
    return field(member, "levels", TR("Levels"))
        .range(0, 4)
        .help(
            TR("How many sizes of the picture, each half the one before, the network sees at once: more hold "
               "larger structures together; 0 leaves it to the descriptor."));
}

template <class Settings> Param coloursField(bool Settings::*member) {
    return field(member, "colours", TR("Compare colours"))
        .help(TR("Also compares the distribution of colours, which networks alone let drift."));
}

template <class Settings> Param statisticField(Statistic Settings::*member) {
    return field(member, "statistic", TR("Statistic"))
        .choices({{"normalised", TR("Normalised")}, {"gram", TR("Gram")}, {"relative", TR("Relative Gram")}})
        .group(TR("Advanced"))
        .help(TR("What is compared of the feature maps: their moments once each has the exemplar's mean and "
                 "deviation, their Gram matrices as published, or these relative to the exemplar's."));
}

template <class Settings> Param poolingField(PoolingChoice Settings::*member) {
    return field(member, "pooling", TR("Pooling"))
        .choices(
            {{"own", TR("As the descriptor says")}, {"average", TR("Average")}, {"maximum", TR("Maximum")}})
        .group(TR("Advanced"))
        .help(
            TR("How the network halves its feature maps: by their mean, or by the largest of four values."));
}

/// Checks that the choice suits the request's channels and that a file that is given is not left unused.
/// @throws UsageError or Error
void checkDescriptor(const Request& request, DescriptorChoice choice);

/// The descriptor as far as it is there before the exemplar was learned from: of one that is yet to be
/// learned, the layers without their weights, for estimates.
Descriptor plannedDescriptor(const Request& request, DescriptorChoice choice);
/// Whether it is learned from the exemplar.
bool learnsDescriptor(const Request& request, DescriptorChoice choice);

/// The descriptor, learned if need be.
Descriptor chosenDescriptor(const Request& request, DescriptorChoice choice, JobContext& context);

/// What the user is told of it: its name, licence and hash.
Message descriptorNote(const Descriptor& descriptor);

} // namespace texloom
