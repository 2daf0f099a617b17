#pragma once

#include "ui/document/situation.h"
#include "ui/document/view_state.h"
#include "ui/profile/hover_box.h"
#include "ui/profile/profile_renderer.h"

#include <QPixmap>
#include <QPointF>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace vp::profile {

/** The altitude profile as a widget: shows the point that any view looks at, and lets one be chosen.
 *
 *  Wheel zooms the distance at the cursor, Shift+wheel the altitude; left or middle drag pans; a click pins the point,
 *  a double click brings it into view on the map. Keys: Left/Right to the neighbouring decision point, Home/End to the
 *  first and last, +/- and Ctrl with them zoom distance, * and / altitude, Up/Down and PageUp/PageDown pan, 0 or Insert
 *  show all. The picture without the cursor is kept, so following the mouse costs no redraw of the curves. */
class ProfileView : public QWidget {
  Q_OBJECT

public:
  explicit ProfileView(document::ViewState& state, QWidget* parent = nullptr);
  ~ProfileView() override;

  /** Keeps zoom and position while the same tour stays. */
  void setSituation(const document::Situation& situation);

  [[nodiscard]] PlotWindow window() const;
  void setWindow(const PlotWindow& window);
  void showAll();

  /** Maps between the widget and the profile, for tests and for hosts that draw over it. Null without a plan. */
  [[nodiscard]] const ProfileRenderer* renderer() const;

  [[nodiscard]] QSize sizeHint() const override { return {900, 260}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {280, 150}; }

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

private:
  void invalidate();
  void followCursor();
  void zoomDistance(double factor, double at);
  void zoomAltitude(double factor, double at);
  void panBy(double distance, double altitude);
  void pin(double distance);
  void stepPinned(int by);
  void pinPoint(std::size_t point);
  void reveal(double distance);
  bool zoomByKey(int key);
  [[nodiscard]] const ProfileFact* factAt(QPointF position) const;
  [[nodiscard]] std::vector<HoverRow> hoverRows(double distance) const;
  [[nodiscard]] ProfileStyle profileStyle() const;
  void describe();

  struct Drag {
    QPointF start;
    PlotWindow window;
    bool moved = false;
  };
  document::ViewState& state_;
  document::Situation situation_;
  std::optional<PlotWindow> window_;  ///< nothing: all
  mutable std::unique_ptr<ProfileRenderer> renderer_;
  QPixmap picture_;
  std::optional<Drag> drag_;
};

}  // namespace vp::profile
