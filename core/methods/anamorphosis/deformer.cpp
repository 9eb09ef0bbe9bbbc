#include "core/methods/anamorphosis/deformer.h"

#include "core/image/cubic_taps.h"
#include "core/job/pool.h"

#include <algorithm>
#include <cmath>

namespace texloom::anamorphosis {

namespace {

/// Rows that are made between two moments for progress and previews.
constexpr int kRowsAtOnce = 64;

SampleTaps tapsFor(Interpolation interpolation, const Extension& axis, double at) {
    const double position = axis.unfolded(at) - 0.5;
    const auto pixel = [&axis](int n) { return axis.pixel(n); };
    switch (interpolation) {
    case Interpolation::Linear:
        return linearTaps(position, pixel);
    case Interpolation::Nearest:
        return nearestTaps(position, pixel);
    case Interpolation::Cubic:
        break;
    }
    return cubicTaps(position, pixel);
}

} // namespace

/// Where a row of pixels comes from.
struct Deformer::Line {
    bool made = false;
    std::vector<PlanePoint> points;
    std::vector<Eigen::Matrix2d> steps;
};

void Deformer::make(const Region& part, Image& image, Image& stmap, JobContext& context) const {
    Pool<Line> lines;
    const int width = part.size.width, height = part.size.height;
    for (int top = 0; top < height; top += kRowsAtOnce) {
        const int bottom = std::min(height, top + kRowsAtOnce);
        context.parallel(top, bottom, [&](int y) {
            const auto line = lines.borrow([width] {
                const auto count = static_cast<std::size_t>(width);
                return Line{false, std::vector<PlanePoint>(count), std::vector<Eigen::Matrix2d>(count)};
            });
            makeRow(part, y, *line, image, stmap);
        });
        context.progress(static_cast<double>(bottom) / height);
        context.preview(image);
    }
}

void Deformer::makeRow(const Region& part, int y, Line& line, Image& image, Image& stmap) const {
    const double down = part.y + y + 0.5;
    // What deforms across does the same in every row.
    if (line.made && !m_warp.turbulent() && !m_warp.alongY())
        for (PlanePoint& point : line.points)
            point.y = down;
    else
        m_warp.row(part.x + 0.5, down, part.size.width, line.points.data(), line.steps.data());
    line.made = true;
    const double width = m_source.width(), height = m_source.height();
    for (int x = 0; x < part.size.width; ++x) {
        const PlanePoint at = line.points[static_cast<std::size_t>(x)];
        samplePixel(at, line.steps[static_cast<std::size_t>(x)], x, y, image);
        stmap(x, y, 0) = static_cast<float>(m_columns.folded(m_columns.unfolded(at.x)) / width);
        stmap(x, y, 1) = static_cast<float>(1 - m_rows.folded(m_rows.unfolded(at.y)) / height);
        stmap(x, y, 2) = 0;
        stmap(x, y, 3) = 1;
    }
}

void Deformer::samplePixel(PlanePoint at, const Eigen::Matrix2d& step, int x, int y, Image& image) const {
    const auto samplesAlong = [&](int axis) {
        const double across = step(0, axis) * m_columns.step(), down = step(1, axis) * m_rows.step();
        return m_interpolation == Interpolation::Nearest
                   ? 1
                   : samplesFor(std::sqrt(across * across + down * down));
    };
    const int across = samplesAlong(0), down = samplesAlong(1);
    if (across * down == 1) {
        const SampleTaps columns = tapsFor(m_interpolation, m_columns, at.x);
        const SampleTaps rows = tapsFor(m_interpolation, m_rows, at.y);
        for (int c = 0; c < image.channels(); ++c)
            image(x, y, c) = sampleAt(m_source.plane(c), columns, rows);
        return;
    }
    for (int j = 0; j < down; ++j)
        for (int i = 0; i < across; ++i) {
            const Eigen::Vector2d away =
                step * Eigen::Vector2d((i + 0.5) / across - 0.5, (j + 0.5) / down - 0.5);
            const SampleTaps columns = tapsFor(m_interpolation, m_columns, at.x + away.x());
            const SampleTaps rows = tapsFor(m_interpolation, m_rows, at.y + away.y());
            for (int c = 0; c < image.channels(); ++c)
                image(x, y, c) += sampleAt(m_source.plane(c), columns, rows);
        }
    for (int c = 0; c < image.channels(); ++c)
        image(x, y, c) /= static_cast<float>(across * down);
}

} // namespace texloom::anamorphosis
