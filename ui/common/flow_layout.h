#pragma once

#include <QLayout>
#include <QList>

namespace texloom::ui {

/// Lays widgets side by side, and goes on in a new row where there is no room for the next one: a bar of
/// buttons that fits in narrow panels. It is as wide as its widest widget at least.
class FlowLayout : public QLayout {
public:
    /// @param parent owns it, if given; its layout becomes this one.
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override;
    int count() const override { return static_cast<int>(m_items.size()); }
    QLayoutItem* itemAt(int index) const override { return m_items.value(index); }
    QLayoutItem* takeAt(int index) override;

    Qt::Orientations expandingDirections() const override { return {}; }
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;
    void setGeometry(const QRect& place) override;

private:
    /// Puts the items into rows of this width, if `move`. @return the height of all rows.
    int rows(const QRect& place, bool move) const;

    QList<QLayoutItem*> m_items;
};

} // namespace texloom::ui
