// The example of CONTRIBUTING.md, whole, among the methods.

#include "tests/methods/examples/mirror_tile.cpp"

#include "core/methods/registry.h"

namespace texloom::mirror_tile {

namespace {
const Registration registered("mirror-tile", self);
}

} // namespace texloom::mirror_tile
