#include "core/network/padding.h"

#include <algorithm>

namespace texloom {

std::vector<int> paddedIndices(int length, int width, Padding padding) {
    std::vector<int> indices;
    for (int i = -width; i < length + width; ++i) {
        int from = i;
        if (padding == Padding::Circular)
            from = ((i % length) + length) % length;
        else if (padding == Padding::Reflect) {
            const int period = std::max(1, 2 * (length - 1));
            from = ((i % period) + period) % period;
            from = std::min(from, period - from);
        }
        indices.push_back(from >= 0 && from < length ? from : -1);
    }
    return indices;
}

void pad(const Tensor& in, const std::vector<int>& columns, const std::vector<int>& rows, Tensor& padded,
         JobContext& context) {
    const int height = static_cast<int>(rows.size()), width = static_cast<int>(columns.size());
    padded.resize(in.channels(), height, width);
    const int inner = (width - in.width()) / 2;
    context.parallel(0, in.channels(), [&](int c) {
        for (int y = 0; y < height; ++y) {
            float* const to = padded.row(c, y);
            if (rows[at(y)] < 0) {
                std::fill_n(to, width, 0.0F);
                continue;
            }
            const float* const from = in.row(c, rows[at(y)]);
            const auto copyOne = [&](int x) { to[x] = columns[at(x)] < 0 ? 0.0F : from[columns[at(x)]]; };
            for (int x = 0; x < inner; ++x)
                copyOne(x);
            std::copy_n(from, in.width(), to + inner);
            for (int x = inner + in.width(); x < width; ++x)
                copyOne(x);
        }
    });
}

void addFolded(const Tensor& padded, const std::vector<int>& columns, const std::vector<int>& rows,
               Tensor& in, JobContext& context) {
    context.parallel(0, in.channels(), [&](int c) {
        for (int y = 0; y < padded.height(); ++y) {
            if (rows[at(y)] < 0)
                continue;
            const float* const from = padded.row(c, y);
            float* const to = in.row(c, rows[at(y)]);
            for (int x = 0; x < padded.width(); ++x)
                if (columns[at(x)] >= 0)
                    to[columns[at(x)]] += from[x];
        }
    });
}

} // namespace texloom
