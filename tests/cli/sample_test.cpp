// Boxes, slices and coloured meshes of solids, as a user asks for them.

#include "core/generator/generator_weights.h"
#include "core/io/image_file.h"
#include "core/io/model_file.h"
#include "core/job/job.h"
#include "core/volume/mesh_file.h"
#include "core/volume/volume_file.h"
#include "tests/cli/program.h"
#include "tests/support/meshes.h"
#include "tests/support/volumes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texloom::test {
namespace {

using ::testing::HasSubstr;

/// A folder with an untrained generator, a dense volume that ends, and a mesh.
class Sampling : public ::testing::Test {
protected:
    Sampling() {
        GeneratorShape shape;
        shape.coarsest = 2;
        shape.step = 2;
        writeModel(m_folder / "solid.safetensors", *GeneratorWeights::drawn(shape, 1).model());
        Model other;
        other.kind = "moments";
        writeModel(m_folder / "other.safetensors", other);
        JobMonitor monitor;
        JobContext context(
            {0, 2, false}, [] { return false; }, monitor);
        const DenseSource dense(sampleVolume({8, 7, 6}, 3), DenseSource::Edge::Ends);
        writeVolume(m_folder / "dense.json", dense, {0, 0, 0, {8, 7, 6}}, {}, context);
        for (const auto& [name, text] : cubes())
            writeText(m_folder / name, text);
    }
    Ended sample(std::vector<std::string> more) const {
        more.insert(more.begin(), "sample");
        more.emplace_back("--quiet");
        return runCli(more, m_folder.path());
    }
    Volume volume(const std::string& name) const {
        JobMonitor monitor;
        JobContext context(
            {0, 2, false}, [] { return false; }, monitor);
        return readVolume(m_folder / name, context).source->volume();
    }
    TemporaryFolder m_folder;
};

TEST_F(Sampling, boxesFitTogether) {
    ASSERT_EQ(sample({"solid.safetensors", "--box", "-5,-4,-3,12,10,8", "-o", "whole.json"}).status, 0);
    ASSERT_EQ(sample({"solid.safetensors", "--box", "1,0,2,3,4,2", "-o", "part.json"}).status, 0);
    const Volume whole = volume("whole.json"), part = volume("part.json");
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 3; ++x)
                EXPECT_EQ(part(x, y, z, 1), whole(x + 6, y + 4, z + 5, 1));
}

TEST_F(Sampling, slicesAreNumberedPictures) {
    ASSERT_EQ(sample({"dense.json", "--box", "1,1,1,4,3,2", "-o", "s.tif", "--depth", "float", "--out-space",
                      "raw"})
                  .status,
              0);
    const Image slice = readImage(m_folder / "s-0001.tif").image;
    EXPECT_EQ(slice.size(), (Size{4, 3}));
    EXPECT_EQ(slice(2, 1, 2), sampleVolume({8, 7, 6}, 3)(3, 2, 2, 2));
}

TEST_F(Sampling, planesAreSquareToAnAxisOrFree) {
    ASSERT_EQ(
        sample({"dense.json", "--plane", "x=3", "--size", "6x7", "-o", "x.exr", "--out-space", "raw"}).status,
        0);
    ASSERT_EQ(sample({"dense.json", "--plane", "3,0,0,0,0,1,0,1,0", "--size", "6x7", "-o", "free.exr",
                      "--out-space", "raw"})
                  .status,
              0);
    EXPECT_TRUE(samePixels(readImage(m_folder / "x.exr").image, readImage(m_folder / "free.exr").image));
}

TEST_F(Sampling, meshesGetTheColoursOfTheirPlaces) {
    for (const char* name : {"out.ply", "out.obj", "out.glb"}) {
        const Ended ended = sample({"solid.safetensors", "--mesh", cubes().begin()->first, "-o", name});
        ASSERT_EQ(ended.status, 0) << ended.err;
        JobMonitor monitor;
        JobContext context(
            {0, 2, false}, [] { return false; }, monitor);
        EXPECT_EQ(readMesh(m_folder / name, context).triangles.size(), 12U)
            << name << ", which is read again";
    }
}

TEST_F(Sampling, refusesInASentence) {
    const auto complaint = [&](const std::vector<std::string>& arguments) {
        const Ended ended = sample(arguments);
        EXPECT_NE(ended.status, 0);
        EXPECT_EQ(ended.complaints(), 1) << ended.err;
        return ended.err;
    };
    EXPECT_THAT(complaint({"solid.safetensors", "--box", "0,0,0,10000,10000,10000", "-o", "o.json"}),
                HasSubstr("1,000,000,000,000 voxels"));
    EXPECT_THAT(complaint({"solid.safetensors", "--box", "0,0,0,4,4", "-o", "o.json"}),
                HasSubstr("5 numbers and needs 6"));
    EXPECT_THAT(complaint({"solid.safetensors", "--box", "0,0,0,4,4,0", "-o", "o.json"}), HasSubstr("empty"));
    EXPECT_THAT(complaint({"solid.safetensors", "-o", "o.json"}), HasSubstr("0 are given"));
    EXPECT_THAT(complaint({"other.safetensors", "--plane", "z=0", "-o", "o.png"}), HasSubstr("moments"));
    EXPECT_THAT(complaint({"dense.json", "--plane", "z=99", "-o", "o.png"}), HasSubstr("beside the volume"));
    EXPECT_THAT(complaint({"dense.json", "--box", "0,0,0,9,9,9", "-o", "o.json"}),
                HasSubstr("not all within"));
    EXPECT_THAT(complaint({"solid.safetensors", "--mesh", cubes().begin()->first, "-o", "o.stl"}),
                HasSubstr(".ply, .obj or .glb"));
    EXPECT_THAT(complaint({"solid.safetensors", "--tile", "33", "--plane", "z=0", "-o", "o.png"}),
                HasSubstr("multiple of 32"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "o.json"));
    EXPECT_FALSE(std::filesystem::exists(m_folder / "o.png"));
}

} // namespace
} // namespace texloom::test
