#pragma once

#include <QAbstractSpinBox>

#include <cstdint>

namespace texloom::ui {

/// A spin box for a seed: any whole number of 64 bits.
class SeedEdit : public QAbstractSpinBox {
    Q_OBJECT

public:
    explicit SeedEdit(QWidget* parent = nullptr);

    std::uint64_t seed() const { return m_seed; }
    void setSeed(std::uint64_t seed);
    /// Takes a new seed at random, small enough to be read out.
    void draw();

    void stepBy(int steps) override;
    QValidator::State validate(QString& text, int& position) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void seedChanged(quint64 seed);

protected:
    StepEnabled stepEnabled() const override;

private:
    void takeText();

    std::uint64_t m_seed = 1;
};

} // namespace texloom::ui
