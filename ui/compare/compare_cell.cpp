#include "ui/compare/compare_cell.h"

#include "ui/common/elided_label.h"
#include "ui/common/icons.h"
#include "ui/viewers/image_viewer.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace texloom::ui {

CompareCell::CompareCell(QWidget* parent)
    : QWidget(parent), m_label(new ElidedLabel(this)), m_use(new QToolButton(this)),
      m_viewer(new ImageViewer(this)) {
    m_label->setTwoLines();
    setIconButton(m_use, QStringLiteral("reset"), tr("Restore settings"));
    m_use->setToolTip(
        tr("Bring the settings of this result into the form (Return); Run then makes it in full size"));
    m_use->setFocusPolicy(Qt::StrongFocus);
    QSizePolicy kept = m_use->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    m_use->setSizePolicy(kept);
    m_use->setVisible(false);
    m_viewer->installEventFilter(this);
    auto* row = new QHBoxLayout;
    row->addWidget(m_label, 1);
    row->addWidget(m_use);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(fontMetrics().height() / 4);
    column->addLayout(row);
    column->addWidget(m_viewer, 1);
    connect(m_use, &QToolButton::clicked, this, &CompareCell::useWanted);
}

void CompareCell::setItem(const CompareItem& item) {
    m_label->setFullText(item.label);
    m_use->setVisible(!item.key.empty());
    m_use->setAccessibleName(tr("Restore the settings of %1").arg(item.label));
    m_viewer->setAccessibleName(item.label);
    m_viewer->setPlaceholder(item.message);
    m_viewer->setPicture(item.picture);
    m_viewer->setToolTip(item.figures);
}

void CompareCell::setPicture(std::shared_ptr<const DisplayPicture> picture) {
    m_viewer->setPicture(std::move(picture));
}

bool CompareCell::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn)
        Q_EMIT entered();
    const bool returns = event->type() == QEvent::KeyPress &&
                         (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Return ||
                          static_cast<QKeyEvent*>(event)->key() == Qt::Key_Enter) &&
                         static_cast<QKeyEvent*>(event)->modifiers() == Qt::NoModifier;
    if ((returns || event->type() == QEvent::MouseButtonDblClick) && m_use->isVisible()) {
        Q_EMIT useWanted();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace texloom::ui
