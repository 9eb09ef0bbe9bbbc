#include "core/session/export/companion_files.h"

#include "core/base/folder_of.h"
#include "core/base/text.h"
#include "core/image/normal_map.h"

#include <algorithm>
#include <set>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

/// Where green of a normal map should point when it is written.
MapRole normalsWanted(const ExportOptions& options) {
    return options.normals != MapRole::Other ? options.normals : options.preset.normals;
}

/// Companion `index` as it is written.
Image companionImage(const Result& result, const ExportOptions& options, std::size_t index) {
    Image image = result.companion(index);
    const MapRole role = result.plan.companions.front()[index].role;
    if (!isNormal(role))
        return image;
    if (result.synthesis.mapKind == MapKind::Dominant)
        renormalize(image);
    const MapRole wanted = normalsWanted(options);
    if (isNormal(wanted) && wanted != role)
        flipGreen(image);
    return image;
}

WriteOptions dataOptions(const Result& result, const ExportOptions& options, Depth depth,
                         const fs::path& path) {
    WriteOptions write;
    write.check = options.check;
    write.depth = depth;
    write.space = "raw";
    write.recipe = result.plan.recipe.toJson(folderOf(path));
    return write;
}

/// The depth of a companion file: as asked for, else as the preset says, else its source's own; where the
/// format has it.
Depth companionDepth(const ExportOptions& options, const std::string& word, std::optional<Depth> preset,
                     Depth own, const fs::path& path) {
    const std::vector<Depth> held = depthsFor(path);
    const auto holds = [&](Depth depth) { return std::find(held.begin(), held.end(), depth) != held.end(); };
    if (const auto asked = options.depths.find(word); asked != options.depths.end() && holds(asked->second))
        return asked->second;
    const bool whole =
        own == Depth::Bits8 || own == Depth::Bits16; // a preset never reduces a file of real numbers
    return preset && whole && holds(*preset) ? *preset : own;
}

void writeCompanion(const Result& result, const ExportOptions& options, std::size_t index,
                    const ExportEntry& entry) {
    WriteOptions write = dataOptions(result, options, *entry.depth, entry.path);
    write.channelNames = result.plan.companions.front()[index].info.channelNames;
    writeImage(entry.path, companionImage(result, options, index), write);
}

/// The companion that holds this; a normal map of either direction counts. None if there is none.
std::optional<std::size_t> companionFor(const Result& result, MapRole role) {
    const std::vector<ExemplarFile>& companions = result.plan.companions.front();
    for (std::size_t i = 0; i < companions.size(); ++i)
        if (role != MapRole::Other &&
            (companions[i].role == role || (isNormal(role) && isNormal(companions[i].role))))
            return i;
    return std::nullopt;
}

/// One channel of a packed file as it is written.
struct PackedSlot {
    std::optional<std::size_t> companion; ///< none: `otherwise` everywhere
    float otherwise = 0;
    bool inverted = false;
};

void writePacked(const Result& result, const ExportOptions& options, const std::vector<PackedSlot>& slots,
                 const ExportEntry& entry) {
    Image packed(result.synthesis.image.size(), static_cast<int>(slots.size()));
    for (int c = 0; c < packed.channels(); ++c) {
        const PackedSlot& slot = slots[static_cast<std::size_t>(c)];
        const Image map = slot.companion ? result.companion(*slot.companion) : Image();
        for (int y = 0; y < packed.height(); ++y)
            for (int x = 0; x < packed.width(); ++x) {
                const float value = slot.companion ? map(x, y, 0) : slot.otherwise;
                packed(x, y, c) = slot.inverted ? 1 - value : value;
            }
    }
    writeImage(entry.path, packed, dataOptions(result, options, *entry.depth, entry.path));
}

/// The channels of a preset's packed file, filled with the companions that hold them.
std::vector<PackedSlot> slotsOf(const Result& result, const PresetFile& file) {
    std::vector<PackedSlot> slots;
    for (const PackedChannel& channel : file.channels)
        slots.push_back({companionFor(result, channel.role), channel.otherwise, channel.inverted});
    return slots;
}

/// The channels of a companion's own file, or layer of it, filled with all the companions that came from it.
std::vector<PackedSlot> slotsLike(const std::vector<ExemplarFile>& companions, const ExemplarFile& packed) {
    const std::vector<PackedChannel> named = companionName(packed.path, packed.layer).packing;
    std::vector<PackedSlot> slots(static_cast<std::size_t>(std::max(packed.info.channels, 1)));
    for (std::size_t c = 0; c < slots.size() && c < named.size(); ++c)
        slots[c] = {{}, named[c].otherwise, named[c].inverted};
    for (std::size_t i = 0; i < companions.size(); ++i) {
        const auto channel = static_cast<std::size_t>(std::max(companions[i].channel.index, 0));
        const bool together = companions[i].path == packed.path && companions[i].layer == packed.layer;
        if (together && channel < slots.size())
            slots[channel] = {i, 0, companions[i].channel.inverted};
    }
    return slots;
}

/// As the map's own file, but never a format that loses values: a JPEG's map is written as PNG.
std::string mapExtension(const ImageFileInfo& source) {
    const std::string own = extensionLike(source);
    return own == ".jpg" ? ".png" : own;
}

/// What sets a companion's name apart from the exemplar's: "_normal" of bark_normal beside bark_albedo or
/// bark.
std::string companionSuffix(const std::string& exemplar, const std::string& companion) {
    const auto [own, theirs] =
        std::mismatch(companion.begin(), companion.end(), exemplar.begin(), exemplar.end());
    const bool common = own != companion.begin() && own != companion.end();
    const std::string rest = common ? std::string(own, companion.end()) : companion;
    return rest.front() == '_' ? rest : "_" + rest;
}

