#include "core/match/patch_columns.h"

#include "core/base/at.h"
#include "core/match/seam_path.h"

#include <algorithm>

namespace texloom {

namespace {

std::vector<int> gridStarts(int length, bool wraps, int patch, int spacing) {
    std::vector<int> starts;
    if (wraps) {
        const int count = (length + spacing - 1) / spacing;
        for (int k = 0; k < count; ++k)
            starts.push_back(static_cast<int>(static_cast<std::int64_t>(k) * length / count));
        return starts;
    }
    for (int x = 0; x + patch <= length; x += spacing)
        starts.push_back(x);
    if (starts.back() + patch < length)
        starts.push_back(length - patch);
    return starts;
}

std::vector<int> coverage(const std::vector<int>& starts, int length, int patch) {
    std::vector<int> covering(at(length), 0);
    for (const int start : starts)
        for (int i = 0; i < patch; ++i)
            ++covering[at((start + i) % length)];
    return covering;
}

/// A column as an image of the patch.
ImageView asImage(const Eigen::VectorXf& column, int patch, int channels) {
    return {column.data(), patch, patch, channels, patch, static_cast<std::ptrdiff_t>(patch) * patch};
}

/// Lays `from` over the columns of `to` from x on. The first `shared` of them have values already, and are
/// parted along a cut.
void joinAcross(const ImageView& from, int x, int shared, float delta, Image& to) {
    std::vector<int> begins(at(from.height), 0);
    if (shared > 0) {
        SeamOverlap overlap(from.height, shared, from.channels);
        for (int y = 0; y < from.height; ++y)
            for (int i = 0; i < shared; ++i)
                for (int c = 0; c < from.channels; ++c) {
                    overlap.first[overlap.at(y, i) + at(c)] = to(x + i, y, c);
                    overlap.second[overlap.at(y, i) + at(c)] = from(i, y, c);
                }
        begins = seamPath(overlap, delta, false);
    }
    for (int c = 0; c < from.channels; ++c)
        for (int y = 0; y < from.height; ++y)
            for (int i = begins[at(y)]; i < from.width; ++i)
                to(x + i, y, c) = from(i, y, c);
}

/// The same for rows: from y on, with `shared` of them there already.
void joinBelow(const ImageView& from, int y, int shared, float delta, bool closes, Image& to) {
    std::vector<int> begins(at(from.width), 0);
    if (shared > 0) {
        SeamOverlap overlap(from.width, shared, from.channels);
        for (int c = 0; c < from.channels; ++c)
            for (int i = 0; i < shared; ++i)
                for (int x = 0; x < from.width; ++x) {
                    overlap.first[overlap.at(x, i) + at(c)] = to(x, y + i, c);
                    overlap.second[overlap.at(x, i) + at(c)] = from(x, i, c);
                }
        begins = seamPath(overlap, delta, closes);
    }
    for (int c = 0; c < from.channels; ++c)
        for (int i = 0; i < from.height; ++i)
            for (int x = 0; x < from.width; ++x)
                if (i >= begins[at(x)])
                    to(x, y + i, c) = from(x, i, c);
}

} // namespace

PatchColumns::PatchColumns(Size size, Wrap wrap, int patch, int spacing)
    : m_size(size), m_wrap(wrap), m_patch(patch), m_xs(gridStarts(size.width, wrap.x, patch, spacing)),
      m_ys(gridStarts(size.height, wrap.y, patch, spacing)), m_coverX(coverage(m_xs, size.width, patch)),
      m_coverY(coverage(m_ys, size.height, patch)) {}

int PatchColumns::countFor(Size size, Wrap wrap, int patch, int spacing) {
    return static_cast<int>(gridStarts(size.width, wrap.x, patch, spacing).size() *
                            gridStarts(size.height, wrap.y, patch, spacing).size());
}

int PatchColumns::mostCovering() const {
    return *std::max_element(m_coverX.begin(), m_coverX.end()) *
           *std::max_element(m_coverY.begin(), m_coverY.end());
}

SignalSource PatchColumns::of(const Image& image) const {
    const auto read = [this, &image](int first, Eigen::Ref<Eigen::MatrixXf> to) {
        const int across = static_cast<int>(m_xs.size());
        for (Eigen::Index k = 0; k < to.cols(); ++k) {
            const int number = first + static_cast<int>(k);
            const int left = m_xs[at(number % across)], top = m_ys[at(number / across)];
            float* value = to.col(k).data();
            for (int c = 0; c < image.channels(); ++c)
                for (int y = 0; y < m_patch; ++y) {
                    const float* row = image.plane(c).row((top + y) % m_size.height);
                    for (int x = 0; x < m_patch; ++x)
                        *value++ = row[left + x < m_size.width ? left + x : (left + x) % m_size.width];
                }
        }
    };
    return {length(image.channels()), count(), read};
}

/// One picture for each row of patches, made in parallel.
std::vector<Image> PatchColumns::strips(JobContext& context,
                                        const std::function<Image(int row)>& make) const {
    std::vector<Image> made(m_ys.size());
    context.parallel(0, static_cast<int>(m_ys.size()), [&](int row) { made[at(row)] = make(row); });
    return made;
}

Image PatchColumns::averagedRow(int row, int channels, const Make& make) const {
    Image strip({m_size.width, m_patch}, channels);
    Eigen::VectorXf column(length(channels));
    const int across = static_cast<int>(m_xs.size());
    for (int k = 0; k < across; ++k) {
        make(row * across + k, column);
        const ImageView patch = asImage(column, m_patch, channels);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < m_patch; ++y)
                for (int x = 0; x < m_patch; ++x)
                    strip((m_xs[at(k)] + x) % m_size.width, y, c) += patch(x, y, c);
    }
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < m_patch; ++y)
            for (int x = 0; x < m_size.width; ++x)
                strip(x, y, c) /= static_cast<float>(m_coverX[at(x)]);
    return strip;
}

