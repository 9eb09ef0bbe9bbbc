#include "ui/inspector/analogy_view.h"

#include "core/session/run/run.h"
#include "ui/common/elided_label.h"
#include "ui/common/icons.h"
#include "ui/common/text.h"
#include "ui/inspector/picture_tile.h"
#include "ui/inspector/port_row.h"

#include <QGridLayout>
#include <QToolButton>

namespace texloom::ui {

AnalogyView::AnalogyView(PortRow* a, PortRow* b, QWidget* parent)
    : QWidget(parent), m_exemplarName(new ElidedLabel), m_resultName(new ElidedLabel),
      m_exemplar(makeTile(tr("A′"), m_exemplarName, tr("Exemplar"), "analogyExemplar")),
      m_result(makeTile(tr("B′"), m_resultName, tr("Result"), "analogyResult")),
      m_useResult(new QToolButton(this)) {
    setObjectName(QStringLiteral("analogy"));
    m_exemplar->setAcceptDrops(true);
    m_exemplar->picture()->setToolTip(tr("<b>A′</b> The exemplar, which stands to A as the result will "
                                         "stand to B. A click opens another one."));
    m_exemplar->picture()->setAccessibleName(tr("A′: open another exemplar"));
    m_result->picture()->setToolTip(tr("<b>B′</b> The result, made from A, A′ and B. A click shows it."));
    m_result->picture()->setAccessibleName(tr("B′: show the result"));
    m_useResult->setObjectName(QStringLiteral("useResult_exemplar"));
    m_useResult->setFocusPolicy(Qt::StrongFocus);
    setIconButton(m_useResult, QStringLiteral("use-result"),
                  tr("Open the result that is shown as an exemplar"));
    m_exemplar->add(m_useResult);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(a, 0, 0);
    grid->addWidget(m_exemplar, 0, 1);
    grid->addWidget(b, 1, 0);
    grid->addWidget(m_result, 1, 1);
    for (const int column : {0, 1})
        grid->setColumnStretch(column, 1);
    connect(m_exemplar->picture(), &QToolButton::clicked, this, &AnalogyView::exemplarWanted);
    connect(m_exemplar, &DropField::fileDropped, this, &AnalogyView::exemplarOffered);
    connect(m_exemplar, &DropField::resultDropped, this, &AnalogyView::resultOffered);
    connect(m_useResult, &QToolButton::clicked, this, [this] { Q_EMIT resultOffered({}); });
    connect(m_result->picture(), &QToolButton::clicked, this, &AnalogyView::resultWanted);
    m_stops = a->stops() + QList<QWidget*>{m_exemplar->picture(), m_useResult} + b->stops() +
              QList<QWidget*>{m_result->picture()};
    setExemplar({}, nullptr);
    setResult(nullptr);
}

PictureTile* AnalogyView::makeTile(const QString& letter, ElidedLabel* name, const QString& title,
                                   const char* object) {
    auto* tile = new PictureTile(letter, name, title, this);
    tile->picture()->setObjectName(QLatin1String(object));
    return tile;
}

void AnalogyView::setExemplar(const QString& name, const std::shared_ptr<const Image>& image) {
    m_exemplarName->setFullText(image ? name : tr("Nothing"));
    m_exemplar->setImage(image);
}

void AnalogyView::setResult(const std::shared_ptr<const Result>& result) {
    const bool any = result && !result->synthesis.image.empty();
    m_resultName->setFullText(any ? sizeText(result->synthesis.image.size()) : tr("Not made yet"),
                              any ? QString::fromStdString(result->label()) : QString());
    m_result->setImage(any ? std::shared_ptr<const Image>(result, &result->synthesis.image) : nullptr);
    m_result->picture()->setEnabled(any);
    m_useResult->setEnabled(any);
}

} // namespace texloom::ui
