#pragma once

#include "ui/jobs/workspace.h"

#include <QObject>

#include <optional>

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace vp::gui {

/** The status bar: message, progress with cancel, the plan's least glide margin and clearance with their places, how much ground
 *  the map shows, and the place under the pointer with ground height, lowest safe altitude and magnetic variation. Where it is
 *  narrow, what is said elsewhere too goes first; nothing in it makes the window wider. */
class StatusLine : public QObject {
  Q_OBJECT

public:
  StatusLine(jobs::Workspace& workspace, QStatusBar& bar);
  void showPlace(std::optional<geo::LatLon> place);
  /** How much ground the map shows from left to right. [m] */
  void showMapWidth(double metres);
  /** What a worker reads or writes; empty when it is done. */
  void showWork(const QString& text);
  void refreshTheme();
  bool eventFilter(QObject* watched, QEvent* event) override;

signals:
  void cancelRequested();

private:
  /// What is left out, one after the other, until the rest has room.
  enum class Shortened { Nothing, PlacesOfLeast, MapWidth, Variation, Least };
  QToolButton* addLeast(const char* name, const QString& tip);
  QLabel* addLabel(const char* name, const QString& accessibleName);
  void showTourPlace(const document::TourSample& (document::PlanView::*which)() const);
  void showActivity();
  void showMessage(const QString& text);
  void fit();
  [[nodiscard]] int neededWidth(Shortened shortened) const;
  [[nodiscard]] int roomForAll() const;
  [[nodiscard]] QString marginText(Shortened shortened) const;
  [[nodiscard]] QString clearanceText(Shortened shortened) const;
  [[nodiscard]] QString placeText(Shortened shortened) const;

  jobs::Workspace& workspace_;
  QStatusBar& bar_;
  QLabel* message_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QToolButton* cancel_ = nullptr;
  QToolButton* leastMargin_ = nullptr;
  QToolButton* leastClearance_ = nullptr;
  QLabel* mapWidth_ = nullptr;
  QLabel* place_ = nullptr;
  QString messageText_;
  double shownWidth_ = 0.0;  ///< m
  std::optional<geo::LatLon> shown_;
};

}  // namespace vp::gui
