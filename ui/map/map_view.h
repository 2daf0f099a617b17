#pragma once

#include "ui/document/situation.h"
#include "ui/document/view_state.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_renderer.h"
#include "ui/map/range_rings.h"
#include "ui/map/tile_layer.h"
#include "ui/map/tools/map_tool.h"
#include "ui/map/view_history.h"

#include <QElapsedTimer>
#include <QImage>
#include <QMenu>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace vp::map {

/** The map: pans, zooms, hovers and edits by asking. Never changes the document: every edit is a signal.
 *
 *  Mouse: wheel zooms at the cursor, left drag pans or drags a target, middle drag or Space and move pan in any tool, double click
 *  zooms to the object, right click cancels or opens a menu that names the object. Keys: arrows pan, Page Up and Down, + and -
 *  zoom, Ctrl+Home shows everything, Alt+Left and Right go through the views, Del deletes the selected target, Esc cancels.
 *  With a click: Ctrl measures from there, Shift draws range rings (on their middle: takes them away), Shift+Alt adds a target at
 *  the end, Ctrl+Alt into the nearest leg. Hovering the tour sets ViewState::hovered; a click on it pins.
 *  Drawing: terrain and overlays are tiles from worker threads; runways, tour and labels are kept in a picture somewhat larger
 *  than the window that is moved while panning; only cursor, glide and tools are drawn anew each time.
 *  @threads GUI thread */
class MapView : public QWidget, private ToolHost {
  Q_OBJECT

public:
  enum class Tool { Select, AddTarget, Measure, DrawWeather };

  explicit MapView(document::ViewState& state, QWidget* parent = nullptr);
  ~MapView() override;

  void setSituation(const document::Situation& situation);
  [[nodiscard]] const MapOptions& options() const { return renderer_.scene().options; }
  void setOptions(const MapOptions& options);

  [[nodiscard]] const MapCamera& camera() const override { return camera_; }
  void setCamera(const MapCamera& camera);  ///< its size is replaced by the widget's

  [[nodiscard]] Tool tool() const { return toolKind_; }
  void setTool(Tool tool);

  [[nodiscard]] bool canGoBack() const { return history_.canGoBack(); }
  [[nodiscard]] bool canGoForward() const { return history_.canGoForward(); }
  [[nodiscard]] const RangeRings& rings() const { return rings_; }
  /** All tiles of the last paint were there. */
  [[nodiscard]] bool isComplete() const { return relief_.isComplete() && overlay_.isComplete(); }

  /** The context menu for a point of the widget, not yet shown. */
  [[nodiscard]] std::unique_ptr<QMenu> contextMenuAt(QPointF at);

  [[nodiscard]] QSize sizeHint() const override { return {900, 640}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 180}; }

public slots:
  void zoomIn();
  void zoomOut();
  void showAll();
  void showPlan();                         ///< the tour, else the targets, as large as it gets
  void toggleRings(vp::geo::Point place);  ///< range rings about a place; away with those that are there
  void clearRings();
  void goBack();
  void goForward();
  void centreOn(vp::geo::Point place);
  void zoomToTarget(int target);
  void moveTarget(int target);  ///< carries it until a click places it
  void measureFrom(vp::geo::Point place);

signals:
  /// @param insertBefore  index into the mission's targets, -1: at the end
  void targetAddRequested(vp::geo::LatLon place, int insertBefore);
  void targetMoveRequested(int target, vp::geo::LatLon place);
  void targetRemoveRequested(int target);
  void targetRenameRequested(int target);
  void targetEditRequested(int target);
  /// @param siteId  a site ("LSZS/21") or an airport ("LSZS")
  void siteExcludeRequested(const QString& siteId, bool exclude);
  /// The engine stops here: where to?  @param distance  along the tour where that was clicked
  void engineOutRequested(vp::geo::Point place, std::optional<double> distance);
  void homeRequested(const QString& takeoff, const QString& landing);  ///< both empty: the tour alone
  /// What to do about all airspaces of a kind, or about those of a name where that is given.
  void airspaceUseRequested(const QString& kind, const QString& name, vp::mission::AirspaceUse use);
  void airspaceRulesRequested();
  /// The outline is one that can be used.
  void weatherDrawn(const std::vector<vp::geo::LatLon>& outline);
  void weatherCornerMoved(int cell, int corner, vp::geo::LatLon place);
  void weatherEditRequested(int cell);
  void weatherRemoveRequested(int cell);
  /// Why what was tried on the map is not done, a sentence.
  void problemFound(const QString& sentence);
  void siteClicked(const QString& siteId);
  /// Place under the mouse; nothing when it leaves or there is no terrain.
  void pointerMoved(std::optional<vp::geo::LatLon> place);
  void toolChanged(vp::map::MapView::Tool tool);
  void cameraChanged();
  void optionsChanged();

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  enum class Drag { None, Undecided, Panning, Tool };
  enum class Jump { Yes, No };

  // ToolHost
  [[nodiscard]] const MapScene& scene() const override { return renderer_.scene(); }
  [[nodiscard]] document::ViewState& viewState() override { return state_; }
  void askAddTarget(geo::Point place, int insertBefore) override;
  void askMoveTarget(int target, geo::Point place) override;
  bool askAddWeather(const std::vector<geo::Point>& outline) override;
  void askMoveWeatherCorner(int cell, std::size_t corner, geo::Point place) override;
  void tell(const QString& sentence) override { emit problemFound(sentence); }
  void askShowSite(int site) override;
  void redraw() override { update(); }
  void leaveTool() override { setTool(Tool::Select); }

  ToolHost& asHost() { return *this; }

  void setScene(MapScene scene);
  void useTool(std::unique_ptr<MapTool> tool, Tool kind);
  void moveTo(const MapCamera& camera, Jump jump);
  void zoomToObject(QPointF at);
  void zoomToPlace(geo::Point place, double metresPerPixel);
  void hoverAt(QPointF at);
  void clearHover();
  void updateCursorShape();
  bool handleViewKey(QKeyEvent* event);
  [[nodiscard]] bool isOnRingMiddle(QPointF at) const;
  bool clickWith(Qt::KeyboardModifiers modifiers, QPointF at);
  void drawObjects(QPainter& painter);
  [[nodiscard]] QString message() const;
  void drawInvitation(QPainter& painter) const;
  [[nodiscard]] std::optional<geo::LatLon> latLon(geo::Point place) const;

  document::ViewState& state_;
  MapRenderer renderer_;
  MapCamera camera_;
  TileLayer relief_;
  TileLayer overlay_;
  RangeRings rings_;
  ViewHistory history_;
  QElapsedTimer sinceMove_;
  bool isUntouched_ = true;  ///< nobody has panned, zoomed or clicked: new content may bring itself into view

  QImage objects_;  ///< runways, tour, labels around objectsCamera_
  MapCamera objectsCamera_;
  bool objectsStale_ = true;

  std::unique_ptr<MapTool> tool_;
  std::vector<std::unique_ptr<MapTool>> leftTools_;  ///< kept until the event that left them is over
  Tool toolKind_ = Tool::Select;
  Drag drag_ = Drag::None;
  QPointF pressedAt_;
  QPointF lastAt_;
  std::optional<QPointF> pointer_;  ///< where the mouse is over the map
  bool isSpaceHeld_ = false;
  bool swallowsMenu_ = false;  ///< the right click has cancelled something
  bool hasHovered_ = false;    ///< ViewState::hovered is ours
};

}  // namespace vp::map
