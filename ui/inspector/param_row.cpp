#include "ui/inspector/param_row.h"

#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/common/value_editors.h"
#include "ui/inspector/mnemonics.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace texloom::ui {

namespace {

/// The value as the window says it: choices by their titles.
QString shownText(const Param& param, const Value& value) {
    if (param.type() == Param::Type::Choice)
        for (const Choice& choice : param.choices())
            if (choice.id == std::get<std::string>(value))
                return translated(choice.title);
    if (const bool* on = std::get_if<bool>(&value))
        return *on ? ParamRow::tr("on") : ParamRow::tr("off");
    const QString text = QString::fromStdString(toText(value));
    return param.unit().empty() ? text : text + QLatin1Char(' ') + translated(param.unit());
}

/// "w_p" with its index below the line.
QString symbolText(const QString& symbol) {
    const qsizetype index = symbol.indexOf(QLatin1Char('_'));
    if (index < 0)
        return QStringLiteral("<i>%1</i>").arg(symbol.toHtmlEscaped());
    return QStringLiteral("<i>%1</i><sub>%2</sub>")
        .arg(symbol.left(index).toHtmlEscaped(), symbol.mid(index + 1).toHtmlEscaped());
}

} // namespace

ParamRow::ParamRow(const Param& param, QGridLayout* grid, QWidget* parent, Mnemonics& mnemonics)
    : QObject(parent), m_param(&param),
      m_label(new QLabel(mnemonics.mark(translated(param.title())), parent)),
      m_editor(makeValueEditor(param, parent)), m_reset(new QToolButton(parent)),
      m_default(param.defaultFor(0)) {
    const QString title = translated(param.title());
    const QString name = QString::fromStdString(param.name());
    setObjectName(name);
    m_label->setObjectName(name + QStringLiteral("Label"));
    m_label->setBuddy(m_editor);
    m_editor->setObjectName(name + QStringLiteral("Editor"));
    m_reset->setObjectName(name + QStringLiteral("Reset"));
    m_reset->setAutoRaise(true);
    m_reset->setFocusPolicy(Qt::StrongFocus);
    setIconButton(m_reset, QStringLiteral("reset"), tr("Reset “%1” to its default").arg(title));
    if (m_reset->icon().isNull())
        m_reset->setText(QStringLiteral("↺"));
    QSizePolicy policy = m_reset->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(policy);

    const int row = grid->rowCount();
    grid->addWidget(m_label, row, 0);
    grid->addWidget(m_editor, row, 1);
    grid->addWidget(m_reset, row, 2);
    m_label->installEventFilter(this);
    m_editor->installEventFilter(this);
    for (QWidget* child : m_editor->findChildren<QWidget*>())
        child->installEventFilter(this);
    connect(m_editor, &ValueEditor::edited, this, [this] {
        choose(m_editor->value());
        Q_EMIT edited();
    });
    connect(m_reset, &QToolButton::clicked, this, [this] {
        reset();
        m_editor->setFocus();
    });
    show();
}

Value ParamRow::value() const {
    return m_chosen.value_or(m_default);
}

void ParamRow::setValue(const Value& value) {
    choose(m_param->checked(value));
    m_editor->setValue(this->value());
}

void ParamRow::setExemplarSide(int side) {
    m_side = side;
    m_default = m_param->defaultFor(side);
    if (m_chosen == m_default)
        m_chosen.reset();
    show();
}

void ParamRow::reset() {
    m_chosen.reset();
    show();
    Q_EMIT edited();
}

void ParamRow::choose(const Value& value) {
    m_chosen.reset();
    if (value != m_default)
        m_chosen = value;
    QFont font = m_label->font();
    font.setBold(changed());
    m_label->setFont(font);
    m_reset->setVisible(changed());
    m_editor->setToolTip(helpText());
    m_label->setToolTip(helpText());
}

void ParamRow::show() {
    choose(value());
    m_editor->setValue(value());
}

void ParamRow::setApplies(bool applies, const QString& reason) {
    m_label->setEnabled(applies);
    m_editor->setEnabled(applies);
    m_reset->setEnabled(applies);
    if (!applies)
        m_label->setToolTip(reason);
}

QString ParamRow::defaultText() const {
    const QString text = shownText(*m_param, m_default);
    if (!m_param->scale())
        return tr("Default: %1.").arg(text);
    const QString share = QString::number(*m_param->scale() * 100, 'g', 3);
    if (m_side == 0)
        return tr("Default: %1 % of the exemplar's shorter side.").arg(share);
    return tr("Default: %1 % of the exemplar's shorter side, here %2.").arg(share, text);
}

QString ParamRow::helpText() const {
    QString title = translated(m_param->title()).toHtmlEscaped();
    if (!m_param->symbol().empty())
        title += tr(" (%1 in the paper)").arg(symbolText(QString::fromStdString(m_param->symbol())));
    QString text = tr("<b>%1</b> %2").arg(title, translated(m_param->help()).toHtmlEscaped());
    if (m_param->hasRange())
        text += tr(" %1.").arg(translated(m_param->limits()).toHtmlEscaped());
    return text + QLatin1Char(' ') + defaultText().toHtmlEscaped();
}

bool ParamRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::Enter)
        Q_EMIT approached();
    if (watched == m_label && event->type() == QEvent::MouseButtonDblClick && m_label->isEnabled()) {
        reset();
        return true;
    }
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
        event->ignore();
        return true;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace texloom::ui
