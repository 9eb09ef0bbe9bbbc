#include "app/cli/console.h"
#include "app/cli/program.h"
#include "core/io/decoder_process.h"
#include "core/job/address_space.h"
#include "core/job/leave_program.h"

using namespace texloom;

namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which are not set up then either
using Early = void(int, char**, char**);
[[gnu::section(".preinit_array"), gnu::used]] Early* const beforeLibraries = endWhereAddressesAreFew;
#endif

} // namespace

int main(int argc, char** argv) {
    DecoderProcess::start(cli::checkInterrupt); // before anything has threads
    leaveProgram(cli::runProgram(argc, argv));
}
