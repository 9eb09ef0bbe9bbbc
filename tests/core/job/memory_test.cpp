#include "core/job/memory.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

void put(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text << "\n";
}

} // namespace

TEST(GroupMemory, IsTheLeastOfAGroupAndThoseAboveIt) {
    const TemporaryFolder root;
    put(root / "slurm/memory.max", "1000");
    put(root / "slurm/memory.current", "300");
    put(root / "slurm/memory.stat", "anon 200\ninactive_file 100\n");
    put(root / "slurm/job/memory.max", "max");
    put(root / "slurm/job/memory.current", "250");
    EXPECT_EQ(groupMemoryLeft(root.path(), "0::/slurm/job\n"), 800U);
    put(root / "slurm/job/memory.max", "700");
    EXPECT_EQ(groupMemoryLeft(root.path(), "0::/slurm/job\n"), 450U);
    put(root / "slurm/job/memory.current", "900");
    EXPECT_EQ(groupMemoryLeft(root.path(), "0::/slurm/job\n"), 0U) << "more is used than is allowed";
}

TEST(GroupMemory, OfTheFirstVersionIsFoundToo) {
    const TemporaryFolder root;
    put(root / "memory/docker/memory.limit_in_bytes", "1000");
    put(root / "memory/docker/memory.usage_in_bytes", "600");
    put(root / "memory/docker/memory.stat", "inactive_file 1\ntotal_inactive_file 50\n");
    EXPECT_EQ(groupMemoryLeft(root.path(), "12:cpuset:/docker\n7:memory:/docker\n0::/docker\n"), 450U);
}

TEST(GroupMemory, IsWithoutLimitWhereThereAreNoGroups) {
    const TemporaryFolder root;
    EXPECT_EQ(groupMemoryLeft(root.path(), "0::/\n"), kUnlimitedMemory);
    EXPECT_EQ(groupMemoryLeft(root.path(), ""), kUnlimitedMemory);
    EXPECT_EQ(groupMemoryLeft(root.path(), "nonsense"), kUnlimitedMemory);
    EXPECT_GT(availableMemory(), 0U);
}

} // namespace texloom::test
