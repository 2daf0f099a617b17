#include "app/gui/weather_controller.h"

#include "core/formats/weather_file.h"
#include "ui/dialogs/message_banner.h"
#include "ui/dialogs/weather_dialog.h"
#include "ui/dialogs/weather_list_dialog.h"
#include "ui/document/weather_view.h"
#include "ui/style/core_text.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QWidget>

namespace vp::gui {

using dialogs::MessageBanner;

WeatherController::WeatherController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), window_(window) {
  connect(&workspace_.document(), &document::MissionDocument::missionChanged, this, [this] {
    if (workspace_.view().selectedWeather() >= static_cast<int>(workspace_.document().mission().weather.size())) {
      workspace_.view().selectWeather(-1);
    }
    refreshList();
  });
  connect(&workspace_.document(), &document::MissionDocument::replaced, this, [this] { workspace_.view().selectWeather(-1); });
  connect(&workspace_.view(), &document::ViewState::unitsChanged, this, &WeatherController::refreshList);
  connect(&workspace_.view(), &document::ViewState::selectionChanged, this, [this] {
    if (list_) {
      list_->select(workspace_.view().selectedWeather());
    }
  });
}

const mission::WeatherCell* WeatherController::at(int cell) const {
  const std::vector<mission::WeatherCell>& cells = workspace_.document().mission().weather;
  return cell >= 0 && cell < static_cast<int>(cells.size()) ? &cells[static_cast<std::size_t>(cell)] : nullptr;
}

void WeatherController::tell(const QString& problem) {
  banner_.show(MessageBanner::Kind::Warning, problem.left(1).toUpper() + problem.mid(1));
}

bool WeatherController::isUsable(const mission::WeatherCell& cell) {
  const auto& terrain = workspace_.situation().terrain;
  const std::string problem = document::weatherProblem(cell, terrain != nullptr ? terrain->frame : geo::LocalFrame(cell.outline.front()));
  if (!problem.empty()) {
    tell(style::coreText(problem));
  }
  return problem.empty();
}

void WeatherController::add(const std::vector<geo::LatLon>& outline) {
  const std::vector<mission::WeatherCell>& cells = workspace_.document().mission().weather;
  mission::WeatherCell cell;
  if (!cells.empty()) {  // weather of one day is much alike
    cell = cells.back();
    cell.name.clear();
  }
  cell.outline = outline;
  const std::size_t index = cells.size();
  const QString title = document::weatherTitle(cell, index);
  dialogs::WeatherDialog dialog(cell, title, workspace_.view().units(), window_);
  connect(&workspace_.document(), &document::MissionDocument::replaced, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted || !isUsable(dialog.result())) {
    return;
  }
  cell = dialog.result();
  workspace_.document().edit(tr("Draw weather %1").arg(document::weatherTitle(cell, index)), [&](mission::Mission& m) { m.weather.push_back(cell); });
  workspace_.view().selectWeather(static_cast<int>(workspace_.document().mission().weather.size()) - 1);
}

void WeatherController::edit(int cell) {
  const mission::WeatherCell* before = at(cell);
  if (before == nullptr) {
    return;
  }
  workspace_.view().selectWeather(cell);
  dialogs::WeatherDialog dialog(*before, document::weatherTitle(*before, static_cast<std::size_t>(cell)), workspace_.view().units(), window_);
  connect(&workspace_.document(), &document::MissionDocument::replaced, &dialog, &QDialog::reject);
  if (dialog.exec() == QDialog::Accepted) {
    replace(cell, dialog.result());
  }
}

void WeatherController::replace(int cell, const mission::WeatherCell& value) {
  const mission::WeatherCell* before = at(cell);
  if (before != nullptr && !(*before == value) && isUsable(value)) {
    workspace_.document().edit(tr("Edit weather %1").arg(document::weatherTitle(value, static_cast<std::size_t>(cell))),
                               [&](mission::Mission& m) { m.weather[static_cast<std::size_t>(cell)] = value; });
  }
}

void WeatherController::remove(int cell) {
  const mission::WeatherCell* before = at(cell);
  if (before != nullptr) {
    workspace_.view().selectWeather(-1);
    workspace_.document().edit(tr("Delete weather %1").arg(document::weatherTitle(*before, static_cast<std::size_t>(cell))),
                               [&](mission::Mission& m) { m.weather.erase(m.weather.begin() + cell); });
  }
}

void WeatherController::moveCorner(int cell, int corner, geo::LatLon place) {
  const mission::WeatherCell* before = at(cell);
  if (before == nullptr || corner < 0 || corner >= static_cast<int>(before->outline.size())) {
    return;
  }
  mission::WeatherCell moved = *before;
  moved.outline[static_cast<std::size_t>(corner)] = place;
  if (isUsable(moved)) {
    workspace_.document().edit(tr("Move a corner of weather %1").arg(document::weatherTitle(moved, static_cast<std::size_t>(cell))),
                               [&](mission::Mission& m) { m.weather[static_cast<std::size_t>(cell)] = moved; });
  }
}

void WeatherController::showList() {
  if (!list_) {
    list_ = new dialogs::WeatherListDialog(window_);
    list_->setAttribute(Qt::WA_DeleteOnClose);
    connect(list_, &dialogs::WeatherListDialog::cellEdited, this, &WeatherController::replace);
    connect(list_, &dialogs::WeatherListDialog::editRequested, this, &WeatherController::edit);
    connect(list_, &dialogs::WeatherListDialog::removeRequested, this, &WeatherController::remove);
    connect(list_, &dialogs::WeatherListDialog::selected, this, [this](int cell) { workspace_.view().selectWeather(cell); });
    connect(list_, &dialogs::WeatherListDialog::drawRequested, this, &WeatherController::drawRequested);
    connect(list_, &dialogs::WeatherListDialog::addRequested, this, &WeatherController::addRequested);
    connect(list_, &dialogs::WeatherListDialog::exportRequested, this, &WeatherController::exportByDialog);
    for (const char* name : {"editUndo", "editRedo"}) {
      if (auto* action = window_->findChild<QAction*>(QLatin1String(name))) {
        list_->addAction(action);  // their keys work there too
      }
    }
    refreshList();
  }
  list_->show();
  list_->raise();
  list_->activateWindow();
}

void WeatherController::refreshList() {
  if (list_) {
    list_->setWeather(workspace_.document().mission().weather, workspace_.view().units());
  }
}

void WeatherController::exportByDialog() {
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Export weather"), QFileInfo(workspace_.document().path()).absolutePath(), tr("GeoJSON (*.geojson)"));
  if (path.isEmpty()) {
    return;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QStringLiteral(".geojson");
  }
  exportTo(path);
}

void WeatherController::exportTo(const QString& path) {
  const std::vector<mission::WeatherCell>& cells = workspace_.document().mission().weather;
  if (const Result<void> written = formats::writeWeather(path.toStdString(), cells); !written) {
    banner_.show(MessageBanner::Kind::Failure, style::coreText(written.error()));
  } else {
    banner_.show(MessageBanner::Kind::Success,
                 tr("%n weather cell(s) written to %1.", nullptr, static_cast<int>(cells.size())).arg(QFileInfo(path).fileName()));
  }
}

}  // namespace vp::gui
