#include "ui/map/chart_layout.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace vp::map {
namespace {

constexpr double kLegendShare = 0.5;  // of the map at most: a map is there to see the ground

/// What is taken so far.
class Room {
public:
  explicit Room(QSizeF map) : inner_(QRectF(QPointF(), map).adjusted(kFurnitureEdge, kFurnitureEdge, -kFurnitureEdge, -kFurnitureEdge)) {}

  [[nodiscard]] const QRectF& inner() const { return inner_; }
  void take(const QRectF& box) { taken_.push_back(box); }

  /// The first of some places that is free, taken.
  template <std::size_t N>
  std::optional<QRectF> firstFree(QSizeF size, const std::array<QPointF, N>& corners) {
    for (const QPointF& corner : corners) {
      const QRectF box(corner, size);
      if (isFree(box)) {
        take(box);
        return box;
      }
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] bool isFree(const QRectF& box) const {
    constexpr double kRounding = 1e-6;  // px
    const double gap = kFurnitureGap - kRounding;
    const QRectF around = box.adjusted(-gap, -gap, gap, gap);
    return inner_.adjusted(-kRounding, -kRounding, kRounding, kRounding).contains(box) &&
           std::none_of(taken_.begin(), taken_.end(), [&](const QRectF& other) { return around.intersects(other); });
  }

  QRectF inner_;
  std::vector<QRectF> taken_;
};

void placeLegend(ChartLayout& layout, Room& room, const FurnitureSizes& sizes, double area) {
  const QRectF& inner = room.inner();
  for (std::size_t count = sizes.legendGroups.size(); count > 0 && !layout.legend; --count) {
    const double height =
        std::accumulate(sizes.legendGroups.begin(), sizes.legendGroups.begin() + static_cast<std::ptrdiff_t>(count), sizes.legendPadding);
    if (height * sizes.legendWidth > kLegendShare * area) {
      continue;
    }
    const double left = inner.right() - sizes.legendWidth;
    layout.legend = room.firstFree({sizes.legendWidth, height},
                                   std::array{QPointF(left, inner.bottom() - height), QPointF(left, layout.scale.top() - kFurnitureGap - height)});
    layout.legendGroups = layout.legend ? count : 0;
  }
}

}  // namespace

std::vector<QRectF> ChartLayout::boxes() const {
  std::vector<QRectF> all{scale};
  for (const std::optional<QRectF>* box : {&message, &wind, &legend, &north}) {
    if (*box) {
      all.push_back(**box);
    }
  }
  return all;
}

ChartLayout layOutChart(QSizeF map, const FurnitureSizes& sizes) {
  Room room(map);
  const QRectF& inner = room.inner();
  ChartLayout layout;
  layout.scale = QRectF(QPointF(inner.left(), inner.bottom() - sizes.scale.height()), sizes.scale);
  room.take(layout.scale);
  if (sizes.message) {
    layout.message = room.firstFree(*sizes.message, std::array{QPointF(inner.center().x() - 0.5 * sizes.message->width(), inner.top())});
  }
  const double below = layout.message ? layout.message->bottom() + kFurnitureGap : inner.top();
  if (sizes.wind) {
    layout.wind = room.firstFree(*sizes.wind, std::array{inner.topLeft(), QPointF(inner.left(), below)});
  }
  placeLegend(layout, room, sizes, map.width() * map.height());
  const double left = inner.right() - sizes.north.width();
  layout.north = room.firstFree(sizes.north, std::array{QPointF(left, inner.top()), QPointF(left, below)});
  return layout;
}

}  // namespace vp::map
