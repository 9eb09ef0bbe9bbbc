#include "core/network/weights_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/file_reader.h"
#include "core/io/image_file.h"
#include "core/io/json_field.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

namespace texloom {

namespace {

constexpr int kMostTensors = 1024, kMostLength = 4096;
constexpr const char* kSuffix = ".weight";

/// The tensors that the head names, read when they are asked for.
class Weights {
public:
    explicit Weights(const std::filesystem::path& json) : m_file(binaryOf(json)) {
        const Message document = Message::verbatim(json.filename().string());
        const JsonField::Json parsed = parseJson(document, readText(json));
        const JsonField root(document, parsed);
        root.needObject();
        const JsonField tensors = root.at("tensors");
        tensors.needArray(1, kMostTensors);
        for (std::size_t i = 0; i < tensors.size(); ++i)
            add(tensors.at(i));
    }

    const std::vector<std::string>& convolutions() const { return m_convolutions; }
    bool has(const std::string& name) const { return m_tensors.count(name + kSuffix) != 0; }

    /// A convolution with its weights. @param inputs as many channels as it must have.
    Filters filters(const std::string& name, int inputs) {
        const Place& weights = m_tensors.at(name + kSuffix);
        const auto bias = m_tensors.find(name + ".bias");
        const std::vector<int>& shape = weights.shape;
        if (shape.size() != 4 || shape[1] != inputs || shape[2] != shape[3] || shape[2] % 2 == 0 ||
            bias == m_tensors.end() || bias->second.shape != std::vector<int>{shape[0]})
            fail(TR("The weights of {} do not fit {} channels and a square of odd side, or have no bias."),
                 name, inputs);
        return {shape[0], inputs, shape[2], values(name, weights), values(name, bias->second)};
    }

private:
    struct Place {
        std::vector<int> shape;
        std::uint64_t offset = 0, count = 1; ///< in numbers
    };

    static std::filesystem::path binaryOf(const std::filesystem::path& json) {
        if (json.extension() != ".json")
            failUsage(TR("{} is no .json: name the one that lies beside the .bin with the weights."),
                      json.filename().string());
        std::filesystem::path beside = json;
        beside.replace_extension(".bin");
        if (!std::filesystem::exists(beside))
            beside.replace_extension(".f32.bin");
        return beside;
    }

    void add(const JsonField& entry) {
        entry.needObject();
        const std::string name = entry.at("name").text();
        Place tensor;
        const JsonField shape = entry.at("shape");
        shape.needArray(1, 4);
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const int length = shape.at(i).whole();
            if (length < 1 || length > kMostLength)
                shape.at(i).wrong(message(TR("a length from 1 to {}"), kMostLength));
            tensor.shape.push_back(length);
            tensor.count *= static_cast<std::uint64_t>(length);
        }
        const double offset = entry.at("offset").number();
        const std::uint64_t there = m_file.size() / sizeof(float);
        if (!(offset >= 0) || offset > static_cast<double>(there) || std::floor(offset) != offset ||
            tensor.count > there - static_cast<std::uint64_t>(offset))
            fail(TR("The weights of {} lie beyond the end of the file, which holds {} numbers: it is cut "
                    "short or "
                    "of another network."),
                 name, there);
        tensor.offset = static_cast<std::uint64_t>(offset);
        if (name.ends_with(kSuffix))
            m_convolutions.push_back(name.substr(0, name.size() - std::string_view(kSuffix).size()));
        m_tensors[name] = std::move(tensor);
    }

    std::vector<float> values(const std::string& name, const Place& tensor) {
        static_assert(std::endian::native == std::endian::little);
        std::vector<float> values(tensor.count);
        m_file.read(values.data(), values.size() * sizeof(float), tensor.offset * sizeof(float));
        if (!std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
            fail(TR("The weights of {} hold values that are not numbers."), name);
        return values;
    }

    FileReader m_file;
    std::map<std::string, Place> m_tensors;
    std::vector<std::string> m_convolutions; ///< in the head's order
};

/// The group of “conv3_1”, or 0 if it is called otherwise.
int groupOf(const std::string& name) {
    const std::size_t line = name.find('_');
    if (name.rfind("conv", 0) != 0 || line == std::string::npos)
        return 0;
    long long group = 0, number = 0;
    return parseInteger(name.substr(4, line - 4), group) && parseInteger(name.substr(line + 1), number) &&
                   group >= 1 && group < 100
               ? static_cast<int>(group)
               : 0;
}

/// Colours from 0 to 1 as networks of Caffe's time want them.
Filters caffeColours() {
    constexpr float kMeans[] = {103.939F, 116.779F, 123.68F};
    Filters filters = Filters::zero(3, 3, 1);
    for (int c = 0; c < 3; ++c) {
        filters.at(c, 2 - c, 0, 0) = 255;
        filters.bias[at(c)] = -kMeans[c];
    }
    return filters;
}

} // namespace

Descriptor importWeights(const std::filesystem::path& json, const WeightsImport& how) {
    using Kind = DescriptorLayer::Kind;
    Weights weights(json);
    Descriptor to;
    to.name = how.name.empty() ? json.stem().string() : how.name;
    to.licence = how.licence;
    to.credit = how.credit;
    to.pooling = how.pooling;
    auto& chain = to.chains.emplace_back();
    chain.push_back(
        {Kind::Convolution, "pre", weights.has("pre") ? weights.filters("pre", 3) : caffeColours()});
    int group = 1, channels = chain.back().filters.outputs;
    std::vector<std::string> missing = how.taps;
    std::size_t length = 0;
    for (const std::string& name : weights.convolutions()) {
        const int own = groupOf(name);
        if (own < group)
            continue; // what belongs to no chain, such as “pre”
        if (own > group)
            chain.push_back({Kind::Pool, "", {}});
        group = own;
        chain.push_back({Kind::Convolution, name, weights.filters(name, channels)});
        channels = chain.back().filters.outputs;
        chain.push_back({Kind::Rectifier, "", {}});
        const std::string tap = "relu" + name.substr(4);
        const auto asked = std::find(missing.begin(), missing.end(), tap);
        if (how.taps.empty() ? name.ends_with("_1") : asked != missing.end()) {
            chain.push_back({Kind::Tap, tap, {}});
            length = chain.size();
            if (asked != missing.end())
                missing.erase(asked);
        }
    }
    if (!missing.empty())
        failUsage(TR("The network has no layer for the tap {}."), missing.front());
    if (length == 0)
        fail(TR("{} names no convolution conv1_1: it is no network of VGG's kind."),
             json.filename().string());
    chain.resize(length);
    return to;
}

} // namespace texloom
