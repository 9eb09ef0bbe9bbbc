#include "core/match/patch_counter.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace texloom {

PatchCounter::PatchCounter(std::vector<Source> patches, std::span<const Size> sizes, int patch,
                           std::int64_t wanted)
    : m_patches(std::move(patches)), m_sizes(sizes.begin(), sizes.end()), m_patch(patch),
      m_uses(m_patches.size(), 0) {
    double pixels = 0;
    for (const Size& size : m_sizes) {
        pixels += static_cast<double>(size.area());
        m_numbers.emplace_back(static_cast<std::size_t>(size.area()), -1);
    }
    const double square = static_cast<double>(patch) * patch;
    m_even = static_cast<double>(wanted) * square / pixels * square;
    for (std::size_t n = 0; n < m_patches.size(); ++n) {
        const Source& place = m_patches[n];
        m_numbers[place.exemplar][place.y * at(m_sizes[place.exemplar].width) + place.x] =
            static_cast<int>(n);
    }
}

int PatchCounter::numberOf(const Source& source) const {
    return m_numbers[source.exemplar][source.y * at(m_sizes[source.exemplar].width) + source.x];
}

void PatchCounter::count(int number, int times, const std::function<void(int number)>& changed) {
    const Source& place = m_patches[at(number)];
    const Size& size = m_sizes[place.exemplar];
    const int reach = m_patch - 1;
    for (int y = std::max(0, place.y - reach); y <= std::min(size.height - 1, place.y + reach); ++y)
        for (int x = std::max(0, place.x - reach); x <= std::min(size.width - 1, place.x + reach); ++x) {
            const int other = m_numbers[place.exemplar][at(y) * at(size.width) + at(x)];
            if (other < 0)
                continue;
            m_uses[at(other)] +=
                times * (m_patch - std::abs(x - place.x)) * (m_patch - std::abs(y - place.y));
            changed(other);
        }
}

} // namespace texloom
