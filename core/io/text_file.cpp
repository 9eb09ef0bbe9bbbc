#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/decoder_process.h"
#include "core/io/file_reader.h"
#include "core/io/image_file.h"
#include "core/io/temporary_file.h"

#include <OpenImageIO/hash.h>

#include <array>

namespace texloom {

namespace fs = std::filesystem;

std::string fileHash(const fs::path& path) {
    FileReader file(path);
    OIIO::SHA1 hash;
    std::array<char, 1 << 16> block{};
    while (const std::size_t count = file.next(block.data(), block.size())) {
        DecoderProcess::check();
        hash.append(block.data(), count);
    }
    return hash.digest();
}

std::string bytesHash(std::string_view bytes) {
    return OIIO::SHA1(bytes.data(), bytes.size()).digest();
}

void writeText(const fs::path& path, std::string_view text) {
    TemporaryFile temporary(path);
    temporary.write(text.data(), text.size(), 0);
    temporary.commit();
}

std::string readText(const fs::path& path, std::uintmax_t largestBytes) {
    FileReader file(path);
    std::string text;
    std::array<char, 1 << 16> block{};
    while (const std::size_t count = file.next(block.data(), block.size())) {
        text.append(block.data(), count);
        if (text.size() > largestBytes)
            fail("{} is longer than {}, too long for a file of this kind.", path.string(),
                 byteText(largestBytes));
    }
    return text;
}

} // namespace texloom
