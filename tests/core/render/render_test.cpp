#include "core/base/error.h"
#include "core/render/microfacets.h"
#include "core/render/render.h"
#include "core/render/visibility.h"
#include "tests/core/render/straight_on.h"
#include "tests/support/textures.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texloom::test {
namespace {

constexpr Size kPicture{96, 96};

/// Calls `work` with a context of so many threads.
template <class Work> auto onThreads(int threads, const Work& work) {
    JobMonitor monitor;
    JobContext context(
        {0, threads, false}, [] { return false; }, monitor);
    return work(context);
}

std::shared_ptr<const Image> filled(int channels, float value, Size size = {16, 16}) {
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            std::fill_n(image.plane(c).row(y), size.width, value);
    return std::make_shared<const Image>(std::move(image));
}

Environment white() {
    return onThreads(2, [](JobContext& context) { return Environment(*filled(3, 2, {64, 32}), context); });
}

/// Light from one side of directions of a panorama of two by one pixels: the left half is −x.
Environment fromTheLeft() {
    Image panorama({64, 32}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 32; ++y)
            std::fill_n(panorama.plane(c).row(y), 32, 1.0F);
    return onThreads(2, [&](JobContext& context) { return Environment(panorama, context); });
}

Image picture(const RenderMesh& mesh, const Material& material, const Environment& light, const Look& look,
              int threads = 2, Size size = kPicture) {
    return onThreads(threads, [&](JobContext& context) {
        return rendered(mesh, MaterialTexture(material), light, look, size, context);
    });
}

/// The mean over all that is covered.
double meanOf(const Image& image, int channel) {
    double sum = 0, covered = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image(x, y, 3) > 0) {
                sum += static_cast<double>(image(x, y, channel));
                ++covered;
            }
    return sum / covered;
}

/// How far apart two pictures are at most.
float apart(const Image& a, const Image& b) {
    float most = 0;
    for (int c = 0; c < a.channels(); ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                most = std::max(most, std::abs(a(x, y, c) - b(x, y, c)));
    return most;
}

TEST(Render, aWhiteSurfaceInWhiteLightIsNotSeen) {
    const Environment light = white();
    const RenderMesh sphere = renderMesh(BasicShape::Sphere);
    for (const float roughness : {0.05F, 0.3F, 0.6F, 1.0F})
        for (const float metallic : {0.0F, 1.0F}) {
            Material material;
            material.maps[MapRole::Color] = filled(3, 1);
            material.roughness = roughness;
            material.metallic = metallic;
            const Image seen = picture(sphere, material, light, straightOn());
            for (int y = 0; y < seen.height(); ++y)
                for (int x = 0; x < seen.width(); ++x)
                    if (seen(x, y, 3) > 0) {
                        ASSERT_NEAR(seen(x, y, 1), 1, 0.02)
                            << roughness << " " << metallic << " at " << x << ", " << y;
                    }
        }
}

TEST(Render, lightThatIsTheSameAllAroundIsOneWhereverItIsAsked) {
    const Environment light = white();
    for (const Eigen::Vector3f& direction :
         {Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0, 0, -1), Eigen::Vector3f(0.6F, -0.8F, 0)}) {
        EXPECT_NEAR(light.irradiance(direction).y(), 1, 0.01);
        for (const float roughness : {0.0F, 0.4F, 1.0F})
            EXPECT_NEAR(light.radiance(direction, roughness).y(), 1, 0.01);
    }
}

TEST(Render, irradianceOfHalfASkyIsAHalfAndItsLobesWiden) {
    const Environment light = fromTheLeft();
    const Eigen::Vector3f left(-1, 0, 0), up(0, 1, 0);
    // The mean over all directions is 1, so that the lit half shines with 2.
    EXPECT_NEAR(light.irradiance(left).y(), 2, 0.1);
    EXPECT_NEAR(light.irradiance(up).y(), 1, 0.05);
    EXPECT_NEAR(light.irradiance(-left).y(), 0, 0.1);
    const Eigen::Vector3f near = Eigen::Vector3f(0.25F, 0, 1).normalized();
    EXPECT_NEAR(light.radiance(near, 0).y(), 0, 1e-5);
    EXPECT_LT(light.radiance(near, 0.4F).y(), light.radiance(near, 0.9F).y());
}

