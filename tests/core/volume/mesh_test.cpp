#include "core/io/image_file.h"
#include "core/volume/mesh_file.h"
#include "tests/core/refusal.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/volumes.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// The mesh of a file with these bytes.
Mesh read(const std::string& bytes, const char* name = "m.obj") {
    const TemporaryFolder folder;
    writeText(folder / name, bytes);
    TestContext context;
    return readMesh(folder / name, context);
}

double areaOf(const Mesh& mesh) {
    double area = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vector3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        area += static_cast<double>((b - a).cross(c - a).norm()) / 2;
    }
    return area;
}

/// By the divergence theorem; positive where the corners turn left seen from outside.
double volumeOf(const Mesh& mesh) {
    double volume = 0;
    for (const Mesh::Triangle& t : mesh.triangles)
        volume +=
            static_cast<double>(mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]]))) /
            6;
    return volume;
}

/// A square of these corners, cut in two, as JSON of glTF with the buffer in it.
std::string gltfSquare(const std::string& nodes, const std::string& indices = "[0,1,2,0,2,3]") {
    return gltfText({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, indices, nodes);
}

} // namespace

TEST(Mesh, ACubeIsTheSameInEveryFormat) {
    for (const auto& [name, bytes] : cubes()) {
        SCOPED_TRACE(name);
        const Mesh mesh = read(bytes, name.c_str());
        EXPECT_EQ(mesh.triangles.size(), 12U);
        EXPECT_EQ(mesh.positions.size(), 8U);
        EXPECT_EQ(mesh.normals.size(), 8U);
        EXPECT_NEAR(areaOf(mesh), 6 * 4, 1e-5);
        EXPECT_NEAR(volumeOf(mesh), 8, 1e-5);
        EXPECT_EQ(mesh.bounds().lowest, Vector3f::Constant(-1));
        EXPECT_EQ(mesh.bounds().highest, Vector3f::Constant(1));
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_NEAR(mesh.normals[i].norm(), 1, 1e-6);
            EXPECT_GT(mesh.normals[i].dot(mesh.positions[i]), 1); // outwards
        }
    }
}

TEST(Mesh, SmoothNormalsOfASphereAreItsRadii) {
    std::string obj;
    constexpr int kRings = 24, kSides = 48;
    for (int r = 0; r <= kRings; ++r)
        for (int s = 0; s < kSides; ++s) {
            const double a = M_PI * r / kRings, b = 2 * M_PI * s / kSides;
            obj += fmt::format("v {} {} {}\n", std::sin(a) * std::cos(b), std::sin(a) * std::sin(b),
                               std::cos(a));
        }
    for (int r = 0; r < kRings; ++r)
        for (int s = 0; s < kSides; ++s) {
            const int a = r * kSides + s + 1, b = r * kSides + (s + 1) % kSides + 1;
            obj += fmt::format("f {} {} {} {}\n", a, a + kSides, b + kSides, b);
        }
    const Mesh mesh = read(obj);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (std::abs(mesh.positions[i].z()) < 0.99F) {
            EXPECT_GT(mesh.normals[i].dot(mesh.positions[i].normalized()), 0.998F);
        }
    EXPECT_NEAR(areaOf(mesh), 4 * M_PI, 0.1);
}

TEST(Mesh, PolygonsOfAnyShapeKeepTheirArea) {
    // A comb with five teeth: no fan covers it.
    std::string obj, face = "f";
    std::vector<std::pair<double, double>> outline = {{0, 0}, {12, 0}};
    for (int tooth = 4; tooth >= 0; --tooth)
        outline.insert(outline.end(),
                       {{2 * tooth + 3, 1}, {2 * tooth + 3, 5}, {2 * tooth + 2, 5}, {2 * tooth + 2, 1}});
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [x, y] = outline[i];
        const auto& [u, v] = outline[(i + 1) % outline.size()];
        twice += x * v - u * y;
        // In a plane that is square to no axis.
        obj += fmt::format("v {} {} {}\n", x / std::sqrt(2) + y / std::sqrt(3), y / std::sqrt(3),
                           -x / std::sqrt(2) + y / std::sqrt(3));
        face += fmt::format(" {}", i + 1);
    }
    const Mesh mesh = read(obj + face + "\n");
    EXPECT_LE(mesh.triangles.size(), outline.size() - 2); // slivers without area may be left out
    EXPECT_NEAR(areaOf(mesh), std::abs(twice) / 2, 1e-4);
    const Vector3f normal = mesh.normals.front();
    for (const Mesh::Triangle& t : mesh.triangles) { // none is turned over
        const Vector3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        EXPECT_GE((b - a).cross(c - a).dot(normal), -1e-5F);
    }
}

