#include "core/audit/audit.h"

#include "core/audit/tour_points.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <utility>

namespace vp::audit {
namespace {

constexpr double kArrivalPlace = 0.1;        // m, end of a glide to its touchdown point
constexpr double kSitePlace = 0.5;           // m, touchdown point in the frame to its degrees
constexpr double kArrivalHeading = 0.1;      // degrees, to the landing course
constexpr double kReactionTolerance = 0.01;  // m along the path
constexpr double kBankTolerance = 0.1;       // degrees, beyond the profile's steepest glide bank
constexpr double kDegrees = 180.0 / 3.14159265358979323846;

/** Where a sample begins. */
struct Sample {
  std::uint64_t number = 0;
  std::size_t interval = 0;
  double distance = 0.0;  ///< m from the first point of the interval
};

/// Samples in the order of the tour's intervals, so that those of one glide are together. @return fewer if it was stopped
std::vector<Sample> drawSamples(const AuditInput& input, const std::vector<Interval>& intervals, const Job& job) {
  constexpr std::uint64_t kPerPoll = 65536;  // about 3 ms
  const double length = intervals.back().begins + intervals.back().length();
  std::vector<Sample> drawn;
  drawn.reserve(input.samples);
  std::vector<std::size_t> begins(intervals.size() + 1, 0);
  for (std::uint64_t number = 0; number < input.samples; ++number) {
    if (number % kPerPoll == 0 && job.stopRequested()) {
      return {};
    }
    Draws draws(input.seed, 2 * number);
    const double place = draws.unit() * length;
    const auto after = std::upper_bound(intervals.begin(), intervals.end(), place, [](double at, const Interval& one) { return at < one.begins; });
    const Interval& interval = *(after - 1);
    drawn.push_back({number, static_cast<std::size_t>(after - 1 - intervals.begin()), std::min(place - interval.begins, interval.length())});
    ++begins[drawn.back().interval + 1];
  }
  for (std::size_t i = 1; i < begins.size(); ++i) {
    begins[i] += begins[i - 1];
  }
  std::vector<Sample> samples(drawn.size());
  for (const Sample& sample : drawn) {
    samples[begins[sample.interval]++] = sample;
  }
  return samples;
}

/** What one thread found; merged so that the order of threads does not matter. */
struct Findings {
  std::uint64_t unsafe = 0;
  std::vector<UnsafePoint> unsafePoints;
  std::array<std::optional<LeastMargin>, kMarginKinds> least;
  std::uint64_t glides = 0;
  std::uint64_t metresFlown = 0;  // in whole metres of each sample, so that the sum does not depend on its order
  std::uint64_t metresOfGround = 0;
  double steepestBank = 0.0;
  double longest = 0.0;

  void note(std::size_t kind, const LeastMargin& margin) {
    std::optional<LeastMargin>& known = least[kind];
    const bool isLess =
        !known || margin.place.left < known->place.left || (margin.place.left == known->place.left && margin.stop.sample < known->stop.sample);
    if (isLess) {
      known = margin;
    }
  }
  void note(UnsafePoint point) {
    ++unsafe;
    unsafePoints.push_back(std::move(point));
    if (unsafePoints.size() >= 2 * kMostListed) {
      keepFirst();
    }
  }
  void keepFirst() {
    std::sort(unsafePoints.begin(), unsafePoints.end(), [](const UnsafePoint& a, const UnsafePoint& b) { return a.stop.sample < b.stop.sample; });
    unsafePoints.resize(std::min(unsafePoints.size(), kMostListed));
  }
  void add(const Findings& other) {
    unsafe += other.unsafe;
    unsafePoints.insert(unsafePoints.end(), other.unsafePoints.begin(), other.unsafePoints.end());
    for (std::size_t kind = 0; kind < kMarginKinds; ++kind) {
      if (other.least[kind]) {
        note(kind, *other.least[kind]);
      }
    }
    glides += other.glides;
    metresFlown += other.metresFlown;
    metresOfGround += other.metresOfGround;
    steepestBank = std::max(steepestBank, other.steepestBank);
    longest = std::max(longest, other.longest);
  }
};

std::string textOf(MarginKind kind, const LeastPlace& place, const std::string& site) {
  switch (kind) {
    case MarginKind::TourClearance:
      return fmt::format("the tour is {:.2f} m below the clearance here", -place.left);
    case MarginKind::GlideClearance:
      return fmt::format("{:.0f} s after the engine stopped the glide to {} is {:.2f} m below the clearance", place.seconds, site, -place.left);
    case MarginKind::Rolling:
      return fmt::format("{:.0f} s after the engine stopped, what rolling may cost takes the glide to {} {:.2f} m into the ground", place.seconds,
                         site, -place.left);
    case MarginKind::Key:
      return fmt::format("the glide to {} is {:.2f} m too low at the high key", site, -place.left);
    case MarginKind::Arrival:
      return fmt::format("the glide arrives {:.2f} m too low at {}", -place.left, site);
  }
  return "";
}

/** One thread's work: flies samples of one interval after the other. */
class Worker {
public:
  Worker(const AuditInput& input, const std::vector<Interval>& intervals, const AirTable& table, GroundLookup lookup)
      : input_(input), intervals_(intervals), table_(table), lookup_(std::move(lookup)) {
    for (const Angle bank : input.plan.mission.aircraft.glideBanks) {
      mostBank_ = std::max(mostBank_, bank.degrees() + kBankTolerance);
    }
  }

