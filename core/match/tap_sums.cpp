#include "core/match/tap_sums.h"

#include "core/base/wide_vectors.h"

#include <cstring>

namespace texloom {

namespace {

using Eight = float __attribute__((vector_size(32)));
constexpr int kEight = 8, kBlock = 4 * kEight;

} // namespace

TEXLOOM_WIDE_VECTORS
void sumTaps(const float* const* taps, const float* weights, int count, int length, float* to) {
    int i = 0;
    for (; i + kBlock <= length; i += kBlock) {
        Eight a{}, b{}, c{}, d{};
        for (int t = 0; t < count; ++t) {
            const float* from = taps[t] + i;
            Eight p, q, r, s;
            std::memcpy(&p, from, sizeof p);
            std::memcpy(&q, from + kEight, sizeof q);
            std::memcpy(&r, from + 2 * kEight, sizeof r);
            std::memcpy(&s, from + 3 * kEight, sizeof s);
            a += weights[t] * p;
            b += weights[t] * q;
            c += weights[t] * r;
            d += weights[t] * s;
        }
        std::memcpy(to + i, &a, sizeof a);
        std::memcpy(to + i + kEight, &b, sizeof b);
        std::memcpy(to + i + 2 * kEight, &c, sizeof c);
        std::memcpy(to + i + 3 * kEight, &d, sizeof d);
    }
    for (; i < length; ++i) {
        float sum = 0;
        for (int t = 0; t < count; ++t)
            sum += weights[t] * taps[t][i];
        to[i] = sum;
    }
}

} // namespace texloom
