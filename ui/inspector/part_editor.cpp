#include "ui/inspector/part_editor.h"

#include "core/methods/method.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

PartEditor::PartEditor(QWidget* parent)
    : QWidget(parent), m_only(new QCheckBox(tr("only a part"), this)), m_numbers(new QWidget(this)) {
    m_only->setObjectName(QStringLiteral("onlyPart"));
    const std::array<const char*, 4> names = {"partX", "partY", "partWidth", "partHeight"};
    const std::array<QString, 4> titles = {tr("Part's left"), tr("Part's top"), tr("Part's width"),
                                           tr("Part's height")};
    auto* grid = new QGridLayout(m_numbers);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("at"), m_numbers), 0, 0);
    grid->addWidget(new QLabel(tr("size"), m_numbers), 1, 0);
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        auto* field = new QSpinBox(m_numbers);
        m_fields[i] = field;
        field->setObjectName(QLatin1String(names[i]));
        field->setAccessibleName(titles[i]);
        field->setToolTip(tr("%1, in pixels of the whole").arg(titles[i]));
        field->setRange(i < 2 ? 0 : 1, kLargestSide);
        field->setKeyboardTracking(false);
        grid->addWidget(field, static_cast<int>(i / 2), 1 + static_cast<int>(i % 2));
        connect(field, &QSpinBox::valueChanged, this, &PartEditor::edited);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_only);
    column->addWidget(m_numbers);
    m_numbers->hide();
    connect(m_only, &QCheckBox::toggled, this, [this](bool only) {
        if (only && !m_chosen)
            setPart(Region{m_whole.width / 4,
                           m_whole.height / 4,
                           {std::max(1, m_whole.width / 2), std::max(1, m_whole.height / 2)}});
        m_numbers->setVisible(only);
        Q_EMIT edited();
    });
}

std::optional<Region> PartEditor::part() const {
    if (!m_only->isChecked() || !isEnabled())
        return {};
    const auto value = [this](std::size_t i) { return m_fields[i]->value(); };
    return Region{value(0), value(1), {value(2), value(3)}};
}

void PartEditor::setPart(const std::optional<Region>& part) {
    const QSignalBlocker blocker(m_only);
    m_only->setChecked(part.has_value());
    m_numbers->setVisible(part.has_value());
    m_chosen = m_chosen || part;
    if (!part)
        return;
    const std::array<int, 4> values = {part->x, part->y, part->size.width, part->size.height};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const QSignalBlocker fieldBlocker(m_fields[i]);
        m_fields[i]->setValue(values[i]);
    }
}

void PartEditor::setWhole(Size whole) {
    m_whole = whole;
}

} // namespace texloom::ui
