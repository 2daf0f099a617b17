#pragma once

#include "ui/dialogs/message_banner.h"
#include "ui/exports/prepare_export.h"
#include "ui/jobs/workspace.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <string>
#include <vector>

class QWidget;

namespace vp::gui {

/** Hands the plan on: flight plans for other programs and pictures, written in the background. A plan that is not verified, or
 *  no longer fits its inputs, is exported only after the operator was told so and agreed. */
class ExportController : public QObject {
  Q_OBJECT

public:
  struct Format {
    std::string id;  ///< name of formats::ExportFormat, or "map", "profile", "3d" for pictures
    QString text;    ///< as in the menu
    QString extension;
    QString loses;           ///< told before it is written
    std::string actionName;  ///< object name of the action
  };
  static const std::vector<Format>& formats();

  ExportController(jobs::Workspace& workspace, dialogs::MessageBanner& banner, QWidget* window);
  ~ExportController() override;

  void exportByDialog(const std::string& id);
  /** Several formats at once, chosen in a dialog. */
  void exportSeveral();
  /** Starts writing; finished() follows. Asks only if there is something to be warned of. @pre there is a plan */
  void exportTo(const std::string& id, const QString& path);

signals:
  void finished(bool written, const QString& path);

private:
  using Paths = std::function<std::vector<std::string>(const exports::PreparedExport&)>;
  bool mayExport();
  enum class Review { Always, IfWarned };
  /// Prepares the files in the background, shows what the waypoints cost, and writes them in the background.
  void exportPlan(std::vector<std::string> formats, const Paths& paths, Review review);
  bool mayWrite(const exports::PreparedExport& prepared, Review review);
  void exportAs(const std::string& id, const QString& path, Review review);
  [[nodiscard]] QString suggestedPath(const Format& format) const;

  jobs::Workspace& workspace_;
  dialogs::MessageBanner& banner_;
  QWidget* window_;
  QStringList chosen_{QStringLiteral("fms"), QStringLiteral("gpx"), QStringLiteral("kml")};  ///< last time in the dialog
  class Job;
  std::unique_ptr<Job> job_;
};

}  // namespace vp::gui
