#pragma once

#include "ui/map/pixel_window.h"

#include <QImage>

namespace vp::map {

/** Paints any window of a layer that is computed pixel by pixel: terrain, overlays. Immutable once built.
 *  @threads paint() is called from many threads at once */
class TilePainter {
public:
  TilePainter() = default;
  virtual ~TilePainter() = default;
  TilePainter(const TilePainter&) = delete;
  TilePainter& operator=(const TilePainter&) = delete;
  TilePainter(TilePainter&&) = delete;
  TilePainter& operator=(TilePainter&&) = delete;

  /** @param devicePixelRatio  how many pixels of the window make a pixel of the user: line widths and patterns follow it */
  [[nodiscard]] virtual QImage paint(const PixelWindow& window, double devicePixelRatio) const = 0;
  /** Ground outside of which paint() gives nothing worth asking for; empty: none. */
  [[nodiscard]] virtual geo::Box extent() const = 0;
  /** Asks long preparations to end early, for shutting down. */
  virtual void abandon() const {}
};

}  // namespace vp::map
