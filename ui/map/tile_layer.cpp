#include "ui/map/tile_layer.h"

#include <QMetaObject>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vp::map {
namespace {

constexpr int kRing = 1;                  // tiles around the view that are painted ahead, for panning
constexpr int kParentScale = 4;           // tiles this many times coarser are kept too: a stand-in for panning far and zooming out
constexpr double kFarthestStandIn = 5.0;  // octaves of scale

/// The part of the frame's raster that a camera shows, at whole device pixels.
PixelWindow windowOf(const MapCamera& camera, double devicePixelRatio) {
  PixelWindow window;
  window.metresPerPixel = camera.metresPerPixel() / devicePixelRatio;
  window.width = static_cast<int>(std::ceil(camera.size().width() * devicePixelRatio));
  window.height = static_cast<int>(std::ceil(camera.size().height() * devicePixelRatio));
  window.left = std::llround(camera.centre().x / window.metresPerPixel - camera.size().width() * devicePixelRatio / 2.0);
  window.top = std::llround(-camera.centre().y / window.metresPerPixel - camera.size().height() * devicePixelRatio / 2.0);
  return window;
}

std::int64_t tileOf(std::int64_t pixel) {
  return pixel >= 0 ? pixel / TileLayer::kTileSize : -((-pixel + TileLayer::kTileSize - 1) / TileLayer::kTileSize);
}

bool overlap(const geo::Box& a, const geo::Box& b) {
  return a.minX < b.maxX && b.minX < a.maxX && a.minY < b.maxY && b.minY < a.maxY;
}

}  // namespace

PixelWindow TileLayer::Key::window() const {
  return {column * kTileSize, row * kTileSize, kTileSize, kTileSize, metresPerPixel};
}

std::size_t TileLayer::KeyHash::operator()(const Key& key) const {
  std::size_t hash = std::hash<double>()(key.metresPerPixel);
  for (const std::int64_t part : {key.column, key.row}) {
    hash ^= std::hash<std::int64_t>()(part) + 0x9E3779B97F4A7C15ULL + (hash << 6U) + (hash >> 2U);
  }
  return hash;
}

TileLayer::TileLayer(int megabytes, QObject* parent) : QObject(parent), limit_(static_cast<std::size_t>(megabytes) << 20U) {
  pool_.setMaxThreadCount(std::max(1, QThread::idealThreadCount() - 1));
  pool_.setThreadPriority(QThread::LowPriority);
}

TileLayer::~TileLayer() {
  stopping_ = true;
  setPainter(nullptr, OldTiles::Drop);
  for (const std::weak_ptr<const TilePainter>& former : former_) {
    if (const auto painter = former.lock()) {
      painter->abandon();
    }
  }
  pool_.clear();
  pool_.waitForDone();
  const std::lock_guard lock(mutex_);  // the last word of each worker came under it
}

void TileLayer::setPainter(std::shared_ptr<const TilePainter> painter, OldTiles old) {
  std::erase_if(former_, [](const auto& former) { return former.expired(); });
  if (painter_ != nullptr) {
    former_.push_back(painter_);
  }
  painter_ = std::move(painter);
  ++generation_;
  if (old == OldTiles::Drop || painter_ == nullptr) {
    tiles_.clear();
    bytes_ = 0;
  }
  const std::lock_guard lock(mutex_);
  queue_.clear();
  painted_.clear();
  workPainter_ = painter_;
  workGeneration_ = generation_;
}

void TileLayer::drawNow(QPainter& painter, const TilePainter& tiles, const MapCamera& camera, double devicePixelRatio) {
  painter.save();
  painter.scale(1.0 / devicePixelRatio, 1.0 / devicePixelRatio);
  painter.drawImage(QPointF(0.0, 0.0), tiles.paint(windowOf(camera, devicePixelRatio), devicePixelRatio));
  painter.restore();
}

