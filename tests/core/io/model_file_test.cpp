#include "core/io/image_file.h"
#include "core/io/model_file.h"
#include "tests/core/refusal.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <limits>

namespace texloom::test {

namespace {

using Json = nlohmann::json;

Model sampleModel() {
    Model model;
    model.kind = "solid-texture";
    model.recipe = R"({"texloom": 1, "method": "solid-texture"})";
    model.exemplarHashes = {"00FF", "ABCD"};
    model.notes = {{"loss", "0.25"}, {"trained", "300 iterations — “first look”"}};
    model.arrays["block.0.weight"] = {{2, 3}, std::vector<float>{1, -2, 3.5F, 0.1F, 1e-30F, -0.0F}};
    model.arrays["step"] = {{}, std::vector<std::int64_t>{std::numeric_limits<std::int64_t>::min()}};
    model.arrays["adam.moment"] = {{3}, std::vector<double>{0.1, 1.0 / 3, 1e300}};
    model.arrays["empty"] = {{0, 7}, std::vector<float>{}};
    return model;
}

/// A file with this head and so many bytes of values, all 0.
std::string fileWith(const std::string& head, std::size_t bytes) {
    const std::uint64_t length = head.size();
    std::string file(sizeof(length), '\0');
    std::memcpy(file.data(), &length, sizeof(length));
    return file + head + std::string(bytes, '\0');
}

/// A head with one array that says this of itself.
std::string headWith(const Json& array) {
    return Json{{"__metadata__", {{"texloom.format", "1"}, {"texloom.kind", "test"}}}, {"w", array}}.dump();
}

std::string floats(const Json& shape, const Json& begin, const Json& end) {
    return headWith({{"dtype", "F32"}, {"shape", shape}, {"data_offsets", {begin, end}}});
}

void read(const std::string& bytes) {
    modelFromBytes(bytes, "m.safetensors");
}

} // namespace

TEST(ModelFile, ComesBackWhole) {
    const TemporaryFolder folder;
    const Model model = sampleModel();
    writeModel(folder / "m.safetensors", model);
    EXPECT_EQ(readModel(folder / "m.safetensors"), model);
    EXPECT_EQ(modelFromBytes(model.bytes(), "m"), model);
    EXPECT_EQ(folder.entries(), 1);
}

TEST(ModelFile, ValuesKeepTheirBits) {
    const Model back = modelFromBytes(sampleModel().bytes(), "m");
    const std::vector<float>& weights = back.values<float>("block.0.weight", {2, 3});
    EXPECT_TRUE(std::signbit(weights[5]));
    EXPECT_EQ(back.values<double>("adam.moment", {3})[1], 1.0 / 3);
    EXPECT_EQ(back.values<std::int64_t>("step", {})[0], std::numeric_limits<std::int64_t>::min());
}

TEST(ModelFile, IsSafetensors) {
    const std::string bytes = sampleModel().bytes();
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    EXPECT_EQ(length % 8, 0U);
    const Json head = Json::parse(bytes.substr(8, length));
    std::uint64_t bytesOfArrays = 0;
    for (const auto& [name, entry] : head.items())
        if (name != "__metadata__") {
            const std::uint64_t begin = entry["data_offsets"][0], end = entry["data_offsets"][1];
            EXPECT_EQ(begin % (entry["dtype"] == "F32" ? 4 : 8), 0U) << name;
            bytesOfArrays += end - begin;
        }
    EXPECT_EQ(8 + length + bytesOfArrays, bytes.size());
    EXPECT_EQ(head["block.0.weight"]["dtype"], "F32");
    EXPECT_EQ(head["block.0.weight"]["shape"], Json({2, 3}));
    float second = 0;
    std::memcpy(&second,
                bytes.data() + 8 + length + head["block.0.weight"]["data_offsets"][0].get<std::size_t>() +
                    sizeof(float),
                sizeof(second));
    EXPECT_EQ(second, -2);
    EXPECT_EQ(head["__metadata__"]["loss"], "0.25");
}

TEST(ModelFile, HashIsThatOfTheFileAndOfTheContent) {
    const TemporaryFolder folder;
    Model model = sampleModel();
    writeModel(folder / "m.safetensors", model);
    EXPECT_EQ(model.hash(), fileHash(folder / "m.safetensors"));
    const std::string before = model.hash();
    std::get<std::vector<float>>(model.arrays["block.0.weight"].values)[0] = 1.0000001F;
    EXPECT_NE(model.hash(), before);
}

TEST(ModelFile, WhatIsMissingOrOfAnotherKindIsSaid) {
    const Model model = sampleModel();
    EXPECT_THAT([&] { model.values<float>("bias", {3}); }, refusal("bias", "solid-texture"));
    EXPECT_THAT(
        [&] {
            model.values<float>("block.0.weight", {3, 2});
        },
        refusal("block.0.weight", "2 × 3 32-bit floats", "3 × 2 32-bit floats"));
    EXPECT_THAT([&] { model.values<double>("block.0.weight", {2, 3}); }, refusal("64-bit floats"));
    EXPECT_THAT([&] { model.checkKind("texture-network"); }, refusal("solid-texture", "texture-network"));
    EXPECT_NO_THROW(model.checkKind("solid-texture"));
}

TEST(ModelFile, EveryShorterFileIsRefused) {
    const std::string bytes = sampleModel().bytes();
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THAT([&] { read(bytes.substr(0, size)); }, refusal("m.safetensors")) << size;
    EXPECT_THAT([&] { read(bytes + "x"); }, refusal("damaged"));
}

TEST(ModelFile, SizesThatLieAreRefusedBeforeMemoryIsTaken) {
    EXPECT_NO_THROW(read(fileWith(floats({2, 3}, 0, 24), 24)));
    EXPECT_THAT([] { read(fileWith(floats({2, 3}, 0, 20), 20)); }, refusal("w", "2 × 3", "0 to 20"));
    EXPECT_THAT([] { read(fileWith(floats({1 << 30}, 0, 4LL << 30), 8)); }, refusal("4,294,967,296"));
    // 2^62 × 4 and 2^32 × 2^32 elements: as 64-bit numbers both overflow to few bytes.
    EXPECT_THAT([] { read(fileWith(floats({1LL << 62, 4}, 0, 0), 0)); }, refusal("w", "shape"));
    EXPECT_THAT([] { read(fileWith(floats({1LL << 32, 1LL << 32}, 0, 0), 0)); }, refusal("w", "shape"));
    EXPECT_THAT([] { read(fileWith(floats({1}, 4, 0), 4)); }, refusal("w", "4 to 0"));
    EXPECT_THAT([] { read(fileWith(floats({1}, 4, 8), 8)); }, refusal("w", "begins at byte 4"));
    EXPECT_THAT([] { read(fileWith(floats({1}, 0, 4), 8)); }, refusal("take 4 bytes", "holds 8"));
    EXPECT_THAT([] { read(fileWith(floats({-1}, 0, 4), 4)); }, refusal("w"));
    EXPECT_THAT([] { read(fileWith(floats({1.5}, 0, 4), 4)); }, refusal("w"));
    EXPECT_THAT([] { read(fileWith(floats(Json(std::vector<int>(9, 1)), 0, 4), 4)); }, refusal("8 axes"));
    EXPECT_THAT([] { read(fileWith(floats({1}, 0, 18446744073709551615ULL), 4)); }, refusal("w"));
    EXPECT_THAT([] { read(std::string(8, '\xff') + "{}"); }, refusal("18,446,744,073,709,551,615"));
}

TEST(ModelFile, ArraysThatOverlapAreRefused) {
    Json head = Json::parse(floats({1}, 0, 4));
    head["v"] = head["w"];
    EXPECT_THAT([&] { read(fileWith(head.dump(), 4)); }, refusal("begins at byte 0"));
}

TEST(ModelFile, WhatIsNoModelIsRefused) {
    EXPECT_THAT([] { read("{}"); }, refusal("2 bytes"));
    EXPECT_THAT([] { read(fileWith("{not json", 0)); }, refusal("not JSON"));
    EXPECT_THAT([] { read(fileWith("[1, 2]", 0)); }, refusal("not JSON"));
    EXPECT_THAT([] { read(fileWith("{}", 0)); }, refusal("no kind"));
    EXPECT_THAT([] { read(fileWith(R"({"__metadata__": 3})", 0)); }, refusal("no kind"));
    EXPECT_THAT([] { read(fileWith(headWith({{"dtype", "F16"}}), 0)); }, refusal("F32, F64 or I64"));
    EXPECT_THAT([] { read(fileWith(headWith("text"), 0)); }, refusal("w"));
    EXPECT_THAT([] { read(fileWith(std::string(100000, '['), 0)); }, refusal("not JSON"));
}

TEST(ModelFile, ANewerFormatIsRefusedByName) {
    const Json head = {{"__metadata__", {{"texloom.format", "7"}, {"texloom.kind", "test"}}}};
    EXPECT_THAT([&] { read(fileWith(head.dump(), 0)); }, refusal("format 7", "up to 1"));
    const Json odd = {{"__metadata__", {{"texloom.format", "x"}, {"texloom.kind", "test"}}}};
    EXPECT_THAT([&] { read(fileWith(odd.dump(), 0)); }, refusal("x"));
}

TEST(ModelFile, ValuesThatAreNotFiniteAreRefusedBothWays) {
    Model model = sampleModel();
    model.arrays["w"] = {{1}, std::vector<float>{std::numeric_limits<float>::infinity()}};
    EXPECT_THAT([&] { model.bytes(); }, refusal("w", "finite"));
    std::string bytes = fileWith(floats({1}, 0, 4), 0);
    EXPECT_THAT([&] { read(bytes + std::string("\0\0\x80\x7f", 4)); }, refusal("w", "finite"));
}

TEST(ModelFile, NamesWithLineBreaksDoNotReachSentences) {
    Json head = Json::parse(floats({1}, 0, 4));
    head["a\nb"] = head["w"];
    EXPECT_THAT([&] { read(fileWith(head.dump(), 8)); }, refusal("control characters"));
    Model model = sampleModel();
    model.arrays[""] = {{}, std::vector<float>{1}};
    EXPECT_THAT([&] { model.bytes(); }, refusal("empty"));
}

TEST(ModelFile, ShapeAndNumberOfValuesMustAgreeToBeWritten) {
    Model model;
    model.kind = "test";
    model.arrays["w"] = {{2, 2}, std::vector<float>{1, 2, 3}};
    EXPECT_THAT([&] { model.bytes(); }, refusal("w", "3 values", "2 × 2"));
}

TEST(ModelFile, AFailedWriteLeavesWhatWasThere) {
    const TemporaryFolder folder;
    Model model = sampleModel();
    writeModel(folder / "m.safetensors", model);
    Model broken = model;
    broken.arrays["w"] = {{1}, std::vector<double>{std::nan("")}};
    EXPECT_THAT([&] { writeModel(folder / "m.safetensors", broken); }, refusal("finite"));
    EXPECT_EQ(readModel(folder / "m.safetensors"), model);
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_THAT([&] { writeModel(folder / "no" / "m.safetensors", model); }, refusal("no folder"));
    EXPECT_THAT([&] { readModel(folder / "gone"); }, refusal("gone"));
    EXPECT_THAT([&] { readModel(folder.path()); }, refusal("a folder"));
}

} // namespace texloom::test
