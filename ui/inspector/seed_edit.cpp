#include "ui/inspector/seed_edit.h"

#include <QLineEdit>
#include <QRandomGenerator>
#include <QStyleOptionSpinBox>

#include <limits>

namespace texloom::ui {

namespace {

constexpr std::uint64_t kLargestSeed = std::numeric_limits<std::uint64_t>::max();
/// Drawn seeds stay below this: easy to read out, and never the same twice in practice.
constexpr int kDrawnBelow = 1'000'000;

} // namespace

SeedEdit::SeedEdit(QWidget* parent) : QAbstractSpinBox(parent) {
    lineEdit()->setText(QString::number(m_seed));
    connect(this, &QAbstractSpinBox::editingFinished, this, &SeedEdit::takeText);
}

void SeedEdit::setSeed(std::uint64_t seed) {
    lineEdit()->setText(QString::number(seed));
    if (seed == m_seed)
        return;
    m_seed = seed;
    Q_EMIT seedChanged(seed);
}

void SeedEdit::draw() {
    setSeed(static_cast<std::uint64_t>(QRandomGenerator::global()->bounded(1, kDrawnBelow)));
}

void SeedEdit::takeText() {
    bool valid = false;
    const quint64 seed = lineEdit()->text().toULongLong(&valid);
    setSeed(valid ? seed : m_seed);
}

void SeedEdit::stepBy(int steps) {
    takeText();
    const auto distance = static_cast<std::uint64_t>(std::abs(steps));
    if (steps < 0)
        setSeed(m_seed < distance ? 0 : m_seed - distance);
    else
        setSeed(kLargestSeed - m_seed < distance ? kLargestSeed : m_seed + distance);
}

QAbstractSpinBox::StepEnabled SeedEdit::stepEnabled() const {
    StepEnabled steps = StepNone;
    if (m_seed > 0)
        steps |= StepDownEnabled;
    if (m_seed < kLargestSeed)
        steps |= StepUpEnabled;
    return steps;
}

QValidator::State SeedEdit::validate(QString& text, int&) const {
    if (text.isEmpty())
        return QValidator::Intermediate;
    bool valid = false;
    text.toULongLong(&valid);
    return valid && text[0].isDigit() ? QValidator::Acceptable : QValidator::Invalid;
}

QSize SeedEdit::sizeHint() const {
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    const QSize text(fontMetrics().horizontalAdvance(QStringLiteral("0000000000")),
                     lineEdit()->sizeHint().height());
    return style()->sizeFromContents(QStyle::CT_SpinBox, &option, text, this);
}

QSize SeedEdit::minimumSizeHint() const {
    return sizeHint();
}

} // namespace texloom::ui
