#include "core/job/leave_program.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace texloom {

void leaveProgram(int status) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    std::exit(status);
#else
    std::cout.flush();
    std::fflush(nullptr);
    ::_exit(status);
#endif
}

} // namespace texloom
