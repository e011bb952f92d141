#include "gui/app/theme.h"

#include <QApplication>
#include <QPalette>
#include <QPixmapCache>
#include <QStyleFactory>

namespace glint {

namespace {

struct Greys {
    QColor window, base, raised, line, edge, text, dimmed, accent, accentText;
};

Greys greysOf(Theme theme) {
    if (theme == Theme::Dark)
        return {QColor(48, 48, 48),    QColor(36, 36, 36),    QColor(64, 64, 64),
                QColor(28, 28, 28),    QColor(112, 112, 112), QColor(222, 222, 222),
                QColor(128, 128, 128), QColor(70, 122, 188),  QColor(255, 255, 255)};
    return {QColor(226, 226, 226), QColor(246, 246, 246), QColor(238, 238, 238),
            QColor(178, 178, 178), QColor(140, 140, 140), QColor(24, 24, 24),
            QColor(130, 130, 130), QColor(48, 108, 184),  QColor(255, 255, 255)};
}

QPalette paletteOf(const Greys& g) {
    QPalette p;
    const auto set = [&](QPalette::ColorRole role, const QColor& color) {
        p.setColor(role, color);
    };
    set(QPalette::Window, g.window);
    set(QPalette::WindowText, g.text);
    set(QPalette::Base, g.base);
    set(QPalette::AlternateBase, g.window);
    set(QPalette::Text, g.text);
    set(QPalette::PlaceholderText, g.dimmed);
    set(QPalette::Button, g.raised);
    set(QPalette::ButtonText, g.text);
    set(QPalette::BrightText, g.text);
    set(QPalette::ToolTipBase, g.raised);
    set(QPalette::ToolTipText, g.text);
    set(QPalette::Highlight, g.accent);
    set(QPalette::HighlightedText, g.accentText);
    set(QPalette::Link, g.accent);
    set(QPalette::Light, g.raised.lighter(115));
    set(QPalette::Midlight, g.raised);
    set(QPalette::Mid, g.line);
    set(QPalette::Dark, g.line);
    set(QPalette::Shadow, QColor(0, 0, 0));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, g.dimmed);
    p.setColor(QPalette::Disabled, QPalette::Highlight, g.dimmed);
    return p;
}

constexpr const char* kSheet = R"(
QToolTip { color: @text; background: @raised; border: 1px solid @line; padding: 3px; }
QMainWindow::separator { background: @line; width: 3px; height: 3px; }
QMainWindow::separator:hover { background: @accent; }
QDockWidget::title { background: @window; padding: 4px 8px; }
QToolBar { border: none; border-bottom: 1px solid @line; padding: 3px; spacing: 3px; }
QToolBar::separator { background: @line; width: 1px; margin: 3px 4px; }
QToolBar QToolButton { padding: 4px; border: 1px solid transparent; border-radius: 3px; }
QToolBar QToolButton:hover { background: @raised; }
QToolBar QToolButton:checked { background: @accent; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QStatusBar { border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QMenuBar { border-bottom: 1px solid @line; }
QTreeView, QListView, QListWidget { border: 1px solid @line; border-radius: 3px; }
QTreeView::item { padding: 2px 0; }
QLineEdit { background: @base; border: 1px solid @line; border-radius: 3px; padding: 1px 4px; selection-background-color: @accent; }
QLineEdit:focus { border: 1px solid @accent; }
glint--DragNumber { background: @base; padding: 1px 3px; }
glint--DragNumber:hover { background: @raised; }
glint--DragNumber[refused="true"] { border: 1px solid #d24a43; background: #5a2a2a; color: #ffffff; }
QToolButton#sectionHeader { border: none; border-radius: 0; background: @raised; padding: 3px 4px; font-weight: 600; }
QToolButton#reset { border: none; padding: 0; }
QFrame#messageBar { border: none; border-bottom: 1px solid @line; background: @raised; }
QFrame#messageBar[level="warning"] { background: #6b5320; }
QFrame#messageBar[level="error"] { background: #6e2f2b; }
QFrame#messageBar[level="warning"] QLabel, QFrame#messageBar[level="error"] QLabel { color: #ffffff; }
QTabBar::tab { padding: 4px 10px; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @edge; border-radius: 3px; background: @base; }
QCheckBox::indicator:hover { border-color: @accent; }
QCheckBox::indicator:focus { border-color: @accent; }
QCheckBox::indicator:checked { background: @accent; border-color: @accent; image: url(:/icons/check.svg); }
QCheckBox::indicator:indeterminate { background: @edge; image: url(:/icons/dash.svg); }
QFrame#startPage { background: @window; }
QFrame#startPage QListWidget { background: transparent; border: none; }
)";

}  // namespace

void applyTheme(Theme theme) {
    const Greys greys = greysOf(theme);
    QPixmapCache::clear();
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(paletteOf(greys));
    QString sheet = QString::fromLatin1(kSheet);
    const std::pair<const char*, QColor> names[] = {
        {"@window", greys.window}, {"@base", greys.base}, {"@raised", greys.raised},
        {"@line", greys.line},     {"@edge", greys.edge}, {"@text", greys.text},
        {"@accent", greys.accent}};
    for (const auto& [name, color] : names) sheet.replace(QLatin1String(name), color.name());
    qApp->setStyleSheet(sheet);
}

}  // namespace glint
