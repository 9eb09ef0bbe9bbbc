// Layers and parts of files, chosen on the command line wherever a picture is read.

#include "core/io/image_file.h"
#include "tests/cli/program.h"
#include "tests/core/io/foreign_files.h"
#include "tests/support/textures.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace texloom::test {

namespace {

using ::testing::HasSubstr;

class LayerOptions : public ::testing::Test {
protected:
    LayerOptions() {
        writeParts(m_folder / "parts.exr", {m_plain, m_wild}, {"plain", "wild"});
        Image maps({32, 24}, 2);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 32; ++x) {
                maps(x, y, 0) = 0.25F;
                maps(x, y, 1) = x < 16 ? 1.0F : 0.0F;
            }
        writeForeign(m_folder / "maps.exr", maps, {.channelNames = {"roughness.Y", "matte.Y"}});
        WriteOptions options;
        options.depth = Depth::Float;
        options.space = "linear";
        writeImage(m_folder / "wild.exr", m_wild, options);
        writeImage(m_folder / "matte.exr", Image(maps.view().channelRange(1, 1)), options);
    }

    Ended run(std::vector<std::string> arguments) const { return runCli(arguments, m_folder.path()); }
    void made(const std::vector<std::string>& arguments) const {
        const Ended end = run(arguments);
        EXPECT_EQ(end.status, 0) << end.err;
    }
    void refused(const std::vector<std::string>& arguments, const std::string& why) const {
        const Ended end = run(arguments);
        EXPECT_EQ(end.status, 2);
        EXPECT_EQ(end.complaints(), 1);
        EXPECT_THAT(end.err, HasSubstr(why));
    }
    Image image(const std::string& name) const { return readImage(m_folder / name).image; }

    TemporaryFolder m_folder;
    Image m_plain = Image({32, 24}, 3), m_wild = blobs({32, 24}, 3);
};

} // namespace

TEST_F(LayerOptions, AreForExemplarsMasksAndCompanions) {
    made({"synth", "quilting", "wild.exr", "--mask", "matte.exr", "--set", "patch=8", "-o", "a.exr",
          "--quiet"});
    made({"synth", "quilting", "parts.exr", "--layer", "wild", "--mask", "maps.exr", "--layer", "mask=matte",
          "--companion", "maps.exr", "--layer", "companion=roughness", "--set", "patch=8", "-o", "b.exr",
          "--quiet"});
    EXPECT_TRUE(samePixels(image("a.exr"), image("b.exr")));
    EXPECT_EQ(image("b_roughness.exr").channels(), 1);
    EXPECT_EQ(image("b_roughness.exr")(3, 3, 0), 0.25F);
    made({"run", "b.json", "-o", "c.exr", "--quiet"}); // the recipe names the layers
    EXPECT_TRUE(samePixels(image("a.exr"), image("c.exr")));
    made({"synth", "quilting", "parts.exr", "--layer", "wild", "--companion", "maps.exr", "--companion",
          "maps.exr", "--layer", "companion=roughness", "--layer", "companion=matte", "-o", "d.exr",
          "--quiet"});
    EXPECT_EQ(image("d_roughness.exr")(3, 3, 0), 0.25F);
    EXPECT_THAT(image("d_matte.exr")(3, 3, 0), ::testing::AnyOf(0.0F, 1.0F));
}

TEST_F(LayerOptions, AreForInputs) {
    made({"synth", "texture-optimization", "wild.exr", "--init", "wild.exr", "--size", "32x24", "-o", "a.exr",
          "--quiet"});
    made({"synth", "texture-optimization", "wild.exr", "--init", "parts.exr", "--layer", "initial=wild",
          "--size", "32x24", "-o", "b.exr", "--quiet"});
    EXPECT_TRUE(samePixels(image("a.exr"), image("b.exr")));
}

