// What a start shows, and the help that the window itself gives.
#include "app/gui/autosave_keeper.h"
#include "app/gui/bundled.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/settings.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>
#include <vector>

namespace vp::gui {

using dialogs::MessageBanner;

void MainWindow::welcome() {
  autosave_->offerRecovery([this](const QString& problem) { openLast(problem); });
}

/// The last mission, else the bundled one; then what there is to tell about a session before.
void MainWindow::openLast(const QString& problem) {
  const auto tell = [this, problem] {
    if (!problem.isEmpty()) {
      banner_->show(MessageBanner::Kind::Warning, problem);
    }
  };
  const auto openExample = [this, tell] {
    if (const QString example = bundledExample(); !example.isEmpty()) {
      files_->open(example, [this, tell](bool opened) {
        if (opened) {
          showHint();
        }
        tell();
      });
    } else {
      tell();
    }
  };
  const QStringList recent = document::Settings(iniFile_).recentFiles();
  if (recent.isEmpty()) {
    openExample();
    return;
  }
  files_->open(recent.front(), [tell, openExample](bool opened) { opened ? tell() : openExample(); });
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
  const std::vector<std::pair<QString, QString>> rows{
      {tr("Wheel, + and −, Page Up and Down"), tr("zoom")},
      {tr("Drag, arrows"), tr("move the map; with the middle button or Space in any tool")},
      {tr("Double click"), tr("zoom to the target or runway")},
      {tr("A, V, M, W"), tr("add targets, select and move, measure, draw weather")},
      {tr("Double click, Return, Backspace"), tr("drawing weather: close the outline, take the last corner back")},
      {tr("Ctrl+click"), tr("measure from there")},
      {tr("Shift+click"), tr("range rings; on their middle: remove them")},
      {tr("R, Shift+R"), tr("range rings from the middle of the map, remove all")},
      {tr("Ctrl+Alt+click, Shift+Alt+click"), tr("add a target into the nearest leg, at the end")},
      {tr("Ctrl+Shift+H"), tr("list of the weather")},
      {tr("Del, Ctrl+E, Ctrl+Up, Ctrl+Down"), tr("delete, edit, move up, move down the selected target")},
      {tr("Ctrl+Z, Ctrl+Y"), tr("undo, redo")},
      {tr("Ctrl+Enter, Ctrl+."), tr("plan, stop planning")},
      {tr("Ctrl+W"), tr("worst point of the tour")},
      {tr("Ctrl+L"), tr("lowest safe altitude")},
      {tr("Pointer on the route"), tr("the glide from there, in all views; a click keeps it")},
      {tr("Left, Right in the profile"), tr("previous, next decision point")},
      {tr("Ctrl+Home, Ctrl+Page Down"), tr("show all, centre the plan")},
      {tr("Ctrl+Shift+Home"), tr("jump to a position, an airfield or a target")},
      {tr("Alt+Left, Alt+Right"), tr("previous, next view")},
      {tr("F2 … F8, F11"), tr("targets, runways, 3D, profile, engine out, decision points, plan; full-screen map")},
      {tr("Ctrl+P"), tr("briefing for the kneeboard")},
      {tr("Ctrl+Shift+F, Alt+Enter"), tr("files and settings of the mission")},
      {tr("Ctrl+Shift+,"), tr("preferences")},
      {tr("F1"), tr("the page of the manual for the view or dialog in front")},
      {tr("In 3D: drag, middle drag, right drag"), tr("move, orbit, zoom; 1 to 4 are fixed views, Space is home")},
  };
  QString text = QStringLiteral("<table>");
  for (const auto& [keys, what] : rows) {
    text += QStringLiteral("<tr><td style='padding-right:18px; white-space:nowrap'><b>%1</b></td><td style='white-space:nowrap'>%2</td></tr>")
                .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
  }
  QDialog dialog(this);
  dialog.setWindowTitle(tr("Keyboard and mouse"));
  auto* table = new QLabel(text + QStringLiteral("</table>"));
  table->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  table->setAccessibleName(dialog.windowTitle());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  auto* column = new QVBoxLayout(&dialog);
  column->addWidget(table);
  column->addWidget(buttons);
  dialog.exec();
}

}  // namespace vp::gui
