#include "core/base/error.h"
#include "core/base/text.h"
#include "core/volume/mesh_formats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace texloom {

namespace {

/// PLY, "the Stanford triangle format": a head of lines, then elements as text or as binary numbers.
enum class Coding { Text, Little, Big };

struct Type {
    std::size_t bytes = 0;
    bool real = false;
    bool negative = false; ///< of integers: whether they have a sign
};

struct Property {
    std::string name;
    Type type;
    std::optional<Type> length; ///< of a list: the type that its length is written in
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

constexpr std::size_t kLongestHead = 1 << 16;
constexpr std::size_t kMostProperties = 64;
constexpr std::size_t kLongestList = MeshBuilder::kMostCorners;

std::optional<Type> typeNamed(std::string_view name) {
    struct Named {
        std::string_view name, other;
        Type type;
    };
    constexpr std::array<Named, 8> kNames = {{{"char", "int8", {1, false, true}},
                                              {"uchar", "uint8", {1, false, false}},
                                              {"short", "int16", {2, false, true}},
                                              {"ushort", "uint16", {2, false, false}},
                                              {"int", "int32", {4, false, true}},
                                              {"uint", "uint32", {4, false, false}},
                                              {"float", "float32", {4, true, true}},
                                              {"double", "float64", {8, true, true}}}};
    for (const Named& named : kNames)
        if (name == named.name || name == named.other)
            return named.type;
    return std::nullopt;
}

/// The numbers behind the head, one after the other.
class Numbers {
public:
    Numbers(std::string file, std::string_view bytes, Coding coding)
        : m_file(std::move(file)), m_left(bytes), m_coding(coding) {}

    std::size_t bytesLeft() const { return m_left.size(); }
    /// The fewest bytes that a number takes.
    std::size_t fewestBytes(const Type& type) const { return m_coding == Coding::Text ? 2 : type.bytes; }

    double next(const Type& type) { return m_coding == Coding::Text ? nextText() : nextBinary(type); }
    std::int64_t nextWhole(const Type& type) {
        const double number = next(type);
        if (number != std::floor(number) || std::abs(number) > 0x1p53)
            fail("{} is damaged: it holds {} where a whole number must be.", m_file, numberText(number));
        return static_cast<std::int64_t>(number);
    }

private:
    [[noreturn]] void breakOff() const { fail("{} is damaged: it breaks off before its last face.", m_file); }
    double nextText() {
        constexpr std::string_view kSpace = " \t\r\n";
        m_left.remove_prefix(std::min(m_left.find_first_not_of(kSpace), m_left.size()));
        if (m_left.empty())
            breakOff();
        double number = 0;
        const auto [end, error] = std::from_chars(m_left.data(), m_left.data() + m_left.size(), number);
        const auto length = static_cast<std::size_t>(end - m_left.data());
        if (error != std::errc() || length == 0 ||
            (length < m_left.size() && kSpace.find(m_left[length]) == std::string_view::npos))
            fail("{} is damaged: a number in it is none.", m_file);
        m_left.remove_prefix(length);
        return number;
    }
    double nextBinary(const Type& type) {
        if (type.bytes == 0 || m_left.size() < type.bytes)
            breakOff();
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.bytes; ++i) {
            const std::size_t place = m_coding == Coding::Little ? i : type.bytes - 1 - i;
            bits |= std::uint64_t{static_cast<unsigned char>(m_left[i])} << (8 * place);
        }
        m_left.remove_prefix(type.bytes);
        if (type.real)
            return type.bytes == sizeof(float)
                       ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                       : std::bit_cast<double>(bits);
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        if (type.negative && (bits & sign) != 0)
            return static_cast<double>(static_cast<std::int64_t>(bits) -
                                       static_cast<std::int64_t>(sign << 1U));
        return static_cast<double>(bits);
    }

    std::string m_file;
    std::string_view m_left;
    Coding m_coding;
};

/// The head's lines, up to end_header.
class Head {
public:
    Head(std::string file, std::string_view text);

    Coding coding = Coding::Text;
    std::vector<Element> elements;
    std::size_t bytes = 0; ///< its length

private:
    [[noreturn]] void wrong(const std::string& line) const {
        std::string shown = line.substr(0, 60);
        std::replace_if(
            shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
        fail("{} is damaged: its head has the line “{}”.", m_file, shown);
    }
    void take(const std::string& line);
    Property propertyFrom(std::istream& words, const std::string& line) const;

    std::string m_file;
};

Head::Head(std::string file, std::string_view text) : m_file(std::move(file)) {
    bool format = false;
    while (bytes < std::min(text.size(), kLongestHead)) {
        const std::size_t end = text.find('\n', bytes);
        if (end == std::string_view::npos)
            break;
        std::string line(text.substr(bytes, std::min(end - bytes, kLongestHead)));
        bytes = end + 1;
        if (!line.empty() && line.back() == '\r')
            line.pop_back();
        if (line == "end_header" && format)
            return;
        format = format || line.starts_with("format ");
        if (line != "ply")
            take(line);
    }
    fail("{} is no PLY file that can be read: its head does not end, or does not say its format.", m_file);
}

void Head::take(const std::string& line) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "format") {
        words >> word;
        coding = word == "binary_little_endian" ? Coding::Little
                 : word == "binary_big_endian"  ? Coding::Big
                                                : Coding::Text;
        if (coding == Coding::Text && word != "ascii")
            wrong(line);
    } else if (word == "element") {
        Element element;
        if (!(words >> element.name >> word) || !parseUnsigned(word, element.count))
            wrong(line);
        elements.push_back(std::move(element));
    } else if (word == "property") {
        if (elements.empty() || elements.back().properties.size() >= kMostProperties)
            wrong(line);
        elements.back().properties.push_back(propertyFrom(words, line));
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
        wrong(line);
    }
}

