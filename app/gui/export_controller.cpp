#include "app/gui/export_controller.h"

#include "core/formats/atomic_file.h"
#include "core/formats/exports/export_formats.h"
#include "core/formats/mission_loader.h"
#include "ui/exports/export_files.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/render_map.h"
#include "ui/profile/profile_renderer.h"
#include "ui/scene3d/scene_picture.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

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
  std::string folder;  ///< of the document, where relative terrain paths start
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

/// The plan's files, its terrain read afresh so that the waypoints can be checked; without terrain they are unverified.
Result<void> writeFormat(const Order& order, const vp::Job& job) {
  const mission::Plan& plan = order.situation.plan->plan();
  std::vector<std::string> checksums;
  Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(plan, order.folder, checksums, job.part(0.0, 0.3));
  const std::shared_ptr<const terrain::ElevationGrid> terrain = grid ? std::make_shared<const terrain::ElevationGrid>(std::move(*grid)) : nullptr;
  const Result<exports::PreparedExport> prepared = exports::prepareExport({plan, terrain, checksums, {order.id}}, job.part(0.3, 1.0));
  if (!prepared) {
    return forward(prepared);
  }
  const auto written = exports::writeExports(*prepared, exports::pathsOf(*prepared, order.path.toStdString()));
  if (!written) {
    return forward(written);
  }
  return {};
}

Result<void> writeOrder(const Order& order, const vp::Job& job) {
  if (formats::findExportFormat(order.id) != nullptr) {
    return writeFormat(order, job);
  }
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
    for (const formats::ExportFormat& format : formats::exportFormats()) {
      all.push_back({format.name, QString::fromStdString(format.what) + QStringLiteral("…"), QString::fromStdString(format.extension),
                     QString::fromStdString(format.loses), "export-" + format.name});
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
  const QString document = workspace_.document().path();
  const QString folder =
      document.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : QFileInfo(document).absolutePath();
  QString name = document.isEmpty() ? workspace_.document().title() : QFileInfo(document).completeBaseName();
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
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
  exportTo(id, path);
}

void ExportController::exportTo(const std::string& id, const QString& path) {
  const QString document = workspace_.document().path();
  const Order order{id,
                    path,
                    document.isEmpty() ? "" : QFileInfo(document).absolutePath().toStdString(),
                    workspace_.situation(),
                    workspace_.view().units(),
                    workspace_.view().pinned()};
  job_->runner.start<bool>(
      [order](const vp::Job& job) -> Result<bool> {
        const Result<void> written = writeOrder(order, job);
        if (!written) {
          return forward(written);
        }
        return true;
      },
      [this, path](const Result<bool>& result) {
        if (result) {
          banner_.show(MessageBanner::Kind::Success, tr("Written to %1").arg(path));
        } else {
          banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(result.error().message()));
        }
        emit finished(result.has_value(), path);
      });
}

}  // namespace vp::gui
