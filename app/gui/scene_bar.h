#pragma once

#include "ui/style/chart_colors.h"

#include <QToolBar>

#include <utility>
#include <vector>

class QComboBox;

namespace vp::scene3d {
class SceneView;
}

namespace vp::gui {

/** The controls above the 3D view: fixed views, flight along the tour, heights drawn larger, what is shown. */
class SceneBar : public QToolBar {
  Q_OBJECT

public:
  explicit SceneBar(scene3d::SceneView& view, QWidget* parent = nullptr);
  void setTheme(style::Theme theme);

private:
  void addPresets();
  void addFlight();
  void addOptions();
  void refresh();

  scene3d::SceneView& view_;
  QAction* fly_ = nullptr;
  QAction* follow_ = nullptr;
  QComboBox* speed_ = nullptr;
  QComboBox* exaggeration_ = nullptr;
  std::vector<std::pair<QAction*, QString>> icons_;
};

}  // namespace vp::gui