TEST(Mesh, ObjKeepsNormalsAndTextureCoordinatesOfItsCorners) {
    const Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0.25 0.75\nvn 0 0 -3\n"
                           "f 1/1/1 2/2/1 3/3/1\nf -4/-4/-1 -2/-2/-1 -1/-1/-1\n");
    ASSERT_EQ(mesh.positions.size(), 4U);
    ASSERT_EQ(mesh.uvs.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(mesh.normals[i], Vector3f(0, 0, -1));
        if (mesh.positions[i] == Vector3f(0, 1, 0)) {
            EXPECT_EQ(mesh.uvs[i], Vector2f(0.25F, 0.25F)); // v from the top
        }
    }
}

TEST(Mesh, ASeamOfTheTextureSplitsAVertex) {
    const Mesh mesh = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "f 1/1 2/2 3/3\nf 1/2 3/3 4/4\n");
    EXPECT_EQ(mesh.positions.size(), 5U);
    EXPECT_EQ(mesh.uvs.size(), 5U);
    const Mesh half = read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1 3 4\n");
    EXPECT_TRUE(half.uvs.empty());
    EXPECT_EQ(half.positions.size(), 4U);
}

TEST(Mesh, PlyReadsEveryType) {
    const Mesh mesh = read("ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nelement camera 2\r\n"
                           "property float f\r\nproperty list uchar short keys\r\nelement vertex 3\r\n"
                           "property double z\r\nproperty float x\r\nproperty int16 y\r\nproperty float u\r\n"
                           "property float v\r\nelement face 1\r\nproperty uchar flags\r\n"
                           "property list uint8 int vertex_index\r\nend_header\r\n"
                           "1.5 2 7 8\r\n-1 0\r\n5 0 0 0 0\r\n5 1e0 0 1 0\r\n5 0 1 0 1\r\n9 3 0 1 2",
                           "m.ply");
    ASSERT_EQ(mesh.positions.size(), 3U);
    EXPECT_EQ(mesh.positions[1], Vector3f(1, 0, 5));
    EXPECT_EQ(mesh.uvs[2], Vector2f(0, 0));
    EXPECT_EQ(mesh.normals[0], Vector3f(0, 0, 1));
}

TEST(Mesh, NodesPlaceWhatIsInThem) {
    const Mesh moved = read(gltfSquare(R"([{"mesh":0,"translation":[10,0,0],"scale":[2,3,1]}])"), "m.gltf");
    EXPECT_EQ(moved.bounds().lowest, Vector3f(10, 0, 0));
    EXPECT_EQ(moved.bounds().highest, Vector3f(12, 3, 0));
    // A quarter turn about x takes the normal from z to −y.
    const Mesh turned =
        read(gltfSquare(R"([{"children":[1],"rotation":[0.70710678,0,0,0.70710678]},{"mesh":0}])"), "m.gltf");
    EXPECT_NEAR(turned.normals[0].y(), -1, 1e-5);
    EXPECT_NEAR(turned.bounds().highest.z(), 1, 1e-5);
    const Mesh mirrored = read(gltfSquare(R"([{"mesh":0,"scale":[-1,1,1]}])"), "m.gltf");
    EXPECT_NEAR(mirrored.normals[0].z(), 1, 1e-6);
    EXPECT_NEAR(areaOf(mirrored), 1, 1e-6);
}

