#include "ui/scene3d/render_thread.h"

#include "ui/document/mailbox.h"
#include "ui/style/core_text.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <stop_token>
#include <thread>

namespace vp::scene3d {

class RenderThread::Private {
public:
  using Task = std::function<void(OffscreenScene&)>;

  explicit Private(RenderThread& owner) : owner_(owner) {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  void post(Task task) {
    {
      const std::lock_guard lock(mutex_);
      tasks_.push_back(std::move(task));
    }
    wake_.notify_one();
  }

  /// Runs something in the GUI thread, after all that is connected by then.
  template <typename Action>
  void tell(Action action) {
    mailbox_.post(std::move(action));
  }

  RenderThread& owner_;

private:
  void run(const std::stop_token& stop) {
    auto scene = OffscreenScene::create();
    if (!scene) {
      tell([this, reason = style::coreText(scene.error())] { emit owner_.failed(reason); });
    } else {
      tell([this, name = (*scene)->rendererName()] { emit owner_.started(name); });
    }
    while (true) {
      Task task;
      {
        std::unique_lock lock(mutex_);
        if (!wake_.wait(lock, stop, [this] { return !tasks_.empty(); })) {
          return;
        }
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      if (scene && !stop.stop_requested()) {
        task(**scene);
      }
    }
  }

  document::Mailbox mailbox_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Task> tasks_;
  std::jthread thread_;
};

RenderThread::RenderThread(QObject* parent) : QObject(parent), d_(std::make_unique<Private>(*this)) {}

RenderThread::~RenderThread() = default;

void RenderThread::post(std::function<void(SceneRenderer&)> task) {
  d_->post([task = std::move(task)](OffscreenScene& scene) { task(scene.renderer()); });
}

void RenderThread::draw(const CameraState& camera, double pixelRatio, bool isSmooth) {
  d_->post([this, camera, pixelRatio, isSmooth](OffscreenScene& scene) {
    const auto start = std::chrono::steady_clock::now();
    bool isComplete = false;
    const QImage picture = scene.render(camera, pixelRatio, isSmooth, false, &isComplete);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    d_->tell([=, this] { emit pictureReady(picture, isComplete, isSmooth, taken.count()); });
  });
}

}  // namespace vp::scene3d
