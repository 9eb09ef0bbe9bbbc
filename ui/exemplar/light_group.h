#pragma once

#include "core/image/exemplar_edit.h"

#include <QGroupBox>

#include <optional>

class QCheckBox;
class QLabel;

namespace texloom::ui {

class ValueEditor;

/// How uneven light is taken out of an exemplar, with a look at it as it was before.
class LightGroup : public QGroupBox {
    Q_OBJECT

public:
    explicit LightGroup(QWidget* parent = nullptr);

    /// Shows a light, or that there is none.
    void setLight(const FlattenEdit* light);
    /// What is asked for; none if the group is not checked.
    std::optional<FlattenEdit> light() const;
    /// Whether the exemplar is to be seen without it.
    bool showsBefore() const;

Q_SIGNALS:
    /// The user changed what light() gives.
    void edited();
    void beforeToggled();

private:
    bool smooth() const;
    void showWhatCounts();
    void tell();

    ValueEditor *m_model, *m_width, *m_order, *m_strength;
    QLabel *m_widthLabel = nullptr, *m_orderLabel = nullptr;
    QCheckBox* m_before;
    bool m_filling = false;
};

} // namespace texloom::ui
