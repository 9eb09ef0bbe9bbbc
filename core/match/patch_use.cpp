#include "core/match/patch_use.h"

#include <cstdint>

namespace texloom {

namespace {

/// Sums over the rectangle from the origin, with a row and a column of zeros before the first.
class SummedArea {
public:
    explicit SummedArea(Size size) : m_width(size.width + 1), m_sums(area(size), 0) {}

    std::int64_t& at(int x, int y) {
        return m_sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                      static_cast<std::size_t>(x)];
    }
    /// Replaces every value by the sum of those above and to the left of it, itself included.
    void sum(Size size) {
        for (int y = 0; y <= size.height; ++y)
            for (int x = 0; x <= size.width; ++x)
                at(x, y) += (x > 0 ? at(x - 1, y) : 0) + (y > 0 ? at(x, y - 1) : 0) -
                            (x > 0 && y > 0 ? at(x - 1, y - 1) : 0);
    }

private:
    static std::size_t area(Size size) {
        return static_cast<std::size_t>(size.width + 1) * static_cast<std::size_t>(size.height + 1);
    }
    int m_width;
    std::vector<std::int64_t> m_sums;
};

} // namespace

std::vector<float> patchUse(const PatchField& field, std::span<const Size> sizes, int exemplar, int patch,
                            const std::function<void()>& check) {
    const Size image = sizes[static_cast<std::size_t>(exemplar)];
    const double square = static_cast<double>(patch) * patch;
    double pixels = 0;
    for (const Size& size : sizes)
        pixels += static_cast<double>(size.area());
    const double expected = static_cast<double>(field.size().area()) * square / pixels * square;
    SummedArea use(image);
    for (int y = 0; y < field.size().height; ++y) {
        check();
        for (int x = 0; x < field.size().width; ++x) {
            const Source& source = field.at(x, y).source;
            if (source.exemplar != exemplar)
                continue;
            ++use.at(source.x, source.y);
            --use.at(source.x + patch, source.y);
            --use.at(source.x, source.y + patch);
            ++use.at(source.x + patch, source.y + patch);
        }
    }
    use.sum(image); // now the count for each pixel
    SummedArea sums(image);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            sums.at(x + 1, y + 1) = use.at(x, y);
    check();
    sums.sum(image);
    std::vector<float> shares;
    for (int y = 0; y + patch <= image.height; ++y)
        for (int x = 0; x + patch <= image.width; ++x) {
            const std::int64_t count =
                sums.at(x + patch, y + patch) - sums.at(x, y + patch) - sums.at(x + patch, y) + sums.at(x, y);
            shares.push_back(static_cast<float>(static_cast<double>(count) / expected));
        }
    return shares;
}

} // namespace texloom
