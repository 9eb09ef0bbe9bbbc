#pragma once

#include "core/methods/method.h"
#include "core/network/descriptor.h"

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