TEST_F(LayerOptions, AreForTheOtherCommands) {
    made({"blend", "wild.exr", "wild.exr", "-o", "a.exr", "--band", "8", "--method", "cut", "--quiet"});
    made({"blend", "parts.exr", "wild.exr", "--layer", "wild", "--layer", "", "-o", "b.exr", "--band", "8",
          "--method", "cut", "--quiet"});
    EXPECT_TRUE(samePixels(image("a.exr"), image("b.exr")));
    made({"synth", "quilting", "wild.exr", "--set", "patch=8", "-o", "c.exr", "--map", "map.exr", "--quiet"});
    made({"apply", "map.exr", "wild.exr", "-o", "d.exr", "--quiet"});
    made({"apply", "map.exr", "parts.exr", "--layer", "wild", "-o", "e.exr", "--quiet"});
    EXPECT_TRUE(samePixels(image("d.exr"), image("e.exr")));
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"analyze", "methods", "parts.exr"},
                                               {"analyze", "statistics", "parts.exr", "--patch", "4"},
                                               {"analyze", "lattice", "parts.exr"}}) {
        std::vector<std::string> layered = command;
        layered.insert(layered.end(), {"--layer", "wild"});
        made(layered);
        layered.back() = "gone";
        refused(layered, "parts.exr has no layer gone; there is plain and wild.");
    }
    for (const char* figures : {"maps", "quality"})
        made({"analyze", figures, "parts.exr", "parts.exr", "--layer", "result=wild", "--layer", "wild"});
}

TEST_F(LayerOptions, ThatAreNotThereAreNamed) {
    const std::vector<std::string> synth = {"synth", "quilting", "wild.exr", "-o", "out.exr"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), synth.begin(), synth.end());
        return more;
    };
    refused(with({"--layer", "diffuse"}), "wild.exr has no layer diffuse; all that it holds is one picture.");
    refused(with({"--mask", "maps.exr", "--layer", "mask=gone"}),
            "maps.exr has no layer gone; there is matte and roughness.");
    refused(with({"--companion", "maps.exr", "--layer", "companion=gone"}), "maps.exr has no layer gone");
    refused(with({"--layer", "mask=matte"}), "--layer mask=matte: no file is given for mask.");
    refused(with({"--layer", "a", "--layer", "b"}), "2 layers were given for 1 files (exemplar)");
    refused({"apply", "maps.exr", "wild.exr", "--layer", "map=gone", "-o", "out.exr"},
            "maps.exr has no layer gone");
    EXPECT_FALSE(std::filesystem::exists(m_folder / "out.exr"));
}

TEST_F(LayerOptions, NumbersAreWrittenWithDecimalDigits) {
    const std::vector<std::string> synth = {"synth", "quilting", "wild.exr", "-o", "out.exr"};
    for (const std::vector<std::string>& number :
         std::vector<std::vector<std::string>>{{"--threads", "0x2"},
                                               {"--threads", "many"},
                                               {"--threads", "2.0"},
                                               {"--threads", " 2"},
                                               {"--memory", "0x400"},
                                               {"--seed", "0x1"},
                                               {"--weight", "0x1p1"},
                                               {"--weight", "inf"},
                                               {"--weight", "nan"},
                                               {"--size", "0x40"},
                                               {"--region", "0x0,0,8,8"},
                                               {"--set", "patch=0x8"}}) {
        std::vector<std::string> all = synth;
        all.insert(all.end(), number.begin(), number.end());
        refused(all, number.back().substr(number.back().find('=') + 1));
    }
    refused({"stress", "quilting", "wild.exr", "-o", "out", "--rounds", "0b10"}, "0b10");
    refused({"analyze", "statistics", "wild.exr", "--patch", "4,0x8"}, "0x8");
    refused({"batch", "none.json", "--threads", "0x2"}, "0x2");
    EXPECT_FALSE(std::filesystem::exists(m_folder / "out.exr"));
}

} // namespace texloom::test
