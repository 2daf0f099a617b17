#include "ui/map/tools/draw_weather_tool.h"

#include "ui/map/chart_text.h"
#include "ui/map/hit_test.h"
#include "ui/map/tools/rubber_band.h"
#include "ui/map/weather_marks.h"
#include "ui/map/words.h"

#include <QLineF>
#include <QPolygonF>

namespace vp::map {
namespace {

constexpr double kSamePlace = 3.0;  // px: a double click's second press
constexpr std::size_t kLeast = 3;   // corners

}  // namespace

bool DrawWeatherTool::isOnFirst(QPointF at) const {
  return corners_.size() >= kLeast && QLineF(at, host().camera().toScreen(corners_.front())).length() <= kReach;
}

void DrawWeatherTool::click(QPointF at) {
  if (host().scene().situation.terrain == nullptr) {
    return;
  }
  if (isOnFirst(at)) {
    close();
    return;
  }
  const bool isSame = !corners_.empty() && QLineF(at, host().camera().toScreen(corners_.back())).length() <= kSamePlace;
  if (!isSame) {
    frame_ = host().scene().situation.terrain->frame.origin();
    corners_.push_back(host().camera().toGround(at));
  }
  host().redraw();
}

bool DrawWeatherTool::doubleClick(QPointF at) {
  click(at);
  if (!corners_.empty()) {  // else that click has closed it
    close();
  }
  return true;
}

bool DrawWeatherTool::key(int key) {
  if (corners_.empty()) {
    return false;
  }
  if (key == Qt::Key_Backspace) {
    corners_.pop_back();
    host().redraw();
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    close();
  } else {
    return false;
  }
  return true;
}

void DrawWeatherTool::close() {
  if (corners_.size() < kLeast) {
    host().tell(Words::tr("Weather needs three corners or more; click where the next one is."));
    return;
  }
  if (host().askAddWeather(corners_)) {
    corners_.clear();
  }
  host().redraw();
}

void DrawWeatherTool::hover(QPointF at) {
  at_ = at;
  host().redraw();
}

bool DrawWeatherTool::cancel() {
  if (corners_.empty()) {
    host().leaveTool();
  } else {
    corners_.clear();
    host().redraw();
  }
  return true;
}

void DrawWeatherTool::sceneChanged() {
  const auto& terrain = host().scene().situation.terrain;
  if (!corners_.empty() && (terrain == nullptr || !(terrain->frame.origin() == *frame_))) {
    corners_.clear();  // they meant places in another frame
  }
}

void DrawWeatherTool::paint(QPainter& painter) const {
  if (corners_.empty()) {
    return;
  }
  const style::ChartColors& colors = host().scene().colors();
  const MapCamera& camera = host().camera();
  QPolygonF line;
  for (const geo::Point& corner : corners_) {
    line << camera.toScreen(corner);
  }
  if (at_) {
    line << (isOnFirst(*at_) ? line.front() : *at_);
  }
  painter.save();
  QColor veil = colors.weather;
  veil.setAlphaF(0.16F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(veil);
  painter.drawPolygon(line);
  painter.setPen(QPen(colors.routeCasing, 4.0));
  painter.drawPolyline(line);
  painter.setPen(QPen(colors.weather, 2.0));
  painter.drawPolyline(line);
  painter.restore();
  for (const geo::Point& corner : corners_) {
    drawHandle(painter, camera.toScreen(corner), colors);
  }
  if (at_) {
    drawReadout(painter, *at_ + QPointF(18.0, 14.0), {distanceText(host().scene(), corners_.back(), camera.toGround(*at_))}, colors, camera.screen());
  }
}

QCursor DrawWeatherTool::cursor(QPointF at) const {
  return isOnFirst(at) ? Qt::PointingHandCursor : Qt::CrossCursor;
}

QString DrawWeatherTool::hint() const {
  if (corners_.empty()) {
    return Words::tr("Click the corners of the weather one after the other; Esc when done");
  }
  return corners_.size() < kLeast ? Words::tr("Click the next corner; Backspace takes the last one back")
                                  : Words::tr("Double click or Return closes the outline; Backspace takes the last corner back, Esc drops it");
}

}  // namespace vp::map
