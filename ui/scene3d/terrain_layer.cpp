#include "ui/scene3d/terrain_layer.h"

#include "ui/scene3d/terrain_nodes.h"

#include <osg/Group>

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace vp::scene3d {
namespace {

constexpr int kCoarseLevels = 4;          // always kept
constexpr std::size_t kNewPerFrame = 16;  // uploads of pictures that a frame can bear

}  // namespace

class TerrainLayer::Private {
public:
  Private(std::shared_ptr<const TerrainModel> model, const SceneStyle& style, std::function<void()> tileReady)
      : model_(std::move(model)),
        theme_(style.theme),
        palette_(style.theme, model_->lowest(), model_->highest(), contourInterval(model_->lowest(), model_->highest(), style.units)),
        tileReady_(std::move(tileReady)) {
    root_ = keep(new osg::Group);
    tiles_ = keep(new osg::Group);
    lids_ = keep(new osg::Group);
    setTerrainState(*root_);
    setLidState(*lids_, *model_, theme_);
    root_->addChild(tiles_.get());
    root_->addChild(lids_.get());
    root_->addChild(buildBaseNode(*model_, theme_).get());
    for (int level = model_->levels() - 1; level >= std::max(0, model_->levels() - kCoarseLevels); --level) {
      for (int row = 0; row < model_->tileRows(level); ++row) {
        for (int column = 0; column < model_->tileColumns(level); ++column) {
          const TileId tile{level, column, row};
          kept_[tile] = {buildTileNodes(*model_, palette_, tile, theme_), 0, true};
        }
      }
    }
    const unsigned int workers = std::clamp(std::thread::hardware_concurrency() / 2, 1U, 4U);
    for (unsigned int i = 0; i < workers; ++i) {
      workers_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
  }

  ~Private() {
    for (std::jthread& worker : workers_) {
      worker.request_stop();
    }
    workers_.clear();  // before what they use
  }
  Private(const Private&) = delete;
  Private& operator=(const Private&) = delete;
  Private(Private&&) = delete;
  Private& operator=(Private&&) = delete;

  bool update(const CameraState& camera, double exaggeration, const TerrainDetail& detail, bool wait) {
    ++frame_;
    std::size_t left = takeFinished(wait ? kMostTiles : kNewPerFrame);
    const auto choose = [&] { return chooseTiles(*model_, camera, exaggeration, detail, [this](TileId tile) { return kept_.contains(tile); }); };
    TileChoice choice = choose();
    while (wait && !choice.wanted.empty()) {
      for (const TileId& tile : choice.wanted) {
        kept_[tile] = {buildTileNodes(*model_, palette_, tile, theme_), frame_, false};
      }
      choice = choose();
    }
    show(choice.shown);
    {
      const std::lock_guard lock(mutex_);
      wanted_ = choice.wanted;
      left += finished_.size();
    }
    wake_.notify_all();
    if (left > 0 && tileReady_) {
      tileReady_();  // more than one frame can take
    }
    forgetOld();
    return choice.wanted.empty() && left == 0;
  }

  void releaseContext() {
    root_->releaseGLObjects();
    for (const auto& [tile, kept] : kept_) {
      kept.nodes.ground->releaseGLObjects();
      if (kept.nodes.lids != nullptr) {
        kept.nodes.lids->releaseGLObjects();
      }
    }
  }

  std::shared_ptr<const TerrainModel> model_;
  GroupPointer root_;
  std::size_t shownCount_ = 0;
  [[nodiscard]] std::size_t keptCount() const { return kept_.size(); }

private:
  struct Kept {
    TileNodes nodes;
    std::uint64_t lastFrame = 0;
    bool isFixed = false;
  };

  void work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      TileId tile;
      {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, stop, [&] { return nextWanted(tile); })) {
          return;
        }
        underWay_.insert(tile);
      }
      TileNodes nodes = buildTileNodes(*model_, palette_, tile, theme_);
      {
        const std::lock_guard lock(mutex_);
        finished_.emplace_back(tile, std::move(nodes));
      }
      if (tileReady_) {
        tileReady_();
      }
    }
  }

  /// The first wanted tile that no worker has taken. @pre mutex_ is held
  bool nextWanted(TileId& tile) {
    const auto next = std::find_if(wanted_.begin(), wanted_.end(), [this](TileId t) { return !underWay_.contains(t); });
    if (next == wanted_.end()) {
      return false;
    }
    tile = *next;
    wanted_.erase(next);
    return true;
  }

  /// @return how many are left for the next frame
  std::size_t takeFinished(std::size_t most) {
    const std::lock_guard lock(mutex_);
    const std::size_t count = std::min(most, finished_.size());
    for (std::size_t i = 0; i < count; ++i) {
      underWay_.erase(finished_[i].first);
      kept_.try_emplace(finished_[i].first, Kept{std::move(finished_[i].second), frame_, false});
    }
    finished_.erase(finished_.begin(), finished_.begin() + static_cast<std::ptrdiff_t>(count));
    return finished_.size();
  }

  void show(const std::vector<TileId>& tiles) {
    tiles_->removeChildren(0, tiles_->getNumChildren());
    lids_->removeChildren(0, lids_->getNumChildren());
    for (const TileId& tile : tiles) {
      Kept& kept = kept_.at(tile);
      kept.lastFrame = frame_;
      tiles_->addChild(kept.nodes.ground.get());
      if (kept.nodes.lids != nullptr) {
        lids_->addChild(kept.nodes.lids.get());
      }
    }
    shownCount_ = tiles.size();
  }

  void forgetOld() {
    if (kept_.size() <= kMostTiles) {
      return;
    }
    std::vector<std::uint64_t> ages;
    for (const auto& [tile, kept] : kept_) {
      ages.push_back(kept.lastFrame);
    }
    const auto cut = ages.begin() + static_cast<std::ptrdiff_t>(ages.size() - kMostTiles * 3 / 4);
    std::nth_element(ages.begin(), cut, ages.end());
    const std::uint64_t oldest = std::min(*cut, frame_);
    std::erase_if(kept_, [&](const auto& entry) { return !entry.second.isFixed && entry.second.lastFrame < oldest; });
  }

  style::Theme theme_;
  TerrainPalette palette_;
  std::function<void()> tileReady_;
  GroupPointer tiles_;
  GroupPointer lids_;
  std::map<TileId, Kept> kept_;
  std::uint64_t frame_ = 0;

  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::vector<TileId> wanted_;
  std::set<TileId> underWay_;
  std::vector<std::pair<TileId, TileNodes>> finished_;
  std::vector<std::jthread> workers_;
};

TerrainLayer::TerrainLayer(std::shared_ptr<const TerrainModel> model, const SceneStyle& style, std::function<void()> tileReady)
    : d_(std::make_unique<Private>(std::move(model), style, std::move(tileReady))) {}

TerrainLayer::~TerrainLayer() = default;

const TerrainModel& TerrainLayer::model() const {
  return *d_->model_;
}

osg::Group& TerrainLayer::root() {
  return *d_->root_;
}

bool TerrainLayer::update(const CameraState& camera, double exaggeration, const TerrainDetail& detail, bool wait) {
  return d_->update(camera, exaggeration, detail, wait);
}

void TerrainLayer::releaseContext() {
  d_->releaseContext();
}

std::size_t TerrainLayer::tilesKept() const {
  return d_->keptCount();
}

std::size_t TerrainLayer::tilesShown() const {
  return d_->shownCount_;
}

}  // namespace vp::scene3d
