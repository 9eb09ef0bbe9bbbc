#include "core/image/image.h"
#include "core/io/image_file.h"
#include "core/network/descriptor.h"
#include "tests/cli/program.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace texloom::test {
namespace {

using ::testing::HasSubstr;

class Descriptors : public ::testing::Test {
protected:
    Descriptors() {
        writeImage(m_folder / "a.png", blobs({64, 60}, 3, 1), {});
        writeImage(m_folder / "b.png", blobs({48, 48}, 1, 2), {});
    }
    Ended learn(const std::string& output, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {
            "learn-descriptor", "a.png",   "b.png", "-o",        output, "--layers",
            "6x5,8x3",          "--sides", "48,32", "--patches", "300",  "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments, m_folder.path());
    }
    TemporaryFolder m_folder;
};

TEST_F(Descriptors, areLearnedWithTheSameBytes) {
    ASSERT_EQ(learn("one.safetensors", {"--threads", "1", "--name", "mine", "--licence", "CC0-1.0"}).status,
              0);
    ASSERT_EQ(learn("two.safetensors", {"--threads", "2", "--name", "mine", "--licence", "CC0-1.0"}).status,
              0);
    EXPECT_EQ(fileHash(m_folder / "one.safetensors"), fileHash(m_folder / "two.safetensors"));
    const Ended told = runCli({"descriptor", "one.safetensors", "--json"}, m_folder.path());
    ASSERT_EQ(told.status, 0) << told.err;
    const nlohmann::json json = nlohmann::json::parse(told.out);
    EXPECT_EQ(json["name"], "mine");
    EXPECT_EQ(json["licence"], "CC0-1.0");
    EXPECT_EQ(json["taps"], (std::vector<std::string>{"relu1", "relu2"}));
    EXPECT_EQ(json["sha1"], fileHash(m_folder / "one.safetensors"));
}

TEST_F(Descriptors, areUsedAndNamedInTheReport) {
    const std::string listed = runCli({"methods", "gram-cnn"}, m_folder.path()).err;
    if (listed.find("gram-cnn is not part of this build") != std::string::npos)
        GTEST_SKIP() << "skipped: this build is made without networks";
    ASSERT_EQ(learn("one.safetensors", {"--name", "mine", "--licence", "CC0-1.0"}).status, 0);
    const Ended made =
        runCli({"synth", "gram-cnn", "a.png", "-o", "out.png", "--size", "32", "--set", "iterations=2",
                "--input", "descriptor=one.safetensors", "--report", "report.json", "--quiet"},
               m_folder.path());
    ASSERT_EQ(made.status, 0) << made.err;
    std::ifstream report(m_folder / "report.json");
    const nlohmann::json json = nlohmann::json::parse(report);
    EXPECT_THAT(json["notes"].dump(), HasSubstr("mine"));
    EXPECT_THAT(json["notes"].dump(), HasSubstr("CC0-1.0"));
    EXPECT_THAT(json["notes"].dump(), HasSubstr(fileHash(m_folder / "one.safetensors")));
}

TEST_F(Descriptors, refuseInASentence) {
    const auto complaint = [&](const Ended& ended) {
        EXPECT_NE(ended.status, 0);
        EXPECT_EQ(ended.complaints(), 1) << ended.err;
        return ended.err;
    };
    EXPECT_THAT(complaint(learn("one.png")), HasSubstr(".safetensors"));
    EXPECT_THAT(complaint(learn("one.safetensors", {"--layers", "6x4"})), HasSubstr("6x4"));
    EXPECT_THAT(complaint(runCli({"descriptor", "a.png"}, m_folder.path())), HasSubstr("a.png"));
    EXPECT_THAT(complaint(runCli({"import-descriptor", "vgg.pth", "-o", "v.safetensors", "--licence", "x",
                                  "--credit", "y"},
                                 m_folder.path())),
                HasSubstr(".json"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "v.safetensors"));
}

TEST_F(Descriptors, ownIsTheOneThatShips) {
    const Ended told = runCli({"descriptor", "--json"}, m_folder.path());
    ASSERT_EQ(told.status, 0) << told.err;
    const nlohmann::json json = nlohmann::json::parse(told.out);
    EXPECT_EQ(json["sha1"], fileHash(TEXLOOM_SOURCE_DIR "/resources/descriptors/own.safetensors"));
    EXPECT_EQ(json["parameters"], 155936);
}

} // namespace
} // namespace texloom::test