  /** Flies samples of one interval. @return false if it was stopped */
  bool fly(std::span<const Sample> samples, const Job& job);
  [[nodiscard]] const Findings& findings() const { return findings_; }

private:
  PromisedGlide promise(const Interval& interval);
  void flyOne(const Sample& sample, const Interval& interval, const PromisedGlide& glide, double freeWay);
  [[nodiscard]] std::string faultAtSite(const GroundTrack& track, int site) const;

  const AuditInput& input_;
  const std::vector<Interval>& intervals_;
  const AirTable& table_;
  GroundLookup lookup_;
  double mostBank_ = 0.0;  // degrees
  Findings findings_;
};

/// Why a glide does not end at its site; empty if it does.
std::string Worker::faultAtSite(const GroundTrack& track, int site) const {
  const mission::SiteInFrame& wanted = input_.plan.sites[static_cast<std::size_t>(site)];
  const geo::Pose end = track.end();
  if (const double beside = geo::distance(end.point(), wanted.pose.point()); !(beside <= kArrivalPlace)) {
    return fmt::format("its glide ends {:.2f} m from the touchdown point of {}", beside, wanted.site.id);
  }
  if (static_cast<std::size_t>(site) < input_.sitePlaces.size()) {
    const double beside = geo::distance(wanted.pose.point(), input_.sitePlaces[static_cast<std::size_t>(site)]);
    if (!(beside <= kSitePlace)) {
      return fmt::format("the plan has the touchdown point of {} {:.2f} m beside where its degrees are", wanted.site.id, beside);
    }
  }
  const double turned = std::abs(std::remainder(end.heading - wanted.pose.heading, 2.0 * Angle::kPi)) * kDegrees;
  return turned <= kArrivalHeading ? "" : fmt::format("its glide arrives {:.2f} degrees off the landing course of {}", turned, wanted.site.id);
}

/// The glide of the point at the end of an interval.
PromisedGlide Worker::promise(const Interval& interval) {
  PromisedGlide glide;
  const mission::DecisionPoint& point = interval.to();
  const int site = point.witness.site;
  if (site < 0 || static_cast<std::size_t>(site) >= input_.plan.sites.size()) {
    glide.fault = "the plan has no glide from the next point";
    return glide;
  }
  std::optional<GroundTrack> track = cutIntoMetres(point.pose, point.witness.pieces);
  if (!track) {
    glide.fault = "the glide from the next point cannot be flown as it is written";
    return glide;
  }
  glide.track = std::move(*track);
  putGroundUnder(glide.track, lookup_);
  glide.gate = askForClearance(glide.track, input_.plan.mission);
  glide.elevation = input_.plan.sites[static_cast<std::size_t>(site)].site.elevation.metres();
  glide.fault = faultAtSite(glide.track, site);
  if (glide.fault.empty()) {
    glide.fault = faultOfLastPart(glide.track, input_.plan.mission.approach);
  }
  ++findings_.glides;
  findings_.metresOfGround += static_cast<std::uint64_t>(glide.track.length);
  return glide;
}

bool Worker::fly(std::span<const Sample> samples, const Job& job) {
  const Interval& interval = intervals_[samples.front().interval];
  const PromisedGlide glide = promise(interval);
  const double freeWay = firstOwnTurn(interval);
  for (const Sample& sample : samples) {
    if (job.stopRequested()) {
      return false;
    }
    flyOne(sample, interval, glide, freeWay);
  }
  return true;
}

void Worker::flyOne(const Sample& sample, const Interval& interval, const PromisedGlide& glide, double freeWay) {
  const mission::Plan& plan = input_.plan;
  const mission::DecisionPoint& from = interval.from();
  const double part = sample.distance / interval.length();
  const double altitude = from.altitude + part * (interval.to().altitude - from.altitude);
  // the way to the stop, then the way from there to the next point
  const flight::Piece& onward = from.onward;
  const std::optional<GroundTrack> gone = cutIntoMetres(from.pose, {{onward.turn, onward.radius, sample.distance}});
  std::optional<GroundTrack> rest;
  if (gone) {
    rest = cutIntoMetres(gone->end(), {{onward.turn, onward.radius, interval.length() - sample.distance}});
  }
  const int site = interval.to().witness.site;
  EngineStop stop{sample.number, interval.track, interval.number, from.pose.point(), altitude, {}, 0.0, site};
  if (!rest) {
    findings_.note(UnsafePoint{stop, {0.0, stop.where, altitude, 0.0}, "the tour cannot be flown as it is written"});
    return;
  }
  stop.where = rest->start.point();
  putGroundUnder(*rest, lookup_);
  Draws draws(input_.seed, 2 * sample.number + 1);
  const bool hasSite = site >= 0 && static_cast<std::size_t>(site) < plan.sites.size();
  const geo::Point goal = hasSite ? plan.sites[static_cast<std::size_t>(site)].pose.point() : stop.where;
  const SampleAir air = drawAir(plan.mission, stop.where, goal, draws);
  stop.wind = air.at(altitude);
  stop.mass_kg = air.mass_kg;
  const GlideMotion motion(plan.mission, air, table_);
  SampleFlight flight(plan.mission, motion);
  flight.stop(*rest, altitude);
  std::string fault = glide.fault;
  const double passive = plan.mission.safety.reactionTime.si() * motion.mostGroundSpeed(altitude);
  if (fault.empty() && rest->length + freeWay < passive - kReactionTolerance) {
    fault = fmt::format("the glide turns after {:.1f} m, but until the pilot reacts the aircraft may have gone on for {:.1f} m",
                        rest->length + freeWay, passive);
  }
  if (fault.empty()) {
    flight.follow(*rest);
    const Bend tourBend = rest->bends.empty() ? Bend() : rest->bends.back();
    flight.glide(glide, tourBend);
    fault = flight.fault();
  }
  const double bank = flight.steepestBank() * kDegrees;
  if (fault.empty() && bank > mostBank_) {
    fault = fmt::format("the glide needs a bank of {:.1f} degrees, which the aircraft may not use", bank);
  }
  const std::string& siteName = hasSite ? plan.sites[static_cast<std::size_t>(site)].site.id : std::string();
  const LeastPlace* worst = nullptr;
  MarginKind worstKind = MarginKind::TourClearance;
  for (std::size_t kind = 0; kind < kMarginKinds; ++kind) {
    const LeastPlace& place = flight.least()[kind];
    if (!std::isfinite(place.left)) {
      continue;
    }
    findings_.note(kind, {stop, place});
    if (place.left < -kHeightTolerance && (worst == nullptr || place.left < worst->left)) {
      worst = &place;
      worstKind = static_cast<MarginKind>(kind);
    }
  }
  if (!fault.empty()) {
    LeastPlace where = flight.now();
    where.left = 0.0;
    findings_.note(UnsafePoint{stop, where, std::move(fault)});
  } else if (worst != nullptr) {
    findings_.note(UnsafePoint{stop, *worst, textOf(worstKind, *worst, siteName)});
  }
  findings_.metresFlown += static_cast<std::uint64_t>(flight.metres());
  findings_.metresOfGround += static_cast<std::uint64_t>(rest->length);
  findings_.steepestBank = std::max(findings_.steepestBank, bank);
  findings_.longest = std::max(findings_.longest, flight.now().seconds);
}

/// Stretches of samples that end at one glide.
std::vector<std::span<const Sample>> groupsOf(const std::vector<Sample>& samples) {
  std::vector<std::span<const Sample>> groups;
  for (std::size_t from = 0; from < samples.size();) {
    std::size_t to = from + 1;
    while (to < samples.size() && samples[to].interval == samples[from].interval) {
      ++to;
    }
    groups.emplace_back(&samples[from], to - from);
    from = to;
  }
  return groups;
}

/** Groups of samples, taken by threads one after the other. */
class Crew {
public:
  Crew(const AuditInput& input, const std::vector<Interval>& intervals, const std::vector<Sample>& samples, const Job& job)
      : input_(input), intervals_(intervals), groups_(groupsOf(samples)), table_(input.plan.mission), job_(job), total_(samples.size()) {}

