#pragma once

#include "core/analysis/lattice.h"

#include <QWidget>

#include <array>
#include <optional>

class QDoubleSpinBox;

namespace texloom::ui {

/// A lattice and its origin as six numbers to be typed.
class LatticeFields : public QWidget {
    Q_OBJECT

public:
    explicit LatticeFields(QWidget* parent = nullptr);

    /// Shows a lattice, zeros if there is none, without edited().
    void setLattice(const std::optional<Lattice>& lattice, Vec2 origin);
    /// What the fields say; none if all vectors are 0.
    std::optional<Lattice> lattice() const;
    Vec2 origin() const;

Q_SIGNALS:
    void edited();

private:
    Vec2 vector(std::size_t first) const;
    QDoubleSpinBox* makeField(const QString& name, const QString& title);

    std::array<QDoubleSpinBox*, 6> m_fields{}; ///< both vectors and the origin, each right and down
    bool m_filling = false;
};

} // namespace texloom::ui
