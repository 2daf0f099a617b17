#pragma once

#include "ui/document/mailbox.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"
#include "ui/scene3d/camera_controller.h"
#include "ui/scene3d/scene_options.h"
#include "ui/scene3d/scene_worker.h"

#include <QElapsedTimer>
#include <QRectF>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

class QLabel;

namespace vp::scene3d {

class CameraInput;
class SceneOverlay;

/** The 3D view of a situation. What draws is the business of the derived classes, see createSceneView().
 *
 *  Mouse: left drag pans, middle drag or left and right together orbits, right drag and wheel zoom, double-click goes to
 *  the place. Keys: Space home, arrows pan, with Shift orbit, + and - zoom, 1 to 4 presets, F follows, Esc ends a flight.
 *  Hovering the tour sets the shared cursor, a click pins it; the glide from the cursor is drawn.
 *  Terrain and scenes are built on a worker; nothing here waits for it. */
class SceneView : public QWidget {
  Q_OBJECT

public:
  SceneView(document::ViewState& state, QWidget* parent);
  ~SceneView() override;

  void setSituation(const document::Situation& situation);
  void setOptions(const SceneOptions& options);
  [[nodiscard]] const SceneOptions& options() const { return options_; }

  void showPreset(Preset preset);
  void goHome();
  /** Flies along the tour from the cursor, `speedFactor` times as fast as the aircraft. Does nothing without a plan. */
  void startFlight(double speedFactor);
  void stopFlight();
  [[nodiscard]] bool isFlying() const { return controller_.flightFactor() > 0.0; }
  /** Keeps the cursor's place on the tour in the middle. */
  void setFollowing(bool following);
  [[nodiscard]] bool isFollowing() const { return controller_.isFollowing(); }

  [[nodiscard]] const CameraController& controller() const { return controller_; }
  [[nodiscard]] CameraState camera() const { return controller_.camera(); }
  [[nodiscard]] const document::Situation& situation() const { return situation_; }
  /** What draws, in words for an "about" box; empty before the first frame. */
  [[nodiscard]] virtual QString rendererName() const { return {}; }
  /** Why there is no 3D; empty if there is. */
  [[nodiscard]] QString problem() const { return problem_; }
  /** True when all that was asked for is built and drawn. */
  [[nodiscard]] virtual bool isSettled() const;

signals:
  void flightChanged();   ///< started, stopped, following
  void optionsChanged();  ///< by setOptions()
  void situationChanged();

protected:
  /// Results of the worker, in the GUI thread, and what they are drawn with.
  virtual void takeTerrain(std::shared_ptr<TerrainLayer> terrain) = 0;
  virtual void takeScene(std::shared_ptr<const SceneNodes> scene) = 0;
  virtual void takeCursor(std::shared_ptr<const SceneNodes> cursor) = 0;
  virtual void takeLook(style::Theme theme, double exaggeration) = 0;
  virtual void takeReserved(std::vector<QRectF> parts) = 0;
  /// The picture must be drawn anew for camera(). May come often.
  virtual void requestFrame() = 0;
  /// Resolution of texts relative to 96 dpi.
  [[nodiscard]] virtual double labelRatio() const { return devicePixelRatioF(); }

  /** Says in place of the picture why there is none. */
  void showProblem(const QString& text);
  /** True while the operator or time moves the camera: speed counts more than beauty. */
  [[nodiscard]] bool isInMotion() const;

  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  friend class CameraInput;

  [[nodiscard]] SceneStyle sceneStyle() const { return {state_.theme(), state_.units()}; }
  void rebuildTerrain();
  void rebuildScene();
  void rebuildCursor();
  void receiveTerrain(const SceneWorker::Terrain& terrain);
  void receiveScene(const SceneWorker::Scene& scene);
  void onCursorChanged();
  void onPlaceRequested(geo::Point place);
  void updatePath();
  void hover(QPointF place);
  void click(QPointF place);
  void goTo(QPointF place);
  void cameraMoved(bool byHand);
  void tick();
  void updateMessage();

  document::ViewState& state_;
  document::Situation situation_;
  SceneOptions options_;
  CameraController controller_;
  std::shared_ptr<const TerrainModel> model_;
  document::Mailbox mailbox_;
  std::unique_ptr<SceneWorker> worker_;
  std::unique_ptr<CameraInput> input_;
  SceneOverlay* overlay_ = nullptr;
  QLabel* message_ = nullptr;
  QString problem_;
  QTimer clock_;
  QElapsedTimer sinceTick_;
  QElapsedTimer sinceMove_;
  QElapsedTimer sincePin_;
  double labelRatio_ = 0.0;
  bool isHome_ = true;  ///< the camera was never moved by hand: it follows what is loaded
  bool isTerrainBuilt_ = false;
  bool didHover_ = false;   ///< the shared cursor hovers because of this view
  bool isPinning_ = false;  ///< the flight moves the pin
};

}  // namespace vp::scene3d
