#include "core/io/model_file.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/file_reader.h"
#include "core/io/temporary_file.h"

#include <OpenImageIO/hash.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they are in memory");

using HeaderJson = nlohmann::json;
using Shape = ModelArray::Shape;
using Sink = std::function<void(const void* data, std::size_t size)>;
using ReadAt = std::function<void(void* data, std::size_t size, std::uint64_t offset)>;

constexpr std::size_t kLengthBytes = 8; // of the head's length, before it; places are rounded up to it, too
constexpr int kDeepestHeader = 8;
constexpr std::size_t kLongestName = 256;
constexpr const char* kMetadata = "__metadata__";
constexpr std::string_view kOwnPrefix = "texloom.";

/// In the order of ModelArray::values.
constexpr std::array<const char*, 3> kTypes = {"F32", "F64", "I64"};
constexpr std::array<const char*, 3> kTypeNames = {TR("32-bit floats"), TR("64-bit floats"),
                                                   TR("64-bit integers")};

std::size_t elementBytes(std::size_t type) {
    return type == 0 ? sizeof(float) : sizeof(double);
}

std::string shapeText(const Shape& shape) {
    return shape.empty() ? "1" : fmt::format("{}", fmt::join(shape, " × "));
}

/// Number of values of this shape; nothing if it does not fit into 64 bits or an axis is negative.
std::optional<std::uint64_t> countOf(const Shape& shape) {
    std::uint64_t count = 1;
    for (const std::int64_t length : shape)
        if (length < 0 || __builtin_mul_overflow(count, static_cast<std::uint64_t>(length), &count))
            return std::nullopt;
    return count;
}

template <class T> bool allFinite(const std::vector<T>& values) {
    if constexpr (std::is_floating_point_v<T>)
        return std::all_of(values.begin(), values.end(), [](T value) { return std::isfinite(value); });
    else
        return true;
}

void checkFinite(const std::string& file, const std::string& name, const ModelArray& array) {
    if (!std::visit([](const auto& values) { return allFinite(values); }, array.values))
        fail("{} holds values in its array {} that are not finite numbers; Texloom needs finite ones.", file,
             name);
}

/// Names end up in sentences of one line.
void checkName(const std::string& file, const std::string& name) {
    const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' '; });
    if (name.empty() || name.size() > kLongestName || control)
        fail("{} is damaged or no model: a name in its head is empty, longer than {} bytes or holds control "
             "characters.",
             file, kLongestName);
}

// Writing

void checkArray(const std::string& name, const ModelArray& array) {
    checkName("The model", name);
    const std::size_t count = std::visit([](const auto& values) { return values.size(); }, array.values);
    if (countOf(array.shape) != count || array.shape.size() > Model::kMostAxes)
        fail("The model's array {} has {} values and a shape of {}.", name, count, shapeText(array.shape));
    checkFinite("The model", name, array);
}

/// Names in the order that their values are written in: larger elements first, so that all are aligned.
std::vector<std::string> writingOrder(const Model& model) {
    std::vector<std::string> names;
    for (const bool wide : {true, false})
        for (const auto& [name, array] : model.arrays)
            if (wide == (elementBytes(array.values.index()) == sizeof(double)))
                names.push_back(name);
    return names;
}

std::string headOf(const Model& model, const std::vector<std::string>& order) {
    HeaderJson metadata = HeaderJson::object();
    for (const auto& [name, text] : model.notes)
        metadata[name] = text;
    metadata["texloom.format"] = std::to_string(Model::kFormat);
    metadata["texloom.kind"] = model.kind;
    metadata["texloom.exemplars"] = fmt::format("{}", fmt::join(model.exemplarHashes, " "));
    metadata["texloom.recipe"] = model.recipe;
    HeaderJson head = {{kMetadata, metadata}};
    std::uint64_t end = 0;
    for (const std::string& name : order) {
        const ModelArray& array = model.arrays.at(name);
        const std::uint64_t begin = end;
        end += *countOf(array.shape) * elementBytes(array.values.index());
        head[name] = {{"dtype", kTypes.at(array.values.index())},
                      {"shape", array.shape},
                      {"data_offsets", {begin, end}}};
    }
    std::string text = head.dump(-1, ' ', false, HeaderJson::error_handler_t::replace);
    text.resize((text.size() + kLengthBytes - 1) / kLengthBytes * kLengthBytes, ' ');
    return text;
}

void serialise(const Model& model, const Sink& sink) {
    for (const auto& [name, array] : model.arrays)
        checkArray(name, array);
    const std::vector<std::string> order = writingOrder(model);
    const std::string head = headOf(model, order);
    const std::uint64_t length = head.size();
    sink(&length, sizeof(length));
    sink(head.data(), head.size());
    for (const std::string& name : order)
        std::visit(
            [&sink](const auto& values) { sink(values.data(), values.size() * sizeof(values.front())); },
            model.arrays.at(name).values);
}

