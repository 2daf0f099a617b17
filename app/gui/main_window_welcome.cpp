// What a start shows, and the help that the window itself gives.
#include "app/gui/autosave_keeper.h"
#include "app/gui/bundled.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/settings.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QFileInfo>
#include <QMessageBox>

namespace vp::gui {

using dialogs::MessageBanner;

void MainWindow::welcome() {
  if (autosave_->offerRecovery(*banner_)) {
    return;
  }
  const document::Settings settings(iniFile_);
  const QStringList recent = settings.recentFiles();
  if (!recent.isEmpty() && QFileInfo::exists(recent.front()) && files_->open(recent.front())) {
    return;
  }
  const QString example = bundledExample();
  if (!example.isEmpty() && files_->open(example)) {
    showHint();
  }
}

void MainWindow::showHint() {
  banner_->show(
      MessageBanner::Kind::Hint,
      tr("This is an example over made-up Alps, already planned. Your own in three steps:  1  New mission, add terrain and airfields (or drop "
         "the files here).  2  Press A and click targets on the map.  3  Press Plan tour. Then move along the magenta route to see the glide "
         "from each point."),
      {{tr("New mission"), [this] { files_->startNew(); }}, {tr("Worst point"), [this] { action(QStringLiteral("planWorst"))->trigger(); }}});
}

void MainWindow::showShortcuts() {
  const auto row = [](const QString& keys, const QString& what) {
    return QStringLiteral("<tr><td style='padding-right:18px'><b>%1</b></td><td>%2</td></tr>").arg(keys, what);
  };
  QString text = QStringLiteral("<table>");
  text += row(tr("Wheel, + and −"), tr("zoom at the pointer"));
  text += row(tr("Drag, arrows"), tr("move the map"));
  text += row(tr("A, V, M"), tr("add targets, select and move, measure"));
  text += row(tr("Del, Ctrl+E"), tr("delete or edit the selected target"));
  text += row(tr("Ctrl+Z, Ctrl+Y"), tr("undo, redo"));
  text += row(tr("Ctrl+Enter, Ctrl+."), tr("plan, stop planning"));
  text += row(tr("Ctrl+W"), tr("worst point of the tour"));
  text += row(tr("Pointer on the route"), tr("the glide from there, in all views; a click keeps it"));
  text += row(tr("Left, Right in the profile"), tr("previous, next decision point"));
  text += row(tr("F2 … F8"), tr("targets, runways, 3D, profile, engine out, decision points, plan"));
  text += row(tr("F11, Ctrl+Home"), tr("full-screen map, show all"));
  text += row(tr("In 3D: drag, middle drag, right drag"), tr("move, orbit, zoom; 1 to 4 are fixed views, Space is home"));
  text += QStringLiteral("</table>");
  QMessageBox box(QMessageBox::NoIcon, tr("Keyboard and mouse"), text, QMessageBox::Close, this);
  box.exec();
}

}  // namespace vp::gui
