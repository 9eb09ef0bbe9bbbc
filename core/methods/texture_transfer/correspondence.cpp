#include "core/methods/texture_transfer/correspondence.h"

#include "core/base/error.h"
#include "core/image/channel_text.h"
#include "core/math/zoom.h"

#include <array>
#include <cmath>

namespace texloom::texture_transfer {

namespace {

bool isGiven(const Request& request) {
    return request.exemplars.front().inputs.image(kCorrespondence) != nullptr;
}

/// One channel: Rec. 709's weights of three channels, or the mean of what there is.
Image luminance(const ImageView& image) {
    constexpr std::array<float, 3> kWeights{0.2126F, 0.7152F, 0.0722F};
    const bool colours = image.channels >= 3;
    const int channels = colours ? 3 : image.channels;
    Image grey(image.size(), 1);
    for (int c = 0; c < channels; ++c) {
        const float weight =
            colours ? kWeights.at(static_cast<std::size_t>(c)) : 1.0F / static_cast<float>(channels);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                grey(x, y, 0) += weight * image(x, y, c);
    }
    return grey;
}

/// Mean and standard deviation of all pixels of some images together.
struct Tones {
    double mean = 0, deviation = 0;
};

Tones tonesOf(std::span<const Image> images) {
    double count = 0, sum = 0, squares = 0;
    for (const Image& image : images) {
        count += static_cast<double>(image.size().area());
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const double value = image(x, y, 0);
                sum += value;
                squares += value * value;
            }
    }
    const double mean = sum / count;
    return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

/// Shifts and stretches the values of `image` so that its tones become `wanted`.
void matchTones(Image& image, const Tones& wanted) {
    const Tones own = tonesOf({&image, 1});
    const double stretch = own.deviation > 0 ? wanted.deviation / own.deviation : 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image(x, y, 0) = static_cast<float>(wanted.mean + stretch * (image(x, y, 0) - own.mean));
}

} // namespace

Correspondence::Correspondence(const Request& request, const Settings& settings, JobContext& context) {
    m_target = *request.inputs.image(kTarget);
    if (isGiven(request)) {
        for (const Exemplar& exemplar : request.exemplars)
            m_exemplars.push_back(*exemplar.inputs.image(kCorrespondence));
        return;
    }
    const auto check = [&context] { context.check(); };
    const auto compared = [&](const ImageView& image, Wrap wrap) {
        Image grey = luminance(image);
        return settings.blur > 0 ? blurred(grey, settings.blur, wrap, check) : std::move(grey);
    };
    for (const Exemplar& exemplar : request.exemplars)
        m_made.push_back(compared(exemplar.image->view().channelRange(0, request.resultChannels()), {}));
    const Tones wanted = tonesOf(m_made);
    m_made.push_back(compared(m_target, request.wrap));
    if (settings.matchTones)
        matchTones(m_made.back(), wanted);
    m_exemplars.assign(m_made.begin(), m_made.end() - 1);
    m_target = m_made.back();
}

std::uint64_t Correspondence::bytesFor(const Request& request) {
    std::uint64_t bytes = 3 * Image::bytesFor(request.size, 1);
    for (const Size& size : request.exemplarSizes())
        bytes += 3 * Image::bytesFor(size, 1);
    return bytes;
}

int correspondenceChannels(const Request& request) {
    return isGiven(request) ? request.inputs.image(kTarget)->channels() : 1;
}

void checkCorrespondence(const Request& request) {
    const bool given = isGiven(request);
    for (const Exemplar& exemplar : request.exemplars)
        if ((exemplar.inputs.image(kCorrespondence) != nullptr) != given)
            failUsage("{} has no picture that corresponds to the target, but another exemplar has; give one "
                      "for each or for none.",
                      given ? exemplar.name : request.exemplars.front().name);
    if (!given)
        return;
    const int wanted = request.inputs.image(kTarget)->channels();
    for (const Exemplar& exemplar : request.exemplars)
        if (const int channels = exemplar.inputs.image(kCorrespondence)->channels(); channels != wanted)
            failUsage("The target has {}, but the picture that corresponds to it for {} has {}; they "
                      "are compared channel by channel, so give pictures of one kind.",
                      channelText(wanted), exemplar.name, channels);
}

} // namespace texloom::texture_transfer