// Reading

/// Where the values of one array are, after the head.
struct Entry {
    std::string name;
    std::size_t type = 0;
    Shape shape;
    std::uint64_t begin = 0, end = 0;
};

std::string textAt(const HeaderJson& metadata, const char* key) {
    const auto found = metadata.find(key);
    return found != metadata.end() && found->is_string() ? found->get<std::string>() : std::string();
}

HeaderJson parsedHead(const std::string& file, const std::string& text) {
    const auto shallow = [](int depth, HeaderJson::parse_event_t, HeaderJson&) {
        return depth <= kDeepestHeader;
    };
    HeaderJson head;
    try {
        head = HeaderJson::parse(text, shallow);
    } catch (const HeaderJson::exception&) {
        head = HeaderJson();
    }
    if (!head.is_object())
        fail("{} is no model: its head is not JSON.", file);
    return head;
}

/// The head without its arrays.
Model describedBy(const std::string& file, const HeaderJson& head) {
    const HeaderJson metadata = head.value(kMetadata, HeaderJson::object());
    Model model;
    if (metadata.is_object())
        model.kind = textAt(metadata, "texloom.kind");
    if (model.kind.empty())
        fail("{} holds arrays, but is no model of Texloom: its head names no kind of model.", file);
    const std::string format = textAt(metadata, "texloom.format");
    checkName(file, model.kind);
    checkName(file, format);
    if (long long number = 0; !parseInteger(format, number) || number < 1)
        fail("{} is no model of Texloom: its format is {}, not a number.", file, format);
    else if (number > Model::kFormat)
        fail("{} is a model in format {}; this Texloom reads formats up to {}. A newer one reads it.", file,
             number, Model::kFormat);
    model.recipe = textAt(metadata, "texloom.recipe");
    std::istringstream hashes(textAt(metadata, "texloom.exemplars"));
    for (std::string hash; hashes >> hash;)
        model.exemplarHashes.push_back(hash);
    for (const auto& [name, value] : metadata.items())
        if (value.is_string() && !name.starts_with(kOwnPrefix))
            model.notes[name] = value.get<std::string>();
    return model;
}

bool readNumbers(const HeaderJson& list, std::size_t most, std::vector<std::int64_t>& numbers) {
    if (!list.is_array() || list.size() > most)
        return false;
    for (const HeaderJson& number : list) {
        if (!number.is_number_unsigned() || number.get<std::uint64_t>() > INT64_MAX)
            return false;
        numbers.push_back(number.get<std::int64_t>());
    }
    return true;
}

Entry entryFrom(const std::string& file, const std::string& name, const HeaderJson& json) {
    Entry entry;
    entry.name = name;
    std::vector<std::int64_t> offsets;
    const auto type =
        json.is_object() ? std::find(kTypes.begin(), kTypes.end(), textAt(json, "dtype")) : kTypes.end();
    if (type == kTypes.end() ||
        !readNumbers(json.value("shape", HeaderJson()), Model::kMostAxes, entry.shape) ||
        !readNumbers(json.value("data_offsets", HeaderJson()), 2, offsets) || offsets.size() != 2)
        fail("{} is damaged or no model: its array {} does not say a type (F32, F64 or I64), a shape of up "
             "to {} axes and a place.",
             file, name, Model::kMostAxes);
    entry.type = static_cast<std::size_t>(type - kTypes.begin());
    entry.begin = static_cast<std::uint64_t>(offsets[0]);
    entry.end = static_cast<std::uint64_t>(offsets[1]);
    const std::optional<std::uint64_t> count = countOf(entry.shape);
    if (entry.end < entry.begin || !count || (entry.end - entry.begin) % elementBytes(entry.type) != 0 ||
        *count != (entry.end - entry.begin) / elementBytes(entry.type))
        fail("{} is damaged: its array {} has a shape of {} and room from byte {} to {}.", file, name,
             shapeText(entry.shape), entry.begin, entry.end);
    return entry;
}

/// All arrays in the order of their places, which follow each other without a gap up to the file's end.
std::vector<Entry> entriesOf(const std::string& file, const HeaderJson& head, std::uint64_t dataBytes) {
    if (head.size() > Model::kMostArrays)
        fail("{} holds {} arrays; a model has up to {}.", file, head.size(), Model::kMostArrays);
    std::vector<Entry> entries;
    for (const auto& [name, json] : head.items())
        if (name != kMetadata) {
            checkName(file, name);
            entries.push_back(entryFrom(file, name, json));
        }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
    });
    std::uint64_t end = 0;
    for (const Entry& entry : entries) {
        if (entry.begin != end)
            fail("{} is damaged: its array {} begins at byte {}, not at {} where the one before it ends.",
                 file, entry.name, entry.begin, end);
        end = entry.end;
    }
    if (end != dataBytes)
        fail("{} is damaged: its arrays take {} bytes, and it holds {}.", file, grouped(end),
             grouped(dataBytes));
    return entries;
}