TEST(Mesh, WhatIsNoneIsRefused) {
    EXPECT_THAT([] { read("hello"); }, refusal("m.obj", "OBJ, PLY or glTF"));
    EXPECT_THAT([] { read(""); }, refusal("m.obj"));
    EXPECT_THAT([] { read("v 0 0 0\nv 1 0 0\nv 0 1 0\n"); }, refusal("no faces"));
    EXPECT_THAT(
        [] {
            read("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n",
                 "m.ply");
        },
        refusal("no faces"));
    EXPECT_THAT([] { read("{}", "m.gltf"); }, refusal("m.gltf"));
    EXPECT_THAT([] { read("glTF\2\0\0\0", "m.glb"); }, refusal("m.glb"));
    TestContext context;
    EXPECT_THAT([&] { readMesh("/nowhere/m.obj", context); }, refusal("/nowhere/m.obj"));
}

TEST(Mesh, FacesWithoutAreaGoAndAreCounted) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\n";
    for (int i = 0; i < 1000; ++i)
        obj += "f 1 2 3\nf 1 1 2\nf 1 2\n";
    EXPECT_THAT([&] { read(obj); }, refusal("no faces", "3000"));
    EXPECT_EQ(read(obj + "f 1 2 4\n").triangles.size(), 1U);
}

TEST(Mesh, IndicesThatLeadNowhereAreRefused) {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_THAT([&] { read(three + "f 1 2 4\n"); }, refusal("vertex 4", "there are 3"));
    EXPECT_THAT([&] { read(three + "f 1 2 0\n"); }, refusal("vertex 0"));
    EXPECT_THAT([&] { read(three + "f -1 -2 -4\n"); }, refusal("vertex 0"));
    EXPECT_THAT([&] { read(three + "f 1//1 2//1 3//1\n"); }, refusal("normal 1", "there are 0"));
    EXPECT_THAT([&] { read(three + "f 1/-1 2/-1 3/-1\n"); }, refusal("texture coordinate 1"));
    EXPECT_THAT([&] { read(three + "f 1 2 2147483647\n"); }, refusal("2147483647"));
    const auto ply = [](const char* face) {
        return std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                           "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                           "end_header\n0 0 0\n1 0 0\n0 1 0\n") +
               face;
    };
    EXPECT_THAT([&] { read(ply("3 0 1 3\n"), "m.ply"); }, refusal("vertex 4"));
    EXPECT_THAT([&] { read(ply("3 0 1 -1\n"), "m.ply"); }, refusal("vertex 0"));
    EXPECT_THAT([&] { read(ply("3 0 1 0.5\n"), "m.ply"); }, refusal("0.5", "whole"));
    EXPECT_THAT([&] { read(ply("3 0 1"), "m.ply"); }, refusal("breaks off"));
    EXPECT_THAT([&] { read(ply("-3 0 1 2"), "m.ply"); }, refusal("-3 corners"));
    EXPECT_THAT([&] { read(gltfSquare(R"([{"mesh":0}])", "[0,1,4]"), "m.gltf"); }, refusal("vertex 5"));
}

TEST(Mesh, NumbersThatAreNoneAreRefused) {
    EXPECT_THAT([] { read("v 0 0 1e30\nf 1 1 1\n"); }, refusal("vertex 1", "1000000000000"));
    EXPECT_THAT([] { read("v 0 0 1e300\nf 1 1 1\n"); }, refusal("vertex 1"));
    EXPECT_THAT(
        [] {
            read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n0 nan 0\n",
                 "m.ply");
        },
        refusal("vertex 1", "nan"));
    EXPECT_THAT(
        [] {
            read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                 "property float z\nend_header\n0 zero 0\n",
                 "m.ply");
        },
        refusal("number"));
}

TEST(Mesh, CountsThatTheFileCannotHoldAreRefusedFirst) {
    const std::string head = "property float x\nproperty float y\nproperty float z\nend_header\n";
    EXPECT_THAT(
        [&] { read("ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" + head, "m.ply"); },
        refusal("4,000,000,000", "vertex", "room for 0"));
    EXPECT_THAT(
        [&] {
            read("ply\nformat ascii 1.0\nelement vertex 18446744073709551615\n" + head + "0 0 0", "m.ply");
        },
        refusal("18,446,744,073,709,551,615"));
    EXPECT_THAT([&] { read("ply\nformat ascii 1.0\nelement vertex 18446744073709551616\n" + head, "m.ply"); },
                refusal("element vertex 18446744073709551616"));
    EXPECT_THAT([] { read("ply\nformat ascii 1.0\nelement nothing 4000000000\nend_header\n", "m.ply"); },
                refusal("nothing", "room for 0"));
}

