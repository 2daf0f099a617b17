#pragma once

#include "core/landing/site_roadmaps.h"
#include "ui/document/mailbox.h"

#include <QObject>

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace vp::panels {

/** Asks SiteRoadmaps on a thread of its own. Only the last question counts: an older one is stopped or dropped, and its
 *  answer never arrives. @threads members are called from the GUI thread, which never waits but in the destructor (some ms) */
class AlternativesWorker : public QObject {
  Q_OBJECT

public:
  struct Question {
    std::shared_ptr<landing::SiteRoadmaps> source;
    geo::Pose pose;
    double altitude = 0.0;  ///< m MSL
    int most = 0;
  };

  explicit AlternativesWorker(QObject* parent = nullptr);
  ~AlternativesWorker() override;

  void ask(Question question);
  /** Stops what runs; no answer comes until the next question. */
  void cancel();

signals:
  void answered(const std::vector<vp::landing::SiteAnswer>& answers);
  void failed(const QString& reason);

private:
  using Answer = Result<std::vector<landing::SiteAnswer>>;
  void run(const std::stop_token& end);
  void deliver(std::uint64_t number, const Answer& result);

  document::Mailbox mailbox_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Question> next_;
  std::stop_source running_;
  std::uint64_t number_ = 0;  ///< of the last question
  std::jthread thread_;
};

}  // namespace vp::panels