TEST(Render, aMirrorReflectsAsSchlickSays) {
    for (const float cosine : {0.2F, 0.5F, 0.9F}) {
        const Reflected reflected = SplitSum::table().at(cosine, 0.016F);
        const double fresnel = std::pow(1 - static_cast<double>(cosine), 5);
        EXPECT_NEAR(reflected.bias, fresnel, 0.02);
        EXPECT_NEAR(reflected.scale, 1 - fresnel, 0.02);
    }
}

TEST(Render, aFlatNormalMapIsAsNone) {
    Material flat;
    flat.maps[MapRole::Color] = filled(3, 0.4F);
    Material withMap = flat;
    Image normals({16, 16}, 3);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            normals(x, y, 0) = normals(x, y, 1) = 0.5F;
            normals(x, y, 2) = 1;
        }
    withMap.maps[MapRole::NormalGl] = std::make_shared<const Image>(std::move(normals));
    const RenderMesh sphere = renderMesh(BasicShape::Sphere);
    EXPECT_LT(apart(picture(sphere, flat, fromTheLeft(), straightOn()),
                    picture(sphere, withMap, fromTheLeft(), straightOn())),
              1e-4F);
}

/// A material whose normals lean to one side everywhere.
Material leaning(float red, float green, MapRole role) {
    Material material;
    material.maps[MapRole::Color] = filled(3, 0.5F);
    Image normals({16, 16}, 3);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            normals(x, y, 0) = red;
            normals(x, y, 1) = green;
            normals(x, y, 2) = 0.85F;
        }
    material.maps[role] = std::make_shared<const Image>(std::move(normals));
    return material;
}

TEST(Render, whatLeansToTheLightIsBrighter) {
    const RenderMesh plane = renderMesh(BasicShape::Plane);
    const auto brightness = [&](const Material& material) {
        return meanOf(picture(plane, material, fromTheLeft(), straightOn()), 1);
    };
    EXPECT_GT(brightness(leaning(0.15F, 0.5F, MapRole::NormalGl)),
              1.5 * brightness(leaning(0.85F, 0.5F, MapRole::NormalGl)));
}

TEST(Render, greenPointsUpInOneKindOfNormalsAndDownInTheOther) {
    Image above({64, 32}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 16; ++y)
            std::fill_n(above.plane(c).row(y), 64, 1.0F);
    const Environment sky = onThreads(1, [&](JobContext& context) { return Environment(above, context); });
    const RenderMesh plane = renderMesh(BasicShape::Plane);
    const auto brightness = [&](float green, MapRole role) {
        return meanOf(picture(plane, leaning(0.5F, green, role), sky, straightOn()), 1);
    };
    EXPECT_GT(brightness(0.85F, MapRole::NormalGl), 1.5 * brightness(0.15F, MapRole::NormalGl));
    EXPECT_NEAR(brightness(0.85F, MapRole::NormalGl), brightness(0.15F, MapRole::NormalDx), 1e-6);
}

TEST(Render, turningTheLightByAHalfTurnsItsSide) {
    Look look = straightOn();
    const RenderMesh plane = renderMesh(BasicShape::Plane);
    const Material left = leaning(0.15F, 0.5F, MapRole::NormalGl),
                   right = leaning(0.85F, 0.5F, MapRole::NormalGl);
    look.lightTurn = std::numbers::pi_v<float>;
    EXPECT_GT(meanOf(picture(plane, right, fromTheLeft(), look), 1),
              1.5 * meanOf(picture(plane, left, fromTheLeft(), look), 1));
}

TEST(Render, mapsRepeatAsOftenAsIsAsked) {
    Image stripes({16, 16}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 16; ++y)
            std::fill_n(stripes.plane(c).row(y), 8, 1.0F);
    Material material;
    material.maps[MapRole::Color] = std::make_shared<const Image>(std::move(stripes));
    Look look = straightOn();
    look.shown = Shown::Color;
    for (const int times : {1, 3}) {
        look.repeat = static_cast<float>(times);
        const Image seen = picture(renderMesh(BasicShape::Plane), material, white(), look);
        int edges = 0;
        const int y = seen.height() / 2;
        for (int x = 1; x < seen.width(); ++x)
            if (seen(x, y, 3) > 0 && seen(x - 1, y, 3) > 0)
                edges += seen(x - 1, y, 0) > 0.5F && seen(x, y, 0) <= 0.5F;
        EXPECT_EQ(edges, times);
    }
}

