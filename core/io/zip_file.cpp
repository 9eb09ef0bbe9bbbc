#include "core/io/zip_file.h"

#include "core/base/error.h"
#include "core/io/temporary_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace texloom {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t kEnd = 0x06054b50, kEntry = 0x02014b50, kLocal = 0x04034b50;
constexpr std::size_t kEndBytes = 22, kEntryBytes = 46, kLocalBytes = 30;
constexpr std::size_t kLongestComment = 65535;
constexpr std::uint64_t kElsewhere = 0xffffffff; ///< the number stands in a ZIP64 field
constexpr unsigned kStored = 0, kDeflated = 8;
constexpr std::size_t kBlock = 1U << 18U;

/// A number of so many bytes, the lowest first.
std::uint64_t littleNumber(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = count; i > 0; --i)
        number = number << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
    return number;
}

/// One file of the archive, as its directory tells.
struct ZipEntry {
    std::string name;
    unsigned method = 0, flags = 0;
    std::uint32_t checksum = 0;
    std::uint64_t packed = 0, bytes = 0, at = 0;
};

class ZipReader {
public:
    explicit ZipReader(const fs::path& path) : m_path(path), m_file(path, std::ios::binary) {
        std::error_code error;
        m_size = fs::file_size(path, error);
        if (!m_file || error)
            fail("{} cannot be read.", path.string());
    }

    std::vector<ZipEntry> directory(std::size_t most) {
        const std::string end = findEnd();
        const std::uint64_t count = littleNumber(end, 10, 2), size = littleNumber(end, 12, 4),
                            at = littleNumber(end, 16, 4);
        if (at == kElsewhere || size == kElsewhere || count == 0xffff)
            fail("{} is a ZIP64 archive, which is not read; unpack it first.", m_path.filename().string());
        if (count > most)
            fail("{} holds {} files, more than {}; unpack it first.", m_path.filename().string(), count,
                 most);
        const std::string bytes = piece(at, size);
        std::vector<ZipEntry> entries;
        for (std::size_t place = 0; entries.size() < count;)
            entries.push_back(entryAt(bytes, place));
        return entries;
    }

    /// Unpacks one file. @param take gets its bytes piece by piece.
    void unpack(const ZipEntry& entry, const std::function<void(std::string_view)>& take) {
        const std::string head = piece(entry.at, kLocalBytes);
        if (littleNumber(head, 0, 4) != kLocal)
            broken();
        const std::uint64_t at =
            entry.at + kLocalBytes + littleNumber(head, 26, 2) + littleNumber(head, 28, 2);
        if (at > m_size || entry.packed > m_size - at)
            broken();
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(at));
        std::uint64_t written = 0;
        uLong sum = crc32(0, nullptr, 0);
        const auto pass = [&](std::string_view bytes) {
            written += bytes.size();
            if (written > entry.bytes)
                broken();
            sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
            take(bytes);
        };
        if (entry.method == kStored)
            copy(entry.packed, pass);
        else
            inflateTo(entry.packed, pass);
        if (written != entry.bytes || sum != entry.checksum)
            broken();
    }

    [[noreturn]] void broken() const { fail("{} is broken or no ZIP archive.", m_path.filename().string()); }

