#include "ui/maps/map_page.h"

#include "ui/jobs/task_bar.h"
#include "ui/viewers/image_viewer.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace texloom::ui {

MapPage::MapPage(const QString& name, QWidget* parent)
    : QWidget(parent), m_viewer(new ImageViewer(this)), m_line(new QLabel(this)),
      m_estimate(new QPushButton(tr("Estimate the map"), this)), m_bar(new TaskBar(this)) {
    m_viewer->setObjectName(name);
    m_line->setWordWrap(true);
    m_line->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_estimate->setObjectName(name + QStringLiteral("Estimate"));
    m_estimate->setToolTip(
        tr("Look for the place in the exemplar that each pixel of the result is most like"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_line, 1);
    row->addWidget(m_estimate);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_viewer, 1);
    column->addLayout(row);
    column->addWidget(m_bar);
    setFocusProxy(m_viewer);
    setLine({});
    setOffer(false);
    connect(m_estimate, &QPushButton::clicked, this, &MapPage::estimateWanted);
    connect(m_bar, &TaskBar::cancelled, this, &MapPage::cancelled);
}

void MapPage::setLine(const QString& text) {
    m_line->setText(text);
    m_line->setVisible(!text.isEmpty());
}

QString MapPage::line() const {
    return m_line->text();
}

void MapPage::setOffer(bool offered) {
    m_estimate->setVisible(offered);
}

void MapPage::setProgress(const std::function<double()>& progress) {
    if (progress)
        m_bar->begin(tr("Estimating the map…"), progress);
    else
        m_bar->end();
}

} // namespace texloom::ui
