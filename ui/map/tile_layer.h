#pragma once

#include "ui/document/mailbox.h"
#include "ui/map/map_camera.h"
#include "ui/map/tile_painter.h"

#include <QImage>
#include <QObject>
#include <QRunnable>
#include <QThreadPool>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

class QPainter;

namespace vp::map {

/** A layer of the map made of tiles that are painted on worker threads and kept while there is room.
 *
 *  draw() never waits: where a tile is not there yet it shows what is known of the place (the tile of the painter
 *  before, tiles of other scales, a picture of the whole), asks for the right one and says tilesArrived() when to draw again.
 *  drawNow() paints everything in place. Both give the same pixels.
 *  @threads GUI thread (or one thread with an event loop); the painter runs on others */
class TileLayer : public QObject {
  Q_OBJECT

public:
  static constexpr int kTileSize = 256;  ///< device pixels

  enum class OldTiles {
    Keep,  ///< shown until the new ones are there: same place, new style
    Drop,  ///< another place
  };

  /** @param megabytes  of tiles kept at most; what is in view stays in any case */
  explicit TileLayer(int megabytes, QObject* parent = nullptr);
  ~TileLayer() override;

  /** @param painter  null: the layer shows nothing */
  void setPainter(std::shared_ptr<const TilePainter> painter, OldTiles old);
  [[nodiscard]] const std::shared_ptr<const TilePainter>& painter() const { return painter_; }

  /** Draws what is there, at whole device pixels, and asks for the rest, nearest to the middle first. */
  void draw(QPainter& painter, const MapCamera& camera, double devicePixelRatio);
  /** Draws everything, painting in this thread. */
  static void drawNow(QPainter& painter, const TilePainter& tiles, const MapCamera& camera, double devicePixelRatio);

  [[nodiscard]] bool isComplete() const { return complete_; }  ///< nothing was missing in the last draw()
  [[nodiscard]] std::size_t keptBytes() const { return bytes_; }
  [[nodiscard]] std::size_t keptTiles() const { return tiles_.size(); }

signals:
  void tilesArrived();

private:
  struct Key {
    double metresPerPixel = 0.0;
    std::int64_t column = 0;
    std::int64_t row = 0;
    bool operator==(const Key&) const = default;
    [[nodiscard]] PixelWindow window() const;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Tile {
    QImage image;
    std::uint64_t generation = 0;
    std::uint64_t lastUsed = 0;
  };
  struct Painted {
    Key key;
    QImage image;
    std::uint64_t generation = 0;
  };

  void request(std::vector<Key> wanted);
  void work();
  void takePainted();
  void evict();
  void wantParents(const PixelWindow& window, std::vector<Key>& wanted);
  void drawStandIn(QPainter& painter, const Key& key, QPointF at);
  void drawScaled(QPainter& painter, const Key& key, QPointF at, double scale);

  std::shared_ptr<const TilePainter> painter_;
  std::vector<std::weak_ptr<const TilePainter>> former_;  ///< may still be at work
  std::uint64_t generation_ = 0;
  std::uint64_t frame_ = 0;
  std::unordered_map<Key, Tile, KeyHash> tiles_;
  std::size_t limit_;
  std::size_t bytes_ = 0;
  bool complete_ = true;
  double devicePixelRatio_ = 1.0;

  std::mutex mutex_;  ///< guards what follows
  std::vector<Key> queue_;
  std::vector<Key> inWork_;
  std::vector<Painted> painted_;
  std::shared_ptr<const TilePainter> workPainter_;
  std::uint64_t workGeneration_ = 0;
  double workPixelRatio_ = 1.0;
  int workers_ = 0;
  std::atomic<bool> stopping_ = false;
  struct Painting : QRunnable {
    explicit Painting(TileLayer& of) : layer(of) { setAutoDelete(false); }
    void run() override { layer.work(); }
    TileLayer& layer;
  };
  Painting painting_{*this};  ///< the same for all threads of the pool
  document::Mailbox mailbox_;
  QThreadPool pool_;
};

}  // namespace vp::map
