#pragma once

#include "ui/scene3d/scene_options.h"

#include <QToolBar>

#include <functional>
#include <vector>

class QAction;
class QComboBox;

namespace vp::scene3d {

class SceneView;

/** Presets, flight and options of a 3D view, for the dock that hosts it. Shows the view's state whoever changes it; what
 *  needs a plan is off without one. Texts only; the host may give the actions icons. */
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
  [[nodiscard]] QComboBox* speedBox() const { return speed_; }
  [[nodiscard]] QComboBox* heightBox() const { return heights_; }

private:
  void addPresets();
  void addFlight();
  void addOptions();
  void showState();
  void changeOptions(const std::function<void(SceneOptions&)>& change);

  SceneView& view_;
  std::vector<QAction*> presets_;
  QAction* follow_ = nullptr;
  QAction* fly_ = nullptr;
  QAction* curtain_ = nullptr;
  QAction* allGlides_ = nullptr;
  QComboBox* speed_ = nullptr;
  QComboBox* heights_ = nullptr;
};

}  // namespace vp::scene3d
