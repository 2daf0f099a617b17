#pragma once

#include "ui/jobs/workspace.h"

#include <QObject>

#include <optional>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace vp::gui {

/** The status bar: message, progress with cancel, the plan's least glide margin and clearance with their places, and the place
 *  under the pointer with ground height and lowest safe altitude. */
class StatusLine : public QObject {
  Q_OBJECT

public:
  StatusLine(jobs::Workspace& workspace, QStatusBar& bar);
  void showPlace(std::optional<geo::LatLon> place);
  /** What a worker reads or writes; empty when it is done. */
  void showWork(const QString& text);
  void refreshTheme();

signals:
  void cancelRequested();

private:
  QToolButton* addLeast(QStatusBar& bar, const char* name, const QString& tip);
  void showLeast();
  void showTourPlace(const document::TourSample& (document::PlanView::*which)() const);
  void showActivity();
  void showProgress(double fraction, const QString& text);

  jobs::Workspace& workspace_;
  QLabel* message_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QToolButton* cancel_ = nullptr;
  QToolButton* leastMargin_ = nullptr;
  QToolButton* leastClearance_ = nullptr;
  QLabel* place_ = nullptr;
  std::optional<geo::LatLon> shown_;
};

}  // namespace vp::gui
