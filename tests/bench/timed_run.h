#pragma once

#include "core/methods/method.h"

#include <benchmark/benchmark.h>

#include <string>

namespace texloom::bench {

/// Runs a method at its defaults on two threads, previews looked at, in each round. Besides the time of all,
/// a counter says how long it took to the first preview.
void timeRun(benchmark::State& state, const std::string& method, const Request& request);

} // namespace texloom::bench