/// A layer's name as a part of a file's.
std::string layerSuffix(const std::string& layer) {
    constexpr std::string_view kNotInNames = "/\\:*?\"<>| ";
    std::string suffix = layer;
    for (char& letter : suffix)
        if (static_cast<unsigned char>(letter) < ' ' || kNotInNames.find(letter) != std::string_view::npos)
            letter = '_';
    return "_" + suffix;
}

/// Hands out file names, no two alike.
class Names {
public:
    Names(const Result& result, const ExportOptions& options)
        : m_result(result), m_options(options), m_taken{options.image} {}

    fs::path next(const std::string& word, const std::string& extension) {
        fs::path path = pathFor(word, extension);
        for (int copy = 2; !m_taken.insert(path).second; ++copy)
            path = pathFor(fmt::format("{}_{}", word, copy), extension);
        return path;
    }

private:
    fs::path pathFor(const std::string& word, const std::string& extension) const {
        if (m_options.pattern.empty())
            return beside(m_options.image, "_" + word, extension);
        return folderOf(m_options.image) /
               (expandName(m_options.pattern, nameWords(m_result, word)) + extension);
    }

    const Result& m_result;
    const ExportOptions& m_options;
    std::set<fs::path> m_taken;
};

/// Puts together what companion files an export has.
class CompanionFiles {
public:
    CompanionFiles(const Result& result, const ExportOptions& options)
        : m_result(result), m_options(options), m_companions(result.plan.companions.front()),
          m_names(result, options) {}

    std::vector<ExportStep> steps() {
        for (const PresetFile& file : m_options.preset.files) {
            if (const auto index = companionFor(m_result, file.role))
                addWhole(*index, file.word, file.depth);
            else if (const std::vector<PackedSlot> slots = slotsOf(m_result, file); anyOf(slots))
                addPacked(slots, file.word, file.depth, Depth::Bits8, ".png");
        }
        for (std::size_t i = 0; i < m_companions.size(); ++i) {
            if (m_used.contains(i))
                continue;
            const std::string word = wordFor(m_companions[i]);
            if (m_companions[i].channel.whole())
                addWhole(i, word, {});
            else
                addLikeItsFile(i, word);
        }
        return std::move(m_steps);
    }

private:
    static bool anyOf(const std::vector<PackedSlot>& slots) {
        return std::any_of(slots.begin(), slots.end(), [](const PackedSlot& slot) { return slot.companion; });
    }

    /// Layers of one file are told apart by their own names, and its pages, which have none, by their
    /// numbers.
    std::string wordFor(const ExemplarFile& companion) const {
        std::uint64_t page = 0;
        const bool named = !companion.layer.empty() && !parseUnsigned(companion.layer, page);
        const std::string ofFile =
            named ? std::string() : companionSuffix(m_result.plan.name(), companion.name());
        return (ofFile + (companion.layer.empty() ? "" : layerSuffix(companion.layer))).substr(1);
    }

    void addWhole(std::size_t i, const std::string& word, std::optional<Depth> preset) {
        const ExemplarFile& companion = m_companions[i];
        const fs::path path = m_names.next(word, mapExtension(companion.info));
        const Depth depth = companionDepth(m_options, word, preset, depthLike(companion.info, path), path);
        const MapRole role = companion.role;
        const ExportEntry entry{path,
                                role == MapRole::Other ? Message(TR("companion map"))
                                                       : Message(mapRoleTitle(writtenRole(role))),
                                false, word, depth};
        m_used.insert(i);
        m_steps.push_back({entry, [&result = m_result, &options = m_options, i, entry] {
                               writeCompanion(result, options, i, entry);
                           }});
    }

    /// Where green points in a normal map as it is written; other maps stay what they are.
    MapRole writtenRole(MapRole role) const {
        const MapRole wanted = normalsWanted(m_options);
        return isNormal(role) && isNormal(wanted) ? wanted : role;
    }

    void addPacked(const std::vector<PackedSlot>& slots, const std::string& word, std::optional<Depth> preset,
                   Depth own, const std::string& extension) {
        for (const PackedSlot& slot : slots)
            if (slot.companion)
                m_used.insert(*slot.companion);
        const fs::path path = m_names.next(word, extension);
        const Depth depth = companionDepth(m_options, word, preset, own, path);
        const ExportEntry entry{path, TR("packed companion maps"), false, word, depth};
        m_steps.push_back({entry, [&result = m_result, &options = m_options, slots, entry] {
                               writePacked(result, options, slots, entry);
                           }});
    }

    /// A packed file is packed again as it came.
    void addLikeItsFile(std::size_t i, const std::string& word) {
        const ExemplarFile& companion = m_companions[i];
        const std::string extension = mapExtension(companion.info);
        const Depth own = depthLike(companion.info, fs::path("x" + extension));
        addPacked(slotsLike(m_companions, companion), word, {}, own, extension);
    }

    const Result& m_result;
    const ExportOptions& m_options;
    const std::vector<ExemplarFile>& m_companions;
    Names m_names;
    std::set<std::size_t> m_used;
    std::vector<ExportStep> m_steps;
};

} // namespace

fs::path beside(const fs::path& image, const std::string& suffix, const std::string& extension) {
    return folderOf(image) / (image.stem().string() + suffix + extension);
}

std::vector<ExportStep> companionSteps(const Result& result, const ExportOptions& options) {
    if (!options.companions || !result.plan.hasCompanions())
        return {};
    return CompanionFiles(result, options).steps();
}

} // namespace texloom
