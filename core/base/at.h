#pragma once

#include <cstddef>

namespace texloom {

/// An index as the containers of the standard library take it; it is not negative.
inline std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

} // namespace texloom
