#include "ui/paint/extend_dialog.h"

#include "ui/common/screen_size.h"
#include "ui/common/text.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace texloom::ui {

namespace {

constexpr int kPlaceWidth = 46, kPlaceLines = 14; ///< of the sketch, in widths and lines of text
constexpr int kDialogWidth = 60;
constexpr int kHatchAlpha = 110;

} // namespace

ExtendDialog::ExtendDialog(std::shared_ptr<const DisplayPicture> picture, int most, QWidget* parent)
    : QDialog(parent), m_picture(std::move(picture)), m_most(most), m_place(new QWidget(this)),
      m_size(new QLabel(this)) {
    setObjectName(QStringLiteral("extendDialog"));
    setWindowTitle(tr("Extend the picture"));
    m_size->setObjectName(QStringLiteral("extendSize"));
    m_size->setAlignment(Qt::AlignCenter);
    m_size->setWordWrap(true);
    m_place->setMinimumSize(fontMetrics().averageCharWidth() * kPlaceWidth,
                            fontMetrics().lineSpacing() * kPlaceLines);
    m_place->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->setObjectName(QStringLiteral("extendButtons"));
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    const Size size = m_picture->size();
    const int across = std::max(0, most - size.width), down = std::max(0, most - size.height);
    const struct {
        const char* name;
        QString title;
        int most;
    } sides[] = {{"extendLeft", tr("&Left"), across},
                 {"extendTop", tr("&Top"), down},
                 {"extendRight", tr("&Right"), across},
                 {"extendBottom", tr("&Bottom"), down}};
    auto* form = new QGridLayout;
    for (std::size_t i = 0; i < m_sides.size(); ++i) {
        m_sides[i] = addSide(sides[i].name, sides[i].title, sides[i].most);
        auto* title = new QLabel(sides[i].title, this);
        title->setBuddy(m_sides[i]);
        // Left and right stand in one column, top and bottom in the other.
        const int row = static_cast<int>(i / 2), column = static_cast<int>(i % 2) * 2;
        form->addWidget(title, row, column);
        form->addWidget(m_sides[i], row, column + 1);
    }
    form->setColumnStretch(1, 1);
    form->setColumnStretch(3, 1);
    auto* intro = new QLabel(tr("How far the picture is to reach beyond each of its edges. What lies there "
                                "is made by the next run."),
                             this);
    intro->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->addWidget(intro);
    column->addLayout(form);
    column->addWidget(m_place, 1);
    column->addWidget(m_size);
    column->addWidget(buttons);
    show(size);
    const int width = fontMetrics().averageCharWidth() * kDialogWidth;
    resizeWithinScreen(this, {width, column->totalHeightForWidth(width)});
}

QSpinBox* ExtendDialog::addSide(const char* name, const QString& title, int most) {
    auto* side = new QSpinBox(this);
    side->setObjectName(QLatin1String(name));
    side->setRange(0, most);
    side->setSuffix(QLatin1Char(' ') + tr("px"));
    side->setAccessibleName(QString(title).remove(QLatin1Char('&')));
    connect(side, &QSpinBox::valueChanged, this,
            [this] { show(extendedSize(m_picture->size(), margins())); });
    return side;
}

Margins ExtendDialog::margins() const {
    return {m_sides[0]->value(), m_sides[1]->value(), m_sides[2]->value(), m_sides[3]->value()};
}

void ExtendDialog::show(Size size) {
    const bool fits = size.longerSide() <= m_most;
    m_size->setText(fits ? tr("%1 → %2 px").arg(sizeText(m_picture->size()), sizeText(size))
                         : tr("%1 px is too large; its sides go up to %2.").arg(sizeText(size)).arg(m_most));
    m_ok->setEnabled(fits && !margins().empty());
    update();
}

/// The picture where it will lie, within the frame of the larger one.
void ExtendDialog::paintEvent(QPaintEvent* event) {
    QDialog::paintEvent(event);
    const Margins around = margins();
    const Size whole = extendedSize(m_picture->size(), around);
    QPainter painter(this);
    const QRectF room = QRectF(m_place->geometry()).adjusted(1, 1, -1, -1);
    const double scale = std::min(room.width() / whole.width, room.height() / whole.height);
    QRectF frame(0, 0, whole.width * scale, whole.height * scale);
    frame.moveCenter(room.center());
    const Size size = m_picture->size();
    const QRectF picture(frame.left() + around.left * scale, frame.top() + around.top * scale,
                         size.width * scale, size.height * scale);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QColor hatch = palette().color(QPalette::WindowText);
    hatch.setAlpha(kHatchAlpha);
    painter.fillRect(frame, QBrush(hatch, Qt::BDiagPattern));
    painter.drawImage(picture, m_picture->levelFor(scale * devicePixelRatioF()));
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DashLine));
    painter.drawRect(frame);
}

} // namespace texloom::ui
