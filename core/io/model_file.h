#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace texloom {

/// One array of a model: its values in the order of memory, the last index fastest.
struct ModelArray {
    using Shape = std::vector<std::int64_t>;

    Shape shape; ///< length of each axis; none for a single number
    /// Weights are float; what training must take up again bit for bit may need the others.
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::int64_t>> values;

    friend bool operator==(const ModelArray&, const ModelArray&) = default;
};

/// What training or learning leaves behind: arrays by name, and a head that says what they are.
///
/// As a file it is a safetensors file (huggingface.co/docs/safetensors), which other programs read, too:
/// eight bytes with the length of a head in JSON, which holds type, shape and place of every array, then
/// their values. Nothing in it is ever executed. The head's metadata say what Texloom adds.
class Model {
public:
    /// Version of what the metadata mean that this build writes and the newest it reads.
    static constexpr int kFormat = 1;
    /// Files that are longer are refused, and so are heads, arrays and axes beyond these numbers.
    static constexpr std::uint64_t kLargestBytes = 8ULL << 30;
    static constexpr std::uint64_t kLargestHead = 16U << 20;
    static constexpr std::size_t kMostArrays = 65536;
    static constexpr std::size_t kMostAxes = 8;

    /// What it is a model of. Methods that make and use models of one kind have ports of this id for it.
    std::string kind;
    std::string recipe;                      ///< JSON text of the recipe that made it; empty if unknown
    std::vector<std::string> exemplarHashes; ///< SHA-1 of the files that it was learnt from
    /// Anything else worth knowing, as text; names do not begin with "texloom.".
    std::map<std::string, std::string> notes;
    std::map<std::string, ModelArray> arrays;

    /// The values of an array. T is float, double or std::int64_t.
    /// @throws Error that names the array if it is missing or has another type or shape.
    template <class T>
    const std::vector<T>& values(const std::string& name, const ModelArray::Shape& shape) const;
    /// @throws Error if it is of another kind.
    void checkKind(std::string_view wanted) const;

    /// The file's bytes: the same for equal models. @throws Error if an array holds what readers refuse.
    std::string bytes() const;
    /// SHA-1 of bytes(), which is that of the file.
    std::string hash() const;

    friend bool operator==(const Model&, const Model&) = default;
};

/// The model in a file's bytes. @param name by which messages call it.
/// @throws Error as readModel()
Model modelFromBytes(std::string_view bytes, const std::string& name);

/// Reads a model. Every size is held against the file's before memory is taken for it.
/// @throws Error in one sentence if it is no model, damaged, of a newer format or too large, or holds values
/// that are not finite.
Model readModel(const std::filesystem::path& path);

/// Writes a model, whole or not at all. @throws Error
void writeModel(const std::filesystem::path& path, const Model& model);

} // namespace texloom