TEST(Render, theSameBitsForAnyNumberOfThreads) {
    Material material;
    material.maps[MapRole::Color] = std::make_shared<const Image>(blobs({64, 64}, 3));
    material.maps[MapRole::Height] = std::make_shared<const Image>(blobs({64, 64}, 1));
    Look look;
    look.relief = 0.1F;
    look.samples = 2;
    look.backdrop = Backdrop::Environment;
    for (const BasicShape shape :
         {BasicShape::Plane, BasicShape::Sphere, BasicShape::Cube, BasicShape::Cylinder}) {
        const RenderMesh mesh = renderMesh(shape);
        EXPECT_TRUE(samePixels(picture(mesh, material, fromTheLeft(), look, 1),
                               picture(mesh, material, fromTheLeft(), look, 5)));
    }
}

TEST(Render, aHeightThatIsHighestEverywhereMovesNothing) {
    Material material;
    material.maps[MapRole::Color] = std::make_shared<const Image>(blobs({32, 32}, 3));
    material.maps[MapRole::Height] = filled(1, 1, {32, 32});
    Look look;
    look.shown = Shown::Color;
    const RenderMesh plane = renderMesh(BasicShape::Plane);
    const Image flat = picture(plane, material, white(), look);
    look.relief = 0.3F;
    EXPECT_LT(apart(flat, picture(plane, material, white(), look)), 1e-5F);
}

TEST(Render, aFloorThatLiesLowerIsSeenFurtherAway) {
    // All of the surface lies `relief` below the plane: seen from above at 45° it shifts by as much.
    Image ramp({64, 64}, 3);
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ramp(x, y, c) = static_cast<float>(y) / 64;
    Material material;
    material.maps[MapRole::Color] = std::make_shared<const Image>(std::move(ramp));
    material.maps[MapRole::Height] = filled(1, 0, {64, 64});
    Look look = straightOn();
    look.shown = Shown::Color;
    look.camera.rise = std::numbers::pi_v<float> / 4;
    look.camera.distance = 60; // so that lines of sight are all but parallel
    look.camera.angle = 0.036F;
    const RenderMesh plane = renderMesh(BasicShape::Plane);
    const float flat = picture(plane, material, white(), look)(48, 48, 0);
    look.relief = 0.1F;
    const float low = picture(plane, material, white(), look)(48, 48, 0);
    EXPECT_NEAR(low - flat, 0.1, 0.01);
}

TEST(Render, whatIsNotOpaqueShowsWhatIsBehind) {
    Material material;
    material.maps[MapRole::Color] = filled(3, 0.8F);
    material.maps[MapRole::Opacity] = filled(1, 0.25F);
    Look look = straightOn();
    const Image seen = picture(renderMesh(BasicShape::Plane), material, white(), look);
    EXPECT_NEAR(seen(48, 48, 3), 0.25, 1e-5);
    look.backdrop = Backdrop::Grey;
    look.shown = Shown::Color;
    const Image onGrey = picture(renderMesh(BasicShape::Plane), material, white(), look);
    EXPECT_NEAR(onGrey(48, 48, 0), 0.25 * 0.8 + 0.75 * 0.18, 1e-5);
    EXPECT_EQ(onGrey(48, 48, 3), 1);
}

TEST(Render, whatDoesNotFitIsRefused) {
    Material material;
    material.maps[MapRole::Color] = filled(3, 1, {16, 16});
    material.maps[MapRole::Roughness] = filled(1, 1, {16, 8});
    try {
        const MaterialTexture texture(material);
        ADD_FAILURE() << "was taken";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("16 × 8"));
    }
    material.maps[MapRole::Roughness] = nullptr;
    material.maps[MapRole::NormalGl] = filled(1, 1, {16, 16});
    EXPECT_THROW(MaterialTexture{material}, UsageError);
    EXPECT_THROW(onThreads(1, [](JobContext& context) { return Environment(*filled(3, 0), context); }),
                 UsageError);
    EXPECT_THROW(renderMesh(Mesh{}), Error);
}

TEST(Visibility, trianglesThatShareAnEdgeCoverEachPixelOnce) {
    // A fan around a point of the pixel grid, so that edges go exactly through the middles of pixels.
    const Eigen::Vector3d middle(8.5, 8.5, 1);
    const Eigen::Vector3d around[] = {{0.5, 0.5, 1}, {16.5, 0.5, 1}, {16.5, 16.5, 1}, {0.5, 16.5, 1}};
    for (int y = 1; y < 16; ++y)
        for (int x = 1; x < 16; ++x) {
            int covered = 0;
            for (int i = 0; i < 4; ++i)
                covered += SeenTriangle({middle, around[i], around[(i + 1) % 4]}).covers(x + 0.5, y + 0.5);
            EXPECT_EQ(covered, 1) << x << ", " << y;
        }
}

