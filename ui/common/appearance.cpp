#include "ui/common/appearance.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>

namespace texloom::ui {

namespace {

const QString kSetting = QStringLiteral("appearance");

/// Fusion, with an outline around check boxes that can be seen on a dark window as well.
class OutlinedFusion : public QProxyStyle {
public:
    OutlinedFusion() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck)
            return;
        const bool enabled = option->state.testFlag(State_Enabled);
        const QPalette& palette = option->palette;
        painter->save();
        painter->setPen(enabled ? palette.color(QPalette::PlaceholderText)
                                : palette.color(isDark(palette) ? QPalette::Light : QPalette::Mid));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
    }
};

/// The colours in which the two palettes differ.
struct Tones {
    QColor window, base, button, text, faint, light, mid, dark, shadow, highlight, link;
};

QPalette paletteFrom(const Tones& tones) {
    QPalette palette(tones.text, tones.button, tones.light, tones.dark, tones.mid, tones.text, tones.text,
                     tones.base, tones.window);
    palette.setColor(QPalette::Midlight, tones.button.lighter(110));
    palette.setColor(QPalette::AlternateBase, tones.window);
    palette.setColor(QPalette::Shadow, tones.shadow);
    palette.setColor(QPalette::Highlight, tones.highlight);
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::Link, tones.link);
    palette.setColor(QPalette::LinkVisited, tones.link);
    palette.setColor(QPalette::ToolTipBase, tones.base);
    palette.setColor(QPalette::ToolTipText, tones.text);
    palette.setColor(QPalette::PlaceholderText, tones.faint);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, tones.faint);
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, tones.text);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, tones.mid);
    return palette;
}

QPalette lightPalette() {
    return paletteFrom({.window = 0xf0f0f0,
                        .base = 0xffffff,
                        .button = 0xf0f0f0,
                        .text = 0x1c1c1c,
                        .faint = 0x686868,
                        .light = 0xffffff,
                        .mid = 0xb8b8b8,
                        .dark = 0x9c9c9c,
                        .shadow = 0x6e6e6e,
                        .highlight = 0x1f66b0,
                        .link = 0x0b57a4});
}

QPalette darkPalette() {
    return paletteFrom({.window = 0x303030,
                        .base = 0x1f1f1f,
                        .button = 0x3d3d3d,
                        .text = 0xe8e8e8,
                        .faint = 0xa8a8a8,
                        .light = 0x565656,
                        .mid = 0x262626,
                        .dark = 0x1b1b1b,
                        .shadow = 0x101010,
                        .highlight = 0x2f74bd,
                        .link = 0x7db8f2});
}

} // namespace

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

void applyAppearance(Appearance appearance) {
    static const bool systemIsDark = isDark(QApplication::palette());
    const bool dark = appearance == Appearance::Dark || (appearance == Appearance::System && systemIsDark);
    QApplication::setStyle(new OutlinedFusion);
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
}

Appearance savedAppearance() {
    const int saved = QSettings().value(kSetting, static_cast<int>(Appearance::Dark)).toInt();
    return saved == 1 ? Appearance::Light : saved == 2 ? Appearance::Dark : Appearance::System;
}

void saveAppearance(Appearance appearance) {
    QSettings().setValue(kSetting, static_cast<int>(appearance));
}

QColor canvasColor() {
    return 0x747474;
}

QColor errorColor(const QPalette& palette) {
    return isDark(palette) ? QColor(0xff9a8f) : QColor(0xa31515);
}

} // namespace texloom::ui
