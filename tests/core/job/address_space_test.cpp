#include "core/job/address_space.h"
#include "core/job/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace texloom::test {

TEST(AddressSpace, StartsAsManyThreadsAsFit) {
    EXPECT_EQ(startableThreads(64, kUnlimitedMemory), 64);
    EXPECT_EQ(startableThreads(1, 0), 1);
    EXPECT_EQ(startableThreads(64, 0), 1) << "this thread is there already";
    const int some = startableThreads(64, 1ULL << 30);
    EXPECT_GT(some, 1);
    EXPECT_LT(some, 64);
    EXPECT_GE(startableThreads(64, 2ULL << 30), 2 * some - 1);
}

TEST(AddressSpace, IsWhatTheLimitLeaves) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{1ULL << 40, 1ULL << 40};
        const bool set = ::setrlimit(RLIMIT_AS, &limit) == 0;
        const std::uint64_t left = addressesLeft();
        ::_exit(set && left < limit.rlim_cur && left > limit.rlim_cur / 2 ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

} // namespace texloom::test
