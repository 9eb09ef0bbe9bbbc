#include "core/io/jpeg_scans.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>

namespace texloom {

namespace {

constexpr int kCoefficients = 64;
constexpr int kStartOfScan = 0xda, kEnd = 0xd9;

/// Of each coefficient the lowest bit that a scan gave; none before the first.
using Known = std::array<std::optional<int>, kCoefficients>;

/// One marker of a file with what belongs to it.
struct Segment {
    int marker = 0;
    std::string_view content = {};

    int byte(std::size_t at) const {
        return at < content.size() ? static_cast<unsigned char>(content[at]) : 0;
    }
};

bool startsFrame(int marker) {
    constexpr int kFirst = 0xc0, kLast = 0xcf, kHuffmanTables = 0xc4, kReserved = 0xc8, kConditioning = 0xcc;
    return marker >= kFirst && marker <= kLast && marker != kHuffmanTables && marker != kReserved &&
           marker != kConditioning;
}

/// The next marker with a whole segment; none where the file breaks off. Data of scans are passed over.
std::optional<Segment> nextSegment(std::string_view& rest) {
    constexpr int kStuffed = 0, kFill = 0xff, kFirstAlone = 0xd0, kLastAlone = 0xd8, kTemporary = 0x01;
    constexpr std::size_t kLengthBytes = 2;
    while (rest.size() >= 2) {
        const std::size_t at = rest.find('\xff');
        if (at == std::string_view::npos || at + 1 >= rest.size())
            return std::nullopt;
        const int marker = static_cast<unsigned char>(rest[at + 1]);
        rest.remove_prefix(marker == kFill ? at + 1 : at + 2);
        if (marker == kEnd)
            return Segment{marker};
        if (marker == kStuffed || marker == kFill || marker == kTemporary ||
            (marker >= kFirstAlone && marker <= kLastAlone))
            continue;
        if (rest.size() < kLengthBytes)
            return std::nullopt;
        const std::size_t length =
            256U * static_cast<unsigned char>(rest[0]) + static_cast<unsigned char>(rest[1]);
        if (length < kLengthBytes || length > rest.size())
            return std::nullopt;
        const Segment segment{marker, rest.substr(kLengthBytes, length - kLengthBytes)};
        rest.remove_prefix(length);
        return segment;
    }
    return std::nullopt;
}

/// What the scans so far have given.
class Scans {
public:
    void takeFrame(const Segment& frame) {
        constexpr int kProgressive = 2;              // of each four kinds of frames the third
        constexpr std::size_t kCount = 5, kEach = 3; // after precision, height and width
        m_progressive = (frame.marker & 3) == kProgressive;
        for (int i = 0; i < frame.byte(kCount); ++i)
            m_components[frame.byte(kCount + 1 + kEach * static_cast<std::size_t>(i))];
    }

    void takeScan(const Segment& scan) {
        const auto count = static_cast<std::size_t>(scan.byte(0));
        const std::size_t band = 1 + 2 * count;
        const int first = m_progressive ? scan.byte(band) : 0;
        const int last = m_progressive ? scan.byte(band + 1) : kCoefficients - 1;
        const int lowestBit = m_progressive ? scan.byte(band + 2) & 15 : 0;
        for (std::size_t i = 0; i < count; ++i)
            if (const auto found = m_components.find(scan.byte(1 + 2 * i)); found != m_components.end())
                for (int k = first; k <= last && k < kCoefficients; ++k)
                    found->second[static_cast<std::size_t>(k)] = lowestBit;
    }

    bool areAll() const {
        for (const auto& [id, known] : m_components)
            for (const std::optional<int>& lowestBit : known)
                if (lowestBit != 0)
                    return false;
        return !m_components.empty();
    }

private:
    bool m_progressive = false;
    std::map<int, Known> m_components;
};

} // namespace

bool hasAllScans(std::string_view jpeg) {
    Scans scans;
    while (const std::optional<Segment> segment = nextSegment(jpeg)) {
        if (segment->marker == kEnd)
            break;
        if (startsFrame(segment->marker))
            scans.takeFrame(*segment);
        else if (segment->marker == kStartOfScan)
            scans.takeScan(*segment);
    }
    return scans.areAll();
}

} // namespace texloom
