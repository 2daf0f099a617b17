#pragma once
// Whether the texts of widgets have the room that they need, and whether a letter after Alt means one thing only.

#include <QAbstractButton>
#include <QComboBox>
#include <QHash>
#include <QHeaderView>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QStringList>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTextDocument>

namespace vp::test {

inline QString described(const QWidget& widget, const QString& text) {
  return QStringLiteral("%1 %2 “%3”").arg(QLatin1String(widget.metaObject()->className()), widget.objectName(), text.left(60));
}

/// A label whose text is wider than it, or higher where it is broken into lines.
inline bool isCut(const QLabel& label) {
  if (label.text().isEmpty() || !label.pixmap(Qt::ReturnByValue).isNull()) {
    return false;
  }
  return label.wordWrap() ? label.height() < label.heightForWidth(label.width()) : label.width() < label.sizeHint().width();
}

inline bool isCut(const QComboBox& box) {
  QStyleOptionComboBox option;
  option.initFrom(&box);
  const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
  return field.width() < box.fontMetrics().horizontalAdvance(box.currentText());
}

inline bool isCut(const QTabBar& bar) {
  int width = 0;
  for (int i = 0; i < bar.count(); ++i) {
    width += bar.tabRect(i).width();
    if (bar.tabText(i).contains(QChar(0x2026)) || bar.tabRect(i).width() < bar.fontMetrics().size(Qt::TextShowMnemonic, bar.tabText(i)).width()) {
      return true;
    }
  }
  return width > bar.width();
}

/** Every visible label, button, choice, tab and column title below a widget that has less room than its text. */
inline QStringList cutTexts(const QWidget& root) {
  QStringList cut;
  for (const auto* label : root.findChildren<QLabel*>()) {
    if (label->isVisible() && isCut(*label)) {
      cut << described(*label, label->text());
    }
  }
  for (const auto* button : root.findChildren<QAbstractButton*>()) {
    if (button->isVisible() && !button->text().isEmpty() && button->width() < button->sizeHint().width()) {
      cut << described(*button, button->text());
    }
  }
  for (const auto* box : root.findChildren<QComboBox*>()) {
    if (box->isVisible() && isCut(*box)) {
      cut << described(*box, box->currentText());
    }
  }
  for (const auto* bar : root.findChildren<QTabBar*>()) {
    if (bar->isVisible() && isCut(*bar)) {
      cut << described(*bar, bar->tabText(0));
    }
  }
  for (const auto* table : root.findChildren<QTableView*>()) {
    const QHeaderView* header = table->horizontalHeader();
    for (int i = 0; table->isVisible() && header->isVisible() && i < header->count(); ++i) {
      const QString title = table->model()->headerData(i, Qt::Horizontal).toString();
      if (!header->isSectionHidden(i) && header->sectionSize(i) < header->fontMetrics().horizontalAdvance(title)) {
        cut << described(*table, title);
      }
    }
  }
  return cut;
}

/** Letters that two texts claim, with the texts. */
inline QStringList doubleMnemonics(const QStringList& texts) {
  QStringList doubles;
  QHash<QString, QString> taken;
  for (const QString& text : texts) {
    const QString key = QKeySequence::mnemonic(text).toString();
    if (key.isEmpty()) {
      continue;
    }
    if (taken.contains(key)) {
      doubles << QStringLiteral("%1: “%2” and “%3”").arg(key, taken.value(key), text);
    }
    taken.insert(key, text);
  }
  return doubles;
}

/** The same for a menu and all menus in it. */
inline QStringList doubleMnemonics(const QMenu& menu) {
  QStringList texts;
  QStringList doubles;
  for (const QAction* action : menu.actions()) {
    texts << action->text();
    if (action->menu() != nullptr) {
      doubles << doubleMnemonics(*action->menu());
    }
  }
  return doubleMnemonics(texts) + doubles;
}

}  // namespace vp::test
