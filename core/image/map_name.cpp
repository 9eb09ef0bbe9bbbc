#include "core/image/map_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace texloom {

namespace {

using Packing = std::vector<PackedChannel>;

constexpr PackedChannel kOcclusion{MapRole::Occlusion, 1};
constexpr PackedChannel kRoughness{MapRole::Roughness, 0.5F};
constexpr PackedChannel kSmoothness{MapRole::Roughness, 0.5F, true};
constexpr PackedChannel kMetallic{MapRole::Metallic, 0};
constexpr PackedChannel kNothing{MapRole::Other, 0};

struct Suffix {
    std::string_view word;
    MapRole role;
};

constexpr auto kSuffixes = std::to_array<Suffix>({
    {"color", MapRole::Color},
    {"colour", MapRole::Color},
    {"col", MapRole::Color},
    {"basecolor", MapRole::Color},
    {"basecolour", MapRole::Color},
    {"basemap", MapRole::Color},
    {"albedo", MapRole::Color},
    {"albedotransparency", MapRole::Color},
    {"diff", MapRole::Color},
    {"diffuse", MapRole::Color},
    {"normal", MapRole::NormalGl},
    {"normalmap", MapRole::NormalGl},
    {"nor", MapRole::NormalGl},
    {"nrm", MapRole::NormalGl},
    {"norm", MapRole::NormalGl},
    {"normalgl", MapRole::NormalGl},
    {"normalopengl", MapRole::NormalGl},
    {"norgl", MapRole::NormalGl},
    {"normaldx", MapRole::NormalDx},
    {"normaldirectx", MapRole::NormalDx},
    {"nordx", MapRole::NormalDx},
    {"roughness", MapRole::Roughness},
    {"roughnessmap", MapRole::Roughness},
    {"rough", MapRole::Roughness},
    {"metallic", MapRole::Metallic},
    {"metalness", MapRole::Metallic},
    {"metal", MapRole::Metallic},
    {"ao", MapRole::Occlusion},
    {"mixedao", MapRole::Occlusion},
    {"occlusion", MapRole::Occlusion},
    {"occlusionmap", MapRole::Occlusion},
    {"ambientocclusion", MapRole::Occlusion},
    {"opacity", MapRole::Opacity},
    {"displacement", MapRole::Height},
    {"disp", MapRole::Height},
    {"height", MapRole::Height},
    {"heightmap", MapRole::Height},
});

/// Unreal's letters, which mean something only after "T_"; its normal maps have green down.
constexpr auto kUnreal = std::to_array<Suffix>({
    {"bc", MapRole::Color},
    {"d", MapRole::Color},
    {"n", MapRole::NormalDx},
    {"r", MapRole::Roughness},
    {"m", MapRole::Metallic},
    {"o", MapRole::Opacity},
    {"h", MapRole::Height},
});

struct PackedSuffix {
    std::string_view word;
    Packing channels;
};

const std::vector<PackedSuffix>& packedSuffixes() {
    static const Packing orm = {kOcclusion, kRoughness, kMetallic};
    static const Packing rma = {kRoughness, kMetallic, kOcclusion};
    static const Packing mra = {kMetallic, kRoughness, kOcclusion};
    static const Packing metallicRoughness = {kNothing, kRoughness, kMetallic}; // glTF without occlusion
    static const Packing metallicSmoothness = {kMetallic, kNothing, kNothing, kSmoothness};
    static const Packing gloss = {kSmoothness};
    static const std::vector<PackedSuffix> suffixes = {
        {"orm", orm},
        {"arm", orm},
        {"aorm", orm},
        {"occlusionroughnessmetallic", orm},
        {"mra", mra},
        {"mrao", mra},
        {"metallicroughnessocclusion", mra},
        {"rma", rma},
        {"rmao", rma},
        {"roughnessmetallicocclusion", rma},
        {"metallicroughness", metallicRoughness},
        {"metalroughness", metallicRoughness},
        {"metallicsmoothness", metallicSmoothness},
        {"metalsmoothness", metallicSmoothness},
        {"maskmap", packingMaskMap()},
        {"gloss", gloss},
        {"glossiness", gloss},
        {"smoothness", gloss},
    };
    return suffixes;
}

bool separates(char letter) {
    return letter == '_' || letter == '-' || letter == ' ' || letter == '.';
}

bool isDigit(char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

std::string lowered(std::string_view text) {
    std::string lower;
    for (const char letter : text)
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return lower;
}

/// One word of a name in lower case, and where it starts.
struct Word {
    std::string text;
    std::size_t at;
};

std::vector<Word> wordsOf(const std::string& name) {
    std::vector<Word> words;
    for (std::size_t at = 0; at < name.size();) {
        std::size_t end = at;
        while (end < name.size() && !separates(name[end]))
            ++end;
        if (end > at)
            words.push_back({lowered(std::string_view(name).substr(at, end - at)), at});
        at = end + 1;
    }
    return words;
}

/// "2k", "1024" or "2048x2048".
bool isResolution(const std::string& word) {
    if (word.size() < 2 || !isDigit(word.front()))
        return false;
    const bool kilo = word.back() == 'k' && std::all_of(word.begin(), word.end() - 1, isDigit);
    const bool pixels = word.size() >= 3 && std::all_of(word.begin(), word.end(), [](char letter) {
                            return isDigit(letter) || letter == 'x';
                        });
    return kilo || pixels;
}

bool isFormat(const std::string& word) {
    constexpr std::array<std::string_view, 6> formats = {"jpg", "jpeg", "png", "exr", "tif", "tga"};
    return std::find(formats.begin(), formats.end(), word) != formats.end();
}

/// Takes resolution and format off the end of the words, but never the first word.
void dropTechnical(std::vector<Word>& words, std::string& resolution) {
    std::size_t kept = words.size();
    std::string found;
    while (kept > 1 && (isResolution(words[kept - 1].text) || isFormat(words[kept - 1].text))) {
        if (isResolution(words[kept - 1].text))
            found = words[kept - 1].text;
        --kept;
    }
    if (found.empty())
        return; // "bark_png" is a name like any other
    words.resize(kept);
    resolution = found;
}

/// What a word says; nothing where it says none.
struct Meaning {
    MapRole role = MapRole::Other;
    Packing packing = {};

    bool any() const { return role != MapRole::Other || !packing.empty(); }
};

template <class Table> MapRole roleIn(const Table& table, std::string_view word) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Suffix& suffix) { return suffix.word == word; });
    return found == table.end() ? MapRole::Other : found->role;
}

