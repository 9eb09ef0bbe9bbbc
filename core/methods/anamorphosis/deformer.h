#pragma once

#include "core/job/job_context.h"
#include "core/math/anamorphosis.h"
#include "core/methods/anamorphosis/extension.h"
#include "core/methods/synthesis.h"

namespace texloom::anamorphosis {

/// Makes part of a deformed picture, and its map.
class Deformer {
public:
    /// @param source the picture that is deformed. @param closes whether it closes where the output does.
    /// @param size of the whole output.
    Deformer(const Image& source, bool closes, Size size, Wrap wrap, const Settings& settings,
             const Anamorphosis& warp)
        : m_source(source), m_warp(warp), m_interpolation(settings.interpolation),
          m_columns(source.width(), size.width, wrap.x, closes && wrap.x ? Border::Repeat : settings.border),
          m_rows(source.height(), size.height, wrap.y, closes && wrap.y ? Border::Repeat : settings.border) {}

    /// @param image of the part's size, and @param stmap of four channels (see kStMapPort); both are filled.
    void make(const Region& part, Image& image, Image& stmap, JobContext& context) const;

private:
    struct Line;
    void makeRow(const Region& part, int y, Line& line, Image& image, Image& stmap) const;
    /// Adds up the samples of one pixel.
    void samplePixel(PlanePoint at, const Eigen::Matrix2d& step, int x, int y, Image& image) const;

    const Image& m_source;
    const Anamorphosis& m_warp;
    Interpolation m_interpolation;
    Extension m_columns, m_rows;
};

} // namespace texloom::anamorphosis