TEST(Visibility, sharesAreThoseOfThePointInSpace) {
    const std::array<Eigen::Vector3d, 3> corners{Eigen::Vector3d(10, 20, 1), Eigen::Vector3d(120, 40, 3),
                                                 Eigen::Vector3d(60, 200, 2)};
    const SeenTriangle triangle(corners);
    const Eigen::Vector3d wanted(0.2, 0.5, 0.3);
    const Eigen::Vector3d point = wanted[0] * corners[0] + wanted[1] * corners[1] + wanted[2] * corners[2];
    const double x = point.x() / point.z(), y = point.y() / point.z();
    EXPECT_TRUE(triangle.covers(x, y));
    EXPECT_NEAR(triangle.depth(x, y), point.z(), 1e-12);
    const std::array<double, 3> shares = triangle.shares(x, y);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(shares[static_cast<std::size_t>(i)], wanted[i], 1e-12);
}

TEST(Visibility, aSphereCoversTheDiscThatPerspectiveGivesIt) {
    const Camera camera;
    const RenderMesh sphere = renderMesh(BasicShape::Sphere);
    const Visibility seen = onThreads(2, [&](JobContext& context) {
        return Visibility(sphere, camera, {300, 300}, context);
    });
    double covered = 0;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 300; ++x)
            covered += seen.at(x, y).any();
    const double distance = camera.distance;
    const double radius =
        150 / std::tan(static_cast<double>(camera.angle) / 2) / std::sqrt(distance * distance - 1);
    EXPECT_NEAR(covered / (std::numbers::pi * radius * radius), 1, 0.01);
}

TEST(Visibility, fromWithinACubeItsWallsAreAllAround) {
    const RenderMesh cube = renderMesh(BasicShape::Cube);
    Camera camera;
    camera.distance = 0.1F;
    camera.angle = 1.5F;
    for (const float turn : {0.0F, 0.7F, 2.0F, 4.0F}) {
        camera.turn = turn;
        const Visibility seen = onThreads(2, [&](JobContext& context) {
            return Visibility(cube, camera, {64, 48}, context);
        });
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_TRUE(seen.at(x, y).any()) << turn << " at " << x << ", " << y;
    }
}

TEST(RenderMesh, oneWithoutPlacesInATextureGetsThem) {
    Mesh cube = renderMesh(BasicShape::Cube).mesh;
    cube.uvs.clear();
    const RenderMesh made = renderMesh(cube);
    ASSERT_EQ(made.mesh.uvs.size(), made.mesh.positions.size());
    EXPECT_EQ(made.mesh.triangles.size(), 12U);
    EXPECT_NEAR(made.radius, 1, 1e-5);
    for (const Mesh::Triangle& t : made.mesh.triangles) { // half of a square face, not stretched
        const Eigen::Vector2f a = made.mesh.uvs[t[1]] - made.mesh.uvs[t[0]],
                              b = made.mesh.uvs[t[2]] - made.mesh.uvs[t[0]];
        EXPECT_NEAR(std::abs(a.x() * b.y() - a.y() * b.x()), 1, 1e-5);
    }
}

TEST(RenderMesh, tangentsFollowTheTexture) {
    for (const BasicShape shape :
         {BasicShape::Plane, BasicShape::Sphere, BasicShape::Cube, BasicShape::Cylinder}) {
        const RenderMesh made = renderMesh(shape);
        for (const Mesh::Triangle& t : made.mesh.triangles) {
            const std::vector<Eigen::Vector3f>& at = made.mesh.positions;
            if ((at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).norm() < 1e-6F)
                continue; // at a pole
            for (const std::uint32_t i : t) {
                EXPECT_NEAR(made.tangents[i].head<3>().norm(), 1, 1e-5);
                EXPECT_NEAR(made.tangents[i].head<3>().dot(made.mesh.normals[i]), 0, 1e-5);
                EXPECT_EQ(made.tangents[i].w(), -1) << "v grows downwards on all shapes";
            }
        }
    }
}

} // namespace
} // namespace texloom::test
