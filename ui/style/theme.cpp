#include "ui/style/theme.h"

#include <QApplication>
#include <QStyleFactory>

namespace vp::style {

QPalette palette(Theme theme) {
  const ChartColors& c = ChartColors::of(theme);
  const bool light = theme == Theme::Light;
  QPalette p;
  p.setColor(QPalette::Window, light ? QColor(0xF1, 0xF2, 0xF5) : QColor(0x17, 0x1A, 0x20));
  p.setColor(QPalette::Base, c.panel);
  p.setColor(QPalette::AlternateBase, light ? QColor(0xF3, 0xF5, 0xF8) : QColor(0x23, 0x27, 0x30));
  p.setColor(QPalette::Button, light ? QColor(0xF7, 0xF8, 0xFA) : QColor(0x26, 0x2B, 0x34));
  p.setColor(QPalette::ToolTipBase, c.panel);
  p.setColor(QPalette::Highlight, c.selection);
  p.setColor(QPalette::HighlightedText, light ? QColor(Qt::white) : QColor(0x0B, 0x0D, 0x12));
  p.setColor(QPalette::Link, c.selection);
  p.setColor(QPalette::PlaceholderText, c.mutedText);
  p.setColor(QPalette::Mid, c.panelBorder);
  p.setColor(QPalette::Light, light ? QColor(Qt::white) : QColor(0x3B, 0x42, 0x4E));
  p.setColor(QPalette::Dark, light ? QColor(0xA5, 0xAB, 0xB5) : QColor(0x0C, 0x0E, 0x12));
  p.setColor(QPalette::Shadow, QColor(0, 0, 0));
  p.setColor(QPalette::BrightText, c.violation);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    p.setColor(role, c.text);
    QColor disabled = c.mutedText;
    disabled.setAlpha(150);
    p.setColor(QPalette::Disabled, role, disabled);
  }
  p.setColor(QPalette::Disabled, QPalette::Highlight, c.panelBorder);
  return p;
}

QString styleSheet(Theme theme) {
  const ChartColors& c = ChartColors::of(theme);
  const QString border = c.panelBorder.name();
  return QStringLiteral(
             "QToolBar { border: none; border-bottom: 1px solid %1; padding: 3px 6px; spacing: 2px; }"
             "QToolBar::separator { background: %1; width: 1px; margin: 5px 6px; }"
             "QToolButton { border: 1px solid transparent; border-radius: 5px; padding: 4px; }"
             "QToolButton:hover { background: %2; }"
             "QToolButton:checked { background: %2; border-color: %3; }"
             "QToolButton:focus { border-color: %3; }"
             "QToolButton[popupMode=\"1\"], QToolButton[popupMode=\"2\"] { padding-right: 15px; }"
             "QDockWidget { titlebar-close-icon: none; font-weight: 600; }"
             "QDockWidget::title { padding: 6px 8px; background: %2; border-bottom: 1px solid %1; text-align: left; }"
             "QStatusBar { border-top: 1px solid %1; }"
             "QStatusBar::item { border: none; }"
             "QMainWindow::separator { background: %1; width: 4px; height: 4px; }"
             "QMainWindow::separator:hover { background: %3; }"
             "QHeaderView::section { background: %2; border: none; border-right: 1px solid %1; border-bottom: 1px solid %1; padding: 4px 6px; }"
             "QTableView { gridline-color: %1; }"
             "QToolTip { border: 1px solid %1; padding: 4px; }"
             // Fusion outlines an empty box darker than the window, which a dark theme swallows
             "QCheckBox::indicator:unchecked:enabled { width: 11px; height: 11px; border: 1px solid %4; border-radius: 2px; background: %5; }"
             "QCheckBox::indicator:unchecked:enabled:hover { border-color: %3; }")
      .arg(border, theme == Theme::Light ? QStringLiteral("#E4E8EE") : QStringLiteral("#2B313B"), c.selection.name(), c.mutedText.name(),
           c.panel.name());
}

void applyTheme(Theme theme) {
  systemTheme();  // afterwards the palette is ours
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(palette(theme));
  if (auto* app = qobject_cast<QApplication*>(QCoreApplication::instance())) {
    app->setStyleSheet(styleSheet(theme));
  }
}

Theme systemTheme() {
  static const Theme atStart = [] {
    const QPalette desktop = QGuiApplication::palette();
    return desktop.color(QPalette::Window).lightness() < desktop.color(QPalette::WindowText).lightness() ? Theme::Dark : Theme::Light;
  }();
  return atStart;
}

}  // namespace vp::style
