#include "ui/common/value_editors.h"

#include "ui/common/numbers_editor.h"
#include "ui/common/text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>

#include <cmath>
#include <limits>

namespace texloom::ui {

namespace {

/// Positions of a slider over a range of reals.
constexpr int kSliderSteps = 1000;
/// A range of reals wider than this is open: a slider over it would be of no use.
constexpr double kOpenSpan = 10'000;

QHBoxLayout* rowFor(QWidget* widget) {
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    return row;
}

/// All spin boxes of a form are this wide, so that their sliders end in line.
void alignSpinBox(QAbstractSpinBox* spin) {
    spin->setAlignment(Qt::AlignRight);
    spin->setFixedWidth(spin->fontMetrics().horizontalAdvance(QStringLiteral("00000.00 px")));
}

QString suffix(const Param& param) {
    return param.unit().empty() ? QString() : QLatin1Char(' ') + translated(param.unit());
}

class IntegerEditor : public ValueEditor {
public:
    IntegerEditor(const Param& param, QWidget* parent) : ValueEditor(parent), m_spin(new QSpinBox(this)) {
        QHBoxLayout* const row = rowFor(this);
        m_spin->setRange(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
        m_spin->setKeyboardTracking(false);
        m_spin->setSuffix(suffix(param));
        m_spin->setAccessibleName(translated(param.title()));
        if (param.hasRange()) {
            m_spin->setRange(static_cast<int>(param.smallest()), static_cast<int>(param.largest()));
            m_slider = new QSlider(Qt::Horizontal, this);
            m_slider->setRange(m_spin->minimum(), m_spin->maximum());
            m_slider->setPageStep(std::max(1, (m_spin->maximum() - m_spin->minimum()) / 10));
            m_slider->setAccessibleName(translated(param.title()));
            row->addWidget(m_slider, 1);
            alignSpinBox(m_spin);
            connect(m_slider, &QSlider::valueChanged, m_spin, &QSpinBox::setValue);
        }
        row->addWidget(m_spin);
        setFocusProxy(m_spin);
        connect(m_spin, &QSpinBox::valueChanged, this, [this](int value) {
            follow(value);
            Q_EMIT edited();
        });
    }

    Value value() const override { return m_spin->value(); }
    void setValue(const Value& value) override {
        const QSignalBlocker blocker(m_spin);
        m_spin->setValue(std::get<int>(value));
        follow(m_spin->value());
    }
    void setLargest(double largest) override {
        const QSignalBlocker spin(m_spin);
        m_spin->setMaximum(static_cast<int>(largest));
        if (m_slider == nullptr)
            return;
        const QSignalBlocker slider(m_slider);
        m_slider->setMaximum(m_spin->maximum());
    }

private:
    void follow(int value) {
        if (m_slider == nullptr)
            return;
        const QSignalBlocker blocker(m_slider);
        m_slider->setValue(value);
    }

    QSpinBox* m_spin;
    QSlider* m_slider = nullptr;
};

class RealEditor : public ValueEditor {
public:
    RealEditor(const Param& param, QWidget* parent)
        : ValueEditor(parent), m_spin(new QDoubleSpinBox(this)), m_from(param.usualFrom()),
          m_to(param.usualTo()) {
        QHBoxLayout* const row = rowFor(this);
        const double largest = std::numeric_limits<float>::max();
        m_spin->setDecimals(decimalsFor(param));
        m_spin->setRange(param.hasRange() ? param.smallest() : -largest,
                         param.hasRange() ? param.largest() : largest);
        m_spin->setKeyboardTracking(false);
        m_spin->setSuffix(suffix(param));
        m_spin->setAccessibleName(translated(param.title()));
        m_spin->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
        if (param.hasRange() && spanOf(param) <= kOpenSpan) {
            m_spin->setStepType(QAbstractSpinBox::DefaultStepType);
            m_spin->setSingleStep((m_to - m_from) / 100);
            m_slider = new QSlider(Qt::Horizontal, this);
            m_slider->setRange(0, kSliderSteps);
            m_slider->setPageStep(kSliderSteps / 10);
            m_slider->setSingleStep(kSliderSteps / 100);
            m_slider->setAccessibleName(translated(param.title()));
            row->addWidget(m_slider, 1);
            alignSpinBox(m_spin);
            connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
                m_spin->setValue(m_from + (m_to - m_from) * position / kSliderSteps);
            });
        }
        row->addWidget(m_spin);
        setFocusProxy(m_spin);
        connect(m_spin, &QDoubleSpinBox::valueChanged, this, [this](double value) {
            follow(value);
            Q_EMIT edited();
        });
    }

