#include "core/network/descriptor.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace texloom {

namespace {

/// Beyond these a file is refused: no network for textures is as large.
constexpr int kMostSteps = 256, kMostChannels = 4096, kLargestSide = 63, kMostLevels = 6;

[[noreturn]] void refuse(const Message& why) {
    fail(TR("The descriptor cannot be used: {}."), why);
}

const std::string& note(const Model& model, const std::string& name) {
    const auto found = model.notes.find(name);
    if (found == model.notes.end())
        refuse(message(TR("its head lacks “{}”"), name));
    return found->second;
}

double numberNote(const Model& model, const std::string& name, double smallest, double largest) {
    double number = 0;
    if (!parseNumber(note(model, name), number) || !(number >= smallest && number <= largest))
        refuse(message(TR("“{}” of its head is no number from {} to {}"), name, numberText(smallest),
                       numberText(largest)));
    return number;
}

/// The weights of a convolution whose input has so many channels.
Filters filtersFrom(const Model& model, const std::string& name, int inputs) {
    const auto found = model.arrays.find(name + ".weight");
    if (found == model.arrays.end())
        refuse(message(TR("there are no weights for its layer {}"), name));
    const ModelArray::Shape& shape = found->second.shape;
    if (shape.size() != 4 || shape[0] < 1 || shape[0] > kMostChannels || shape[1] != inputs ||
        shape[2] != shape[3] || shape[2] < 1 || shape[2] > kLargestSide || shape[2] % 2 == 0)
        refuse(message(TR("the weights of its layer {} do not fit {} channels and a square of odd side"),
                       name, inputs));
    Filters filters;
    filters.outputs = static_cast<int>(shape[0]);
    filters.inputs = inputs;
    filters.side = static_cast<int>(shape[2]);
    filters.weights = model.values<float>(name + ".weight", shape);
    filters.bias = model.values<float>(name + ".bias", {shape[0]});
    return filters;
}

/// Reads the words of the head's “network”, and what they name.
class Reader {
public:
    Reader(const Model& model, Descriptor& to) : m_model(model), m_to(to) {}

    void read() {
        begin();
        std::istringstream words(note(m_model, "network"));
        int steps = 0;
        for (std::string word; words >> word;) {
            if (++steps > kMostSteps)
                refuse(message(TR("its network has more than {} steps"), kMostSteps));
            take(word);
        }
        end();
    }

private:
    void begin() {
        m_to.chains.emplace_back();
        m_channels = m_to.channels;
        m_endsInTap = false;
    }

    void end() const {
        if (!m_endsInTap)
            refuse(TR("a chain of its network does not end in a tap"));
    }

    void take(const std::string& word) {
        if (word == "|") {
            end();
            return begin();
        }
        const std::size_t colon = word.find(':');
        const std::string kind = word.substr(0, colon);
        const std::string name = colon == std::string::npos ? "" : word.substr(colon + 1);
        DescriptorLayer layer;
        layer.name = name;
        if (kind == "conv" && !name.empty() && m_convolutions.insert(name).second) {
            layer.filters = filtersFrom(m_model, name, m_channels);
            m_channels = layer.filters.outputs;
        } else if (word == "relu")
            layer.kind = DescriptorLayer::Kind::Rectifier;
        else if (word == "pool")
            layer.kind = DescriptorLayer::Kind::Pool;
        else if (kind == "tap" && !name.empty() && !m_to.chains.back().empty() && m_taps.insert(name).second)
            layer.kind = DescriptorLayer::Kind::Tap;
        else
            refuse(message(TR("“{}” in its network means nothing there"), word.substr(0, 40)));
        m_endsInTap = layer.kind == DescriptorLayer::Kind::Tap;
        m_to.chains.back().push_back(std::move(layer));
    }

    const Model& m_model;
    Descriptor& m_to;
    int m_channels = 0;
    bool m_endsInTap = false;
    std::set<std::string> m_convolutions, m_taps; ///< no name comes twice
};

} // namespace

std::vector<std::string> Descriptor::taps() const {
    std::vector<std::string> names;
    for (const auto& chain : chains)
        for (const DescriptorLayer& layer : chain)
            if (layer.kind == DescriptorLayer::Kind::Tap)
                names.push_back(layer.name);
    return names;
}

std::size_t Descriptor::parameters() const {
    std::size_t count = 0;
    for (const auto& chain : chains)
        for (const DescriptorLayer& layer : chain)
            count += layer.filters.weights.size() + layer.filters.bias.size();
    return count;
}

Model Descriptor::model() const {
    Model to;
    to.kind = kDescriptorPort;
    to.notes = {{"name", name},
                {"licence", licence},
                {"credit", credit},
                {"channels", std::to_string(channels)},
                {"offset", numberText(static_cast<double>(offset))},
                {"scale", numberText(static_cast<double>(scale))},
                {"pooling", pooling == Pooling::Average ? "average" : "maximum"},
                {"levels", std::to_string(levels)}};
    std::string network;
    for (const auto& chain : chains) {
        network += network.empty() ? "" : " |";
        for (const DescriptorLayer& layer : chain) {
            network += network.empty() ? "" : " ";
            switch (layer.kind) {
            case DescriptorLayer::Kind::Convolution: {
                network += "conv:" + layer.name;
                const Filters& filters = layer.filters;
                to.arrays[layer.name + ".weight"] = {
                    {filters.outputs, filters.inputs, filters.side, filters.side}, filters.weights};
                to.arrays[layer.name + ".bias"] = {{filters.outputs}, filters.bias};
                break;
            }
            case DescriptorLayer::Kind::Rectifier:
                network += "relu";
                break;
            case DescriptorLayer::Kind::Pool:
                network += "pool";
                break;
            case DescriptorLayer::Kind::Tap:
                network += "tap:" + layer.name;
                break;
            }
        }
    }
    to.notes["network"] = network;
    return to;
}

Descriptor Descriptor::from(const Model& model) {
    model.checkKind(kDescriptorPort);
    Descriptor to;
    to.name = note(model, "name");
    to.licence = note(model, "licence");
    to.credit = note(model, "credit");
    to.channels = static_cast<int>(numberNote(model, "channels", 1, kMostChannels));
    to.offset = static_cast<float>(numberNote(model, "offset", -1e6, 1e6));
    to.scale = static_cast<float>(numberNote(model, "scale", 1e-6, 1e6));
    to.levels = static_cast<int>(numberNote(model, "levels", 1, kMostLevels));
    const std::string& pooling = note(model, "pooling");
    if (pooling != "average" && pooling != "maximum")
        refuse(TR("“pooling” of its head is neither average nor maximum"));
    to.pooling = pooling == "average" ? Pooling::Average : Pooling::Maximum;
    Reader(model, to).read();
    return to;
}

} // namespace texloom
