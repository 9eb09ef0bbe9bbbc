#include "ui/lattice/lattice_text.h"

namespace texloom::ui {

bool sameVectors(const Lattice& a, const Lattice& b) {
    return (a.v1 - b.v1).length() < kSameVectors && (a.v2 - b.v2).length() < kSameVectors;
}

QString vectorText(Vec2 vector, int decimals) {
    return QStringLiteral("%1, %2").arg(vector.x, 0, 'f', decimals).arg(vector.y, 0, 'f', decimals);
}

} // namespace texloom::ui
