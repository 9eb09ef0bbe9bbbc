#include "core/analysis/map_usage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace texloom {

namespace {

constexpr int kCell = 8;

/// Consecutive pixels of a row with the same offset.
struct Run {
    int begin, end;
    int dx, dy;
    std::uint16_t exemplar;
    int region;

    bool sameOffset(const Run& other) const {
        return dx == other.dx && dy == other.dy && exemplar == other.exemplar;
    }
};

/// Disjoint sets of runs with the number of pixels in each.
class Regions {
public:
    int add(std::int64_t pixels) {
        m_parent.push_back(static_cast<int>(m_parent.size()));
        m_pixels.push_back(pixels);
        return m_parent.back();
    }
    void join(int a, int b) {
        a = root(a);
        b = root(b);
        if (a == b)
            return;
        if (m_pixels[at(a)] < m_pixels[at(b)])
            std::swap(a, b);
        m_parent[at(b)] = a;
        m_pixels[at(a)] += m_pixels[at(b)];
    }
    std::int64_t largest() const {
        return m_pixels.empty() ? 0 : *std::max_element(m_pixels.begin(), m_pixels.end());
    }

private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }
    int root(int of) {
        while (m_parent[at(of)] != of)
            of = m_parent[at(of)] = m_parent[at(m_parent[at(of)])];
        return of;
    }

    std::vector<int> m_parent;
    std::vector<std::int64_t> m_pixels;
};

void findRuns(const PositionMap& map, int y, Regions& regions, std::vector<Run>& runs) {
    runs.clear();
    for (int x = 0; x < map.width(); ++x) {
        const Source& source = map.at(x, y);
        if (!source.valid())
            continue;
        const Run run{x, x + 1, source.x - x, source.y - y, source.exemplar, 0};
        if (!runs.empty() && runs.back().end == x && runs.back().sameOffset(run))
            ++runs.back().end;
        else
            runs.push_back(run);
    }
    for (Run& run : runs)
        run.region = regions.add(run.end - run.begin);
}

void joinRows(const std::vector<Run>& above, const std::vector<Run>& row, Regions& regions) {
    for (std::size_t i = 0, j = 0; i < above.size() && j < row.size();) {
        const bool touch = above[i].begin < row[j].end && row[j].begin < above[i].end;
        if (touch && above[i].sameOffset(row[j]))
            regions.join(above[i].region, row[j].region);
        if (above[i].end < row[j].end)
            ++i;
        else
            ++j;
    }
}

} // namespace

double largestVerbatimRegion(const PositionMap& map, const std::function<void()>& check) {
    Regions regions;
    std::vector<Run> above, row;
    for (int y = 0; y < map.height(); ++y) {
        check();
        findRuns(map, y, regions, row);
        joinRows(above, row, regions);
        above.swap(row);
    }
    return static_cast<double>(regions.largest()) / static_cast<double>(map.size().area());
}

Image occurrence(const PositionMap& map, int exemplar, const std::function<void()>& check) {
    Image counts(map.exemplarSizes()[static_cast<std::size_t>(exemplar)], 1);
    for (int y = 0; y < map.height(); ++y) {
        check();
        for (int x = 0; x < map.width(); ++x)
            if (const Source& source = map.at(x, y); source.exemplar == exemplar)
                counts(source.x, source.y, 0) += 1;
    }
    double pixels = 0;
    for (const Size& size : map.exemplarSizes())
        pixels += static_cast<double>(size.area());
    const auto scale = static_cast<float>(pixels / static_cast<double>(map.size().area()));
    for (int y = 0; y < counts.height(); ++y)
        for (int x = 0; x < counts.width(); ++x)
            counts(x, y, 0) *= scale;
    return counts;
}

std::vector<Image> occurrencesOf(const PositionMap& map, const std::function<void()>& check) {
    std::vector<Image> images;
    for (std::size_t e = 0; e < map.exemplarSizes().size(); ++e)
        images.push_back(occurrence(map, static_cast<int>(e), check));
    return images;
}

Image occurrencePicture(const Image& occurrence) {
    Image picture(occurrence);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            picture(x, y, 0) = 1 - std::exp2(-picture(x, y, 0));
    return picture;
}

double occurrenceEntropy(const std::vector<Image>& occurrences) {
    std::vector<double> cells;
    double whole = 0, most = 0;
    for (const Image& image : occurrences)
        for (int top = 0; top < image.height(); top += kCell)
            for (int left = 0; left < image.width(); left += kCell) {
                const int bottom = std::min(top + kCell, image.height());
                const int right = std::min(left + kCell, image.width());
                double sum = 0;
                for (int y = top; y < bottom; ++y)
                    for (int x = left; x < right; ++x)
                        sum += static_cast<double>(image(x, y, 0));
                cells.push_back(sum);
                whole += sum;
                // Cells at the border are smaller, and so is their share where all are used equally.
                const double share = static_cast<double>(bottom - top) * (right - left);
                most += share;
            }
    if (whole <= 0 || cells.size() < 2)
        return 1;
    double entropy = 0;
    for (const double sum : cells)
        if (sum > 0)
            entropy -= sum / whole * std::log(sum / whole);
    return std::min(1.0, entropy / std::log(std::max(2.0, most / (kCell * kCell))));
}

} // namespace texloom
