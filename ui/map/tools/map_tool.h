#pragma once

#include "ui/document/view_state.h"
#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QCursor>
#include <QPainter>
#include <QPointF>
#include <QString>

#include <cstddef>
#include <vector>

namespace vp::map {

/** What a tool sees of the map and may ask it for. The map passes edits on; nothing changes before the document does. */
class ToolHost {
public:
  ToolHost() = default;
  virtual ~ToolHost() = default;
  ToolHost(const ToolHost&) = delete;
  ToolHost& operator=(const ToolHost&) = delete;
  ToolHost(ToolHost&&) = delete;
  ToolHost& operator=(ToolHost&&) = delete;

  [[nodiscard]] virtual const MapCamera& camera() const = 0;
  [[nodiscard]] virtual const MapScene& scene() const = 0;
  [[nodiscard]] virtual document::ViewState& viewState() = 0;
  virtual void askAddTarget(geo::Point place, int insertBefore) = 0;
  virtual void askMoveTarget(int target, geo::Point place) = 0;
  /** @return false: it cannot be used, and the operator has been told why; nothing has been asked for */
  virtual bool askAddWeather(const std::vector<geo::Point>& outline) = 0;
  virtual void askMoveWeatherCorner(int cell, std::size_t corner, geo::Point place) = 0;
  virtual void tell(const QString& sentence) = 0;  ///< what is wrong
  virtual void askShowSite(int site) = 0;          ///< index into Situation::sites
  virtual void redraw() = 0;
  virtual void leaveTool() = 0;  ///< back to selecting; destroys the tool after the event
};

/** A state of the mouse on the map. Points are device-independent pixels. The map itself pans and zooms in every tool. */
class MapTool {
public:
  explicit MapTool(ToolHost& host) : host_(host) {}
  virtual ~MapTool() = default;
  MapTool(const MapTool&) = delete;
  MapTool& operator=(const MapTool&) = delete;
  MapTool(MapTool&&) = delete;
  MapTool& operator=(MapTool&&) = delete;

  /** Left button down. @return true: the tool takes the drag; false: dragging pans, and without a drag click() follows */
  virtual bool press(QPointF /*at*/) { return false; }
  virtual void drag(QPointF /*at*/) {}
  virtual void release(QPointF /*at*/) {}
  virtual void click(QPointF /*at*/) {}
  /** The second press of a double click; the first was a click. @return false: it is another click */
  virtual bool doubleClick(QPointF /*at*/) { return false; }
  /** A key of Qt::Key. @return false: the tool has no use for it */
  virtual bool key(int /*key*/) { return false; }
  virtual void hover(QPointF /*at*/) {}
  /** Esc or right click. @return false: there was nothing to cancel */
  virtual bool cancel() { return false; }
  /** The situation has changed: what the tool holds on to may be gone. */
  virtual void sceneChanged() {}
  virtual void paint(QPainter& /*painter*/) const {}
  [[nodiscard]] virtual QCursor cursor(QPointF at) const = 0;
  /** What to do next, in a short sentence; empty: nothing to say. */
  [[nodiscard]] virtual QString hint() const { return {}; }

protected:
  [[nodiscard]] ToolHost& host() const { return host_; }

private:
  ToolHost& host_;
};

}  // namespace vp::map
