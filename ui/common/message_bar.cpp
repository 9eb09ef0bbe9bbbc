#include "ui/common/message_bar.h"

#include "ui/common/icons.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include <utility>

namespace texloom::ui {

namespace {

constexpr std::chrono::seconds kBriefly{6};

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_action(new QPushButton(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setObjectName(QStringLiteral("messageBar"));
    m_text->setObjectName(QStringLiteral("messageText"));
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_action->setObjectName(QStringLiteral("messageAction"));
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("messageClose"));
    close->setAutoRaise(true);
    setIconButton(close, QStringLiteral("close"), tr("Close message"));

    auto* row = new QHBoxLayout(this);
    row->addWidget(m_icon);
    row->addWidget(m_text, 1);
    row->addWidget(m_action);
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, qOverload<>(&MessageBar::dismiss));
    connect(m_action, &QPushButton::clicked, this, [this] {
        const auto action = std::exchange(m_onAction, {});
        dismiss();
        if (action)
            action();
    });
    m_brief.setSingleShot(true);
    m_brief.setInterval(kBriefly);
    connect(&m_brief, &QTimer::timeout, this, qOverload<>(&MessageBar::dismiss));
    hide();
}

void MessageBar::sayBriefly(const QString& text) {
    say(Kind::Information, text);
    m_brief.start();
}

void MessageBar::say(Kind kind, const QString& text, const QString& action, std::function<void()> onAction) {
    m_brief.stop();
    m_kind = kind;
    m_onAction = std::move(onAction);
    const bool error = kind == Kind::Error;
    const int side = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this);
    m_icon->setPixmap(
        style()
            ->standardIcon(error ? QStyle::SP_MessageBoxWarning : QStyle::SP_MessageBoxInformation)
            .pixmap(side, side));
    m_icon->setAccessibleName(error ? tr("Error") : tr("Information"));
    m_text->setText(text);
    m_action->setText(action);
    m_action->setVisible(!action.isEmpty());
    show();
    QAccessibleEvent alert(m_text, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
}

void MessageBar::dismiss() {
    m_brief.stop();
    hide();
    m_text->clear();
    m_onAction = {};
}

void MessageBar::dismissTold() {
    if (m_kind == Kind::Error || !m_onAction)
        dismiss();
}

void MessageBar::dismiss(const QString& text) {
    if (m_text->text() == text)
        dismiss();
}

QString MessageBar::text() const {
    return m_text->text();
}

} // namespace texloom::ui
