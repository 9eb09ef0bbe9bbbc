#pragma once

namespace texloom {

/// Index into `length` pixels that mirrors at the borders, as often as need be.
inline int mirrored(int at, int length) {
    const int period = 2 * length;
    const int folded = (at % period + period) % period;
    return folded < length ? folded : period - 1 - folded;
}

/// Index into `length` pixels that repeat, as often as need be.
inline int repeated(int at, int length) {
    const int rest = at % length;
    return rest < 0 ? rest + length : rest;
}

} // namespace texloom
