#include "window/Theme.h"
#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>
#include <QStyleFactory>
#include <QToolTip>

namespace stromar {

namespace {
struct Shade {
    QPalette::ColorRole role;
    const char* light;
    const char* dark;
};

constexpr Shade kShades[] = {
    {QPalette::Window, "#efefef", "#2d2f31"},
    {QPalette::WindowText, "#1c1d1e", "#e2e3e4"},
    {QPalette::Base, "#ffffff", "#222426"},
    {QPalette::AlternateBase, "#f5f5f5", "#282a2c"},
    {QPalette::Text, "#1c1d1e", "#e2e3e4"},
    {QPalette::PlaceholderText, "#7d8185", "#8b9095"},
    {QPalette::Button, "#ececec", "#393c3f"},
    {QPalette::ButtonText, "#1c1d1e", "#e2e3e4"},
    {QPalette::BrightText, "#ffffff", "#ffffff"},
    {QPalette::ToolTipBase, "#fdfdf6", "#3a3d40"},
    {QPalette::ToolTipText, "#1c1d1e", "#e8e9ea"},
    {QPalette::Highlight, "#3b7dd8", "#4a8fe7"},
    {QPalette::HighlightedText, "#ffffff", "#ffffff"},
    {QPalette::Link, "#2666b8", "#74aef5"},
    {QPalette::LinkVisited, "#6b4ba1", "#b79bea"},
    {QPalette::Light, "#ffffff", "#55595d"},
    {QPalette::Midlight, "#f4f4f4", "#45494c"},
    {QPalette::Mid, "#b9bbbd", "#25272a"},
    {QPalette::Dark, "#9a9da0", "#1a1c1e"},
    {QPalette::Shadow, "#6a6d70", "#0d0e0f"},
};
constexpr Shade kFaded[] = {
    {QPalette::WindowText, "#9fa2a5", "#777c81"},      {QPalette::Text, "#9fa2a5", "#777c81"},
    {QPalette::ButtonText, "#9fa2a5", "#777c81"},      {QPalette::Highlight, "#c5c8cb", "#4a4e52"},
    {QPalette::HighlightedText, "#f4f4f4", "#9a9fa4"},
};

bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightness() < 128; }

QPalette paletteOf(bool dark) {
    QPalette palette;
    for (const Shade& shade : kShades)
        palette.setColor(shade.role, QColor(QLatin1String(dark ? shade.dark : shade.light)));
    for (const Shade& shade : kFaded)
        palette.setColor(QPalette::Disabled, shade.role, QColor(QLatin1String(dark ? shade.dark : shade.light)));
    return palette;
}

/// Fusion with visible check boxes: it draws their outline darker than the window, which is invisible on a dark one.
class CStyle : public QProxyStyle {
public:
    CStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const bool box = element == PE_IndicatorCheckBox, radio = element == PE_IndicatorRadioButton;
        if ((!box && !radio) || !isDark(option->palette)) return;
        painter->save();
        painter->setPen(option->palette.color(option->state & State_Enabled ? QPalette::PlaceholderText : QPalette::Light));
        painter->setBrush(Qt::NoBrush);
        if (box)
            painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        else {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5));
        }
        painter->restore();
    }
};

/// Qt before 6.5 does not say which theme the system has: the palette it starts with does.
bool systemIsDark() {
    static const bool dark = isDark(QApplication::palette());
    return dark;
}
} // namespace

void applyTheme(const QString& theme) {
    const bool system = systemIsDark(); // asked before the palette is ours
    const bool dark = theme == QLatin1String("dark") || (theme != QLatin1String("light") && system);
    if (!dynamic_cast<CStyle*>(QApplication::style())) QApplication::setStyle(new CStyle);
    const QPalette palette = paletteOf(dark);
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
}

} // namespace stromar