void TileLayer::draw(QPainter& painter, const MapCamera& camera, double devicePixelRatio) {
  complete_ = true;
  if (painter_ == nullptr) {
    return;
  }
  ++frame_;
  if (devicePixelRatio != devicePixelRatio_) {
    devicePixelRatio_ = devicePixelRatio;
    setPainter(painter_, OldTiles::Keep);
  }
  const PixelWindow window = windowOf(camera, devicePixelRatio);
  const geo::Box extent = painter_->extent();
  std::vector<Key> missing;
  std::vector<Key> ahead;
  painter.save();
  painter.scale(1.0 / devicePixelRatio, 1.0 / devicePixelRatio);
  const std::int64_t west = tileOf(window.left);
  const std::int64_t east = tileOf(window.left + window.width - 1);
  const std::int64_t north = tileOf(window.top);
  const std::int64_t south = tileOf(window.top + window.height - 1);
  for (std::int64_t row = north - kRing; row <= south + kRing; ++row) {
    for (std::int64_t column = west - kRing; column <= east + kRing; ++column) {
      const Key key{window.metresPerPixel, column, row};
      if (!extent.isEmpty() && !overlap(extent, key.window().box())) {
        continue;
      }
      const bool isInView = row >= north && row <= south && column >= west && column <= east;
      const auto found = tiles_.find(key);
      const bool isRight = found != tiles_.end() && found->second.generation == generation_;
      if (!isRight) {
        (isInView ? missing : ahead).push_back(key);
      }
      if (!isInView) {
        continue;
      }
      const QPointF at(static_cast<double>(column * kTileSize - window.left), static_cast<double>(row * kTileSize - window.top));
      if (found != tiles_.end()) {
        found->second.lastUsed = frame_;
        painter.drawImage(at, found->second.image);
      } else {
        drawStandIn(painter, key, at);
      }
    }
  }
  painter.restore();
  complete_ = missing.empty();
  const double middleColumn = (static_cast<double>(window.left) + 0.5 * window.width) / kTileSize - 0.5;
  const double middleRow = (static_cast<double>(window.top) + 0.5 * window.height) / kTileSize - 0.5;
  std::stable_sort(missing.begin(), missing.end(), [&](const Key& a, const Key& b) {
    const auto away = [&](const Key& key) {
      return std::hypot(static_cast<double>(key.column) - middleColumn, static_cast<double>(key.row) - middleRow);
    };
    return away(a) < away(b);
  });
  wantParents(window, missing);
  missing.insert(missing.end(), ahead.begin(), ahead.end());
  request(std::move(missing));
}

void TileLayer::wantParents(const PixelWindow& window, std::vector<Key>& wanted) {
  const geo::Box extent = painter_->extent();
  const auto parent = [](std::int64_t pixel) { return tileOf(pixel >= 0 ? pixel / kParentScale : -((-pixel + kParentScale - 1) / kParentScale)); };
  for (std::int64_t row = parent(window.top); row <= parent(window.top + window.height - 1); ++row) {
    for (std::int64_t column = parent(window.left); column <= parent(window.left + window.width - 1); ++column) {
      const Key key{window.metresPerPixel * kParentScale, column, row};
      const auto found = tiles_.find(key);
      if (found != tiles_.end() && found->second.generation == generation_) {
        found->second.lastUsed = frame_;
      } else if (extent.isEmpty() || overlap(extent, key.window().box())) {
        wanted.push_back(key);
      }
    }
  }
}

void TileLayer::drawStandIn(QPainter& painter, const Key& key, QPointF at) {
  const geo::Box box = key.window().box();
  // tiles of the two nearest other scales that show a part of this place, the nearer on top
  double scale = 0.0;
  double below = 0.0;
  double nearest = kFarthestStandIn;
  double second = kFarthestStandIn;
  for (const auto& [other, tile] : tiles_) {
    const double octaves = std::abs(std::log2(other.metresPerPixel / key.metresPerPixel));
    if (octaves == 0.0 || octaves >= second || other.metresPerPixel == scale || !overlap(box, other.window().box())) {
      continue;
    }
    if (octaves < nearest) {
      second = nearest;
      below = scale;
      nearest = octaves;
      scale = other.metresPerPixel;
    } else {
      second = octaves;
      below = other.metresPerPixel;
    }
  }
  for (const double from : {below, scale}) {
    if (from > 0.0) {
      drawScaled(painter, key, at, from);
    }
  }
}

