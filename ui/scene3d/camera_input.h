#pragma once

#include <QPointF>
#include <QtCore/qnamespace.h>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace vp::scene3d {

class SceneView;

/** Mouse and keys of the 3D view: what is being dragged, and what a key does. */
class CameraInput {
public:
  explicit CameraInput(SceneView& view) : view_(view) {}

  void press(const QMouseEvent& event);
  /** @return true if a drag took it; else the mouse only hovers */
  bool move(const QMouseEvent& event);
  void release(const QMouseEvent& event);
  void wheel(const QWheelEvent& event);
  /** @return false if the key means nothing here */
  bool key(const QKeyEvent& event);
  [[nodiscard]] bool isDragging() const { return drag_ != Drag::None; }

private:
  enum class Drag { None, Pan, Orbit, Zoom };
  [[nodiscard]] static Drag dragFor(Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers);
  void begin(Drag drag, QPointF place);
  void end();
  bool arrow(int key, bool isOrbit);

  SceneView& view_;
  Drag drag_ = Drag::None;
  QPointF start_;
  QPointF last_;
  bool hasMoved_ = false;
  bool isClick_ = false;
};

}  // namespace vp::scene3d
