#include "ui/jobs/task_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kSteps = 1000;
constexpr std::chrono::milliseconds kBetweenUpdates{100};

} // namespace

TaskBar::TaskBar(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_bar(new QProgressBar(this)),
      m_cancel(new QPushButton(tr("Cancel"), this)) {
    m_bar->setRange(0, kSteps);
    m_cancel->setObjectName(QStringLiteral("cancelTask"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_text);
    row->addWidget(m_bar, 1);
    row->addWidget(m_cancel);
    m_timer.setInterval(kBetweenUpdates);
    connect(&m_timer, &QTimer::timeout, this, &TaskBar::poll);
    connect(m_cancel, &QPushButton::clicked, this, &TaskBar::cancelled);
    hide();
}

void TaskBar::begin(const QString& text, std::function<double()> progress) {
    m_progress = std::move(progress);
    m_text->setText(text);
    m_bar->setAccessibleName(text);
    m_timer.start();
    poll();
    show();
}

void TaskBar::end() {
    m_timer.stop();
    hide();
}

void TaskBar::poll() {
    m_bar->setValue(static_cast<int>(std::lround(m_progress() * kSteps)));
}

} // namespace texloom::ui
