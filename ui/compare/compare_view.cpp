#include "ui/compare/compare_view.h"

#include "ui/common/background.h"
#include "ui/common/text.h"
#include "ui/compare/compare_cell.h"
#include "ui/compare/view_link.h"
#include "ui/compare/wipe_viewer.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace texloom::ui {

namespace {

/// A difference ready to be shown.
struct ShownDifference {
    std::shared_ptr<const DisplayPicture> picture;
    double number = 0;
    bool partial = false; ///< the pictures are not of one size
};

ShownDifference makeDifference(const DisplayPicture& first, const DisplayPicture& second, DifferenceKind kind,
                               const DisplayLook& look) {
    Difference found = difference(first.values(), second.values(), kind);
    ShownDifference shown;
    shown.number = found.number;
    shown.partial = first.values().size() != second.values().size();
    shown.picture =
        std::make_shared<const DisplayPicture>(std::make_shared<const Image>(std::move(found.image)), look);
    return shown;
}

QString differenceText(DifferenceKind kind, const ShownDifference& shown, Size part) {
    const QString number = QString::number(shown.number, 'g', 4);
    const QString text = kind == DifferenceKind::Squared ? CompareView::tr("RMSE %1").arg(number)
                         : kind == DifferenceKind::Relative
                             ? CompareView::tr("mean relative difference %1").arg(number)
                             : CompareView::tr("mean absolute difference %1").arg(number);
    return shown.partial ? CompareView::tr("%1 over the %2 px that both have").arg(text, sizeText(part))
                         : text;
}

} // namespace

CompareView::CompareView(const CompareActions& actions, QWidget* parent)
    : QWidget(parent), m_actions(actions), m_bar(new CompareBar(actions, this)),
      m_stack(new QStackedWidget(this)), m_scroll(new QScrollArea), m_empty(new QLabel),
      m_single(new WipeViewer), m_link(new ViewLink(this)) {
    setObjectName(QStringLiteral("compareView"));
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_single->setObjectName(QStringLiteral("compareViewer"));
    m_single->setAccessibleName(tr("Comparison"));
    m_single->setPlaceholder(tr("Two pictures are needed; choose them above."));
    m_empty->setObjectName(QStringLiteral("compareEmpty"));
    m_empty->setText(tr("Choose results in the Results dock and press Compare, or Try all methods in the "
                        "Synthesis menu."));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_stack->addWidget(m_empty);
    m_stack->addWidget(m_scroll);
    m_stack->addWidget(m_single);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_bar);
    column->addWidget(m_stack, 1);
    connect(m_bar, &CompareBar::pairChanged, this, &CompareView::showPair);
    connect(m_bar, &CompareBar::kindChanged, this, &CompareView::showPair);
    connect(m_bar, &CompareBar::lookChanged, this, &CompareView::look);
    connect(actions.link, &QAction::toggled, m_link, &ViewLink::setLinked);
    makeChannelKeys();
    setItems({});
}

void CompareView::makeChannelKeys() {
    const std::pair<Qt::Key, int> keys[] = {
        {Qt::Key_C, -1}, {Qt::Key_R, 0}, {Qt::Key_G, 1}, {Qt::Key_B, 2}, {Qt::Key_A, 3}};
    for (const auto& [key, channel] : keys)
        new QShortcut(
            QKeySequence(Qt::SHIFT | key), this,
            [this, channel = channel] {
                DisplayLook look = m_bar->look();
                look.channel = channel;
                m_bar->setLook(look);
            },
            Qt::WidgetWithChildrenShortcut);
}

void CompareView::setItems(std::vector<CompareItem> items, int columns, const QString& heading) {
    m_items = std::move(items);
    m_heading = heading;
    m_looked.assign(m_items.size(), nullptr);
    const int count = static_cast<int>(m_items.size());
    m_columns = columns > 0 ? columns : std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
    m_last = std::max(0, count - 1);
    QStringList labels;
    for (const CompareItem& item : m_items)
        labels += item.label;
    fillGrid();
    m_bar->setLabels(labels);
    m_bar->setPair(std::max(count - 2, std::min(0, count - 1)), count - 1);
    m_actions.sheet->setEnabled(count > 0);
    setMode(CompareMode::Grid);
    if (m_bar->look() != DisplayLook{})
        look();
    Q_EMIT replaced();
}

void CompareView::fillGrid() {
    m_link->clear();
    m_cells.clear();
    auto* content = new QWidget;
    auto* grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    for (int i = 0; i < static_cast<int>(m_items.size()); ++i) {
        auto* cell = new CompareCell(content);
        cell->setItem(m_items[static_cast<std::size_t>(i)]);
        m_cells.push_back(cell);
        m_link->add(cell->viewer());
        grid->addWidget(cell, i / m_columns, i % m_columns);
        connect(cell, &CompareCell::entered, this, [this, i] { entered(i); });
        connect(cell->viewer(), &ImageViewer::hovered, this, [this, i](QPoint pixel) { hover(i, pixel); });
        connect(cell->viewer(), &ImageViewer::unhovered, this, &CompareView::endHover);
        connect(cell, &CompareCell::useWanted, this,
                [this, i] { Q_EMIT useWanted(m_items[static_cast<std::size_t>(i)].key); });
    }
    for (int row = 0; row < grid->rowCount(); ++row)
        grid->setRowStretch(row, 1);
    for (int column = 0; column < m_columns; ++column)
        grid->setColumnStretch(column, 1);
    m_link->add(m_single);
    m_scroll->setWidget(content);
}

