// The main() of a program with several classes of tests, of which its first argument names one.

#include "tests/ui/test_programs.h"

#include "tests/ui/window_fixture.h"

#include <cctype>
#include <cstdio>
#include <map>
#include <string>

namespace texloom::ui {

namespace {

std::map<std::string, TestProgram::Run>& programs() {
    static std::map<std::string, TestProgram::Run> all;
    return all;
}

/// "volume_saving" for "VolumeSavingTest".
std::string nameOf(std::string className) {
    className.resize(className.rfind("Test"));
    std::string name;
    for (const char letter : className) {
        if (std::isupper(static_cast<unsigned char>(letter)) != 0 && !name.empty())
            name += '_';
        name += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return name;
}

} // namespace

TestProgram::TestProgram(const char* className, Run run) {
    programs().emplace(nameOf(className), run);
}

} // namespace texloom::ui

int main(int argc, char** argv) {
    using namespace texloom::ui;
    const auto chosen = argc > 1 ? programs().find(argv[1]) : programs().end();
    if (chosen == programs().end()) {
        std::fprintf(stderr, "Usage: %s TESTS [argument of Qt Test…]; TESTS is one of:\n", argv[0]);
        for (const auto& [name, run] : programs())
            std::fprintf(stderr, "  %s\n", name.c_str());
        return 2;
    }
    argv[1] = argv[0];
    return runTests(argc - 1, argv + 1, chosen->second);
}