    Value value() const override { return m_spin->value(); }
    void setValue(const Value& value) override {
        const QSignalBlocker blocker(m_spin);
        m_spin->setValue(std::get<double>(value));
        follow(m_spin->value());
    }

private:
    static double spanOf(const Param& param) {
        return param.hasRange() ? param.usualTo() - param.usualFrom() : 1;
    }

    static int decimalsFor(const Param& param) {
        const double span = spanOf(param);
        return span > kOpenSpan ? 3 : span > 100 ? 1 : span > 10 ? 2 : span >= 0.1 ? 3 : 6;
    }

    void follow(double value) {
        if (m_slider == nullptr)
            return;
        const QSignalBlocker blocker(m_slider);
        const double share = (value - m_from) / (m_to - m_from);
        m_slider->setValue(static_cast<int>(std::lround(share * kSliderSteps)));
    }

    QDoubleSpinBox* m_spin;
    QSlider* m_slider = nullptr;
    double m_from, m_to; ///< the ends of the slider
};

class ToggleEditor : public ValueEditor {
public:
    ToggleEditor(const Param& param, QWidget* parent) : ValueEditor(parent), m_box(new QCheckBox(this)) {
        QHBoxLayout* const row = rowFor(this);
        row->addWidget(m_box);
        row->addStretch();
        m_box->setAccessibleName(translated(param.title()));
        setFocusProxy(m_box);
        connect(m_box, &QCheckBox::toggled, this, &ValueEditor::edited);
    }

    Value value() const override { return m_box->isChecked(); }
    void setValue(const Value& value) override {
        const QSignalBlocker blocker(m_box);
        m_box->setChecked(std::get<bool>(value));
    }

private:
    QCheckBox* m_box;
};

class ChoiceEditor : public ValueEditor {
public:
    ChoiceEditor(const Param& param, QWidget* parent) : ValueEditor(parent), m_combo(new QComboBox(this)) {
        rowFor(this)->addWidget(m_combo);
        for (const Choice& choice : param.choices())
            m_combo->addItem(translated(choice.title), QString::fromStdString(choice.id));
        setFocusProxy(m_combo);
        connect(m_combo, &QComboBox::currentIndexChanged, this, &ValueEditor::edited);
    }

    Value value() const override { return m_combo->currentData().toString().toStdString(); }
    void setValue(const Value& value) override {
        const QSignalBlocker blocker(m_combo);
        m_combo->setCurrentIndex(m_combo->findData(QString::fromStdString(std::get<std::string>(value))));
    }

private:
    QComboBox* m_combo;
};

} // namespace

ValueEditor* makeValueEditor(const Param& param, QWidget* parent) {
    switch (param.type()) {
    case Param::Type::Toggle:
        return new ToggleEditor(param, parent);
    case Param::Type::Integer:
        return new IntegerEditor(param, parent);
    case Param::Type::Real:
        return new RealEditor(param, parent);
    case Param::Type::Choice:
        return new ChoiceEditor(param, parent);
    case Param::Type::Area:
    case Param::Type::Size:
    case Param::Type::Points:
        return new NumbersEditor(param, parent);
    }
    return nullptr;
}

} // namespace texloom::ui
