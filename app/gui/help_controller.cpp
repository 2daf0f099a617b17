#include "app/gui/help_controller.h"

#include "ui/document/view_state.h"
#include "ui/help/manual_window.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QKeyEvent>
#include <QPushButton>
#include <QTabWidget>

#include <map>
#include <string_view>

namespace vp::gui {
namespace {

/// Classes of views and dialogs, or names of their pages ("tab widget/number"), and where the manual speaks of them.
const std::map<std::string_view, const char*>& pages() {
  static const std::map<std::string_view, const char*> table{
      {"vp::map::MapView", "map"},
      {"vp::profile::ProfileView", "profile"},
      {"vp::scene3d::SceneView", "scene"},
      {"vp::scene3d::SceneToolBar", "scene"},
      {"vp::panels::TargetPanel", "targets"},
      {"vp::panels::SitePanel", "runways"},
      {"vp::panels::EngineOutPanel", "engine-out"},
      {"vp::panels::LandingPanel", "landing-now"},
      {"landingTabs/0", "landing-now#planners"},
      {"landingTabs/1", "landing-now#runways"},
      {"landingTabs/2", "landing-now#terms"},
      {"vp::panels::PlanSummaryPanel", "plan"},
      {"vp::panels::DecisionTable", "profile#decision-points"},
      {"vp::dialogs::MessageBanner", "troubleshooting#messages-and-what-to-do"},
      {"vp::dialogs::AircraftDialog", "aircraft"},
      {"vp::dialogs::AirspaceDialog", "airspace"},
      {"vp::dialogs::BriefingDialog", "briefing"},
      {"vp::dialogs::ExportDialog", "exports"},
      {"vp::dialogs::ExportReview", "exports#before-a-file-is-written"},
      {"vp::dialogs::FetchTerrainDialog", "fetching#terrain"},
      {"vp::dialogs::ImportTargetsDialog", "targets#from-files"},
      {"vp::dialogs::JumpDialog", "map#finding-places"},
      {"vp::dialogs::MissionFilesDialog", "files#files-of-a-mission"},
      {"vp::dialogs::MissionSettingsDialog", "settings"},
      {"missionPages/0", "settings#safety"},
      {"missionPages/1", "settings#approach"},
      {"missionPages/2", "settings#air-and-engine"},
      {"missionPages/3", "settings#planner"},
      {"vp::dialogs::PreferencesDialog", "preferences"},
      {"vp::dialogs::SafeAltitudeDialog", "exports#lowest-safe-altitude-map"},
      {"vp::dialogs::TargetDialog", "targets"},
      {"vp::dialogs::WeatherDialog", "weather#weather"},
      {"vp::dialogs::WeatherListDialog", "weather#weather"},
      {"vp::dialogs::WindDialog", "wind"},
  };
  return table;
}

QString pageOf(std::string_view key) {
  const auto found = pages().find(key);
  return found == pages().end() ? QString() : QLatin1String(found->second);
}

/// A page for a widget itself, whatever is around it.
QString pageOfAlone(const QWidget& widget) {
  if (const auto* tabs = qobject_cast<const QTabWidget*>(&widget)) {
    return pageOf(QStringLiteral("%1/%2").arg(tabs->objectName()).arg(tabs->currentIndex()).toStdString());
  }
  for (const QMetaObject* type = widget.metaObject(); type != nullptr; type = type->superClass()) {
    if (const QString page = pageOf(type->className()); !page.isEmpty()) {
      return page;
    }
  }
  return {};
}

}  // namespace

HelpController::HelpController(const document::ViewState& view, QWidget* window) : QObject(window), view_(view), window_(window) {
  qApp->installEventFilter(this);
}

QString HelpController::pageFor(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    if (widget->isWindow()) {
      for (const auto* tabs : widget->findChildren<QTabWidget*>()) {  // the focus is beside the pages of a dialog: the one in front
        if (const QString page = pageOfAlone(*tabs); !page.isEmpty() && qobject_cast<const QDialog*>(widget) != nullptr) {
          return page;
        }
      }
      return pageOfAlone(*widget);  // a dialog without a page has none of its parent's
    }
    if (const QString page = pageOfAlone(*widget); !page.isEmpty()) {
      return page;
    }
  }
  return {};
}

QStringList HelpController::allPages() {
  QStringList all;
  for (const auto& [key, page] : pages()) {
    all << QLatin1String(page);
  }
  return all;
}

void HelpController::showForFocus() {
  const QWidget* focus = QApplication::focusWidget();
  show(pageFor(focus != nullptr ? focus : QApplication::activeWindow()));
}

void HelpController::show(const QString& page) {
  QWidget* parent = QApplication::activeModalWidget() != nullptr ? QApplication::activeModalWidget() : window_;
  if (!manual_ || manual_->parentWidget() != parent) {
    delete manual_;
    manual_ = new help::ManualWindow(help::Manual::bundledFolder(), view_.theme(), parent);
    manual_->setAttribute(Qt::WA_DeleteOnClose);
  }
  manual_->showPage(page);
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

help::ManualWindow* HelpController::shown() const {
  return manual_;
}

/// A button box gets its Help button when the dialog is about to be shown, so dialogs know nothing of the manual.
void HelpController::addButton(QDialog& dialog) {
  auto* buttons = dialog.findChild<QDialogButtonBox*>();
  if (buttons == nullptr || buttons->button(QDialogButtonBox::Help) != nullptr || pageFor(&dialog).isEmpty()) {
    return;
  }
  QPushButton* help = buttons->addButton(QDialogButtonBox::Help);
  help->setAutoDefault(false);
  connect(help, &QPushButton::clicked, this, [this, shown = QPointer<QDialog>(&dialog)] {
    if (shown) {
      const QWidget* focus = shown->focusWidget();
      show(pageFor(focus != nullptr ? focus : shown));
    }
  });
}

bool HelpController::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Polish) {
    if (auto* dialog = qobject_cast<QDialog*>(watched)) {
      addButton(*dialog);
    }
  } else if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::HelpContents)) {
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (widget != nullptr && widget->window() != window_ && qobject_cast<const help::ManualWindow*>(widget->window()) == nullptr) {
      show(pageFor(widget));
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace vp::gui
