#pragma once

#include "ui/scene3d/scene_options.h"

#include <QToolBar>

#include <functional>
#include <vector>

class QAction;

namespace vp::scene3d {

class SceneView;

/** Presets, flight and options of a 3D view, for the dock that hosts it. Shows the view's state whoever changes it; what
 *  needs a plan is off without one. Texts only; the host may give the actions icons. Everything is an action, so that what
 *  has no room in a narrow view is in the menu at the end of the bar. */
class SceneToolBar : public QToolBar {
  Q_OBJECT

public:
  SceneToolBar(SceneView& view, QWidget* parent);

  /// Top, North, along the tour, from the runway.
  [[nodiscard]] const std::vector<QAction*>& presetActions() const { return presets_; }
  [[nodiscard]] QAction* followAction() const { return follow_; }
  [[nodiscard]] QAction* flyAction() const { return fly_; }
  [[nodiscard]] QAction* curtainAction() const { return curtain_; }
  [[nodiscard]] QAction* allGlidesAction() const { return allGlides_; }
  [[nodiscard]] QAction* speedAction() const { return speed_; }      ///< its menu holds the factors as data
  [[nodiscard]] QAction* heightsAction() const { return heights_; }  ///< as above
  [[nodiscard]] double flightSpeed() const { return flightSpeed_; }  ///< times that of the aircraft

private:
  void addPresets();
  void addFlight();
  void addOptions();
  void showOverflow();
  QAction* addChoice(const QString& tip, const QString& text, const std::vector<double>& factors, const std::function<void(double)>& choose);
  static void showChoice(QAction* action, double factor);
  void showState();
  void changeOptions(const std::function<void(SceneOptions&)>& change);

  SceneView& view_;
  std::vector<QAction*> presets_;
  QAction* follow_ = nullptr;
  QAction* fly_ = nullptr;
  QAction* curtain_ = nullptr;
  QAction* allGlides_ = nullptr;
  QAction* speed_ = nullptr;
  QAction* heights_ = nullptr;
  double flightSpeed_ = 10.0;
};

}  // namespace vp::scene3d
