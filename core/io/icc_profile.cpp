#include "core/io/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace texloom {

namespace {

/// Big-endian numbers; behind the end there are zeros.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : m_bytes(bytes) {}

    std::size_t size() const { return m_bytes.size(); }
    std::string_view word(std::size_t at) const { return at < size() ? m_bytes.substr(at, 4) : ""; }
    std::uint32_t number(std::size_t at, std::size_t bytes = 4) const {
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            number = number << 8 | (at + i < size() ? static_cast<unsigned char>(m_bytes[at + i]) : 0U);
        return number;
    }
    /// s15Fixed16Number
    double fixed(std::size_t at) const { return static_cast<std::int32_t>(number(at)) / 65536.0; }
    /// The data of a tag, from its type on; empty if there is none.
    Bytes tag(std::string_view name) const {
        constexpr std::size_t kHeader = 128, kEntry = 12, kMostTags = 200;
        const std::size_t count = std::min<std::size_t>(number(kHeader), kMostTags);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = kHeader + 4 + i * kEntry;
            if (word(entry) == name && number(entry + 4) < size())
                return Bytes(m_bytes.substr(number(entry + 4), number(entry + 8)));
        }
        return Bytes({});
    }
    friend bool operator==(const Bytes& a, const Bytes& b) { return a.m_bytes == b.m_bytes; }

private:
    std::string_view m_bytes;
};

constexpr std::size_t kTableSize = 4096;

void setPower(FileColor& color, double power) {
    color.curve = power == 1 ? FileColor::Curve::Linear : FileColor::Curve::Power;
    color.power = power;
}

/// A parametric curve of section 10.18, as a table.
bool setParametric(FileColor& color, const Bytes& curve) {
    constexpr std::array<std::size_t, 5> kCounts = {1, 3, 4, 5, 7};
    const std::uint32_t kind = curve.number(8, 2);
    if (kind >= kCounts.size() || curve.size() < 12 + 4 * kCounts[kind])
        return false;
    std::array<double, 7> p{}; // g a b c d e f
    for (std::size_t i = 0; i < kCounts[kind]; ++i)
        p[i] = curve.fixed(12 + 4 * i);
    const auto [g, a, b, c, d, e, f] = p;
    if (kind == 0) {
        setPower(color, g);
        return g > 0;
    }
    const double start = kind < 3 ? -b / a : d;
    const double above = kind == 4 ? e : kind == 2 ? c : 0, below = kind == 4 ? f : kind == 2 ? c : 0;
    const double slope = kind < 3 ? 0 : c;
    for (std::size_t i = 0; i < kTableSize; ++i) {
        const double x = static_cast<double>(i) / (kTableSize - 1);
        const double light = x >= start ? std::pow(std::max(a * x + b, 0.0), g) + above : slope * x + below;
        color.table.push_back(static_cast<float>(std::isfinite(light) ? light : 0));
    }
    color.curve = FileColor::Curve::Table;
    return true;
}

bool setCurve(FileColor& color, const Bytes& curve) {
    if (curve.word(0) == "para")
        return setParametric(color, curve);
    if (curve.word(0) != "curv")
        return false;
    const std::size_t count = curve.number(8);
    if (count == 0 || count > 65536 || curve.size() < 12 + 2 * count) {
        color.curve = FileColor::Curve::Linear;
        return count == 0;
    }
    if (count == 1) {
        setPower(color, curve.number(12, 2) / 256.0); // u8Fixed8Number
        return curve.number(12, 2) > 0;
    }
    color.curve = FileColor::Curve::Table;
    for (std::size_t i = 0; i < count; ++i)
        color.table.push_back(static_cast<float>(curve.number(12 + 2 * i, 2)) / 65535.0F);
    return true;
}

} // namespace

std::optional<FileColor> colorOfProfile(std::string_view profile) {
    const Bytes bytes(profile);
    if (bytes.word(36) != "acsp" || bytes.word(20) != "XYZ ")
        return std::nullopt;
    FileColor color;
    if (bytes.word(16) == "GRAY")
        return setCurve(color, bytes.tag("kTRC")) ? std::optional(color) : std::nullopt;
    const Bytes curve = bytes.tag("rTRC");
    const bool oneCurve = curve == bytes.tag("gTRC") && curve == bytes.tag("bTRC");
    if (bytes.word(16) != "RGB " || bytes.tag("A2B0").size() > 0 || !oneCurve || !setCurve(color, curve))
        return std::nullopt;
    FileColor::Matrix colorants{};
    constexpr std::array<const char*, 3> kTags = {"rXYZ", "gXYZ", "bXYZ"};
    for (std::size_t column = 0; column < 3; ++column) {
        const Bytes xyz = bytes.tag(kTags[column]);
        if (xyz.size() < 20)
            return std::nullopt;
        for (std::size_t row = 0; row < 3; ++row)
            colorants[3 * row + column] = xyz.fixed(8 + 4 * row);
    }
    color.toRec709 = toRec709FromD50(colorants);
    return color;
}

} // namespace texloom
