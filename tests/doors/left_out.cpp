// A method that a build was made without, as one whose library was not there.

#include "core/base/text.h"
#include "core/methods/registry.h"

namespace texloom {

namespace {
const Registration leftOut(AbsentMethod{
    "left-out", TR("Its library was not there when Texloom was built; install it, and "
                   "build Texloom again.")});
}

} // namespace texloom
