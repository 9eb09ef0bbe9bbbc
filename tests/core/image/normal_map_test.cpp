#include "core/image/normal_map.h"

#include <gtest/gtest.h>

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

} // namespace texloom::test
