#include "core/math/periodic_component.h"

#include "core/math/fft.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace texloom {

namespace {

/// The jumps across the borders, v of Moisan's eq. 6, as an image that is 0 inside.
void writeJumps(const PlaneView& image, const PlaneSpan& jumps) {
    const int right = image.width - 1, bottom = image.height - 1;
    for (int x = 0; x < image.width; ++x) {
        const float jump = image(x, bottom) - image(x, 0);
        jumps(x, 0) += jump;
        jumps(x, bottom) -= jump;
    }
    for (int y = 0; y < image.height; ++y) {
        const float jump = image(right, y) - image(0, y);
        jumps(0, y) += jump;
        jumps(right, y) -= jump;
    }
}

/// 2 cos(2πk / length) − 2 for every k: the transform of the second difference.
std::vector<double> secondDifferences(int length) {
    std::vector<double> values(static_cast<std::size_t>(length));
    for (int k = 0; k < length; ++k)
        values[static_cast<std::size_t>(k)] = 2 * std::cos(2 * std::numbers::pi * k / length) - 2;
    return values;
}

/// Solves Δs = v with periodic borders: divides by the transform of the Laplacian, and leaves the mean at 0.
void divideByLaplacian(const RealFft2d& fft, std::complex<float>* spectrum,
                       const std::function<void()>& check) {
    const std::vector<double> alongX = secondDifferences(fft.size().width);
    const std::vector<double> alongY = secondDifferences(fft.size().height);
    const auto area = static_cast<double>(fft.size().area());
    for (std::size_t column = 0; column < static_cast<std::size_t>(fft.columns()); ++column) {
        check();
        std::complex<float>* values = spectrum + static_cast<std::ptrdiff_t>(column) * fft.columnStride();
        for (std::size_t row = 0; row < alongY.size(); ++row) {
            const double laplacian = (alongX[column] + alongY[row]) * area;
            values[row] *= column + row == 0 ? 0.0F : static_cast<float>(1 / laplacian);
        }
    }
}

} // namespace

Image periodicComponent(const ImageView& image, const std::function<void()>& check) {
    Image periodic(image);
    const RealFft2d fft(image.size());
    FftBuffer<std::complex<float>> spectrum(fft.spectrumSize());
    for (int c = 0; c < image.channels; ++c) {
        Image smooth(image.size(), 1);
        writeJumps(image.plane(c), smooth.plane(0));
        fft.forward(smooth.plane(0).data, spectrum.data(), check);
        divideByLaplacian(fft, spectrum.data(), check);
        fft.backward(spectrum.data(), smooth.plane(0).data, check);
        for (int y = 0; y < image.height; ++y) {
            float* row = periodic.plane(c).row(y);
            for (int x = 0; x < image.width; ++x)
                row[x] -= smooth(x, y, 0);
        }
    }
    return periodic;
}

} // namespace texloom
