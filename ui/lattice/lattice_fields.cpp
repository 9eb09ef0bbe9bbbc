#include "ui/lattice/lattice_fields.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

namespace texloom::ui {

namespace {

constexpr double kLargest = 65535;

} // namespace

LatticeFields::LatticeFields(QWidget* parent) : QWidget(parent) {
    const std::array<QString, 3> titles = {tr("First vector"), tr("Second vector"), tr("Origin")};
    const std::array<const char*, 6> names = {"latticeV1x", "latticeV1y",     "latticeV2x",
                                              "latticeV2y", "latticeOriginX", "latticeOriginY"};
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("right, px")), 0, 1);
    grid->addWidget(new QLabel(tr("down, px")), 0, 2);
    for (int i = 0; i < 6; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const QString& title = titles[index / 2];
        m_fields[index] = makeField(QLatin1String(names[index]),
                                    (i % 2 == 0 ? tr("%1, right") : tr("%1, down")).arg(title));
        grid->addWidget(m_fields[index], 1 + i / 2, 1 + i % 2);
        if (i % 2 == 0)
            grid->addWidget(new QLabel(title), 1 + i / 2, 0);
    }
    m_fields[4]->setToolTip(tr("Where a tile begins. The methods choose by themselves until it is moved."));
    m_fields[5]->setToolTip(m_fields[4]->toolTip());
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
}

QDoubleSpinBox* LatticeFields::makeField(const QString& name, const QString& title) {
    auto* field = new QDoubleSpinBox;
    field->setObjectName(name);
    field->setAccessibleName(title);
    field->setRange(-kLargest, kLargest);
    field->setDecimals(2);
    field->setSingleStep(0.1);
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight);
    field->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0000.00")) * 3 / 2);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_filling)
            Q_EMIT edited();
    });
    return field;
}

void LatticeFields::setLattice(const std::optional<Lattice>& lattice, Vec2 origin) {
    m_filling = true;
    const Lattice shown = lattice.value_or(Lattice{{0, 0}, {0, 0}});
    const std::array<double, 6> values = {shown.v1.x, shown.v1.y, shown.v2.x, shown.v2.y, origin.x, origin.y};
    for (std::size_t i = 0; i < values.size(); ++i)
        m_fields[i]->setValue(values[i]);
    m_filling = false;
}

Vec2 LatticeFields::vector(std::size_t first) const {
    return {m_fields[first]->value(), m_fields[first + 1]->value()};
}

std::optional<Lattice> LatticeFields::lattice() const {
    const Lattice typed{vector(0), vector(2)};
    return typed.v1.length() + typed.v2.length() > 0 ? std::optional(typed) : std::nullopt;
}

Vec2 LatticeFields::origin() const {
    return vector(4);
}

} // namespace texloom::ui
