#include "ui/window/start_page.h"

#include "ui/exemplar/files.h"
#include "ui/exemplar/thumbnails.h"

#include <QAction>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

/// A place to drop things, with a dashed outline that grows stronger while something is dragged over the
/// window.
class DropZone : public QWidget {
public:
    using QWidget::QWidget;

    void setDropping(bool dropping) {
        m_dropping = dropping;
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const double width = std::max(1, fontMetrics().lineWidth()) * (m_dropping ? 3.0 : 1.5);
        const double radius = fontMetrics().height() / 2.0;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(palette().color(m_dropping ? QPalette::Highlight : QPalette::PlaceholderText),
                            width, m_dropping ? Qt::SolidLine : Qt::DashLine));
        painter.drawRoundedRect(QRectF(rect()).adjusted(width, width, -width, -width), radius, radius);
    }

private:
    bool m_dropping = false;
};

QFont larger(QFont font, double factor) {
    font.setPointSizeF(font.pointSizeF() * factor);
    return font;
}

} // namespace

StartPage::StartPage(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("startPage"));
    auto* column = new QVBoxLayout(this);
    const int margin = fontMetrics().height();
    column->setContentsMargins(margin, margin, margin, margin);
    column->addWidget(makeDropZone(actions));
    m_recent = addSection(tr("Opened last"), QStringLiteral("recentThumbnails"));
    m_bundled = addSection(tr("Exemplars to try"), QStringLiteral("bundledThumbnails"));
    m_recentList->setWrapping(false);
    m_recentList->setFixedHeight(m_recentList->gridSize().height() +
                                 style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, m_recentList));
    column->setStretchFactor(m_bundledList, 1);
    column->addStretch();
    setTabOrder(m_recentList, m_bundledList);
}

QWidget* StartPage::makeDropZone(const QList<QAction*>& actions) {
    auto* zone = new DropZone(this);
    m_zone = zone;
    auto* title = new QLabel(tr("Drop a picture of a material here"), zone);
    title->setFont(larger(font(), 1.6));
    title->setAlignment(Qt::AlignCenter);
    auto* text = new QLabel(
        tr("Texloom makes more of it: any size, no visible repeats. A first preview starts by itself."),
        zone);
    text->setWordWrap(true);
    text->setAlignment(Qt::AlignCenter);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    for (QAction* action : actions) {
        auto* button = new QToolButton(zone);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        buttons->addWidget(button);
    }
    buttons->addStretch();
    auto* column = new QVBoxLayout(zone);
    const int margin = fontMetrics().height() * 2;
    column->setContentsMargins(margin, margin, margin, margin);
    column->addWidget(title);
    column->addWidget(text);
    column->addSpacing(fontMetrics().height() / 2);
    column->addLayout(buttons);
    return zone;
}

ThumbnailList* StartPage::addSection(const QString& title, const QString& name) {
    auto* label = new QLabel(title, this);
    label->setFont(larger(font(), 1.15));
    label->setContentsMargins(0, fontMetrics().height() / 2, 0, 0);
    auto* list = new QListWidget(this);
    list->setObjectName(name);
    list->setAccessibleName(title);
    label->setBuddy(list);
    layout()->addWidget(label);
    layout()->addWidget(list);
    auto* thumbnails = new ThumbnailList(list);
    connect(thumbnails, &ThumbnailList::chosen, this, &StartPage::chosen);
    (m_recentList == nullptr ? m_recentTitle : m_bundledTitle) = label;
    (m_recentList == nullptr ? m_recentList : m_bundledList) = list;
    return thumbnails;
}

void StartPage::refresh() {
    m_recent->setFiles(recentFiles());
    m_bundled->setFiles(bundledExemplars());
    m_recentTitle->setVisible(!m_recent->isEmpty());
    m_recentList->setVisible(!m_recent->isEmpty());
    m_bundledTitle->setVisible(!m_bundled->isEmpty());
    m_bundledList->setVisible(!m_bundled->isEmpty());
}

void StartPage::setDropping(bool dropping) {
    static_cast<DropZone*>(m_zone)->setDropping(dropping);
}

} // namespace texloom::ui
