#include "ui/scene3d/scene_worker.h"

#include "ui/document/mailbox.h"

#include <QDebug>

#include <array>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace vp::scene3d {
namespace {

/// What a layer of terrain calls when a tile is there; cut off when the worker that made it ends.
class TileBell {
public:
  explicit TileBell(std::function<void()> ring) : ring_(std::move(ring)) {}
  void ring() {
    const std::lock_guard lock(mutex_);
    if (ring_) {
      ring_();
    }
  }
  void cut() {
    const std::lock_guard lock(mutex_);
    ring_ = nullptr;
  }

private:
  std::mutex mutex_;
  std::function<void()> ring_;
};

}  // namespace

class SceneWorker::Private {
public:
  using Task = std::function<void(const std::stop_token&)>;
  enum Kind : std::size_t { TerrainKind, SceneKind, CursorKind, KindCount };

  explicit Private(std::function<void()> tileReady) : bell_(std::make_shared<TileBell>(std::move(tileReady))) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~Private() {
    bell_->cut();
    {
      const std::lock_guard lock(mutex_);
      for (std::stop_source& source : sources_) {
        source.request_stop();
      }
    }
    thread_.request_stop();
    thread_.join();
  }
  Private(const Private&) = delete;
  Private& operator=(const Private&) = delete;
  Private(Private&&) = delete;
  Private& operator=(Private&&) = delete;

  void post(Kind kind, Task task) {
    {
      const std::lock_guard lock(mutex_);
      sources_[kind].request_stop();
      sources_[kind] = std::stop_source();
      tasks_[kind] = std::move(task);
    }
    wake_.notify_one();
  }

  bool isBusy() {
    const std::lock_guard lock(mutex_);
    return isRunning_ || tasks_[TerrainKind] || tasks_[SceneKind] || tasks_[CursorKind];
  }

  /// Hands a result to the GUI thread unless it is no longer wanted when it gets there.
  template <typename Deliver>
  void deliver(const std::stop_token& stop, Deliver deliver) {
    mailbox_.post([stop, deliver = std::move(deliver)] {
      if (!stop.stop_requested()) {
        deliver();
      }
    });
  }

  std::shared_ptr<TileBell> bell_;
  std::shared_ptr<const TerrainModel> model_;  ///< used by tasks only

private:
  void run(const std::stop_token& stop) {
    while (true) {
      Task task;
      std::stop_token taskStop;
      {
        std::unique_lock lock(mutex_);
        isRunning_ = false;
        const auto hasTask = [this] { return tasks_[TerrainKind] || tasks_[SceneKind] || tasks_[CursorKind]; };
        if (!wake_.wait(lock, stop, hasTask)) {
          return;
        }
        for (std::size_t kind = 0; kind < KindCount && !task; ++kind) {
          task = std::exchange(tasks_[kind], nullptr);
          taskStop = sources_[kind].get_token();
        }
        isRunning_ = true;
      }
      try {
        task(taskStop);
      } catch (const std::exception& e) {  // a bug, or no memory: the scene stays as it was
        qWarning("3D scene: %s", e.what());
      }
    }
  }

  document::Mailbox mailbox_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::array<Task, KindCount> tasks_;
  std::array<std::stop_source, KindCount> sources_;
  bool isRunning_ = false;
  std::jthread thread_;
};

SceneWorker::SceneWorker(std::function<void()> tileReady, QObject* parent) : QObject(parent), d_(std::make_unique<Private>(std::move(tileReady))) {}

SceneWorker::~SceneWorker() = default;

void SceneWorker::buildTerrain(std::shared_ptr<const document::TerrainData> terrain, const SceneStyle& style) {
  d_->post(Private::TerrainKind, [this, terrain = std::move(terrain), style](const std::stop_token& stop) {
    Terrain result;
    const bool isDrawable = terrain != nullptr && terrain->grid->columns() >= 2 && terrain->grid->rows() >= 2;
    if (isDrawable) {
      const bool isSame = d_->model_ != nullptr && &d_->model_->terrain() == terrain.get();
      result.model = isSame ? d_->model_ : TerrainModel::build(terrain, stop);
      if (result.model == nullptr) {
        return;  // stopped
      }
      result.layer = std::make_shared<TerrainLayer>(result.model, style, [bell = d_->bell_] { bell->ring(); });
    }
    d_->model_ = result.model;
    d_->deliver(stop, [this, result] { emit terrainReady(result); });
  });
}

void SceneWorker::buildScene(const document::Situation& situation, const SceneOptions& options, const SceneStyle& style, double labelRatio) {
  d_->post(Private::SceneKind, [=, this](const std::stop_token& stop) {
    const bool standsOnIt = d_->model_ != nullptr && &d_->model_->terrain() == situation.terrain.get();
    const auto scene = scene3d::buildScene(situation, standsOnIt ? d_->model_ : nullptr, options, style, stop);
    if (!scene) {
      return;
    }
    const Scene result{buildSceneNodes(*scene, labelRatio), scene->altitudes};
    d_->deliver(stop, [this, result] { emit sceneReady(result); });
  });
}

void SceneWorker::buildCursor(const document::Situation& situation, std::optional<double> distance, int selectedTarget, const SceneStyle& style,
                              double labelRatio) {
  d_->post(Private::CursorKind, [=, this](const std::stop_token&) {
    const bool standsOnIt = d_->model_ != nullptr && &d_->model_->terrain() == situation.terrain.get();
    auto nodes = buildSceneNodes(buildCursorScene(situation, standsOnIt ? d_->model_ : nullptr, distance, selectedTarget, style), labelRatio);
    // shown even if the cursor has moved on: while it keeps moving something must follow it
    d_->deliver({}, [this, nodes = std::move(nodes)] { emit cursorReady(nodes); });
  });
}

bool SceneWorker::isBusy() const {
  return d_->isBusy();
}

}  // namespace vp::scene3d
