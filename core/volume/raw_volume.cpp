#include "core/volume/raw_volume.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/color/color_pipeline.h"
#include "core/io/file_reader.h"
#include "core/io/json_field.h"
#include "core/io/temporary_file.h"
#include "core/volume/file_slices.h"

#include <bit>
#include <cmath>
#include <utility>

namespace texloom {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they are in memory");

/// Version of the format that this build writes and the newest it reads.
constexpr int kFormat = 1;
constexpr const char* kType = "float32";
constexpr const char* kOrder = "channel, x, y, z";
constexpr std::size_t kLongestVolumeHead = 16U << 20;

/// What the .json file says.
struct VolumeHead {
    Box box;
    int channels = 0;
    bool repeats = false;
    std::string data; ///< name of the other file, in the same folder
    std::string hash, space, recipe;
};

/// What sentences about the .json file call it.
Message documentOf(const fs::path& path) {
    return message("file {}", path.string());
}

fs::path dataFileOf(const fs::path& path) {
    return fs::path(path).replace_extension(".raw");
}

std::string headText(const fs::path& path, const Box& box, int channels, const VolumeWriteOptions& options,
                     const std::string& hash) {
    JsonField::Json json;
    json["texloom-volume"] = kFormat;
    json["data"] = dataFileOf(path).filename().string();
    json["size"] = {box.size.width, box.size.height, box.size.depth};
    json["channels"] = channels;
    json["type"] = kType;
    json["bytes"] = "little-endian";
    json["order"] = kOrder;
    json["place"] = {box.x, box.y, box.z};
    json["repeats"] = options.repeats;
    json["space"] = options.space;
    json["hash"] = hash;
    if (!options.recipe.empty())
        json["recipe"] = parseJson(TR("recipe"), options.recipe);
    return json.dump(2, ' ', false, JsonField::Json::error_handler_t::replace) + "\n";
}

void interleave(const Image& picture, std::vector<float>& samples) {
    float* sample = samples.data();
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            for (int c = 0; c < picture.channels(); ++c)
                *sample++ = picture(x, y, c);
}

Image separated(const std::vector<float>& samples, Size size, int channels) {
    Image picture(size, channels);
    const float* sample = samples.data();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < channels; ++c)
                picture(x, y, c) = *sample++;
    return picture;
}

int wholeFrom(const JsonField& field, int least) {
    const int number = field.whole();
    if (number < least)
        field.wrong(message("{} or more", least));
    return number;
}

std::int64_t coordinateFrom(const JsonField& field) {
    const double number = field.number();
    if (number != std::floor(number) || std::abs(number) > static_cast<double>(Box::kFarthest))
        field.wrong(
            message("a whole number from −{} to {}", grouped(Box::kFarthest), grouped(Box::kFarthest)));
    return static_cast<std::int64_t>(number);
}

void checkText(const JsonField& field, const char* only) {
    if (field.text() != only)
        field.wrong(Message::verbatim(fmt::format("\"{}\"", only)));
}

/// The name of a file in the same folder, and nothing that leads out of it.
std::string dataNameFrom(const JsonField& field) {
    std::string name = field.text();
    if (name.empty() || name == "." || name == ".." || fs::path(name).filename() != name)
        field.wrong(TR("the name of a file in the same folder"));
    return name;
}

VolumeHead headFrom(const fs::path& path, const JsonField::Json& json) {
    const JsonField field(documentOf(path), json);
    if (!json.is_object() || !field.has("texloom-volume"))
        fail("{} does not describe a volume.", path.string());
    if (const int format = wholeFrom(field.at("texloom-volume"), 1); format > kFormat)
        fail("{} is a volume in format {}; this Texloom reads formats up to {}. A newer one reads it.",
             path.string(), format, kFormat);
    checkText(field.at("type"), kType);
    checkText(field.at("bytes"), "little-endian");
    checkText(field.at("order"), kOrder);
    const JsonField size = field.at("size"), place = field.at("place");
    size.needArray(3, 3);
    place.needArray(3, 3);
    VolumeHead head;
    head.box = {coordinateFrom(place.at(0)),
                coordinateFrom(place.at(1)),
                coordinateFrom(place.at(2)),
                {wholeFrom(size.at(0), 1), wholeFrom(size.at(1), 1), wholeFrom(size.at(2), 1)}};
    head.channels = wholeFrom(field.at("channels"), 1);
    if (!field.at("repeats").json().is_boolean())
        field.at("repeats").wrong(TR("true or false"));
    head.repeats = field.at("repeats").json().get<bool>();
    head.data = dataNameFrom(field.at("data"));
    head.space = field.at("space").text();
    head.hash = field.has("hash") ? field.at("hash").text() : std::string();
    if (field.has("recipe"))
        head.recipe =
            field.at("recipe").json().dump(2, ' ', false, JsonField::Json::error_handler_t::replace);
    return head;
}

