#include "ui/log/log_panel.h"

#include "ui/common/icons.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTime>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr int kMostLines = 5000;

} // namespace

LogPanel::LogPanel(QWidget* parent) : QWidget(parent), m_text(new QPlainTextEdit(this)) {
    setObjectName(QStringLiteral("logPanel"));
    m_text->setObjectName(QStringLiteral("logText"));
    m_text->setAccessibleName(tr("Log"));
    m_text->setReadOnly(true);
    m_text->setMaximumBlockCount(kMostLines);
    m_text->setTabChangesFocus(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_text->setPlaceholderText(tr("What is run, and what goes wrong, is noted here."));
    auto* copy = new QToolButton(this);
    copy->setObjectName(QStringLiteral("copyLog"));
    copy->setText(tr("Copy all"));
    copy->setIcon(icon(QStringLiteral("copy")));
    copy->setToolTip(tr("Copy the whole log, for a report"));
    auto* clear = new QToolButton(this);
    clear->setObjectName(QStringLiteral("clearLog"));
    clear->setText(tr("Clear"));
    clear->setToolTip(tr("Take all lines off the log"));
    auto* row = new QHBoxLayout;
    for (QToolButton* button : {copy, clear}) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        row->addWidget(button);
    }
    row->addStretch();
    auto* column = new QVBoxLayout(this);
    column->addLayout(row);
    column->addWidget(m_text, 1);
    connect(copy, &QToolButton::clicked, this, [this] { QApplication::clipboard()->setText(text()); });
    connect(clear, &QToolButton::clicked, m_text, &QPlainTextEdit::clear);
}

void LogPanel::add(const QString& text) {
    const QScrollBar* const bar = m_text->verticalScrollBar();
    const bool follows = bar->value() == bar->maximum();
    m_text->appendPlainText(
        tr("%1  %2").arg(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")), text));
    if (follows)
        scrollToEnd();
}

void LogPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    // What was added while it was hidden has no place yet.
    QMetaObject::invokeMethod(this, &LogPanel::scrollToEnd, Qt::QueuedConnection);
}

void LogPanel::scrollToEnd() {
    m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->maximum());
}

QString LogPanel::text() const {
    return m_text->toPlainText();
}

} // namespace texloom::ui
