#pragma once

#include <QDialog>

namespace vp::about {

/** What the program is, which build of it, what the promise rests on, its libraries and data sources with their licences.
 *  The version is the application's, the commit the application's property "commit" (set by the program's main function).
 *  Its text can be selected and copied. */
class AboutDialog : public QDialog {
  Q_OBJECT

public:
  explicit AboutDialog(QWidget* parent = nullptr);

  /** All of it as plain text, as `volplane --version` prints it: what a report of a fault should carry. */
  [[nodiscard]] static QString plainText();
};

}  // namespace vp::about
