#include "ui/common/reading_bar.h"

#include "ui/common/elided_label.h"
#include "ui/common/readings.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

#include <chrono>

namespace texloom::ui {

namespace {

/// A bar that came up for every small file would only flicker.
constexpr std::chrono::milliseconds kPatience{400};
constexpr int kBarWidth = 16;

} // namespace

ReadingBar::ReadingBar(QWidget* parent) : QFrame(parent), m_text(new ElidedLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    setObjectName(QStringLiteral("readingBar"));
    m_text->setObjectName(QStringLiteral("readingText"));
    auto* busy = new QProgressBar(this);
    busy->setRange(0, 0); // how long it takes, nobody knows
    busy->setTextVisible(false);
    busy->setFixedWidth(fontMetrics().averageCharWidth() * kBarWidth);
    busy->setAccessibleName(tr("Working"));
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(QStringLiteral("cancelReading"));
    cancel->setToolTip(tr("Stops; everything stays as it was."));
    auto* row = new QHBoxLayout(this);
    row->addWidget(busy);
    row->addWidget(m_text, 1);
    row->addWidget(cancel);
    m_patience.setSingleShot(true);
    m_patience.setInterval(kPatience);
    connect(&m_patience, &QTimer::timeout, this, &QWidget::show);
    connect(&Readings::all(), &Readings::changed, this, &ReadingBar::refresh);
    connect(cancel, &QPushButton::clicked, &Readings::all(), &Readings::stop);
    hide();
}

void ReadingBar::refresh() {
    const Readings& readings = Readings::all();
    if (readings.count() == 0) {
        m_patience.stop();
        return hide();
    }
    const int others = readings.count() - 1;
    const std::shared_ptr<const Readings::Reading> first = readings.first();
    const QString doing = first->doing == Readings::Doing::Edit ? tr("Editing %1…") : tr("Reading %1…");
    const QString what =
        others > 0 ? tr("%1 and %2 more").arg(first->what, QString::number(others)) : first->what;
    m_text->setFullText(doing.arg(what));
    if (!isVisible() && !m_patience.isActive())
        m_patience.start();
}

} // namespace texloom::ui
