#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texloom::test {

/// How often each reader gets damaged bytes: TEXLOOM_FUZZ_ITERATIONS, or 300.
int iterations();

/// Runs a reader, which may succeed or throw Error, and nothing else, and must not work for long: processor
/// time, whatever else the machine does.
void expectReadOrRefused(const std::function<void()>& read);

/// Damages `originals` in turn, `count` times, and hands each to `read`. The damage is another one at each
/// call of the program, unless TEXLOOM_FUZZ_SEED is set; a failure says it and the iteration, and so does the
/// file texloom-fuzz-NAME in the folder of temporary files, where the program came to its end.
void fuzz(const std::string& name, const std::vector<std::string>& originals, int count,
          const std::function<void(const std::string&)>& read);

} // namespace texloom::test
