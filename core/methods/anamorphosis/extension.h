#pragma once

#include "core/image/mirror.h"
#include "core/methods/anamorphosis/settings.h"

#include <algorithm>
#include <cmath>

namespace texloom::anamorphosis {

/// One axis of the picture that is deformed, and how it goes on beyond its ends.
class Extension {
public:
    /// @param length of the picture; @param output of the output, which closes if it `wraps`: then as many
    /// pictures as come nearest are fitted to it, or, mirrored, its second half goes back where the first
    /// came from.
    Extension(int length, int output, bool wraps, Border border)
        : m_length(length), m_output(output), m_wraps(wraps), m_border(border),
          m_step(wraps && border == Border::Repeat ? timesOf(length, output) * length / output : 1) {}

    /// The place in the picture, or beyond its ends, for one in the output or beyond its own.
    double unfolded(double at) const {
        if (!m_wraps)
            return at;
        if (m_border == Border::Repeat)
            return at * m_step;
        const double place = remainder(at, m_output);
        return std::min(place, m_output - place);
    }
    /// How far a step of 1 in the output goes there.
    double step() const { return m_step; }
    /// The same place within the picture.
    double folded(double at) const {
        if (at >= 0 && at < m_length)
            return at;
        if (m_border == Border::Repeat)
            return remainder(at, m_length);
        const double place = remainder(at, 2.0 * m_length);
        return std::min(place, 2.0 * m_length - place);
    }
    /// A pixel's number within the picture.
    int pixel(int at) const {
        if (at >= 0 && at < m_length)
            return at;
        return m_border == Border::Repeat ? repeated(at, m_length) : mirrored(at, m_length);
    }

private:
    static double remainder(double at, double period) {
        if (at >= 0 && at < period)
            return at;
        const double rest = std::fmod(at, period);
        return rest < 0 ? rest + period : rest;
    }
    static double timesOf(int length, int output) {
        return std::max(1, (2 * output + length) / (2 * length));
    }

    int m_length, m_output;
    bool m_wraps;
    Border m_border;
    double m_step;
};

} // namespace texloom::anamorphosis
