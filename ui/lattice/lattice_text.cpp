#include "ui/lattice/lattice_text.h"

#include <cmath>

namespace texloom::ui {

bool sameVectors(const Lattice& a, const Lattice& b) {
    return (a.v1 - b.v1).length() < kSameVectors && (a.v2 - b.v2).length() < kSameVectors;
}

QString vectorText(Vec2 vector, int decimals) {
    const double unit = std::pow(10.0, -decimals);
    const auto whole = [unit](double value) { return std::abs(value) < unit / 2 ? 0.0 : value; }; // never −0
    return QStringLiteral("%1, %2")
        .arg(whole(vector.x), 0, 'f', decimals)
        .arg(whole(vector.y), 0, 'f', decimals);
}

} // namespace texloom::ui
