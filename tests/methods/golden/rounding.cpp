#include "tests/methods/golden/rounding.h"

#include <fftw3.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <type_traits>

// Nothing of Texloom's own is asked: what changes there must fail, and not be taken for another machine.

namespace texloom::test {

namespace {

/// The same numbers from 0 to 1 by every library, as the standard demands of its engines.
class Numbers {
public:
    double next() { return static_cast<double>(m_engine()) / 4294967296.0; }

private:
    std::mt19937 m_engine; // its default seed
};

void addFunctions(Hash& hash) {
    Numbers numbers;
    for (int i = 0; i < 20000; ++i) {
        const double x = 20 * numbers.next() + 1e-6, y = 4 * numbers.next() - 2;
        const auto f = static_cast<float>(x), g = static_cast<float>(y);
        hash.addAll(std::span<const double>(
            std::array{std::exp(y), std::log(x), std::log2(x), std::pow(x, y), std::sin(x), std::cos(x),
                       std::tan(y), std::atan2(y, x), std::acos(y / 2), std::hypot(x, y), std::tanh(y)}));
        hash.addAll(std::span<const float>(std::array{std::exp(g), std::log(f), std::log2(f), std::pow(f, g),
                                                      std::sin(f), std::cos(f), std::hypot(f, g)}));
    }
}

struct Destroy {
    void operator()(fftwf_plan plan) const { fftwf_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftwf_plan>, Destroy>;

/// Rows of real numbers and columns of complex ones, there and back.
void addTransforms(Hash& hash, int width, int height) {
    const int columns = width / 2 + 1;
    const auto reals = static_cast<std::size_t>(width * height),
               complexes = static_cast<std::size_t>(columns * height);
    const std::unique_ptr<float, decltype(&fftwf_free)> image(fftwf_alloc_real(reals), fftwf_free);
    const std::unique_ptr<fftwf_complex, decltype(&fftwf_free)> spectrum(fftwf_alloc_complex(complexes),
                                                                         fftwf_free);
    fftwf_complex* const values = spectrum.get();
    const Plan rows(fftwf_plan_many_dft_r2c(1, &width, height, image.get(), nullptr, 1, width, values,
                                            nullptr, 1, columns, FFTW_ESTIMATE));
    const Plan down(fftwf_plan_many_dft(1, &height, columns, values, nullptr, columns, 1, values, nullptr,
                                        columns, 1, FFTW_FORWARD, FFTW_ESTIMATE));
    const Plan back(fftwf_plan_many_dft_c2r(1, &width, height, values, nullptr, 1, columns, image.get(),
                                            nullptr, 1, width, FFTW_ESTIMATE));
    Numbers numbers;
    for (std::size_t i = 0; i < reals; ++i)
        image.get()[i] = static_cast<float>(numbers.next());
    fftwf_execute(rows.get());
    fftwf_execute(down.get());
    hash.addAll(std::span<const fftwf_complex>(values, complexes));
    fftwf_execute(back.get());
    hash.addAll(std::span<const float>(image.get(), reals));
}

} // namespace

std::uint64_t roundingOfThisMachine() {
    Hash hash;
    addFunctions(hash);
    constexpr std::array<std::array<int, 2>, 5> sizes = {
        {{128, 128}, {160, 144}, {96, 90}, {21, 35}, {250, 8}}};
    for (const auto& [width, height] : sizes)
        addTransforms(hash, width, height);
    return hash.value();
}

} // namespace texloom::test
