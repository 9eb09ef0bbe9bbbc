#include "ui/common/icons.h"

#include <QAbstractButton>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

#include <memory>

namespace texloom::ui {

namespace {

class TintedSvgEngine : public QIconEngine {
public:
    TintedSvgEngine(const QString& file, bool struck)
        : m_renderer(std::make_shared<QSvgRenderer>(file)), m_struckWhenOff(struck) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal ratio = painter->device()->devicePixelRatio();
        QPixmap drawn = pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state);
        drawn.setDevicePixelRatio(ratio);
        painter->drawPixmap(rect.topLeft(), drawn);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap drawn(size);
        drawn.fill(Qt::transparent);
        QPainter painter(&drawn);
        m_renderer->render(&painter, QRectF(QPointF(), size));
        if (m_struckWhenOff && state == QIcon::Off)
            strike(painter, size);
        painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
        painter.fillRect(drawn.rect(), color(mode));
        return drawn;
    }

    QIconEngine* clone() const override { return new TintedSvgEngine(*this); }

private:
    static QColor color(QIcon::Mode mode) {
        const QPalette palette = QGuiApplication::palette();
        if (mode == QIcon::Disabled)
            return palette.color(QPalette::Disabled, QPalette::ButtonText);
        return palette.color(mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText);
    }

    /// A line across with a gap on both sides, so that it shows over any drawing.
    static void strike(QPainter& painter, QSizeF size) {
        const QLineF line(size.width() * 0.1, size.height() * 0.1, size.width() * 0.9, size.height() * 0.9);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setCompositionMode(QPainter::CompositionMode_Clear);
        painter.setPen(QPen(Qt::black, size.width() / 4));
        painter.drawLine(line);
        painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
        painter.setPen(QPen(Qt::black, size.width() / 12, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(line);
    }

    std::shared_ptr<QSvgRenderer> m_renderer;
    bool m_struckWhenOff;
};

QIcon load(const QString& name, bool struckWhenOff) {
    const QString file = QStringLiteral(":/icons/%1.svg").arg(name);
    return QFile::exists(file) ? QIcon(new TintedSvgEngine(file, struckWhenOff)) : QIcon();
}

} // namespace

QIcon icon(const QString& name) {
    return load(name, false);
}

QIcon toggleIcon(const QString& name) {
    return load(name, true);
}

void setIconButton(QAbstractButton* button, const QString& name, const QString& text) {
    button->setIcon(icon(name));
    if (button->icon().isNull())
        button->setText(text);
    button->setToolTip(text);
    button->setAccessibleName(text);
}

} // namespace texloom::ui
