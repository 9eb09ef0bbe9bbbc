#include "core/base/error.h"
#include "core/io/image_file.h"
#include "tests/core/io/write_as.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

/// The entries of a list, "a, b".
std::vector<std::string> entriesOf(const std::string& list) {
    std::vector<std::string> entries;
    std::istringstream text(list);
    for (std::string entry; std::getline(text, entry, ',');) {
        const std::size_t first = entry.find_first_not_of(' ');
        entries.push_back(entry.substr(first, entry.find_last_not_of(' ') - first + 1));
    }
    return entries;
}

/// The cells of the rows of docs/formats.md that begin with a name's ending.
std::vector<std::vector<std::string>> writtenFormats() {
    std::istringstream page(readText(fs::path(TEXLOOM_SOURCE_DIR) / "docs" / "formats.md"));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| ."))
            continue;
        std::istringstream cells(line.substr(1));
        std::vector<std::string>& row = rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, '|');)
            row.push_back(cell);
    }
    return rows;
}

bool holds(const fs::path& path, int channels, Depth depth) {
    try {
        writeImage(path, blobs({24, 20}, channels), as(depth));
    } catch (const UsageError&) {
        return false;
    }
    return readImageInfo(path).channels == channels;
}

} // namespace

TEST(FormatsPage, SaysWhatIsWritten) {
    const TemporaryFolder folder;
    const auto rows = writtenFormats();
    ASSERT_EQ(rows.size(), 5U);
    for (const std::vector<std::string>& row : rows)
        for (const std::string& ending : entriesOf(row.at(0))) {
            const fs::path path = folder / ("a" + ending);
            std::vector<std::string> depths;
            for (const Depth depth : depthsFor(path))
                depths.emplace_back(depthName(depth));
            EXPECT_EQ(depths, entriesOf(row.at(1))) << ending;
            const std::vector<std::string> counts = entriesOf(row.at(2));
            for (const int channels : {1, 2, 3, 4, 5, 14}) {
                const bool listed = counts.front() == "any" ||
                                    std::count(counts.begin(), counts.end(), std::to_string(channels)) > 0;
                for (const Depth depth : depthsFor(path))
                    EXPECT_EQ(holds(path, channels, depth), listed) << ending << " with " << channels;
            }
        }
}

TEST(FormatsPage, SaysWhatLosesNothing) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& row : writtenFormats()) {
        if (!row.at(4).ends_with("without loss "))
            continue;
        const fs::path path = folder / ("a" + entriesOf(row.at(0)).front());
        for (const Depth depth : depthsFor(path)) {
            writeImage(path, blobs({24, 20}, 3), as(depth));
            const Image once = readImage(path).image;
            writeImage(path, once, as(depth));
            EXPECT_TRUE(samePixels(readImage(path).image, once)) << path;
        }
    }
}

} // namespace texloom::test