  Result<Findings> run() {
    std::vector<std::jthread> threads;
    for (int i = 1; i < input_.threads; ++i) {
      threads.emplace_back([this] { work(); });
    }
    work();
    threads.clear();
    if (broken_) {
      std::rethrow_exception(broken_);
    }
    if (failure_) {
      return tl::unexpected<Error>(*failure_);
    }
    if (job_.stopRequested()) {
      return fail(Errc::Cancelled, "the second opinion was stopped");
    }
    return all_;
  }

private:
  void work() {
    try {
      const Result<GroundLookup> lookup = input_.newLookup();
      if (!lookup) {
        const std::lock_guard lock(mutex_);
        failure_ = lookup.error();
        return;
      }
      Worker worker(input_, intervals_, table_, *lookup);
      for (std::size_t i = next_++; i < groups_.size() && worker.fly(groups_[i], job_); i = next_++) {
        done_ += groups_[i].size();
        const std::lock_guard lock(mutex_);
        job_.progress(static_cast<double>(done_) / static_cast<double>(total_),
                      fmt::format("second opinion: {} of {} engine failures", done_.load(), total_));
      }
      const std::lock_guard lock(mutex_);
      all_.add(worker.findings());
    } catch (...) {
      const std::lock_guard lock(mutex_);
      broken_ = std::current_exception();
    }
  }