void PatchColumns::average(const Make& make, JobContext& context, Image& to) const {
    const int channels = to.channels();
    const std::vector<Image> rows =
        strips(context, [&](int row) { return averagedRow(row, channels, make); });
    // Over a pixel of a column all rows have as many patches, so that the mean of their means is the mean.
    std::vector<std::vector<std::pair<int, int>>> over(at(m_size.height));
    for (int k = 0; k < static_cast<int>(m_ys.size()); ++k)
        for (int i = 0; i < m_patch; ++i)
            over[at((m_ys[at(k)] + i) % m_size.height)].emplace_back(k, i);
    context.parallel(0, m_size.height, [&](int y) {
        for (int c = 0; c < channels; ++c) {
            float* row = to.plane(c).row(y);
            std::fill_n(row, m_size.width, 0.0F);
            for (const auto& [strip, line] : over[at(y)]) {
                const float* from = rows[at(strip)].plane(c).row(line);
                for (int x = 0; x < m_size.width; ++x)
                    row[x] += from[x];
            }
            for (int x = 0; x < m_size.width; ++x)
                row[x] /= static_cast<float>(m_coverY[at(y)]);
        }
    });
}

/// Beyond the width of an axis that wraps the last patch lies over the first: one more cut.
Image PatchColumns::cutRow(int row, int channels, float delta, const Make& make) const {
    Image strip({m_size.width + m_patch, m_patch}, channels);
    Eigen::VectorXf column(length(channels));
    const int across = static_cast<int>(m_xs.size());
    int end = 0;
    for (int k = 0; k < across; ++k) {
        make(row * across + k, column);
        const int left = m_xs[at(k)];
        joinAcross(asImage(column, m_patch, channels), left, std::max(0, end - left), delta, strip);
        end = left + m_patch;
    }
    if (const int beyond = std::min(end - m_size.width, m_size.width); m_wrap.x && beyond > 0) {
        const Image head(strip.view().crop(0, 0, {beyond, m_patch}));
        joinAcross(head, m_size.width, beyond, delta, strip);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < m_patch; ++y)
                std::copy_n(strip.plane(c).row(y) + m_size.width, beyond, strip.plane(c).row(y));
    }
    strip.shrink({m_size.width, m_patch});
    return strip;
}

void PatchColumns::cut(const Make& make, float delta, JobContext& context, Image& to) const {
    const int channels = to.channels();
    const std::vector<Image> rows =
        strips(context, [&](int row) { return cutRow(row, channels, delta, make); });
    Image whole({m_size.width, m_size.height + m_patch}, channels);
    int end = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        context.check();
        const int top = m_ys[k];
        joinBelow(rows[k], top, std::max(0, end - top), delta, m_wrap.x, whole);
        end = top + m_patch;
    }
    if (const int beyond = std::min(end - m_size.height, m_size.height); m_wrap.y && beyond > 0) {
        const Image head(whole.view().crop(0, 0, {m_size.width, beyond}));
        joinBelow(head, m_size.height, beyond, delta, m_wrap.x, whole);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < beyond; ++y)
                std::copy_n(whole.plane(c).row(m_size.height + y), m_size.width, whole.plane(c).row(y));
    }
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < m_size.height; ++y)
            std::copy_n(whole.plane(c).row(y), m_size.width, to.plane(c).row(y));
}

std::uint64_t PatchColumns::joinBytes(Size size, int channels, int patch, int spacing) {
    const int rows = size.height / spacing + 2;
    return static_cast<std::uint64_t>(rows) * Image::bytesFor({size.width + patch, patch}, channels) +
           Image::bytesFor({size.width, size.height + patch}, channels);
}

} // namespace texloom
