#pragma once

namespace texloom::ui {

/// A class of Qt Test cases that a program holds beside others; see test_programs.cpp.
class TestProgram {
public:
    using Run = int (*)(int argc, char** argv);

    /// @param className such as "ViewerTest", which is called up as "viewer".
    TestProgram(const char* className, Run run);
};

} // namespace texloom::ui

/// Makes a class of tests one that the file's program can run.
#define TEXLOOM_UI_TESTS(Class)                                                                              \
    static const texloom::ui::TestProgram programOf##Class(#Class, [](int argc, char** argv) {               \
        Class tests;                                                                                         \
        return QTest::qExec(&tests, argc, argv);                                                             \
    });