Property Head::propertyFrom(std::istream& words, const std::string& line) const {
    Property property;
    std::string word;
    words >> word;
    if (word == "list") {
        words >> word;
        property.length = typeNamed(word);
        if (!property.length || property.length->real)
            wrong(line);
        words >> word;
    }
    const std::optional<Type> type = typeNamed(word);
    if (!type || !(words >> property.name))
        wrong(line);
    property.type = *type;
    return property;
}

/// Which property of an element has one of these names; −1 if none.
int indexOf(const Element& element, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        for (std::size_t i = 0; i < element.properties.size(); ++i)
            if (element.properties[i].name == name)
                return static_cast<int>(i);
    return -1;
}

class PlyReader {
public:
    PlyReader(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder)
        : m_file(path.string()), m_head(m_file, bytes),
          m_numbers(m_file, std::string_view(bytes).substr(m_head.bytes), m_head.coding), m_builder(builder) {
    }

    void read() {
        for (const Element& element : m_head.elements) {
            checkCount(element);
            if (element.name == "vertex")
                readVertices(element);
            else if (element.name == "face")
                readFaces(element);
            else
                for (std::uint64_t i = 0; i < element.count; ++i)
                    readRow(element);
        }
    }

private:
    /// Every element takes some bytes: a count beyond what the file can hold is found before it is met.
    void checkCount(const Element& element) const {
        std::size_t bytes = 0;
        for (const Property& property : element.properties)
            bytes += m_numbers.fewestBytes(property.length.value_or(property.type));
        // The last number of a text needs no space behind it.
        const std::uint64_t most = bytes == 0 ? 0 : (m_numbers.bytesLeft() + 1) / bytes;
        if (element.count > most)
            fail("{} says that it has {} elements of the kind {}; there is room for {}.", m_file,
                 grouped(element.count), printable(element.name), grouped(most));
    }

    static std::string printable(std::string name) {
        name.resize(std::min<std::size_t>(name.size(), 60));
        std::replace_if(
            name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
        return name;
    }

    /// Reads one element: single numbers to m_values, the last list to m_list.
    void readRow(const Element& element, int list = -1) {
        m_values.assign(element.properties.size(), 0);
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const Property& property = element.properties[i];
            if (!property.length) {
                m_values[i] = m_numbers.next(property.type);
                continue;
            }
            const std::int64_t length = m_numbers.nextWhole(*property.length);
            const bool wanted = static_cast<int>(i) == list;
            if (length < 0 || (wanted && length > static_cast<std::int64_t>(kLongestList)))
                fail("{} has a face of {} corners; faces can have up to {}.", m_file, length, kLongestList);
            if (wanted)
                m_list.clear();
            for (std::int64_t n = 0; n < length; ++n)
                if (wanted)
                    m_list.push_back(m_numbers.nextWhole(property.type));
                else
                    m_numbers.next(property.type);
        }
    }

    float value(int index) const { return static_cast<float>(m_values[static_cast<std::size_t>(index)]); }

    void readVertices(const Element& element) {
        const std::array<int, 3> place = {indexOf(element, {"x"}), indexOf(element, {"y"}),
                                          indexOf(element, {"z"})};
        const std::array<int, 3> normal = {indexOf(element, {"nx"}), indexOf(element, {"ny"}),
                                           indexOf(element, {"nz"})};
        const std::array<int, 2> uv = {indexOf(element, {"u", "s", "texture_u"}),
                                       indexOf(element, {"v", "t", "texture_v"})};
        const auto all = [](const auto& indices) {
            return std::all_of(indices.begin(), indices.end(), [](int index) { return index >= 0; });
        };
        if (!all(place))
            fail("{} has vertices without x, y and z.", m_file);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            readRow(element);
            m_builder.addPosition({value(place[0]), value(place[1]), value(place[2])});
            if (all(normal))
                m_builder.addNormal({value(normal[0]), value(normal[1]), value(normal[2])});
            if (all(uv))
                m_builder.addUv({value(uv[0]), 1 - value(uv[1])}); // PLY counts v from the bottom
        }
    }

    void readFaces(const Element& element) {
        const int list = indexOf(element, {"vertex_indices", "vertex_index"});
        if (list < 0 || !element.properties[static_cast<std::size_t>(list)].length)
            fail("{} has faces without a list of vertices.", m_file);
        const bool normals = m_builder.normals() > 0, uvs = m_builder.uvs() > 0;
        std::vector<MeshBuilder::Corner> corners;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            readRow(element, list);
            corners.clear();
            for (const std::int64_t index : m_list)
                corners.push_back({index, normals ? index : -1, uvs ? index : -1});
            m_builder.addPolygon(corners);
        }
    }

    std::string m_file;
    Head m_head;
    Numbers m_numbers;
    MeshBuilder& m_builder;
    std::vector<double> m_values;
    std::vector<std::int64_t> m_list;
};

} // namespace

void readPly(const std::filesystem::path& path, const std::string& bytes, MeshBuilder& builder) {
    PlyReader(path, bytes, builder).read();
}

} // namespace texloom
