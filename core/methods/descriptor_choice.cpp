#include "core/methods/descriptor_choice.h"

#include "core/base/error.h"
#include "core/network/descriptor_learning.h"
#include "core/network/filter_banks.h"

#include <algorithm>
#include <utility>

namespace texloom {

namespace {

/// Automatic resolved, without a file.
DescriptorChoice resolved(const Request& request, DescriptorChoice choice) {
    if (choice != DescriptorChoice::Automatic)
        return choice;
    const int channels = request.channels();
    return channels == 3 || channels == 1 ? DescriptorChoice::Own : DescriptorChoice::Exemplar;
}

std::shared_ptr<const Model> givenFile(const Request& request) {
    return request.inputs.first<Model>(kDescriptorPort);
}

/// The exemplar as a tensor with values from 0 to 1 in each channel.
Tensor unitTensor(const Image& image) {
    Tensor to(image.channels(), image.height(), image.width());
    for (int c = 0; c < image.channels(); ++c) {
        const ValueRange range = valueRange(image.view().channelRange(c, 1));
        const bool inside = range.smallest >= 0 && range.largest <= 1;
        const float low = inside ? 0 : range.smallest, span = inside ? 1 : range.largest - range.smallest;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                to.row(c, y)[x] = (image(x, y, c) - low) / span;
    }
    return to;
}

} // namespace

std::optional<Pooling> poolingOf(PoolingChoice choice) {
    if (choice == PoolingChoice::Own)
        return std::nullopt;
    return choice == PoolingChoice::Average ? Pooling::Average : Pooling::Maximum;
}

Port descriptorInput() {
    return {.id = std::string(kDescriptorPort),
            .title = TR("Descriptor"),
            .help = TR("A network of your own, such as one that import-descriptor or learn-descriptor made."),
            .kind = AssetKind::Model};
}

bool learnsDescriptor(const Request& request, DescriptorChoice choice) {
    return !givenFile(request) && resolved(request, choice) == DescriptorChoice::Exemplar;
}

void checkDescriptor(const Request& request, DescriptorChoice choice) {
    const auto file = givenFile(request);
    if (file && choice != DescriptorChoice::Automatic)
        failUsage(
            TR("A descriptor's file is given and another descriptor chosen: choose automatic, or leave the "
               "file out."));
    const int channels = request.channels();
    const int seen = file                                                 ? Descriptor::from(*file).channels
                     : resolved(request, choice) == DescriptorChoice::Own ? 3
                                                                          : channels;
    if (channels != seen && channels != 1)
        failUsage(
            TR("The descriptor sees {} channels, and the exemplar has {} with its maps: choose one that sees "
               "them all, such as exemplar, random or wavelet."),
            seen, channels);
}

Descriptor plannedDescriptor(const Request& request, DescriptorChoice choice) {
    if (const auto file = givenFile(request))
        return Descriptor::from(*file);
    switch (resolved(request, choice)) {
    case DescriptorChoice::Random:
        return randomDescriptor(request.channels());
    case DescriptorChoice::Wavelet:
        return waveletDescriptor(request.channels());
    case DescriptorChoice::Exemplar:
        return unlearnedDescriptor(quickLearning(), request.channels());
    default:
        return Descriptor::from(ownDescriptor());
    }
}

Descriptor chosenDescriptor(const Request& request, DescriptorChoice choice, JobContext& context) {
    if (!learnsDescriptor(request, choice))
        return plannedDescriptor(request, choice);
    std::vector<Tensor> pictures;
    for (const Exemplar& exemplar : request.exemplars) {
        context.check();
        pictures.push_back(unitTensor(*exemplar.image));
    }
    Descriptor descriptor = learnDescriptor(pictures, quickLearning(), context);
    descriptor.name = "exemplar";
    descriptor.licence = "as the exemplar's";
    descriptor.credit = "Learned from the exemplar";
    return descriptor;
}

Message descriptorNote(const Descriptor& descriptor) {
    return message(TR("Descriptor: {} (licence {}; {}; SHA-1 {})."), descriptor.name, descriptor.licence,
                   descriptor.credit, descriptor.model().hash());
}

} // namespace texloom
