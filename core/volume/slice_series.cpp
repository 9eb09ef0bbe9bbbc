#include "core/volume/slice_series.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/image/channel_text.h"
#include "core/volume/file_slices.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kFewestDigits = 4, kMostDigits = 9;
constexpr const char* kPeriodAttribute = "texloom:period";

/// A name such as bark-0042.png in its parts: "bark-", "0042", ".png".
struct SliceName {
    std::string begin, digits, end;

    std::string numbered(int number) const {
        return fmt::format("{}{:0{}}{}", begin, number, digits.size(), end);
    }
};

/// Nothing if no number ends the name.
std::optional<SliceName> splitName(const fs::path& path) {
    const std::string stem = path.stem().string();
    std::size_t begin = stem.size();
    while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1])) != 0)
        --begin;
    if (begin == stem.size() || stem.size() - begin > kMostDigits)
        return std::nullopt;
    return SliceName{stem.substr(0, begin), stem.substr(begin), path.extension().string()};
}

/// All files of the series that one belongs to, by their numbers.
std::map<int, fs::path> seriesOf(const fs::path& path, const SliceName& name) {
    std::map<int, fs::path> slices;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::optional<SliceName> other = splitName(entry->path());
        if (!other || other->begin != name.begin || other->end != name.end)
            continue;
        const fs::path file = path.parent_path() / entry->path().filename();
        const auto [there, fresh] = slices.emplace(std::stoi(other->digits), file);
        if (!fresh)
            fail("{} and {} have the same number; slices of a volume are numbered one by one.",
                 there->second.string(), file.string());
    }
    return slices;
}

void checkComplete(const std::map<int, fs::path>& slices, const SliceName& name) {
    const int first = slices.begin()->first, last = slices.rbegin()->first;
    int number = first;
    for (const auto& [there, path] : slices)
        if (there != number++)
            fail("The slice {} is missing; there are others from {} to {}.", name.numbered(number - 1), first,
                 last);
}

/// Files that take their places only when all are there; removed if that never comes.
class TemporarySeries {
public:
    explicit TemporarySeries(const fs::path& target) {
        static std::atomic<int> count = 0;
        const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
        m_folder = parent / fmt::format(".texloom-slices-{}-{}", ::getpid(), count++);
        std::error_code error;
        fs::create_directory(m_folder, error);
        if (error)
            fail("{} cannot be written: {}.", target.string(), error.message());
    }
    ~TemporarySeries() {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
    TemporarySeries(const TemporarySeries&) = delete;
    TemporarySeries& operator=(const TemporarySeries&) = delete;

    fs::path add(const fs::path& target) {
        m_files.emplace_back(m_folder / target.filename(), target);
        return m_files.back().first;
    }
    void commit() {
        for (const auto& [from, to] : m_files) {
            std::error_code error;
            fs::rename(from, to, error);
            if (error)
                fail("{} cannot be written: {}.", to.string(), error.message());
        }
    }

private:
    fs::path m_folder;
    std::vector<std::pair<fs::path, fs::path>> m_files;
};

/// Slices of a longer volume that was here before would be read as a part of this one.
void checkNoneBehind(const std::vector<fs::path>& files) {
    const std::optional<SliceName> name = splitName(files.front());
    for (const auto& [number, file] : seriesOf(files.front(), *name))
        if (number >= static_cast<int>(files.size()))
            fail("{} already exists and would be taken for a part of this volume of {} slices; remove it or "
                 "choose another name.",
                 file.string(), files.size());
}

bool sameKind(const ImageFileInfo& a, const ImageFileInfo& b) {
    return a.size == b.size && a.channels == b.channels;
}

} // namespace

std::vector<fs::path> sliceFiles(const fs::path& path, int depth) {
    const std::size_t digits = std::max(kFewestDigits, std::to_string(depth - 1).size());
    std::vector<fs::path> files;
    for (int z = 0; z < depth; ++z)
        files.push_back(path.parent_path() / fmt::format("{}-{:0{}}{}", path.stem().string(), z, digits,
                                                         path.extension().string()));
    return files;
}

void writeSlices(const fs::path& path, const VolumeSource& source, const Box& box,
                 const VolumeWriteOptions& options, JobContext& context) {
    checkWritable(path, source.channels(), options.depth);
    const std::vector<fs::path> files = sliceFiles(path, box.size.depth);
    checkNoneBehind(files);
    WriteOptions each;
    each.depth = options.depth;
    each.space = options.space;
    each.recipe = options.recipe;
    each.check = [&context] { context.check(); };
    if (options.repeats)
        each.attributes = {{kPeriodAttribute, std::to_string(box.size.depth)}};
    TemporarySeries series(path);
    forEachSlice(source, box, options.space, context, [&](int z, const Image& picture) {
        writeImage(series.add(files[static_cast<std::size_t>(z)]), picture, each);
    });
    series.commit();
}

std::vector<fs::path> filesOfSlices(const fs::path& path) {
    const std::optional<SliceName> name = splitName(path);
    std::vector<fs::path> files;
    try {
        if (name)
            for (const auto& [number, file] : seriesOf(path, *name))
                files.push_back(file);
    } catch (const Error&) { // two have one number: no volume
        files.clear();
    }
    return files.empty() ? std::vector<fs::path>{path} : files;
}

LoadedVolume readSlices(const fs::path& path, JobContext& context, const VolumeReadOptions& options) {
    const std::optional<SliceName> name = splitName(path);
    if (!name)
        fail("{} is no slice of a volume: its name does not end in a number of up to {} digits.",
             path.string(), kMostDigits);
    const std::map<int, fs::path> slices = seriesOf(path, *name);
    if (slices.empty())
        fail("There is no file {}.", path.string());
    checkComplete(slices, *name);
    const fs::path& firstPath = slices.begin()->second;
    const ImageFileInfo first = readImageInfo(firstPath);
    const VolumeSize size{first.size.width, first.size.height, static_cast<int>(slices.size())};
    checkVolumeSize(firstPath, size, first.channels, options.largestVoxels);
    Volume volume(size, first.channels);
    int z = 0;
    for (const auto& [number, file] : slices) {
        context.progress(static_cast<double>(z) / size.depth);
        LoadedImage slice = readImage(file, {.largestPixels = first.size.area()});
        if (!sameKind(slice.info, first))
            fail("{} is {} × {} px with {}; the volume's first slice {} is {} × {} px with {}.",
                 file.string(), slice.info.size.width, slice.info.size.height,
                 channelText(slice.info.channels), firstPath.string(), first.size.width, first.size.height,
                 first.channels);
        putSlice(std::move(slice.image), options.space.empty() ? slice.info.space : options.space, z++,
                 volume);
    }
    const bool repeats = readAttribute(firstPath, kPeriodAttribute) == std::to_string(size.depth);
    const auto edge = repeats ? DenseSource::Edge::Repeats : DenseSource::Edge::Ends;
    return {std::make_shared<const DenseSource>(std::move(volume), edge), first.recipe};
}

} // namespace texloom