  const AuditInput& input_;
  const std::vector<Interval>& intervals_;
  std::vector<std::span<const Sample>> groups_;
  AirTable table_;
  const Job& job_;
  std::size_t total_ = 0;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  Findings all_;
  std::optional<Error> failure_;
  std::exception_ptr broken_;
};

}  // namespace

const char* nameOf(MarginKind kind) {
  switch (kind) {
    case MarginKind::TourClearance:
      return "tour.clearance";
    case MarginKind::GlideClearance:
      return "glide.clearance";
    case MarginKind::Rolling:
      return "glide.dynamics";
    case MarginKind::Key:
      return "approach.key";
    case MarginKind::Arrival:
      return "glide.arrival";
  }
  return "";
}

Result<AuditReport> audit(const AuditInput& input, const Job& job) {
  const std::vector<Interval> intervals = intervalsOf(input.plan);
  if (intervals.empty() || !std::isfinite(intervals.back().begins + intervals.back().length())) {
    return fail(Errc::OutOfRange, "the plan has no way on which an engine could fail; plan the mission again");
  }
  const std::vector<Sample> samples = drawSamples(input, intervals, job);
  if (samples.size() < input.samples) {
    return fail(Errc::Cancelled, "the second opinion was stopped");
  }
  Result<Findings> found = Crew(input, intervals, samples, job).run();
  if (!found) {
    return forward(found);
  }
  found->keepFirst();
  AuditReport report;
  report.samples = input.samples;
  report.seed = input.seed;
  report.unsafe = found->unsafe;
  report.unsafePoints = std::move(found->unsafePoints);
  report.least = found->least;
  report.tourLength = intervals.back().begins + intervals.back().length();
  report.glides = found->glides;
  report.metresFlown = static_cast<double>(found->metresFlown);
  report.metresOfGround = static_cast<double>(found->metresOfGround);
  report.steepestBank_deg = found->steepestBank;
  report.longest_s = found->longest;
  return report;
}

}  // namespace vp::audit
