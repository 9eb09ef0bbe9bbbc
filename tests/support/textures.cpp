#include "tests/support/textures.h"

#include "core/job/random.h"

#include <cmath>

namespace texloom::test {

Image noise(Size size, int channels, std::uint64_t seed) {
    const Random random(seed);
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) = static_cast<float>(random.uniform(x, y, static_cast<std::uint32_t>(c)));
    return image;
}

Image blobs(Size size, int channels, std::uint64_t seed) {
    constexpr int kWaves = 12;
    const Random random(seed);
    const Image grain = noise(size, channels, seed + 1);
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                double sum = 0;
                for (int wave = 0; wave < kWaves; ++wave) {
                    const double angle = 6.2831853 * random.uniform(wave, 0);
                    const double frequency = 0.05 + 0.4 * random.uniform(wave, 1);
                    const double phase = 6.2831853 * random.uniform(wave, 2) + 0.4 * c;
                    sum += std::sin(frequency * (x * std::cos(angle) + y * std::sin(angle)) + phase);
                }
                const double soft = 0.5 + 0.45 * std::tanh(sum / 3);
                image(x, y, c) = static_cast<float>(0.9 * soft) + 0.1F * grain(x, y, c);
            }
    return image;
}

Image periodic(Size size, Size period, int channels) {
    const Image tile = noise(period, channels);
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) = tile(x % period.width, y % period.height, c);
    return image;
}

Image constant(Size size, int channels, float value) {
    Image image(size, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                image(x, y, c) = value;
    return image;
}

std::filesystem::path bundled(const char* name) {
    return std::filesystem::path(TEXLOOM_SOURCE_DIR) / "resources" / "exemplars" / name;
}

} // namespace texloom::test
