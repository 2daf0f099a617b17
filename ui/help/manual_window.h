#pragma once

#include "ui/help/manual.h"
#include "ui/style/theme.h"

#include <QUrl>
#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;
class QTextBrowser;
class QToolBar;
class QTreeWidget;

namespace vp::help {

/** The manual in a window of its own: contents at the side, back and forward, search in the page. Reads its files when they are shown, never
 *  the network; links to the outside are handed to the desktop. */
class ManualWindow : public QWidget {
  Q_OBJECT

public:
  /** @param folder  of the manual, Manual::bundledFolder(); if it cannot be read the window says so */
  ManualWindow(const QString& folder, style::Theme theme, QWidget* parent = nullptr);

  /** Shows "map" or "map#overlays"; the contents for an empty name. */
  void showPage(const QString& page);
  /** The page shown, as showPage takes it. */
  [[nodiscard]] QString shownPage() const;
  /** Marks the next place of the text, from the top again behind the last one. @return whether there is one */
  bool find(const QString& text, bool backwards = false);

private:
  QToolBar* buildTools(style::Theme theme);
  void fillContents();
  void follow(const QUrl& link);
  void markInContents(const QUrl& shown);

  std::optional<Manual> manual_;
  QTextBrowser* text_ = nullptr;
  QTreeWidget* contents_ = nullptr;
  QLineEdit* search_ = nullptr;
  QLabel* found_ = nullptr;
};

}  // namespace vp::help
