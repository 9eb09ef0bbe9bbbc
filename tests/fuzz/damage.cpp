#include "tests/fuzz/damage.h"

#include <algorithm>
#include <array>

namespace texloom::test {

namespace {

/// Draws for one iteration, one after the other.
class Draws {
public:
    Draws(const Random& random, int iteration) : m_random(random), m_iteration(iteration) {}
    std::size_t below(std::size_t count) {
        return count == 0 ? 0 : m_random.below(static_cast<std::uint32_t>(count), m_iteration, 0, m_next++);
    }
    /// A place in a file: half the time in its first 300 bytes, where the headers are.
    std::size_t place(std::size_t size) {
        return below(2) == 0 ? below(size) : below(std::min<std::size_t>(size, 300));
    }

private:
    const Random& m_random;
    int m_iteration;
    std::uint32_t m_next = 0;
};

void flipBits(std::string& bytes, Draws& draws) {
    for (std::size_t n = draws.below(8) + 1; n > 0; --n) {
        char& byte = bytes[draws.place(bytes.size())];
        byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << draws.below(8)));
    }
}

void changeBytes(std::string& bytes, Draws& draws) {
    for (std::size_t n = draws.below(8) + 1; n > 0; --n)
        bytes[draws.place(bytes.size())] = static_cast<char>(draws.below(256));
}

/// Lengths, sizes and offsets are what decoders stumble over.
void setNumber(std::string& bytes, Draws& draws) {
    constexpr std::array<std::uint32_t, 10> kExtremes = {
        0, 1, 0xff, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xffffffff, 0xfffffff0, 0x01000000};
    const std::uint32_t number = kExtremes[draws.below(kExtremes.size())];
    const std::size_t width = std::size_t{1} << draws.below(3);
    const bool bigEnd = draws.below(2) == 0;
    const std::size_t at = draws.place(bytes.size());
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
        bytes[at + i] = static_cast<char>(number >> (8 * (bigEnd ? width - 1 - i : i)));
}

void cutEnd(std::string& bytes, Draws& draws) {
    bytes.resize(draws.below(bytes.size()));
}

void cutPiece(std::string& bytes, Draws& draws) {
    bytes.erase(draws.place(bytes.size()), draws.below(64) + 1);
}

void doublePiece(std::string& bytes, Draws& draws) {
    const std::size_t at = draws.place(bytes.size());
    bytes.insert(at, bytes.substr(at, draws.below(256) + 1));
}

void splice(std::string& bytes, const std::string& other, Draws& draws) {
    const std::size_t from = draws.place(other.size());
    bytes.replace(draws.place(bytes.size()), draws.below(256), other.substr(from, draws.below(256) + 1));
}

} // namespace

std::string damaged(std::string bytes, const std::string& other, const Random& random, int iteration) {
    Draws draws(random, iteration);
    for (std::size_t n = draws.below(3) + 1; n > 0 && !bytes.empty(); --n)
        switch (draws.below(7)) {
        case 0:
            flipBits(bytes, draws);
            break;
        case 1:
            changeBytes(bytes, draws);
            break;
        case 2:
            setNumber(bytes, draws);
            break;
        case 3:
            cutEnd(bytes, draws);
            break;
        case 4:
            cutPiece(bytes, draws);
            break;
        case 5:
            doublePiece(bytes, draws);
            break;
        default:
            splice(bytes, other, draws);
        }
    return bytes;
}

} // namespace texloom::test
