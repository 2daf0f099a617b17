#include "ui/scene3d/label_placement.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::scene3d {
namespace {

constexpr std::size_t kMostTexts = 80;  // more cannot be read
constexpr double kBehindGround = 0.4;   // opacity

struct Candidate {
  const AtlasItem* item = nullptr;
  int atlas = 0;
  Vec3 place;
  ScreenPoint at;
};

QRectF rectOf(const Candidate& candidate, const AtlasPiece& piece, const CameraState& camera) {
  // whole pixels: texts stay sharp
  const double left = std::clamp(candidate.at.x - 0.5 * piece.size.width(), 2.0, std::max(2.0, camera.width - piece.size.width() - 2.0));
  const double top = std::max(candidate.at.y - candidate.item->lift - piece.size.height(), 2.0);
  return {std::round(left), std::round(top), piece.size.width(), piece.size.height()};
}

PlacedLabel uprightAt(const AtlasPiece& piece, const QRectF& rect, double opacity) {
  return {0, &piece, {{{rect.left(), rect.top()}, {rect.right(), rect.top()}, {rect.right(), rect.bottom()}, {rect.left(), rect.bottom()}}}, opacity};
}

/// A symbol about its anchor, an aircraft turned the way that its heading appears.
PlacedLabel symbolAt(const Candidate& candidate, const CameraState& camera, double opacity) {
  const AtlasPiece& piece = candidate.item->full;
  double angle = 0.0;  // of the nose, clockwise from up on the picture
  if (candidate.item->shape == AtlasItem::Shape::Aircraft) {
    const double ahead = 0.02 * candidate.at.depth;
    const Vec3 nose = candidate.place + ahead * Vec3{std::cos(candidate.item->heading), std::sin(candidate.item->heading), 0.0};
    if (const auto to = camera.project(nose)) {
      angle = std::atan2(to->x - candidate.at.x, candidate.at.y - to->y);
    }
  }
  const double w = 0.5 * piece.size.width();
  const double h = 0.5 * piece.size.height();
  PlacedLabel placed{0, &piece, {}, opacity};
  const std::array<std::array<double, 2>, 4> offsets{{{-w, -h}, {w, -h}, {w, h}, {-w, h}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [x, y] = offsets[k];
    placed.corners[k] = {candidate.at.x + x * std::cos(angle) - y * std::sin(angle), candidate.at.y + x * std::sin(angle) + y * std::cos(angle)};
  }
  return placed;
}

}  // namespace

std::vector<PlacedLabel> placeLabels(const std::vector<const LabelAtlas*>& atlases, const CameraState& camera, double exaggeration,
                                     const std::vector<QRectF>& reserved, const std::function<bool(Vec3)>& isClear) {
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < atlases.size(); ++a) {
    for (const AtlasItem& item : atlases[a]->items) {
      const Vec3 place{item.anchor.x, item.anchor.y, item.anchor.z * exaggeration};
      const auto at = camera.project(place);
      if (at && at->depth < item.showWithin && at->x > 0.0 && at->y > 0.0 && at->x < camera.width && at->y < camera.height) {
        candidates.push_back({&item, static_cast<int>(a), place, *at});
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.item->priority != b.item->priority ? a.item->priority > b.item->priority : a.at.depth < b.at.depth;
  });
  std::vector<PlacedLabel> placed;
  std::vector<QRectF> taken = reserved;
  const auto isFree = [&](const QRectF& rect) {
    return std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(rect); });
  };
  for (const Candidate& candidate : candidates) {
    const AtlasItem& item = *candidate.item;
    const bool isSymbol = item.shape != AtlasItem::Shape::Text;
    if (!isSymbol && taken.size() >= kMostTexts + reserved.size()) {
      continue;
    }
    std::optional<QRectF> rect;
    const AtlasPiece* piece = &item.full;
    if (!isSymbol) {
      for (const AtlasPiece* choice : {&item.full, &item.brief}) {
        if (!rect && !choice->size.isEmpty() && isFree(rectOf(candidate, *choice, camera))) {
          rect = rectOf(candidate, *choice, camera);
          piece = choice;
        }
      }
      if (!rect) {
        continue;
      }
    }
    const bool isVisible = isClear(candidate.place);
    if (!isVisible && !item.isFaintBehindGround) {
      continue;
    }
    const double opacity = isVisible ? 1.0 : kBehindGround;
    if (rect) {
      taken.push_back(*rect);
    }
    if (item.shape == AtlasItem::Shape::Aircraft) {
      const double half = 0.35 * piece->size.width();
      taken.emplace_back(candidate.at.x - half, candidate.at.y - half, 2.0 * half, 2.0 * half);
    }
    placed.push_back(rect ? uprightAt(*piece, *rect, opacity) : symbolAt(candidate, camera, opacity));
    placed.back().atlas = candidate.atlas;
  }
  return placed;
}

}  // namespace vp::scene3d