Meaning meaningOf(const std::string& word, bool unreal) {
    Meaning meaning{roleIn(kSuffixes, word)};
    if (unreal && meaning.role == MapRole::Other)
        meaning.role = roleIn(kUnreal, word);
    for (const PackedSuffix& packed : packedSuffixes())
        if (packed.word == word)
            meaning.packing = packed.channels;
    return meaning;
}

/// The name up to where a word starts, without the separator before it.
std::string before(const std::string& name, const Word& word) {
    std::size_t end = word.at;
    while (end > 0 && separates(name[end - 1]))
        --end;
    return name.substr(0, end);
}

bool isUnreal(const std::vector<Word>& words) {
    return words.size() > 2 && words.front().text == "t";
}

/// "gl" and "dx" after a word for normals.
std::string direction(const std::string& word) {
    if (word == "gl" || word == "opengl" || word == "ogl")
        return "gl";
    return word == "dx" || word == "directx" ? "dx" : "";
}

/// The words joined that say what the file holds: the longest run at the end that means something.
/// @return how many; 0 if none does.
std::size_t meaningfulWords(const std::vector<Word>& words, bool unreal, Meaning& meaning) {
    for (const std::size_t count : {3U, 2U, 1U}) {
        if (count >= words.size())
            continue;
        std::string joined;
        for (std::size_t i = words.size() - count; i < words.size(); ++i) {
            const std::string normals = direction(words[i].text);
            joined += normals.empty() || count == 1 ? words[i].text : normals;
        }
        meaning = meaningOf(joined, unreal && count == 1);
        if (meaning.any())
            return count;
    }
    return 0;
}

std::string materialOf(const MapName& name) {
    std::string base = lowered(name.base);
    std::vector<Word> words = wordsOf(base);
    std::string resolution;
    dropTechnical(words, resolution);
    if (words.size() > 1 && words.front().text == "t")
        words.erase(words.begin());
    std::string joined;
    for (const Word& word : words)
        joined += (joined.empty() ? "" : "_") + word.text;
    return joined;
}

std::string resolutionOf(const MapName& name) {
    std::string resolution = name.resolution;
    if (resolution.empty()) {
        std::vector<Word> words = wordsOf(name.base);
        dropTechnical(words, resolution);
    }
    return resolution;
}

} // namespace

const std::vector<PackedChannel>& packingOrm() {
    static const Packing packing = {kOcclusion, kRoughness, kMetallic};
    return packing;
}

const std::vector<PackedChannel>& packingMaskMap() {
    static const Packing packing = {kMetallic, kOcclusion, kNothing, kSmoothness};
    return packing;
}

MapName mapNameFrom(const std::string& stem, bool alone) {
    if (alone) {
        MapName name = mapNameFrom(stem);
        if (name.role != MapRole::Other || !name.packing.empty())
            return name;
        MapName behind = mapNameFrom("x_" + stem);
        if (behind.base != "x")
            return name;
        behind.base.clear();
        return behind;
    }
    std::vector<Word> words = wordsOf(stem);
    MapName name{stem};
    dropTechnical(words, name.resolution);
    Meaning meaning;
    const bool unreal = isUnreal(words);
    std::size_t count = meaningfulWords(words, unreal, meaning);
    if (count == 0 && words.size() > 1 && isDigit(words.back().text.front())) { // bark_normal_01
        words.pop_back();
        count = meaningfulWords(words, unreal, meaning);
    }
    if (count == 0)
        return {stem};
    name.role = meaning.role;
    name.packing = std::move(meaning.packing);
    const Word first = words[words.size() - count];
    words.resize(words.size() - count);
    const std::size_t named = words.size();
    dropTechnical(words, name.resolution);
    name.base = before(stem, words.size() < named ? wordsOf(stem)[words.size()] : first);
    if (words.size() > 1 && words.front().text == "t")
        name.base = name.base.substr(words[1].at);
    return name;
}

bool sameMaterial(const std::string& stem, const std::string& other) {
    const MapName one = mapNameFrom(stem, true), two = mapNameFrom(other, true);
    const std::string first = resolutionOf(one), second = resolutionOf(two);
    return materialOf(one) == materialOf(two) && (first.empty() || second.empty() || first == second);
}

} // namespace texloom
