#pragma once

#include "core/image/size.h"

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace texloom {

/// The smallest length of at least `length` that FFTW transforms fast: a product of 2, 3, 5 and 7.
int fastFftLength(int length);

/// Complex or real samples aligned for SIMD, as FFTW wants them.
template <class T> class FftBuffer {
public:
    FftBuffer() = default;
    explicit FftBuffer(std::size_t count);

    T* data() const { return m_data.get(); }
    std::size_t size() const { return m_data.get_deleter().count; }

private:
    struct Free {
        std::size_t count;
        void operator()(T* data) const;
    };
    std::unique_ptr<T[], Free> m_data;
};

/// Two-dimensional Fourier transforms of real images of one size, unnormalised (forward then backward
/// multiplies by the area), in single precision through FFTW with ESTIMATE plans from one cache, so that
/// every run on a machine uses the same plans. They are done in two passes that the caller controls, because
/// patches are mostly zero and only part of the output is needed: rows that are zero, or not needed, are
/// skipped.
///
/// A spectrum is stored by columns: column k (0 to width / 2) at `k * columnStride()`, `height` values each.
class RealFft2d {
public:
    using Complex = std::complex<float>;

    /// @param size of the transform; each side best from fastFftLength().
    explicit RealFft2d(Size size);

    Size size() const { return m_size; }
    int columns() const { return m_size.width / 2 + 1; }
    std::ptrdiff_t columnStride() const { return m_columnStride; }
    /// Floats from one row of a real image to the next: as in an Image of this size, whose planes can be
    /// passed.
    std::ptrdiff_t rowStride() const { return m_rowStride; }
    std::size_t spectrumSize() const {
        return static_cast<std::size_t>(m_columnStride) * static_cast<std::size_t>(columns());
    }
    std::size_t imageSize() const {
        return static_cast<std::size_t>(m_rowStride) * static_cast<std::size_t>(m_size.height);
    }

    /// Transforms the first `rows` rows of `image` into `spectrum`, by rows; the other rows count as 0.
    /// `check` is called between blocks and may throw.
    void forwardRows(const float* image, int rows, Complex* spectrum,
                     const std::function<void()>& check) const;
    /// Transforms only the rows [first, last) and leaves the other rows of the spectrum unchanged. Calls for
    /// different rows may run at the same time. `first` is a multiple of kBlock.
    void forwardRows(const float* image, int first, int last, Complex* spectrum) const;
    /// Transforms the columns [first, last) of a spectrum in place.
    void forwardColumns(Complex* spectrum, int first, int last) const;
    void backwardColumns(Complex* spectrum, int first, int last) const;
    /// Computes the first `rows` rows of the image and destroys the spectrum.
    void backwardRows(Complex* spectrum, int rows, float* image, const std::function<void()>& check) const;
    /// Computes only the rows [first, last) and destroys the same rows of the spectrum; otherwise like
    /// forwardRows().
    void backwardRows(Complex* spectrum, int first, int last, float* image) const;

    /// Both passes over the whole image, one thread; `check` is called between blocks and may throw.
    void forward(const float* image, Complex* spectrum, const std::function<void()>& check) const;
    void backward(Complex* spectrum, float* image, const std::function<void()>& check) const;

    /// Rows and columns are best processed this many at a time.
    static constexpr int kBlock = 16;
    /// How many blocks hold so many rows or columns.
    static constexpr int blocksFor(int count) { return (count + kBlock - 1) / kBlock; }

private:
    Size m_size;
    std::ptrdiff_t m_columnStride;
    std::ptrdiff_t m_rowStride;
};

/// Two-dimensional backward transforms to complex images, unnormalised, for spectra that are largely zero,
/// like those of analytic signals: blocks of columns that are zero are skipped. Plans and layout are as those
/// of RealFft2d, but a spectrum has all `width` columns.
class ComplexFft2d {
public:
    using Complex = std::complex<float>;

    explicit ComplexFft2d(Size size);

    Size size() const { return m_size; }
    std::ptrdiff_t columnStride() const { return m_columnStride; }
    /// Samples from one row of a complex image to the next.
    std::ptrdiff_t rowStride() const { return m_rowStride; }
    std::size_t spectrumSize() const {
        return static_cast<std::size_t>(m_columnStride) * static_cast<std::size_t>(m_size.width);
    }
    std::size_t imageSize() const {
        return static_cast<std::size_t>(m_rowStride) * static_cast<std::size_t>(m_size.height);
    }

    /// @param filled for each column, whether it holds anything but zeros. The spectrum is destroyed.
    /// @param check called between blocks; may throw.
    void backward(Complex* spectrum, const std::vector<bool>& filled, Complex* image,
                  const std::function<void()>& check) const;

private:
    Size m_size;
    std::ptrdiff_t m_columnStride;
    std::ptrdiff_t m_rowStride;
};

} // namespace texloom
