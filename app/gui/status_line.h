#pragma once

#include "ui/jobs/workspace.h"

#include <QObject>

#include <optional>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace vp::gui {

/** The status bar: message, progress with cancel, place under the pointer with ground height and lowest safe altitude. */
class StatusLine : public QObject {
  Q_OBJECT

public:
  StatusLine(jobs::Workspace& workspace, QStatusBar& bar);
  void showPlace(std::optional<geo::LatLon> place);
  void refreshTheme();

signals:
  void cancelRequested();

private:
  void showActivity();
  void showProgress(double fraction, const QString& text);

  jobs::Workspace& workspace_;
  QLabel* message_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QToolButton* cancel_ = nullptr;
  QLabel* place_ = nullptr;
  std::optional<geo::LatLon> shown_;
};

}  // namespace vp::gui
