#include "ui/inspector/picture_tile.h"

#include "ui/common/elided_label.h"
#include "ui/inspector/thumbnail.h"

#include <QLabel>
#include <QVBoxLayout>

namespace texloom::ui {

namespace {

constexpr int kPictureLines = 5; ///< lines of text that a picture is high

} // namespace

PictureTile::PictureTile(const QString& letter, ElidedLabel* name, const QString& title, QWidget* parent)
    : DropField(parent), m_picture(new QToolButton(this)), m_buttons(new QHBoxLayout) {
    auto* heading = new QLabel(letter, this);
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    const int side = fontMetrics().lineSpacing() * kPictureLines;
    m_picture->setText(title);
    m_picture->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_picture->setIconSize({side, side});
    m_picture->setFixedHeight(side + fontMetrics().lineSpacing() / 2);
    m_picture->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_picture->setFocusPolicy(Qt::StrongFocus);
    auto* first = new QHBoxLayout;
    first->addWidget(heading);
    first->addWidget(name, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(fontMetrics().lineSpacing() / 6);
    column->addLayout(first);
    column->addWidget(m_picture);
    m_buttons->addStretch();
    column->addLayout(m_buttons);
    column->addStretch();
}

void PictureTile::add(QToolButton* button) {
    m_buttons->insertWidget(m_buttons->count() - 1, button);
}

void PictureTile::setImage(const std::shared_ptr<const Image>& image) {
    if (m_image == image)
        return;
    m_image = image;
    m_picture->setToolButtonStyle(image ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextOnly);
    if (!image)
        return m_picture->setIcon({});
    makeThumbnail(m_picture, image, m_picture->iconSize().width(), [this, image](const QPixmap& made) {
        if (m_image != image)
            return;
        QIcon icon(made);
        icon.addPixmap(made, QIcon::Disabled);
        m_picture->setIcon(icon);
    });
}

} // namespace texloom::ui