void TileLayer::drawScaled(QPainter& painter, const Key& key, QPointF at, double scale) {
  const geo::Box box = key.window().box();
  const PixelWindow in = key.window();
  for (auto& [other, tile] : tiles_) {
    const PixelWindow from = other.window();
    const geo::Box has = from.box();
    if (other.metresPerPixel != scale || !overlap(box, has)) {
      continue;
    }
    tile.lastUsed = frame_;
    const double minX = std::max(box.minX, has.minX);
    const double maxX = std::min(box.maxX, has.maxX);
    const double minY = std::max(box.minY, has.minY);
    const double maxY = std::min(box.maxY, has.maxY);
    const auto inWindow = [&](const PixelWindow& w) {
      return QRectF(QPointF(minX / w.metresPerPixel - static_cast<double>(w.left), -maxY / w.metresPerPixel - static_cast<double>(w.top)),
                    QPointF(maxX / w.metresPerPixel - static_cast<double>(w.left), -minY / w.metresPerPixel - static_cast<double>(w.top)));
    };
    painter.drawImage(inWindow(in).translated(at), tile.image, inWindow(from));
  }
}

void TileLayer::request(std::vector<Key> wanted) {
  const std::lock_guard lock(mutex_);
  std::erase_if(wanted, [this](const Key& key) { return std::find(inWork_.begin(), inWork_.end(), key) != inWork_.end(); });
  queue_ = std::move(wanted);
  workPixelRatio_ = devicePixelRatio_;
  const int useful = std::min(pool_.maxThreadCount(), static_cast<int>(queue_.size()));
  for (; workers_ < useful; ++workers_) {
    pool_.start(&painting_);
  }
}

void TileLayer::work() {
  while (true) {
    Key key;
    std::shared_ptr<const TilePainter> painter;
    std::uint64_t generation = 0;
    double pixelRatio = 1.0;
    {
      const std::lock_guard lock(mutex_);
      if (stopping_ || queue_.empty() || workPainter_ == nullptr) {
        --workers_;
        return;
      }
      key = queue_.front();
      queue_.erase(queue_.begin());
      inWork_.push_back(key);
      painter = workPainter_;
      generation = workGeneration_;
      pixelRatio = workPixelRatio_;
    }
    QImage image = painter->paint(key.window(), pixelRatio);
    const std::lock_guard lock(mutex_);
    std::erase(inWork_, key);
    if (generation == workGeneration_) {
      painted_.push_back({key, std::move(image), generation});
    }
    if (painted_.size() <= 1 && !stopping_) {
      mailbox_.post([this] { takePainted(); });
    }
  }
}

void TileLayer::takePainted() {
  std::vector<Painted> painted;
  {
    const std::lock_guard lock(mutex_);
    painted.swap(painted_);
  }
  for (Painted& next : painted) {
    Tile& tile = tiles_[next.key];
    bytes_ -= static_cast<std::size_t>(tile.image.sizeInBytes());
    tile = {std::move(next.image), next.generation, frame_};
    bytes_ += static_cast<std::size_t>(tile.image.sizeInBytes());
  }
  evict();
  emit tilesArrived();
}

void TileLayer::evict() {
  if (bytes_ <= limit_) {
    return;
  }
  std::vector<std::pair<std::uint64_t, Key>> byAge;
  for (const auto& [key, tile] : tiles_) {
    if (tile.lastUsed < frame_) {
      byAge.emplace_back(tile.lastUsed, key);
    }
  }
  std::sort(byAge.begin(), byAge.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  // to three quarters, so that this does not run with every tile
  for (auto next = byAge.begin(); next != byAge.end() && bytes_ > limit_ - limit_ / 4; ++next) {
    const auto tile = tiles_.find(next->second);
    bytes_ -= static_cast<std::size_t>(tile->second.image.sizeInBytes());
    tiles_.erase(tile);
  }
}

}  // namespace vp::map