template <class T> std::vector<T> readValues(const ReadAt& read, const Entry& entry, std::uint64_t start) {
    std::vector<T> values((entry.end - entry.begin) / sizeof(T));
    if (!values.empty())
        read(values.data(), values.size() * sizeof(T), start + entry.begin);
    return values;
}

ModelArray readArray(const ReadAt& read, const Entry& entry, std::uint64_t start) {
    if (entry.type == 0)
        return {entry.shape, readValues<float>(read, entry, start)};
    if (entry.type == 1)
        return {entry.shape, readValues<double>(read, entry, start)};
    return {entry.shape, readValues<std::int64_t>(read, entry, start)};
}

Model deserialise(const std::string& file, std::uint64_t size, const ReadAt& read) {
    if (size > Model::kLargestBytes)
        fail("{} is {} long; models are read up to {}.", file, byteText(size),
             byteText(Model::kLargestBytes));
    if (size < kLengthBytes)
        fail("{} is no model: it has {} bytes.", file, size);
    std::uint64_t length = 0;
    read(&length, sizeof(length), 0);
    if (length > Model::kLargestHead || length > size - kLengthBytes)
        fail("{} is damaged or no model: its head is said to have {} bytes; it can have up to {}.", file,
             grouped(length), grouped(std::min(Model::kLargestHead, size - kLengthBytes)));
    std::string text(length, '\0');
    read(text.data(), text.size(), kLengthBytes);
    const HeaderJson head = parsedHead(file, text);
    Model model = describedBy(file, head);
    const std::uint64_t start = kLengthBytes + length;
    for (const Entry& entry : entriesOf(file, head, size - start)) {
        ModelArray array = readArray(read, entry, start);
        checkFinite(file, entry.name, array);
        model.arrays[entry.name] = std::move(array);
    }
    return model;
}

template <class T>
constexpr std::size_t kTypeOf = std::is_same_v<T, float>    ? 0
                                : std::is_same_v<T, double> ? 1
                                                            : 2;

} // namespace

template <class T> const std::vector<T>& Model::values(const std::string& name, const Shape& shape) const {
    const auto found = arrays.find(name);
    if (found == arrays.end())
        fail("The model of kind {} has no array {}; it was made by another version.", kind, name);
    const ModelArray& array = found->second;
    if (array.values.index() != kTypeOf<T> || array.shape != shape)
        fail("The model's array {} holds {} {}; {} {} are needed.", name, shapeText(array.shape),
             Message(kTypeNames.at(array.values.index())), shapeText(shape),
             Message(kTypeNames.at(kTypeOf<T>)));
    return std::get<std::vector<T>>(array.values);
}

template const std::vector<float>& Model::values(const std::string&, const Shape&) const;
template const std::vector<double>& Model::values(const std::string&, const Shape&) const;
template const std::vector<std::int64_t>& Model::values(const std::string&, const Shape&) const;

void Model::checkKind(std::string_view wanted) const {
    if (kind != wanted)
        fail("The model is of the kind {}; one of the kind {} is needed.", kind, wanted);
}

std::string Model::bytes() const {
    std::string bytes;
    serialise(*this, [&bytes](const void* data, std::size_t size) {
        bytes.append(static_cast<const char*>(data), size);
    });
    return bytes;
}

std::string Model::hash() const {
    OIIO::SHA1 hash;
    serialise(*this, [&hash](const void* data, std::size_t size) { hash.append(data, size); });
    return hash.digest();
}

Model modelFromBytes(std::string_view bytes, const std::string& name) {
    return deserialise(name, bytes.size(), [bytes](void* data, std::size_t size, std::uint64_t offset) {
        std::memcpy(data, bytes.data() + offset, size);
    });
}

Model readModel(const fs::path& path) {
    FileReader file(path);
    return deserialise(
        path.string(), file.size(),
        [&file](void* data, std::size_t size, std::uint64_t offset) { file.read(data, size, offset); });
}

void writeModel(const fs::path& path, const Model& model) {
    TemporaryFile temporary(path);
    std::int64_t offset = 0;
    serialise(model, [&](const void* data, std::size_t size) {
        temporary.write(data, size, offset);
        offset += static_cast<std::int64_t>(size);
    });
    temporary.commit();
}

} // namespace texloom
