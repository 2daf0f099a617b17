#pragma once

#include "ui/briefing/briefing_content.h"

#include <QRectF>

#include <memory>

class QPainter;

namespace vp::map {
class MapRenderer;
}

namespace vp::briefing {

/** The pictures of a briefing, drawn by the same code as the window's. Targets are called by their number in the tour, runways
 *  by their idents, and the letters of the diversions stand along the tour, with a bar across it wherever the runway changes.
 *  Boxes are in units of page.h. Lines and text are drawn as such, the ground as an image; in monochrome all is one grey image.
 *  @pre source and content outlive the object   @threads one at a time */
class Pictures {
public:
  Pictures(const BriefingSource& source, const BriefingContent& content, const BriefingOptions& options);
  ~Pictures();
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;

  void map(QPainter& painter, const QRectF& box) const;
  /** Height of the ground worth showing by its width. */
  [[nodiscard]] double mapAspect() const;
  void profile(QPainter& painter, const QRectF& box) const;
  void glideMap(QPainter& painter, const QRectF& box, double distance) const;
  void glideProfile(QPainter& painter, const QRectF& box, double distance) const;

private:
  class Private;
  std::unique_ptr<Private> d_;
};

}  // namespace vp::briefing
