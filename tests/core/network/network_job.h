#pragma once

#include "core/job/job_context.h"
#include "core/network/tensor.h"

namespace texloom::test {

/// A job to compute in, with so many threads.
struct NetworkJob {
    explicit NetworkJob(int threads = 2)
        : context(
              {7, threads, false}, [] { return false; }, monitor) {}

    JobMonitor monitor;
    JobContext context;
};

/// Normal numbers, another field for each seed.
inline Tensor normalTensor(int channels, int height, int width, int seed) {
    Tensor tensor(channels, height, width);
    const Random random(static_cast<std::uint64_t>(seed));
    for (std::size_t i = 0; i < tensor.size(); ++i)
        tensor.data()[i] = static_cast<float>(random.normal(static_cast<int>(i), 0));
    return tensor;
}

inline double innerProduct(const Tensor& a, const Tensor& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += static_cast<double>(a.data()[i]) * static_cast<double>(b.data()[i]);
    return sum;
}

inline bool sameBits(const Tensor& a, const Tensor& b) {
    return a.sameShape(b) && std::equal(a.data(), a.data() + a.size(), b.data());
}

} // namespace texloom::test
