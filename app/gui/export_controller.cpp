#include "app/gui/export_controller.h"

#include "app/gui/suggested_file.h"
#include "core/formats/atomic_file.h"
#include "core/formats/exports/export_formats.h"
#include "core/formats/mission_loader.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/export_review.h"
#include "ui/exports/export_files.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/render_map.h"
#include "ui/profile/profile_renderer.h"
#include "ui/scene3d/scene_picture.h"
#include "ui/style/core_text.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace vp::gui {
namespace {

constexpr int kPictureWidth = 1600;
constexpr int kPictureHeight = 1000;
constexpr double kPictureScale = 2.0;

/// Everything that writing needs, as values.
struct Order {
  std::string id;
  QString path;
  document::Situation situation;
  style::Units units;
  std::optional<double> cursor;
};

Result<QImage> draw(const Order& order) {
  const QSize size(kPictureWidth, kPictureHeight);
  const style::Theme theme = style::Theme::Light;  // for paper
  if (order.id == "map") {
    map::MapScene scene;
    scene.situation = order.situation;
    scene.units = order.units;
    scene.cursor = order.cursor;
    return map::renderMap(scene, size, kPictureScale);
  }
  if (order.id == "profile") {
    return profile::renderProfile(order.situation, size, kPictureScale, theme, order.units, order.cursor);
  }
  scene3d::CameraSpec camera;
  camera.cursor = order.cursor;
  return scene3d::renderScene(order.situation, {}, camera, size, theme, order.units, 1.0);
}

/// The plan's files in memory, its terrain read afresh so that the waypoints can be checked; without terrain they are unverified.
Result<exports::PreparedExport> prepare(const document::Situation& situation, const std::string& folder, const std::vector<std::string>& formats,
                                        const vp::Job& job) {
  const mission::Plan& plan = situation.plan->plan();
  std::vector<std::string> checksums;
  Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(plan, folder, checksums, job.part(0.0, 0.3));
  if (!grid && grid.error().code == Errc::Cancelled) {
    return forward(grid);
  }
  const std::shared_ptr<const terrain::ElevationGrid> terrain = grid ? std::make_shared<const terrain::ElevationGrid>(std::move(*grid)) : nullptr;
  Result<exports::PreparedExport> prepared = exports::prepareExport({plan, terrain, checksums, formats}, job.part(0.3, 1.0));
  if (prepared && !grid) {
    prepared->remarks.insert(prepared->remarks.begin(), {true, grid.error().message()});
  }
  return prepared;
}

Result<void> writePicture(const Order& order) {
  const Result<QImage> image = draw(order);
  if (!image) {
    return forward(image);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image->save(&buffer, "PNG");
  return formats::writeFileAtomically(order.path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace

using dialogs::MessageBanner;

class ExportController::Job {
public:
  jobs::JobRunner runner;
};

const std::vector<ExportController::Format>& ExportController::formats() {
  static const std::vector<Format> list = [] {
    std::vector<Format> all;
    for (const vp::formats::ExportFormat& format : vp::formats::exportFormats()) {
      all.push_back({format.name, style::coreText(format.what) + QStringLiteral("…"), QString::fromStdString(format.extension),
                     style::coreText(format.loses), "export-" + format.name});
    }
    all.push_back({"map", tr("Picture of the map…"), QStringLiteral("png"), {}, "export-map"});
    all.push_back({"profile", tr("Picture of the profile…"), QStringLiteral("png"), {}, "export-profile"});
    all.push_back({"3d", tr("Picture of the 3D view…"), QStringLiteral("png"), {}, "export-3d"});
    return all;
  }();
  return list;
}

ExportController::ExportController(jobs::Workspace& workspace, MessageBanner& banner, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), window_(window), job_(std::make_unique<Job>()) {}

ExportController::~ExportController() = default;

bool ExportController::mayExport() {
  const document::Situation& situation = workspace_.situation();
  if (!situation.plan) {
    banner_.show(MessageBanner::Kind::Warning, tr("There is no plan to export; plan the tour first."));
    return false;
  }
  QString doubt;
  if (!situation.plan->isVerified()) {
    doubt = tr("This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it.");
  } else if (!situation.planIsCurrent) {
    doubt = tr("This plan is out of date: the mission has been changed since it was made.");
  }
  if (doubt.isEmpty()) {
    return true;
  }
  QMessageBox box(QMessageBox::Warning, tr("Export"), doubt, QMessageBox::Cancel, window_);
  box.setInformativeText(tr("Export it all the same?"));
  QPushButton* proceed = box.addButton(tr("Export anyway"), QMessageBox::DestructiveRole);
  box.setDefaultButton(QMessageBox::Cancel);
  box.exec();
  return box.clickedButton() == proceed;
}

QString ExportController::suggestedPath(const Format& format) const {
  const QString folder = suggestedFolder(workspace_.document());
  const QString name = suggestedName(workspace_.document());
  const bool isPicture = format.extension == QStringLiteral("png");
  return QDir(folder).filePath(name + (isPicture ? QLatin1Char('-') + QString::fromStdString(format.id) : QString()) + QLatin1Char('.') +
                               format.extension);
}

void ExportController::exportByDialog(const std::string& id) {
  const auto format = std::find_if(formats().begin(), formats().end(), [&](const Format& f) { return f.id == id; });
  if (format == formats().end() || !mayExport()) {
    return;
  }
  QString title = tr("Export");
  if (!format->loses.isEmpty()) {
    title += QStringLiteral(" – ") + tr("note: %1").arg(format->loses);
  }
  QString path = QFileDialog::getSaveFileName(window_, title, suggestedPath(*format), QStringLiteral("*.") + format->extension);
  if (path.isEmpty()) {
    return;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QLatin1Char('.') + format->extension;
  }
  exportAs(id, path, Review::Always);
}

void ExportController::exportSeveral() {
  if (!mayExport()) {
    return;
  }
  const QString folder = QFileInfo(suggestedPath(formats().front())).absolutePath();
  const std::string& name = workspace_.situation().plan->plan().mission.name;
  const QString mission = name.empty() ? workspace_.document().title() : QString::fromStdString(name);
  dialogs::ExportDialog dialog(mission, folder, chosen_, window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  chosen_ = dialog.formats();
  std::vector<std::string> names;
  for (const QString& format : chosen_) {
    names.push_back(format.toStdString());
  }
  exportPlan(
      std::move(names),
      [folder = dialog.folder().toStdString(), pattern = dialog.pattern().toStdString(),
       mission = mission.toStdString()](const exports::PreparedExport& prepared) { return exports::pathsOf(prepared, folder, pattern, mission); },
      Review::Always);
}

bool ExportController::mayWrite(const exports::PreparedExport& prepared, Review review) {
  if (review == Review::IfWarned && !prepared.hasWarnings()) {
    return true;
  }
  return dialogs::ExportReview(prepared, workspace_.view().units(), window_).exec() == QDialog::Accepted;
}

void ExportController::exportPlan(std::vector<std::string> formats, const Paths& paths, Review review) {
  const QString document = workspace_.document().path();
  const std::string folder = document.isEmpty() ? std::string() : QFileInfo(document).absolutePath().toStdString();
  const auto failed = [this](const vp::Error& error) {
    banner_.show(MessageBanner::Kind::Failure, style::coreText(error));
    emit finished(false, {});
  };
  using Prepared = std::shared_ptr<const exports::PreparedExport>;
  job_->runner.start<Prepared>(
      [situation = workspace_.situation(), folder, formats = std::move(formats)](const vp::Job& job) -> Result<Prepared> {
        Result<exports::PreparedExport> prepared = prepare(situation, folder, formats, job);
        if (!prepared) {
          return forward(prepared);
        }
        return std::make_shared<const exports::PreparedExport>(std::move(*prepared));
      },
      [this, paths, failed, review](const Result<Prepared>& prepared) {
        if (!prepared) {
          failed(prepared.error());
          return;
        }
        if (!mayWrite(**prepared, review)) {
          emit finished(false, {});
          return;
        }
        const std::vector<std::string> files = paths(**prepared);
        job_->runner.start<bool>(
            [files, prepared = *prepared](const vp::Job&) -> Result<bool> {
              const auto written = exports::writeExports(*prepared, files);
              if (!written) {
                return forward(written);
              }
              return true;
            },
            [this, files, failed](const Result<bool>& written) {
              if (!written) {
                failed(written.error());
                return;
              }
              const QString first = QString::fromStdString(files.front());
              banner_.show(MessageBanner::Kind::Success,
                           files.size() == 1
                               ? tr("Written to %1").arg(first)
                               : tr("%n files written to %1", nullptr, static_cast<int>(files.size())).arg(QFileInfo(first).absolutePath()));
              emit finished(true, first);
            });
      });
}

void ExportController::exportTo(const std::string& id, const QString& path) {
  exportAs(id, path, Review::IfWarned);
}

void ExportController::exportAs(const std::string& id, const QString& path, Review review) {
  if (vp::formats::findExportFormat(id) != nullptr) {
    exportPlan(
        {id}, [file = path.toStdString()](const exports::PreparedExport& prepared) { return exports::pathsOf(prepared, file); }, review);
    return;
  }
  const Order order{id, path, workspace_.situation(), workspace_.view().units(), workspace_.view().pinned()};
  job_->runner.start<bool>(
      [order](const vp::Job&) -> Result<bool> {
        const Result<void> written = writePicture(order);
        if (!written) {
          return forward(written);
        }
        return true;
      },
      [this, path](const Result<bool>& result) {
        if (result) {
          banner_.show(MessageBanner::Kind::Success, tr("Written to %1").arg(path));
        } else {
          banner_.show(MessageBanner::Kind::Failure, style::coreText(result.error()));
        }
        emit finished(result.has_value(), path);
      });
}

}  // namespace vp::gui
