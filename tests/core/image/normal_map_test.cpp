#include "core/image/map_role.h"
#include "core/image/normal_map.h"
#include "tests/core/refusal.h"

namespace texloom::test {

TEST(NormalMap, ReadsVectorsStoredAsTheyAre) {
    Image raw(Size{2, 1}, 3);
    raw(0, 0, 0) = -0.6F;
    raw(0, 0, 2) = 0.8F;
    raw(1, 0, 1) = 0.5F;
    flipGreen(raw);
    renormalize(raw);
    EXPECT_FLOAT_EQ(raw(0, 0, 0), -0.6F);
    EXPECT_FLOAT_EQ(raw(1, 0, 1), -1);
    EXPECT_FLOAT_EQ(raw(1, 0, 2), 0);
}

TEST(MapRole, RecognisesSuffixesInAnyCase) {
    const auto expectName = [](const char* stem, const char* base, MapRole role) {
        const MapName name = mapNameFrom(stem);
        EXPECT_EQ(name.base, base) << stem;
        EXPECT_EQ(name.role, role) << stem;
    };
    expectName("bark_albedo", "bark", MapRole::Color);
    expectName("Bark-BaseColor", "Bark", MapRole::Color);
    expectName("old_bark_NRM", "old_bark", MapRole::NormalGl);
    expectName("bark_nor_gl", "bark", MapRole::NormalGl);
    expectName("bark_Normal_DX", "bark", MapRole::NormalDx);
    expectName("bark_NormalDX", "bark", MapRole::NormalDx);
    expectName("bark_rough_2k", "bark", MapRole::Roughness);
    expectName("bark metalness", "bark", MapRole::Metallic);
    expectName("bark_AO", "bark", MapRole::Occlusion);
    expectName("bark_opacity", "bark", MapRole::Opacity);
    expectName("bark_disp", "bark", MapRole::Height);
    expectName("bark_height_dx", "bark_height_dx", MapRole::Other);
    expectName("normal", "normal", MapRole::Other);
    expectName("bark_2", "bark_2", MapRole::Other);
    for (const MapRoleInfo& info : mapRoles()) {
        EXPECT_EQ(mapRoleFrom(info.id), info.role);
        EXPECT_EQ(mapRoleId(info.role), info.id);
    }
    EXPECT_THAT([] { mapRoleFrom("bump"); }, usageRefusal("bump", "height"));
}

} // namespace texloom::test