TEST(Mesh, HugePolygonsAreRefused) {
    std::string obj, face = "f";
    for (int i = 0; i < 60000; ++i) {
        obj += fmt::format("v {} {} 0\n", std::cos(i * 1e-4), std::sin(i * 1e-4));
        face += fmt::format(" {}", i + 1);
    }
    EXPECT_THAT([&] { read(obj + face + "\n"); }, refusal("60000 corners", "up to 256"));
}

TEST(Mesh, HeadsOfPlyThatAreNoneAreRefused) {
    EXPECT_THAT([] { read("ply\nformat ascii 1.0\nelement vertex 3\n", "m.ply"); }, refusal("does not end"));
    EXPECT_THAT([] { read("ply\nend_header\n", "m.ply"); }, refusal("end_header"));
    EXPECT_THAT([] { read("ply\nformat utf7 1.0\nend_header\n", "m.ply"); }, refusal("format utf7"));
    EXPECT_THAT([] { read("ply\nformat ascii 1.0\nproperty float x\nend_header\n", "m.ply"); },
                refusal("property float x"));
    EXPECT_THAT(
        [] {
            read("ply\nformat ascii 1.0\nelement face 1\nproperty list float int l\nend_header\n", "m.ply");
        },
        refusal("list float"));
    EXPECT_THAT([] { read("ply\nformat ascii 1.0\nelement face 1\nproperty half l\nend_header\n", "m.ply"); },
                refusal("half"));
    EXPECT_THAT(
        [] { read("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n3\n", "m.ply"); },
        refusal("x, y and z"));
}

TEST(Mesh, GltfThatLiesIsRefused) {
    const std::string good = gltfSquare(R"([{"mesh":0}])");
    const auto with = [&good](const std::string& what, const std::string& instead) {
        std::string bytes = good;
        const std::size_t at = bytes.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return bytes.replace(at, what.size(), instead);
    };
    EXPECT_NO_THROW(read(good, "m.gltf"));
    EXPECT_THAT([&] { read(with("\"count\":4", "\"count\":5"), "m.gltf"); }, refusal("m.gltf"));
    EXPECT_THAT([&] { read(with("\"count\":4", "\"count\":4611686018427387904"), "m.gltf"); },
                refusal("m.gltf"));
    EXPECT_THAT([&] { read(with("\"componentType\":5126", "\"componentType\":5130"), "m.gltf"); },
                refusal("m.gltf"));
    EXPECT_THAT([&] { read(with("\"POSITION\":0", "\"POSITION\":9"), "m.gltf"); }, refusal("m.gltf"));
    EXPECT_THAT([&] { read(gltfSquare(R"([{"mesh":0,"children":[0]}])"), "m.gltf"); }, refusal("nested"));
    EXPECT_THAT(
        [&] {
            read(with("{\"asset\"", "{\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"asset\""),
                 "m.gltf");
        },
        refusal("KHR_draco_mesh_compression"));
}

TEST(Mesh, GltfReadsNoFileOutsideItsFolder) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "in");
    const std::string bytes = gltfBytes({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3});
    writeText(folder / "secret.bin", bytes);
    writeText(folder / "in" / "beside.bin", bytes);
    TestContext context;
    const auto reading = [&](const std::string& uri) {
        writeText(folder / "in" / "m.gltf", gltfWith(uri, bytes.size(), 4, 6, R"([{"mesh":0}])"));
        return readMesh(folder / "in" / "m.gltf", context);
    };
    EXPECT_EQ(reading("beside.bin").triangles.size(), 2U);
    EXPECT_THAT([&] { reading("../secret.bin"); }, refusal("m.gltf"));
    EXPECT_THAT([&] { reading((folder / "secret.bin").string()); }, refusal("m.gltf"));
    EXPECT_THAT([&] { reading("gone.bin"); }, refusal("m.gltf"));
}

} // namespace texloom::test
