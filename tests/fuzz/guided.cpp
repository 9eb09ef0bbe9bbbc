// One reader of files, fed by libFuzzer, which looks for inputs that reach new code. TEXLOOM_FUZZ_READER says
// which; hour.sh runs them all. Whatever the input, it is read or refused by a texloom::Error.

#include "core/base/error.h"
#include "tests/fuzz/readers.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace texloom::test {

namespace {

const Reader& chosenReader() {
    const char* const asked = std::getenv("TEXLOOM_FUZZ_READER");
    const auto found = readers().find(asked ? asked : "");
    if (found != readers().end())
        return found->second;
    std::fputs("TEXLOOM_FUZZ_READER is one of:", stderr);
    for (const auto& [name, read] : readers())
        std::fprintf(stderr, " %s", name.c_str());
    std::fputs("\n", stderr);
    std::exit(2);
}

} // namespace

} // namespace texloom::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto& read = texloom::test::chosenReader();
    try {
        read(std::string_view(reinterpret_cast<const char*>(data), size));
    } catch (const texloom::Error&) {
        return 0;
    }
    return 0;
}
