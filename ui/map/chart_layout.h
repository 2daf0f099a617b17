#pragma once

#include <QRectF>
#include <QSizeF>

#include <cstddef>
#include <optional>
#include <vector>

namespace vp::map {

/** To the edge of the map. [px] */
inline constexpr double kFurnitureEdge = 12.0;
/** Free between two pieces of furniture. [px] */
inline constexpr double kFurnitureGap = 8.0;

/** How large that is which stands still on the map; device-independent pixels. */
struct FurnitureSizes {
  QSizeF scale;
  QSizeF north;
  std::optional<QSizeF> message;  ///< what to do next
  double legendWidth = 0.0;
  double legendPadding = 0.0;        ///< above and below its groups together
  std::vector<double> legendGroups;  ///< heights of the parts of the legend that are left out as one, the most important first
  std::optional<QSizeF> wind = {};   ///< none in still air
};

/** Where the furniture of a map stands; device-independent pixels from the upper left corner. What is missing has no room. */
struct ChartLayout {
  QRectF scale;                   ///< lower left, always there
  std::optional<QRectF> message;  ///< top, in the middle
  std::optional<QRectF> wind;     ///< upper left, below the message where there is no room beside it
  std::optional<QRectF> legend;   ///< lower right, above the scale bar where there is no room beside it; at most half of the map
  std::size_t legendGroups = 0;   ///< so many of the groups are in the legend, from the first on
  std::optional<QRectF> north;    ///< upper right, below the message where there is no room beside it

  [[nodiscard]] std::vector<QRectF> boxes() const;
};

/** Places the furniture so that no two pieces are nearer than kFurnitureGap to each other and none is nearer than
 *  kFurnitureEdge to the edge. Importance: scale bar, message, wind, legend from its first group on, north arrow; nothing takes room
 *  from what is more important, and what finds none is left out.
 *  @pre the scale bar fits into the map   @threads pure */
ChartLayout layOutChart(QSizeF map, const FurnitureSizes& sizes);

}  // namespace vp::map
