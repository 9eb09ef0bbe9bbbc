#include "ui/common/numbers_editor.h"

#include "ui/common/text.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include <cmath>

namespace texloom::ui {

namespace {

constexpr int kLargest = 65535;

QWidget* pairOf(QWidget* first, QWidget* second) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(first, 1);
    layout->addWidget(second, 1);
    return row;
}

} // namespace

NumbersEditor::NumbersEditor(const Param& param, QWidget* parent)
    : ValueEditor(parent), m_param(param), m_value(param.defaultFor(0)) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    for (const QString& title : pairTitles()) {
        for (const QString& side : {tr("%1, across"), tr("%1, down")}) {
            const std::size_t index = m_numbers.size();
            auto* number = new QSpinBox(this);
            number->setObjectName(
                QStringLiteral("%1-%2").arg(QString::fromStdString(param.name())).arg(index));
            number->setAccessibleName(side.arg(title));
            number->setRange(0, kLargest);
            number->setKeyboardTracking(false);
            if (param.type() == Param::Type::Size)
                number->setSpecialValueText(tr("auto"));
            connect(number, &QSpinBox::valueChanged, this, [this, index](int value) { take(index, value); });
            m_numbers.push_back(number);
        }
        form->addRow(title, pairOf(m_numbers[m_numbers.size() - 2], m_numbers.back()));
    }
    setFocusProxy(m_numbers.front());
    showNumbers();
}

std::vector<QString> NumbersEditor::pairTitles() const {
    if (m_param.type() == Param::Type::Area)
        return {tr("Left, top"), tr("Width, height")};
    if (m_param.type() == Param::Type::Size)
        return {tr("Width, height")};
    std::vector<QString> titles;
    for (std::size_t i = 0; i < m_param.pointCount(); ++i)
        titles.push_back(i < m_param.choices().size() ? translated(m_param.choices()[i].title)
                                                      : tr("Point %1").arg(i + 1));
    return titles;
}

void NumbersEditor::setValue(const Value& value) {
    m_value = value;
    showNumbers();
}

void NumbersEditor::showNumbers() {
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        double number = 0;
        if (const auto* points = std::get_if<PlanePoints>(&m_value))
            number = i % 2 == 0 ? points->at(i / 2).x : points->at(i / 2).y;
        else if (const auto& wholes = std::get<Wholes>(m_value); !wholes.empty())
            number = wholes.at(i);
        const QSignalBlocker blocker(m_numbers[i]);
        m_numbers[i]->setValue(static_cast<int>(std::lround(number)));
    }
}

void NumbersEditor::take(std::size_t index, int number) {
    if (auto* points = std::get_if<PlanePoints>(&m_value)) {
        PlanePoint& point = points->at(index / 2);
        (index % 2 == 0 ? point.x : point.y) = number;
    } else {
        Wholes wholes;
        for (const QSpinBox* spin : m_numbers)
            wholes.push_back(spin->value());
        // Half a size is none yet: the other side follows.
        if (m_param.type() == Param::Type::Size && (wholes[0] == 0 || wholes[1] == 0))
            wholes = number == 0 ? Wholes{} : Wholes{number, number};
        m_value = wholes;
        showNumbers();
    }
    Q_EMIT edited();
}

} // namespace texloom::ui
