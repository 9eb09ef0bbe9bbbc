#include "core/image/map_name.h"
#include "tests/core/refusal.h"

#include <string>
#include <vector>

namespace texloom::test {

namespace {

void expectName(const char* stem, const char* base, MapRole role) {
    const MapName name = mapNameFrom(stem);
    EXPECT_EQ(name.base, base) << stem;
    EXPECT_EQ(name.role, role) << stem;
    EXPECT_TRUE(name.packing.empty()) << stem;
}

/// What the channels hold, one letter each: Occlusion, Roughness, Smoothness, Metallic, nothing.
std::string lettersOf(const std::string& stem) {
    std::string letters;
    for (const PackedChannel& channel : mapNameFrom(stem).packing)
        letters += channel.role == MapRole::Occlusion   ? 'O'
                   : channel.role == MapRole::Roughness ? (channel.inverted ? 'S' : 'R')
                   : channel.role == MapRole::Metallic  ? 'M'
                                                        : '-';
    return letters;
}

} // namespace

TEST(MapName, RecognisesSuffixesInAnyCase) {
    expectName("bark_albedo", "bark", MapRole::Color);
    expectName("Bark-BaseColor", "Bark", MapRole::Color);
    expectName("old_bark_NRM", "old_bark", MapRole::NormalGl);
    expectName("bark_nor_gl", "bark", MapRole::NormalGl);
    expectName("bark_Normal_DX", "bark", MapRole::NormalDx);
    expectName("bark_NormalDX", "bark", MapRole::NormalDx);
    expectName("bark_rough_2k", "bark", MapRole::Roughness);
    expectName("bark_normal_01", "bark", MapRole::NormalGl);
    expectName("bark metalness", "bark", MapRole::Metallic);
    expectName("bark_AO", "bark", MapRole::Occlusion);
    expectName("bark_opacity", "bark", MapRole::Opacity);
    expectName("bark_disp", "bark", MapRole::Height);
    expectName("bark_height_dx", "bark_height_dx", MapRole::Other);
    expectName("normal", "normal", MapRole::Other);
    expectName("bark_2", "bark_2", MapRole::Other);
    expectName("bark_2k", "bark_2k", MapRole::Other);
    for (const MapRoleInfo& info : mapRoles()) {
        EXPECT_EQ(mapRoleFrom(info.id), info.role);
        EXPECT_EQ(mapRoleId(info.role), info.id);
    }
    EXPECT_THAT([] { mapRoleFrom("bump"); }, usageRefusal("bump", "height"));
}

TEST(MapName, ReadsNamesAsLibrariesAndProgramsWriteThem) {
    expectName("brick_wall_nor_gl_4k", "brick_wall", MapRole::NormalGl); // Poly Haven
    expectName("brick_wall_diff_1k", "brick_wall", MapRole::Color);
    expectName("Bricks075A_1K-JPG_NormalDX", "Bricks075A", MapRole::NormalDx); // ambientCG
    expectName("Bricks075A_8K_AmbientOcclusion", "Bricks075A", MapRole::Occlusion);
    expectName("uhxkbghs_4K_Displacement", "uhxkbghs", MapRole::Height); // Quixel
    expectName("Rock_Cliff_Base_Color", "Rock_Cliff", MapRole::Color);   // Substance
    expectName("Rock_Cliff_Normal_OpenGL", "Rock_Cliff", MapRole::NormalGl);
    expectName("Rock_Cliff_Mixed_AO", "Rock_Cliff", MapRole::Occlusion);
    expectName("Rock_AlbedoTransparency", "Rock", MapRole::Color); // Unity
    expectName("T_Rock_N", "Rock", MapRole::NormalDx);             // Unreal
    expectName("T_Rock_BC", "Rock", MapRole::Color);
    expectName("T_Rock_2K_H", "Rock", MapRole::Height);
    expectName("Rock_N", "Rock_N", MapRole::Other); // means nothing without T_
    EXPECT_EQ(mapNameFrom("brick_wall_nor_gl_4K").resolution, "4k");
    EXPECT_EQ(mapNameFrom("Bricks075A_1K-JPG_Color").resolution, "1k");
}

TEST(MapName, KnowsWhatPackedFilesHold) {
    EXPECT_EQ(lettersOf("rock_orm"), "ORM");
    EXPECT_EQ(lettersOf("rock_arm_2k"), "ORM");
    EXPECT_EQ(lettersOf("T_Rock_ORM"), "ORM");
    EXPECT_EQ(lettersOf("Rock_OcclusionRoughnessMetallic"), "ORM");
    EXPECT_EQ(lettersOf("rock-MRA"), "MRO");
    EXPECT_EQ(lettersOf("rock_RMA"), "RMO");
    EXPECT_EQ(lettersOf("Rock_MetallicSmoothness"), "M--S");
    EXPECT_EQ(lettersOf("Rock_Metallic_Smoothness"), "M--S");
    EXPECT_EQ(lettersOf("Rock_MaskMap"), "MO-S");
    EXPECT_EQ(lettersOf("rock_4K_Gloss"), "S");
    EXPECT_EQ(lettersOf("charm"), "");
    EXPECT_EQ(mapNameFrom("T_Rock_ORM").base, "Rock");
    EXPECT_TRUE(mapNameFrom("rock_orm").isCompanion());
    EXPECT_FALSE(mapNameFrom("rock_albedo").isCompanion());
}

TEST(MapName, NamesOfOneMaterialBelongTogether) {
    EXPECT_TRUE(sameMaterial("bark_albedo", "Bark_Normal"));
    EXPECT_TRUE(sameMaterial("bark", "bark_orm"));
    EXPECT_TRUE(sameMaterial("wood_2k", "wood_rough_2k"));
    EXPECT_TRUE(sameMaterial("T_Rock_BC", "T_Rock_ORM"));
    EXPECT_TRUE(sameMaterial("albedo", "normal"));
    EXPECT_FALSE(sameMaterial("bark_diff_1k", "bark_rough_2k"));
    EXPECT_FALSE(sameMaterial("bark_albedo", "birch_normal"));
}

} // namespace texloom::test