void CompareView::setItem(int index, const CompareItem& item) {
    const auto at = static_cast<std::size_t>(index);
    m_items[at] = item;
    m_looked[at] = nullptr;
    m_cells[at]->setItem(item);
    if (m_bar->look() != DisplayLook{})
        lookAt(index);
    if (m_mode != CompareMode::Grid && (index == m_bar->first() || index == m_bar->second()))
        showPair();
}

int CompareView::pictures() const {
    return static_cast<int>(
        std::count_if(m_items.begin(), m_items.end(), [](const CompareItem& item) { return item.picture; }));
}

ImageViewer* CompareView::viewer(int index) const {
    return m_cells[static_cast<std::size_t>(index)]->viewer();
}

ImageViewer* CompareView::front() const {
    if (m_mode != CompareMode::Grid)
        return m_single;
    return m_cells.empty() ? m_single : viewer(m_last);
}

void CompareView::entered(int index) {
    if (index == m_last)
        return;
    // The last two that were looked at are the pair of the other modes.
    m_bar->setPair(std::min(m_last, index), std::max(m_last, index));
    m_last = index;
}

void CompareView::hover(int index, QPoint pixel) {
    const CompareItem& item = m_items[static_cast<std::size_t>(index)];
    // The same place is marked in all pictures of the same size.
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const bool alike = item.picture && m_items[i].picture &&
                           item.picture->size() == m_items[i].picture->size() &&
                           static_cast<int>(i) != index && m_link->linked();
        m_cells[i]->viewer()->setMarker(alike ? std::optional(pixel) : std::nullopt);
    }
    if (item.picture)
        Q_EMIT hovered(item.label, pixel, item.picture->valueText(pixel.x(), pixel.y()));
}

void CompareView::endHover() {
    for (const CompareCell* cell : m_cells)
        cell->viewer()->setMarker({});
    Q_EMIT unhovered();
}

void CompareView::setMode(CompareMode mode) {
    m_other = mode == CompareMode::Toggle && m_mode == CompareMode::Toggle && !m_other;
    const bool hadFocus =
        isAncestorOf(focusWidget()) && focusWidget() != nullptr && focusWidget()->hasFocus();
    m_mode = mode;
    m_actions.mode(mode)->setChecked(true);
    m_bar->setMode(mode);
    QWidget* const page = m_items.empty()             ? static_cast<QWidget*>(m_empty)
                          : mode == CompareMode::Grid ? static_cast<QWidget*>(m_scroll)
                                                      : m_single;
    m_stack->setCurrentWidget(page);
    if (hadFocus && !m_items.empty())
        front()->setFocus();
    showPair();
}

void CompareView::look() {
    ++m_lookRequest;
    std::fill(m_looked.begin(), m_looked.end(), nullptr);
    for (int i = 0; i < static_cast<int>(m_items.size()); ++i)
        if (m_bar->look() == DisplayLook{})
            m_cells[static_cast<std::size_t>(i)]->setPicture(m_items[static_cast<std::size_t>(i)].picture);
        else
            lookAt(i);
    showPair();
}

void CompareView::lookAt(int index) {
    const auto at = static_cast<std::size_t>(index);
    const auto picture = m_items[at].picture;
    if (!picture || picture->step() > 1)
        return;
    const std::shared_ptr<const Image> values(picture, &picture->values());
    inBackground(
        this, [values, look = m_bar->look()] { return std::make_shared<const DisplayPicture>(values, look); },
        [this, at, picture, request = m_lookRequest](std::shared_ptr<const DisplayPicture> looked) {
            if (request != m_lookRequest || at >= m_items.size() || m_items[at].picture != picture)
                return;
            m_looked[at] = std::move(looked);
            m_cells[at]->setPicture(m_looked[at]);
            if (m_mode == CompareMode::Wipe || m_mode == CompareMode::Toggle)
                showPair();
        },
        [](const QString&) {});
}

std::shared_ptr<const DisplayPicture> CompareView::shownPicture(int index) const {
    if (index < 0 || index >= static_cast<int>(m_items.size()))
        return nullptr;
    const auto at = static_cast<std::size_t>(index);
    return m_looked[at] ? m_looked[at] : m_items[at].picture;
}

void CompareView::showPair() {
    ++m_request;
    m_bar->say({});
    m_single->setFarPicture(nullptr);
    m_single->setBadge({});
    const int shown = m_other ? m_bar->second() : m_bar->first();
    switch (m_mode) {
    case CompareMode::Grid:
        return;
    case CompareMode::Wipe:
        m_single->setPicture(shownPicture(m_bar->first()));
        m_single->setFarPicture(shownPicture(m_bar->second()));
        return;
    case CompareMode::Toggle:
        m_single->setPicture(shownPicture(shown));
        if (shown >= 0)
            m_single->setBadge(m_items[static_cast<std::size_t>(shown)].label);
        return;
    case CompareMode::Difference:
        return showDifference();
    }
}

void CompareView::showDifference() {
    const auto pictureAt = [this](int index) {
        return index >= 0 ? m_items[static_cast<std::size_t>(index)].picture : nullptr;
    };
    const auto first = pictureAt(m_bar->first());
    const auto second = pictureAt(m_bar->second());
    if (!first || !second) {
        m_single->setPicture(nullptr);
        return;
    }
    const DifferenceKind kind = m_bar->kind();
    inBackground(
        this,
        [first, second, kind, look = m_bar->look()] { return makeDifference(*first, *second, kind, look); },
        [this, kind, request = m_request](const ShownDifference& shown) {
            if (request != m_request)
                return;
            m_single->setPicture(shown.picture);
            m_bar->say(differenceText(kind, shown, shown.picture->size()));
        },
        [this](const QString& why) { m_bar->say(why); });
}

} // namespace texloom::ui
