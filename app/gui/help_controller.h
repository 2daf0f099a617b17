#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>

class QDialog;
class QWidget;

namespace vp::document {
class ViewState;
}
namespace vp::help {
class ManualWindow;
}

namespace vp::gui {

/** F1 everywhere: opens the page of the manual that belongs to the view or dialog that has the focus. Gives dialogs that have a page a Help
 *  button. Nothing of the manual is read before it is asked for. */
class HelpController : public QObject {
  Q_OBJECT

public:
  /** @param window  the main window, whose own F1 is an action; dialogs are watched by an event filter of the application */
  HelpController(const document::ViewState& view, QWidget* window);

  /** The page for a widget: that of the nearest one around it that has one, "" for the contents. */
  [[nodiscard]] static QString pageFor(const QWidget* widget);

  /** All pages that some view or dialog leads to. */
  [[nodiscard]] static QStringList allPages();

  /** Opens the page for what has the focus. */
  void showForFocus();
  /** Opens a page, as help::ManualWindow::showPage takes it. While a dialog blocks the main window, the manual belongs to that dialog. */
  void show(const QString& page);
  /** The manual's window, or null if it was not opened. */
  [[nodiscard]] help::ManualWindow* shown() const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void addButton(QDialog& dialog);

  const document::ViewState& view_;
  QWidget* window_;
  QPointer<help::ManualWindow> manual_;
};

}  // namespace vp::gui
