#pragma once

#include <cstddef>

namespace texloom {

/// Real transforms of lines, in place and unnormalised, in which second differences are diagonal: of lines
/// whose ends nothing crosses by cosines (each sample half a step from the end), of lines that close by
/// Fourier's, the real parts first and then the imaginary ones from the last.
class LineTransform {
public:
    LineTransform(int length, bool closes) : m_length(length), m_closes(closes) {}

    int length() const { return m_length; }
    /// Floats from one line to the next in a buffer of lines: 64 bytes' worth or a multiple.
    std::ptrdiff_t stride() const { return (m_length + 15) / 16 * 16; }
    /// @param lines aligned to 64 bytes or by FftBuffer, `stride` floats apart (a multiple of 16).
    void forward(float* lines, int count, std::ptrdiff_t stride) const;
    void backward(float* lines, int count, std::ptrdiff_t stride) const;
    /// What forward() and then backward() multiply by.
    double scale() const { return m_closes ? m_length : 2.0 * m_length; }
    /// What the second difference multiplies coefficient k by.
    double secondDifference(int k) const;

private:
    int m_length;
    bool m_closes;
};

} // namespace texloom
