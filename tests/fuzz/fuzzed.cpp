#include "tests/fuzz/fuzzed.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/job/random.h"
#include "tests/fuzz/damage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <random>

namespace texloom::test {

namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kLongest = 20; // seconds of processor time
#else
constexpr double kLongest = 5;
#endif

/// The number in a variable of the environment.
std::uint64_t numberFrom(const char* name, std::uint64_t otherwise) {
    const char* asked = std::getenv(name);
    std::uint64_t number = otherwise;
    if (asked && !parseUnsigned(asked, number))
        ADD_FAILURE() << name << " is " << asked << ", not a number";
    return number;
}

/// Another one at each call of the program, so that many short runs are as good as a long one.
std::uint64_t seed() {
    static const std::uint64_t drawn = std::random_device()();
    return numberFrom("TEXLOOM_FUZZ_SEED", drawn);
}

/// "TEXLOOM_FUZZ_SEED=7, iteration 12": what it takes to see it again.
std::string placeText(int iteration) {
    return "TEXLOOM_FUZZ_SEED=" + std::to_string(seed()) + ", iteration " + std::to_string(iteration);
}

/// Processor time of this process, in seconds.
double worked() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Says in a file which iteration is under way, since after a crash nobody is left to say it.
class Trace {
public:
    explicit Trace(const std::string& name) : m_path(fs::temp_directory_path() / ("texloom-fuzz-" + name)) {}
    ~Trace() {
        std::error_code ignored;
        fs::remove(m_path, ignored);
    }
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;
    void at(int iteration) const { std::ofstream(m_path) << placeText(iteration) << '\n'; }

private:
    fs::path m_path;
};

} // namespace

int iterations() {
    return static_cast<int>(numberFrom("TEXLOOM_FUZZ_ITERATIONS", 300));
}

void expectReadOrRefused(const std::function<void()>& read) {
    const double start = worked();
    try {
        read();
    } catch (const Error& error) {
        EXPECT_STRNE(error.what(), "");
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "not a texloom::Error: " << error.what();
    } catch (...) {
        ADD_FAILURE() << "not a texloom::Error, and no exception of the standard";
    }
    EXPECT_LT(worked() - start, kLongest);
}

void fuzz(const std::string& name, const std::vector<std::string>& originals, int count,
          const std::function<void(const std::string&)>& read) {
    const Random random(seed());
    const Trace trace(name);
    for (int i = 0; i < count && !::testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(placeText(i));
        trace.at(i);
        const auto which = static_cast<std::size_t>(i) % originals.size();
        const std::string& other =
            originals[(which + 1 + static_cast<std::size_t>(i) / 7) % originals.size()];
        const std::string bytes = damaged(originals[which], other, random, i);
        expectReadOrRefused([&] { read(bytes); });
    }
}

} // namespace texloom::test