private:
    std::string piece(std::uint64_t at, std::uint64_t size) {
        if (at > m_size || size > m_size - at)
            broken();
        std::string bytes(static_cast<std::size_t>(size), '\0');
        m_file.clear();
        m_file.seekg(static_cast<std::streamoff>(at));
        if (!m_file.read(bytes.data(), static_cast<std::streamsize>(size)))
            broken();
        return bytes;
    }

    /// The record at the end, behind which only a comment stands.
    std::string findEnd() {
        if (m_size < kEndBytes)
            broken();
        const std::uint64_t length = std::min<std::uint64_t>(m_size, kEndBytes + kLongestComment);
        const std::string tail = piece(m_size - length, length);
        for (std::size_t at = tail.size() - kEndBytes + 1; at > 0; --at)
            if (littleNumber(tail, at - 1, 4) == kEnd)
                return tail.substr(at - 1, kEndBytes);
        broken();
    }

    ZipEntry entryAt(const std::string& bytes, std::size_t& place) const {
        if (place + kEntryBytes > bytes.size() || littleNumber(bytes, place, 4) != kEntry)
            broken();
        ZipEntry entry;
        entry.flags = static_cast<unsigned>(littleNumber(bytes, place + 8, 2));
        entry.method = static_cast<unsigned>(littleNumber(bytes, place + 10, 2));
        entry.checksum = static_cast<std::uint32_t>(littleNumber(bytes, place + 16, 4));
        entry.packed = littleNumber(bytes, place + 20, 4);
        entry.bytes = littleNumber(bytes, place + 24, 4);
        entry.at = littleNumber(bytes, place + 42, 4);
        const std::size_t name = littleNumber(bytes, place + 28, 2),
                          extra = littleNumber(bytes, place + 30, 2),
                          comment = littleNumber(bytes, place + 32, 2);
        if (place + kEntryBytes + name + extra + comment > bytes.size())
            broken();
        entry.name = bytes.substr(place + kEntryBytes, name);
        place += kEntryBytes + name + extra + comment;
        return entry;
    }

    void copy(std::uint64_t left, const std::function<void(std::string_view)>& take) {
        std::string block(kBlock, '\0');
        while (left > 0) {
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left, kBlock));
            if (!m_file.read(block.data(), static_cast<std::streamsize>(count)))
                broken();
            take(std::string_view(block).substr(0, count));
            left -= count;
        }
    }

    void inflateTo(std::uint64_t left, const std::function<void(std::string_view)>& take) {
        z_stream stream{};
        if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
            broken();
        struct End {
            z_stream* stream;
            ~End() { inflateEnd(stream); }
        } const end{&stream};
        std::string in(kBlock, '\0'), out(kBlock, '\0');
        int state = Z_OK;
        while (state != Z_STREAM_END) {
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left, kBlock));
            if (count == 0 || !m_file.read(in.data(), static_cast<std::streamsize>(count)))
                broken();
            left -= count;
            stream.next_in = reinterpret_cast<Bytef*>(in.data());
            stream.avail_in = static_cast<uInt>(count);
            do {
                stream.next_out = reinterpret_cast<Bytef*>(out.data());
                stream.avail_out = kBlock;
                state = inflate(&stream, Z_NO_FLUSH);
                if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
                    broken();
                take(std::string_view(out).substr(0, kBlock - stream.avail_out));
            } while (stream.avail_out == 0 && state != Z_STREAM_END);
        }
    }

    fs::path m_path;
    std::ifstream m_file;
    std::uint64_t m_size = 0;
};

/// A name that no file of this call has yet.
fs::path freePath(const fs::path& folder, const fs::path& name, std::set<fs::path>& taken) {
    fs::path path = folder / name;
    for (int copy = 2; !taken.insert(path).second; ++copy)
        path = folder / (name.stem().string() + "_" + std::to_string(copy) + name.extension().string());
    return path;
}

/// The file's name without folders, whichever way they are separated; empty for a folder, a name that means
/// another place, or what Apple's archives hold besides.
fs::path plainName(const std::string& name) {
    const std::size_t slash = name.find_last_of("/\\");
    const std::string plain = slash == std::string::npos ? name : name.substr(slash + 1);
    const bool odd = plain == "." || plain == ".." || plain.starts_with("._") ||
                     plain.find('\0') != std::string::npos || plain.find(':') != std::string::npos;
    return odd ? fs::path() : fs::path(plain);
}

} // namespace

std::vector<fs::path> unzip(const fs::path& archive, const fs::path& folder,
                            const std::function<bool(const fs::path&)>& wanted, const ZipLimits& limits,
                            const std::function<void()>& check) {
    ZipReader reader(archive);
    std::vector<fs::path> files;
    std::set<fs::path> taken;
    std::uint64_t left = limits.bytes;
    std::error_code error;
    fs::create_directories(folder, error);
    for (const ZipEntry& entry : reader.directory(limits.files)) {
        const fs::path name = plainName(entry.name);
        if (name.empty() || !wanted(name))
            continue;
        const bool encrypted = (entry.flags & 1U) != 0;
        if (encrypted || (entry.method != kStored && entry.method != kDeflated))
            fail("{} in {} is packed in a way that is not read; unpack the archive first.", name.string(),
                 archive.filename().string());
        if (entry.bytes > left)
            fail("{} holds more than {} bytes; unpack it first.", archive.filename().string(), limits.bytes);
        left -= entry.bytes;
        const fs::path path = freePath(folder, name, taken);
        TemporaryFile file(path);
        std::int64_t at = 0;
        reader.unpack(entry, [&](std::string_view bytes) {
            check();
            file.write(bytes.data(), bytes.size(), at);
            at += static_cast<std::int64_t>(bytes.size());
        });
        file.commit();
        files.push_back(path);
    }
    return files;
}

} // namespace texloom
