#include "ui/volume/box_dialog.h"

#include "core/base/text.h"
#include "core/volume/volume_file.h"
#include "ui/common/background.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

#include <algorithm>
#include <exception>

namespace texloom::ui {

namespace {

constexpr int kFarthestCorner = 1'000'000'000, kLongestSide = 1'000'000;

} // namespace

BoxDialog::BoxDialog(const Box& first, QWidget* parent)
    : QDialog(parent), m_from{new QSpinBox(this), new QSpinBox(this), new QSpinBox(this)},
      m_sides{new QSpinBox(this), new QSpinBox(this), new QSpinBox(this)}, m_verdict(new QLabel(this)),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this)) {
    setObjectName(QStringLiteral("boxDialog"));
    setWindowTitle(tr("Box of voxels"));
    auto* grid = new QGridLayout(this);
    const std::array<std::int64_t, 3> from = {first.x, first.y, first.z};
    const std::array<int, 3> sides = {first.size.width, first.size.height, first.size.depth};
    grid->addWidget(new QLabel(tr("First voxel"), this), 0, 1);
    grid->addWidget(new QLabel(tr("Voxels"), this), 0, 2);
    for (std::size_t i = 0; i < m_from.size(); ++i) {
        const QString axis(QStringLiteral("xyz").at(static_cast<int>(i)));
        const int row = static_cast<int>(i) + 1;
        grid->addWidget(new QLabel(axis, this), row, 0);
        m_from.at(i)->setObjectName(QStringLiteral("boxFrom_") + axis);
        m_from.at(i)->setAccessibleName(tr("First voxel along %1").arg(axis));
        m_from.at(i)->setRange(-kFarthestCorner, kFarthestCorner);
        m_from.at(i)->setValue(static_cast<int>(from.at(i)));
        m_sides.at(i)->setObjectName(QStringLiteral("boxSide_") + axis);
        m_sides.at(i)->setAccessibleName(tr("Voxels along %1").arg(axis));
        m_sides.at(i)->setRange(1, kLongestSide);
        m_sides.at(i)->setValue(std::max(1, sides.at(i)));
        grid->addWidget(m_from.at(i), row, 1);
        grid->addWidget(m_sides.at(i), row, 2);
        connect(m_sides.at(i), &QSpinBox::valueChanged, this, &BoxDialog::judge);
    }
    m_verdict->setObjectName(QStringLiteral("boxVerdict"));
    m_verdict->setWordWrap(true);
    grid->addWidget(m_verdict, 4, 0, 1, 3);
    grid->addWidget(m_buttons, 5, 0, 1, 3);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    judge();
}

Box BoxDialog::box() const {
    return {m_from[0]->value(),
            m_from[1]->value(),
            m_from[2]->value(),
            {m_sides[0]->value(), m_sides[1]->value(), m_sides[2]->value()}};
}

void BoxDialog::judge() {
    QString text;
    bool possible = true;
    try {
        checkFileBox(box());
        text = tr("%1 voxels")
                   .arg(QString::fromStdString(grouped(static_cast<std::uint64_t>(box().size.voxels()))));
    } catch (const std::exception& error) {
        text = sentence(error);
        possible = false;
    }
    m_verdict->setText(text);
    m_buttons->button(QDialogButtonBox::Save)->setEnabled(possible);
}

} // namespace texloom::ui