void checkFinite(const fs::path& path, const std::vector<float>& samples, int z) {
    for (const float sample : samples)
        if (!std::isfinite(sample))
            fail("{} holds values at z = {} that are not finite numbers; Texloom needs finite ones.",
                 path.string(), z);
}

} // namespace

void writeRawVolume(const fs::path& path, const VolumeSource& source, const Box& box,
                    const VolumeWriteOptions& options, JobContext& context) {
    TemporaryFile data(dataFileOf(path)), head(path);
    std::vector<float> samples(static_cast<std::size_t>(box.size.width) *
                               static_cast<std::size_t>(box.size.height) *
                               static_cast<std::size_t>(source.channels()));
    std::int64_t offset = 0;
    forEachSlice(source, box, options.space, context, [&](int, const Image& picture) {
        interleave(picture, samples);
        data.write(samples.data(), samples.size() * sizeof(float), offset);
        offset += static_cast<std::int64_t>(samples.size() * sizeof(float));
    });
    const std::string text = headText(path, box, source.channels(), options, data.hash());
    head.write(text.data(), text.size(), 0);
    data.commit();
    head.commit();
}

std::vector<fs::path> filesOfRawVolume(const fs::path& path) {
    try {
        const VolumeHead head =
            headFrom(path, parseJson(documentOf(path), readText(path, kLongestVolumeHead)));
        return {path, path.parent_path() / head.data};
    } catch (const Error&) {
        return {path};
    }
}

LoadedVolume readRawVolume(const fs::path& path, JobContext& context, const VolumeReadOptions& options) {
    const VolumeHead head = headFrom(path, parseJson(documentOf(path), readText(path, kLongestVolumeHead)));
    const VolumeSize size = head.box.size;
    head.box.check();
    checkVolumeSize(path, size, head.channels, options.largestVoxels);
    color::findSpace(head.space);
    const fs::path dataPath = path.parent_path() / head.data;
    FileReader data(dataPath);
    if (const std::uint64_t bytes = Volume::bytesFor(size, head.channels); bytes != data.size())
        fail("{} has {} bytes; {} voxels with {} channels, as {} says, take {}.", dataPath.string(),
             grouped(data.size()), sizeText(size), head.channels, path.string(), grouped(bytes));
    if (!head.hash.empty() && fileHash(dataPath) != head.hash)
        fail("{} is not the file that {} was written for: its SHA-1 is another.", dataPath.string(),
             path.string());
    Volume volume(size, head.channels);
    const Size sliceSize{size.width, size.height};
    std::vector<float> samples(static_cast<std::size_t>(sliceSize.area()) *
                               static_cast<std::size_t>(head.channels));
    for (int z = 0; z < size.depth; ++z) {
        context.progress(static_cast<double>(z) / size.depth);
        data.read(samples.data(), samples.size() * sizeof(float),
                  static_cast<std::uint64_t>(z) * samples.size() * sizeof(float));
        checkFinite(dataPath, samples, z);
        putSlice(separated(samples, sliceSize, head.channels), head.space, z, volume);
    }
    const auto edge = head.repeats ? DenseSource::Edge::Repeats : DenseSource::Edge::Ends;
    return {std::make_shared<const DenseSource>(std::move(volume), edge, head.box.x, head.box.y, head.box.z),
            head.recipe};
}

} // namespace texloom
