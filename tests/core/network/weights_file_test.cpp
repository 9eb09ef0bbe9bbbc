#include "core/base/error.h"
#include "core/network/descriptor_network.h"
#include "core/network/weights_file.h"
#include "tests/core/network/network_job.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace texloom::test {
namespace {

using testing::HasSubstr;

/// Nothing but taps.
WeightsImport withTaps(const std::vector<std::string>& taps) {
    WeightsImport how;
    how.taps = taps;
    return how;
}

/// conv1_1 makes red less green, and twice blue; conv2_1 their sum and −1.
struct NetworkFiles {
    NetworkFiles() {
        write(R"({"tensors": [
            {"name": "pre.weight", "shape": [3, 3, 1, 1], "offset": 0},
            {"name": "pre.bias", "shape": [3], "offset": 9},
            {"name": "conv1_1.weight", "shape": [2, 3, 1, 1], "offset": 12},
            {"name": "conv1_1.bias", "shape": [2], "offset": 18},
            {"name": "conv2_1.weight", "shape": [1, 2, 1, 1], "offset": 20},
            {"name": "conv2_1.bias", "shape": [1], "offset": 22}]})");
        values({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, 2, 0, 0, 1, 1, -1});
    }
    void write(const std::string& json) const { std::ofstream(folder / "net.json") << json; }
    void values(const std::vector<float>& numbers) const {
        std::ofstream(folder / "net.bin", std::ios::binary)
            .write(reinterpret_cast<const char*>(numbers.data()),
                   static_cast<std::streamsize>(numbers.size() * sizeof(float)));
    }
    std::string refusal(const WeightsImport& how = {}) const {
        try {
            importWeights(folder / "net.json", how);
        } catch (const Error& error) {
            return error.what();
        }
        return "taken";
    }

    TemporaryFolder folder;
};

TEST(WeightsFile, isTheNetworkThatItSays) {
    const NetworkFiles files;
    const Descriptor descriptor = importWeights(files.folder / "net.json", {});
    EXPECT_EQ(descriptor.taps(), (std::vector<std::string>{"relu1_1", "relu2_1"}));
    const DescriptorNetwork network(descriptor, Pooling::Average, 0, 9);
    Tensor input(3, 2, 2);
    // Red 4, 2, 0, 2; green 1, 4, 1, 0; blue 0, 1, 2, 1.
    const float values[] = {4, 2, 0, 2, 1, 4, 1, 0, 0, 1, 2, 1};
    std::copy(std::begin(values), std::end(values), input.data());
    NetworkJob job;
    DescriptorNetwork::Workspace work;
    network.forward(input, Edges{}, work, job.context);
    const Tensor& first = network.features(0, work);
    EXPECT_EQ(std::vector<float>(first.data(), first.data() + 8),
              (std::vector<float>{3, 0, 0, 2, 0, 2, 4, 2}));
    EXPECT_EQ(*network.features(1, work).data(), 1.25F + 2 - 1);
}

TEST(WeightsFile, takesTheTapsThatAreAskedFor) {
    const NetworkFiles files;
    EXPECT_EQ(importWeights(files.folder / "net.json", withTaps({"relu1_1"})).taps(),
              (std::vector<std::string>{"relu1_1"}));
    EXPECT_THAT(files.refusal(withTaps({"relu4_1"})), HasSubstr("relu4_1"));
}

TEST(WeightsFile, refusesWhatIsDamagedOrOfAnotherNetwork) {
    const NetworkFiles files;
    files.values({1, 2, 3});
    EXPECT_THAT(files.refusal(), HasSubstr("cut short"));
    files.values(std::vector<float>(23, std::nanf("")));
    EXPECT_THAT(files.refusal(), HasSubstr("not numbers"));
    files.values(std::vector<float>(100, 0));
    files.write("no json");
    EXPECT_NE(files.refusal(), "taken");
    files.write(R"({"tensors": [{"name": "fc.weight", "shape": [4, 4], "offset": 0}]})");
    EXPECT_THAT(files.refusal(), HasSubstr("conv1_1"));
    files.write(R"({"tensors": [{"name": "conv1_1.weight", "shape": [4, 7, 3, 3], "offset": 0}]})");
    EXPECT_NE(files.refusal(), "taken");
    files.write(R"({"tensors": [{"name": "conv1_1.weight", "shape": [99999999, 3, 3, 3], "offset": 0}]})");
    EXPECT_NE(files.refusal(), "taken");
    files.write(R"({"tensors": [{"name": "conv1_1.weight", "shape": [1], "offset": -1}]})");
    EXPECT_NE(files.refusal(), "taken");
    std::filesystem::remove(files.folder / "net.bin");
    EXPECT_NE(files.refusal(), "taken");
    EXPECT_THROW(importWeights(files.folder / "net.pth", {}), UsageError);
}

} // namespace
} // namespace texloom::test
