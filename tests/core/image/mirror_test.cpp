#include "core/image/mirror.h"

#include <gtest/gtest.h>

namespace texloom::test {

TEST(Mirror, WalksToAndFroBetweenTheBorders) {
    for (const int length : {1, 2, 5}) {
        // Each border pixel is met twice before the walk turns.
        int at = 0, step = 1;
        for (int i = 0; i < 4 * length; ++i) {
            EXPECT_EQ(mirrored(i, length), at) << i << " of " << length;
            EXPECT_EQ(mirrored(-1 - i, length), at) << -1 - i << " of " << length;
            if (at + step < 0 || at + step >= length)
                step = -step;
            else
                at += step;
        }
    }
}

} // namespace texloom::test
