#include "ui/window/readout.h"

#include "ui/common/elided_label.h"

#include <QHBoxLayout>

namespace texloom::ui {

Readout::Readout(QWidget* parent)
    : QWidget(parent), m_place(new ElidedLabel(this)), m_values(new QLabel(this)), m_kind(new QLabel(this)) {
    setObjectName(QStringLiteral("readout"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(fontMetrics().height() * 2);
    row->addWidget(m_place, 1);
    row->addWidget(m_values);
    row->addWidget(m_kind);
}

void Readout::show(const QString& place, const QString& values, const QString& kind) {
    m_place->setFullText(place);
    m_values->setText(values);
    m_kind->setText(kind);
}

void Readout::addToPlace(const QString& text) {
    m_place->setFullText(tr("%1 · %2").arg(m_place->fullText(), text));
}

void Readout::clear() {
    show({}, {}, {});
}

QString Readout::text() const {
    return QStringLiteral("%1 %2 %3").arg(m_place->fullText(), m_values->text(), m_kind->text()).trimmed();
}

} // namespace texloom::ui
