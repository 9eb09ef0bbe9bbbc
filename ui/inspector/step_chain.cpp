#include "ui/inspector/step_chain.h"

#include "core/methods/method.h"
#include "ui/common/text.h"
#include "ui/inspector/method_chooser.h"
#include "ui/inspector/method_form.h"
#include "ui/inspector/mnemonics.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace texloom::ui {

namespace {

/// Whether a method takes up what another one makes. Which follow which is for planRun() to say, in a
/// sentence.
bool follows(const MethodInfo& info) {
    return std::any_of(methods().begin(), methods().end(),
                       [&info](const Method& method) { return !linksBetween(method.info(), info).empty(); });
}

} // namespace

StepChain::StepChain(QWidget* parent) : QWidget(parent), m_column(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("stepChain"));
    m_column->setContentsMargins(0, 0, 0, 0);
    addLink();
    setFocusProxy(m_links.front().chooser);
}

void StepChain::addLink() {
    auto* chooser = new QComboBox;
    chooser->setObjectName(QStringLiteral("then%1").arg(m_links.size() + 1));
    chooser->setAccessibleName(tr("Method that follows"));
    chooser->addItem(tr("Nothing"));
    fillWithMethods(chooser, follows);
    chooser->installEventFilter(this);
    connect(chooser, &QComboBox::currentIndexChanged, this, [this, chooser] { methodChosen(chooser); });

    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Then"));
    label->setBuddy(chooser);
    row->addWidget(label);
    row->addWidget(chooser, 1);
    column->addLayout(row);
    m_column->addWidget(box);
    m_links.push_back({box, chooser, nullptr});
}

void StepChain::removeLinksAfter(std::size_t index) {
    while (m_links.size() > index + 1) {
        m_links.back().box->deleteLater();
        m_links.back().box->hide();
        m_links.pop_back();
    }
}

void StepChain::methodChosen(const QComboBox* chooser) {
    const auto found = std::find_if(m_links.begin(), m_links.end(),
                                    [chooser](const Link& link) { return link.chooser == chooser; });
    delete found->form;
    found->form = nullptr;
    const std::string id = chooser->currentData().toString().toStdString();
    const auto index = static_cast<std::size_t>(found - m_links.begin());
    if (id.empty()) {
        removeLinksAfter(index);
    } else {
        const Method& method = findMethod(id);
        Mnemonics none(QStringLiteral("abcdefghijklmnopqrstuvwxyz")); // those of the first method stay valid
        auto* form = new MethodForm(method, none);
        form->setExemplarSide(m_side);
        connect(form, &MethodForm::edited, this, &StepChain::edited);
        connect(form, &MethodForm::helpWanted, this, &StepChain::helpWanted);
        found->box->layout()->addWidget(form);
        found->form = form;
        if (index + 1 == m_links.size())
            addLink();
        Q_EMIT helpWanted(translated(method.info().summary).toHtmlEscaped());
    }
    Q_EMIT edited();
}

std::vector<RecipeStep> StepChain::steps() const {
    std::vector<RecipeStep> steps;
    for (const Link& link : m_links)
        if (link.form)
            steps.push_back({link.form->method().id(), link.form->values()});
    return steps;
}

std::vector<RecipeStep> StepChain::changedSteps() const {
    std::vector<RecipeStep> steps;
    for (const Link& link : m_links)
        if (link.form)
            steps.push_back({link.form->method().id(), link.form->changedValues()});
    return steps;
}

void StepChain::setSteps(const std::vector<RecipeStep>& steps) {
    m_links.front().chooser->setCurrentIndex(0);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        QComboBox* const chooser = m_links[i].chooser;
        chooser->setCurrentIndex(chooser->findData(QString::fromStdString(steps[i].method)));
        m_links[i].form->setValues(steps[i].parameters);
    }
}

void StepChain::resetAll() {
    for (const Link& link : m_links)
        if (link.form)
            link.form->setValues({});
}

void StepChain::setExemplarSide(int side) {
    m_side = side;
    for (const Link& link : m_links)
        if (link.form)
            link.form->setExemplarSide(side);
}

bool StepChain::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Enter || event->type() == QEvent::FocusIn)
        Q_EMIT helpWanted(
            tr("A method that starts from the image made so far and works on it, in the same run and "
               "with the same seed.")
                .toHtmlEscaped());
    return QWidget::eventFilter(watched, event);
}

} // namespace texloom::ui
