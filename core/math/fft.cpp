#include "core/math/fft.h"

#include "core/base/large_memory.h"
#include "core/math/line_transform.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <tuple>
#include <type_traits>

namespace texloom {

namespace {

enum class Kind {
    RealForward,
    RealBackward,
    Forward,
    Backward,
    BackwardApart,
    Cosine,
    CosineBackward,
    HalfComplex,
    HalfComplexBackward
};

/// A batch of one-dimensional transforms: length, how many, and where they lie.
struct Batch {
    Kind kind;
    int length;
    int count;
    int inStride, inDistance, outStride, outDistance;

    auto key() const { return std::tuple(kind, length, count, inStride, inDistance, outStride, outDistance); }
    friend bool operator<(const Batch& a, const Batch& b) { return a.key() < b.key(); }
};

fftwf_complex* raw(std::complex<float>* data) {
    return reinterpret_cast<fftwf_complex*>(data);
}

fftwf_plan makeRealPlan(const Batch& b, float* reals, fftwf_r2r_kind kind) {
    return fftwf_plan_many_r2r(1, &b.length, b.count, reals, nullptr, b.inStride, b.inDistance, reals,
                               nullptr, b.outStride, b.outDistance, &kind, FFTW_ESTIMATE);
}

/// ESTIMATE plans read nothing from the arrays and depend on their alignment alone, so that one plan serves
/// all buffers whose blocks start at the alignment of allocateMemory().
fftwf_plan makePlan(const Batch& b) {
    const auto inSize =
        static_cast<std::size_t>(b.inDistance) * b.count + static_cast<std::size_t>(b.inStride) * b.length;
    const auto outSize =
        static_cast<std::size_t>(b.outDistance) * b.count + static_cast<std::size_t>(b.outStride) * b.length;
    const FftBuffer<std::complex<float>> in(inSize), out(outSize);
    auto* reals = reinterpret_cast<float*>(in.data());
    switch (b.kind) {
    case Kind::RealForward:
        return fftwf_plan_many_dft_r2c(1, &b.length, b.count, reals, nullptr, b.inStride, b.inDistance,
                                       raw(out.data()), nullptr, b.outStride, b.outDistance, FFTW_ESTIMATE);
    case Kind::RealBackward:
        return fftwf_plan_many_dft_c2r(1, &b.length, b.count, raw(out.data()), nullptr, b.inStride,
                                       b.inDistance, reals, nullptr, b.outStride, b.outDistance,
                                       FFTW_ESTIMATE);
    case Kind::BackwardApart:
        return fftwf_plan_many_dft(1, &b.length, b.count, raw(in.data()), nullptr, b.inStride, b.inDistance,
                                   raw(out.data()), nullptr, b.outStride, b.outDistance, FFTW_BACKWARD,
                                   FFTW_ESTIMATE);
    case Kind::Cosine:
        return makeRealPlan(b, reals, FFTW_REDFT10);
    case Kind::CosineBackward:
        return makeRealPlan(b, reals, FFTW_REDFT01);
    case Kind::HalfComplex:
        return makeRealPlan(b, reals, FFTW_R2HC);
    case Kind::HalfComplexBackward:
        return makeRealPlan(b, reals, FFTW_HC2R);
    case Kind::Forward:
    case Kind::Backward:
        break;
    }
    return fftwf_plan_many_dft(1, &b.length, b.count, raw(in.data()), nullptr, b.inStride, b.inDistance,
                               raw(in.data()), nullptr, b.outStride, b.outDistance,
                               b.kind == Kind::Forward ? FFTW_FORWARD : FFTW_BACKWARD, FFTW_ESTIMATE);
}

struct DestroyPlan {
    void operator()(fftwf_plan plan) const { fftwf_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, DestroyPlan>;

/// The only place where plans are made; FFTW's planner is not thread-safe.
fftwf_plan planFor(const Batch& batch) {
    static std::mutex mutex;
    static std::map<Batch, Plan> plans;
    const std::lock_guard lock(mutex);
    Plan& plan = plans[batch];
    if (!plan)
        plan.reset(makePlan(batch));
    return plan.get();
}

/// A multiple of 8 complex samples (64 bytes), and never of 4 KiB, which would put a row's samples in one
/// cache set.
std::ptrdiff_t paddedStride(int length) {
    const std::ptrdiff_t stride = (length + 7) / 8 * 8;
    return stride % 512 == 0 ? stride + 8 : stride;
}

} // namespace

int fastFftLength(int length) {
    for (int candidate = std::max(1, length);; ++candidate) {
        int rest = candidate;
        for (const int prime : {2, 3, 5, 7})
            while (rest % prime == 0)
                rest /= prime;
        if (rest == 1)
            return candidate;
    }
}

template <class T> void FftBuffer<T>::Free::operator()(T* data) const {
    freeMemory(data, count * sizeof(T));
}

template <class T>
FftBuffer<T>::FftBuffer(std::size_t count)
    : m_data(static_cast<T*>(allocateMemory(count * sizeof(T))), {count}) {}

template class FftBuffer<float>;
template class FftBuffer<std::complex<float>>;

RealFft2d::RealFft2d(Size size)
    : m_size(size), m_columnStride(paddedStride(size.height)), m_rowStride((size.width + 15) / 16 * 16) {}

void RealFft2d::forwardRows(const float* image, int rows, Complex* spectrum,
                            const std::function<void()>& check) const {
    for (int column = 0; column < columns(); ++column)
        std::fill(spectrum + column * m_columnStride + rows,
                  spectrum + column * m_columnStride + m_size.height, Complex(0, 0));
    for (int row = 0; row < rows; row += kBlock) {
        check();
        forwardRows(image, row, std::min(row + kBlock, rows), spectrum);
    }
}

void RealFft2d::forwardRows(const float* image, int first, int last, Complex* spectrum) const {
    for (int row = first; row < last; row += kBlock) {
        const auto plan = planFor({Kind::RealForward, m_size.width, std::min(kBlock, last - row), 1,
                                   static_cast<int>(m_rowStride), static_cast<int>(m_columnStride), 1});
        // FFTW's out-of-place real transform leaves its input alone, though its interface is not const.
        fftwf_execute_dft_r2c(plan, const_cast<float*>(image) + row * m_rowStride, raw(spectrum + row));
    }
}

void RealFft2d::forwardColumns(Complex* spectrum, int first, int last) const {
    const int stride = static_cast<int>(m_columnStride);
    const auto plan = planFor({Kind::Forward, m_size.height, last - first, 1, stride, 1, stride});
    fftwf_execute_dft(plan, raw(spectrum + first * m_columnStride), raw(spectrum + first * m_columnStride));
}

void RealFft2d::backwardColumns(Complex* spectrum, int first, int last) const {
    const int stride = static_cast<int>(m_columnStride);
    const auto plan = planFor({Kind::Backward, m_size.height, last - first, 1, stride, 1, stride});
    fftwf_execute_dft(plan, raw(spectrum + first * m_columnStride), raw(spectrum + first * m_columnStride));
}

void RealFft2d::backwardRows(Complex* spectrum, int rows, float* image,
                             const std::function<void()>& check) const {
    for (int row = 0; row < rows; row += kBlock) {
        check();
        backwardRows(spectrum, row, std::min(row + kBlock, rows), image);
    }
}

void RealFft2d::backwardRows(Complex* spectrum, int first, int last, float* image) const {
    for (int row = first; row < last; row += kBlock) {
        const auto plan = planFor({Kind::RealBackward, m_size.width, std::min(kBlock, last - row),
                                   static_cast<int>(m_columnStride), 1, 1, static_cast<int>(m_rowStride)});
        fftwf_execute_dft_c2r(plan, raw(spectrum + row), image + row * m_rowStride);
    }
}

void RealFft2d::forward(const float* image, Complex* spectrum, const std::function<void()>& check) const {
    forwardRows(image, m_size.height, spectrum, check);
    for (int column = 0; column < columns(); column += kBlock) {
        check();
        forwardColumns(spectrum, column, std::min(column + kBlock, columns()));
    }
}

void RealFft2d::backward(Complex* spectrum, float* image, const std::function<void()>& check) const {
    for (int column = 0; column < columns(); column += kBlock) {
        check();
        backwardColumns(spectrum, column, std::min(column + kBlock, columns()));
    }
    backwardRows(spectrum, m_size.height, image, check);
}

ComplexFft2d::ComplexFft2d(Size size)
    : m_size(size), m_columnStride(paddedStride(size.height)), m_rowStride((size.width + 7) / 8 * 8) {}

void ComplexFft2d::backward(Complex* spectrum, const std::vector<bool>& filled, Complex* image,
                            const std::function<void()>& check) const {
    constexpr int kBlock = RealFft2d::kBlock;
    const int columnStride = static_cast<int>(m_columnStride);
    for (int column = 0; column < m_size.width; column += kBlock) {
        check();
        const int count = std::min(kBlock, m_size.width - column);
        const auto begin = filled.begin() + column;
        if (std::find(begin, begin + count, true) == begin + count)
            continue;
        Complex* const block = spectrum + column * m_columnStride;
        const auto plan = planFor({Kind::Backward, m_size.height, count, 1, columnStride, 1, columnStride});
        fftwf_execute_dft(plan, raw(block), raw(block));
    }
    for (int row = 0; row < m_size.height; row += kBlock) {
        check();
        const int count = std::min(kBlock, m_size.height - row);
        const auto plan = planFor(
            {Kind::BackwardApart, m_size.width, count, columnStride, 1, 1, static_cast<int>(m_rowStride)});
        fftwf_execute_dft(plan, raw(spectrum + row), raw(image + row * m_rowStride));
    }
}

void LineTransform::forward(float* lines, int count, std::ptrdiff_t stride) const {
    const int distance = static_cast<int>(stride);
    const Kind kind = m_closes ? Kind::HalfComplex : Kind::Cosine;
    fftwf_execute_r2r(planFor({kind, m_length, count, 1, distance, 1, distance}), lines, lines);
}

void LineTransform::backward(float* lines, int count, std::ptrdiff_t stride) const {
    const int distance = static_cast<int>(stride);
    const Kind kind = m_closes ? Kind::HalfComplexBackward : Kind::CosineBackward;
    fftwf_execute_r2r(planFor({kind, m_length, count, 1, distance, 1, distance}), lines, lines);
}

double LineTransform::secondDifference(int k) const {
    // −4 sin², which does not cancel as 2 cos − 2 does.
    const double half = std::sin(std::numbers::pi * k / (m_closes ? m_length : 2.0 * m_length));
    return -4 * half * half;
}

} // namespace texloom
