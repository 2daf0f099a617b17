#include "core/emergency/anytime_search.h"

#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/risk/leg_risk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::emergency {
namespace {

/// Mean number of neighbours, as landing::buildRrtStarRoadmap has it (measured there), and the most that are looked at.
constexpr double kNeighbours = 20.0;
constexpr std::size_t kMostNeighbours = 30;
/// Runways that are tried from each new pose, the most promising first.
constexpr std::size_t kMostGoals = 4;
/// Share of samples near the best path, as soon as there is one; the others look for different ways.
constexpr double kNearBest = 0.5;
/// How far from it: evenly over the magnitudes between these [m].
constexpr double kLeastReach = 10.0;
constexpr double kMostReach = 3000.0;
/// Risks closer than this are the same [relative].
constexpr double kSameRisk = 1e-9;
constexpr double kSlack = 1e-9;

double bucketOf(const InformedSamples& samples, double turnRadius) {
  constexpr double kUsualPoses = 3000.0;
  return std::max(4.0 * turnRadius, std::sqrt(kNeighbours * samples.area() / (Angle::kPi * kUsualPoses)));
}

}  // namespace

AnytimeSearch::AnytimeSearch(const LandingRequest& request, const LandingGoals& goals)
    : request_(request),
      world_(*request.world),
      goals_(goals),
      flight_(world_),
      samples_(world_, goals, request.pose, request.altitude, request.seed),
      index_(world_.terrain.grid().extent(), bucketOf(samples_, world_.glide.minRadius())) {
  Node root;
  root.pose = request.pose;
  root.altitude = request.altitude;
  root.least = goals.inRange().front().least;
  nodes_.push_back(std::move(root));
  index_.insert(request.pose.point(), 0);
}

double AnytimeSearch::wantedInHand() const {
  const bool anyHeight = best_.node < 0 || (request_.risk != nullptr && best_.risk > 0.0);
  return anyHeight ? 0.0 : best_.inHand;
}

bool AnytimeSearch::mayHelp(double altitude, double risk, double least) const {
  return altitude - least >= wantedInHand() && (request_.risk == nullptr || risk <= best_.risk);
}

bool AnytimeSearch::isBetter(double risk, double altitude, const Glide& than) const {
  if (!than.exists()) {
    return true;
  }
  if (request_.risk != nullptr && std::abs(risk - than.risk) > kSameRisk * than.risk) {
    return risk < than.risk;
  }
  return altitude > than.altitude + kSlack;
}

bool AnytimeSearch::isFinished() const {
  if (samples_.isEmpty()) {
    return true;
  }
  const bool nothingToGain = request_.risk == nullptr || best_.risk <= 0.0;
  return best_.node >= 0 && nothingToGain && request_.altitude - goals_.inRange().front().least - best_.inHand < kWorthwhile;
}

double AnytimeSearch::riskAlong(const flight::DubinsPath& path, double altitude) const {
  if (request_.risk == nullptr) {
    return 0.0;
  }
  std::vector<flight::Piece> pieces;
  flight::appendPieces(path, pieces);
  mission::LandingPath glide{path.start, altitude, {}, -1};
  geo::Pose pose = path.start;
  flight_.fly(pose, altitude, pieces, &glide.legs);
  return riskOf(request_, glide);
}

/// The best glide from a node to a pose over all radii, if it is better than `atLeast`.
AnytimeSearch::Glide AnytimeSearch::glideFrom(int node, const geo::Pose& to, const Glide& atLeast) {
  const Node& from = nodes_[static_cast<std::size_t>(node)];
  const aircraft::GlideBands* const bands = world_.glide.bands();
  const std::size_t band = bands == nullptr ? 0 : bands->below(from.altitude);
  const aircraft::GlideModel& model = bands == nullptr ? world_.glide : bands->between(band, band);
  const flight::PosePair pair(from.pose, to);
  Glide best;
  for (std::size_t radius = 0; radius < world_.glide.glideRadii().size(); ++radius) {
    const flight::TurnLoss loss = flight::turnLossAt(model, radius);
    const flight::DubinsPath path = pair.leastLoss(world_.glide.glideRadii()[radius], loss);
    const Glide& known = best.exists() ? best : atLeast;
    const bool byHeight = request_.risk == nullptr && bands == nullptr && known.exists();
    if (byHeight && from.altitude - flight::lossOf(path, loss) <= known.altitude) {
      continue;
    }
    ++counts_.glides;
    const double altitude = flight_.endOf(path, radius, from.altitude);
    if (altitude <= GlideFlight::kTouches || !isBetter(from.risk, altitude, known)) {
      continue;  // no leg has a risk below zero
    }
    const double risk = request_.risk == nullptr ? 0.0 : from.risk + riskAlong(path, from.altitude);
    if (isBetter(risk, altitude, known)) {
      best = {path, radius, altitude, risk};
    }
  }
  return best;
}

void AnytimeSearch::tryDirect(const Countdown& countdown) {
  for (std::size_t goal = 0; goal < goals_.inRange().size(); ++goal) {
    if (countdown.isOver() || !mayHelp(request_.altitude, 0.0, goals_.inRange()[goal].least)) {
      return;
    }
    ++counts_.direct;
    tryGoal(0, goal);
  }
}

geo::Pose AnytimeSearch::sample() {
  if (!bestPath_ || samples_.unit() >= kNearBest) {
    return samples_.next();
  }
  double along = samples_.unit() * lengthOf(*bestPath_);
  geo::Pose pose = bestPath_->start;
  for (const mission::LandingLeg& leg : bestPath_->legs) {
    pose = flight::poseAfter(pose, leg.piece, std::min(along, leg.piece.length));
    along -= leg.piece.length;
    if (along <= 0.0) {
      break;
    }
  }
  return samples_.near(pose, kLeastReach * std::pow(kMostReach / kLeastReach, samples_.unit()));
}

void AnytimeSearch::grow() {
  ++counts_.samples;
  const geo::Pose pose = sample();
  const double ground = world_.terrain.grid().upperAt(pose.point());
  const double most = request_.altitude - goals_.leastLoss(request_.pose, pose);
  if (most < ground + world_.clearance) {
    return;  // unknown ground too
  }
  const double least = goals_.leastFrom(pose);
  if (!mayHelp(most, 0.0, least)) {
    return;
  }
  gatherParents(pose);
  Node node;
  node.pose = pose;
  node.least = least;
  if (!chooseParent(pose, least, node)) {
    return;
  }
  tryAncestors(pose, node);
  node.altitude = node.glide.altitude;
  node.risk = node.glide.risk;
  const int added = static_cast<int>(nodes_.size());
  nodes_[static_cast<std::size_t>(node.parent)].children.push_back(added);
  nodes_.push_back(std::move(node));
  index_.insert(pose.point(), added);
  ++counts_.poses;
  tryGoals(added);
  rewire(added);
}

/// near_: the neighbours that may still help, the start among them.
void AnytimeSearch::gatherParents(const geo::Pose& pose) {
  const double radius =
      std::max(2.0 * world_.glide.minRadius(), std::sqrt(kNeighbours * samples_.area() / (Angle::kPi * static_cast<double>(nodes_.size()))));
  near_.clear();
  index_.within(pose.point(), radius, near_);
  std::erase_if(near_, [this](int id) {
    const Node& node = nodes_[static_cast<std::size_t>(id)];
    return id == 0 || !mayHelp(node.altitude, node.risk, node.least);
  });
  near_.push_back(0);
}

bool AnytimeSearch::chooseParent(const geo::Pose& pose, double least, Node& node) {
  candidates_.clear();
  for (const int id : near_) {
    const Node& from = nodes_[static_cast<std::size_t>(id)];
    const double altitude = from.altitude - goals_.leastLoss(from.pose, pose);
    if (mayHelp(altitude, from.risk, least)) {
      candidates_.push_back({altitude, id});
    }
  }
  std::sort(candidates_.begin(), candidates_.end(), [this](const Candidate& a, const Candidate& b) {
    const double riskA = nodes_[static_cast<std::size_t>(a.node)].risk;
    const double riskB = nodes_[static_cast<std::size_t>(b.node)].risk;
    return riskA != riskB ? riskA < riskB : a.altitude != b.altitude ? a.altitude > b.altitude : a.node < b.node;
  });
  for (std::size_t i = 0; i < std::min(kMostNeighbours, candidates_.size()); ++i) {
    if (!isBetter(nodes_[static_cast<std::size_t>(candidates_[i].node)].risk, candidates_[i].altitude, node.glide)) {
      continue;
    }
    const Glide glide = glideFrom(candidates_[i].node, pose, node.glide);
    if (glide.exists() && isBetter(glide.risk, glide.altitude, node.glide)) {
      node.glide = glide;
      node.parent = candidates_[i].node;
    }
  }
  return node.parent >= 0 && mayHelp(node.glide.altitude, node.glide.risk, least);
}

void AnytimeSearch::tryAncestors(const geo::Pose& pose, Node& node) {
  for (int ancestor = nodes_[static_cast<std::size_t>(node.parent)].parent; ancestor >= 0;
       ancestor = nodes_[static_cast<std::size_t>(ancestor)].parent) {
    const Glide glide = glideFrom(ancestor, pose, node.glide);
    if (!glide.exists() || !isBetter(glide.risk, glide.altitude, node.glide)) {
      return;
    }
    node.glide = glide;
    node.parent = ancestor;
  }
}

void AnytimeSearch::rewire(int added) {
  candidates_.clear();
  for (const int id : near_) {
    const Node& from = nodes_[static_cast<std::size_t>(added)];
    const Node& to = nodes_[static_cast<std::size_t>(id)];
    const double gain = from.altitude - goals_.leastLoss(from.pose, to.pose) - to.altitude;
    if (id != 0 && id != from.parent && gain > 0.0) {
      candidates_.push_back({gain, id});
    }
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.altitude != b.altitude ? a.altitude > b.altitude : a.node < b.node; });
  candidates_.resize(std::min(kMostNeighbours, candidates_.size()));
  const std::vector<Candidate> gains = candidates_;
  for (const auto& [gain, id] : gains) {
    Node& node = nodes_[static_cast<std::size_t>(id)];
    Glide known = node.glide;
    known.altitude = node.altitude;
    known.risk = node.risk;
    const Glide glide = glideFrom(added, node.pose, known);
    // never lower than it was: what glides on from it stays clear of the ground
    if (!glide.exists() || glide.altitude < node.altitude || !isBetter(glide.risk, glide.altitude, known)) {
      continue;
    }
    const std::vector<int> chain = chainOf(added);
    if (std::find(chain.begin(), chain.end(), id) != chain.end()) {
      continue;  // with a risk, an ancestor could be lower
    }
    std::erase(nodes_[static_cast<std::size_t>(node.parent)].children, id);
    node.parent = added;
    node.glide = glide;
    node.altitude = glide.altitude;
    node.risk = glide.risk;
    nodes_[static_cast<std::size_t>(added)].children.push_back(id);
    ++counts_.rewired;
    passOn(id);
    renewLanding();
    tryGoals(id);
  }
}

/// New altitudes and risks for all that glides on from a node.
void AnytimeSearch::passOn(int node) {
  std::vector<int> open{node};
  while (!open.empty()) {
    const Node& from = nodes_[static_cast<std::size_t>(open.back())];
    open.pop_back();
    for (const int child : from.children) {
      Node& to = nodes_[static_cast<std::size_t>(child)];
      to.altitude = std::max(to.altitude, flight_.endOf(to.glide.path, to.glide.radius, from.altitude));
      to.risk = request_.risk == nullptr ? 0.0 : from.risk + riskAlong(to.glide.path, from.altitude);
      to.glide.altitude = to.altitude;
      to.glide.risk = to.risk;
      open.push_back(child);
    }
  }
}

void AnytimeSearch::tryGoals(int node) {
  std::vector<Candidate> goals;
  const Node& from = nodes_[static_cast<std::size_t>(node)];
  for (std::size_t i = 0; i < goals_.inRange().size(); ++i) {
    const landing::Approach& approach = goals_.inRange()[i].approach;
    const double inHand = from.altitude - goals_.leastLoss(from.pose, approach.gate) - approach.altitude;
    if (mayHelp(inHand, from.risk, 0.0)) {
      goals.push_back({inHand, static_cast<int>(i)});
    }
  }
  std::sort(goals.begin(), goals.end(),
            [](const Candidate& a, const Candidate& b) { return a.altitude != b.altitude ? a.altitude > b.altitude : a.node < b.node; });
  for (std::size_t i = 0; i < std::min(kMostGoals, goals.size()); ++i) {
    if (mayHelp(goals[i].altitude, from.risk, 0.0)) {
      tryGoal(node, static_cast<std::size_t>(goals[i].node));
    }
  }
}

void AnytimeSearch::tryGoal(int node, std::size_t goal) {
  const landing::Approach& approach = goals_.inRange()[goal].approach;
  Glide wanted;
  wanted.altitude = approach.altitude + wantedInHand() - kSlack;
  wanted.risk = best_.risk;
  const Glide glide = glideFrom(node, approach.gate, wanted);
  if (glide.exists() && glide.altitude >= approach.altitude) {
    accept({node, goal, glide, glide.altitude - approach.altitude, glide.risk});
  }
}

/// The best landing again, after what leads to it may have become better.
void AnytimeSearch::renewLanding() {
  if (best_.node < 0) {
    return;
  }
  Landing again = best_;
  const Node& from = nodes_[static_cast<std::size_t>(best_.node)];
  again.glide.altitude = flight_.endOf(again.glide.path, again.glide.radius, from.altitude);
  again.glide.risk = request_.risk == nullptr ? 0.0 : from.risk + riskAlong(again.glide.path, from.altitude);
  if (!isBetter(again.glide.risk, again.glide.altitude, best_.glide)) {
    return;
  }
  again.inHand = again.glide.altitude - goals_.inRange()[again.goal].approach.altitude;
  again.risk = again.glide.risk;
  accept(again);
}

bool AnytimeSearch::isBetterLanding(const Landing& landing) const {
  if (best_.node < 0) {
    return true;
  }
  Glide known = best_.glide;
  known.altitude = best_.inHand;
  known.risk = best_.risk;
  return isBetter(landing.risk, landing.inHand, known);
}

/** Takes a landing that is better than the best, what its manoeuvres cost included, after leaving out poses that are worth less than the manoeuvres
 *  that they cost. */
bool AnytimeSearch::accept(Landing landing) {
  if (!isBetterLanding(landing)) {
    return false;
  }
  std::vector<Glide> glides = glidesOf(landing);
  std::optional<mission::LandingPath> path = pathOf(glides, landing);
  for (std::size_t i = glides.size(); path && i-- > 1;) {
    Landing shorter = landing;
    std::vector<Glide> fewer = without(glides, i);
    std::optional<mission::LandingPath> direct = fewer.empty() ? std::nullopt : pathOf(fewer, shorter);
    const Glide known{landing.glide.path, landing.glide.radius, landing.inHand, landing.risk};
    if (direct && isBetter(shorter.risk, shorter.inHand, known)) {
      path = std::move(direct);
      landing = shorter;
      glides = std::move(fewer);
    }
  }
  if (!path || !isBetterLanding(landing)) {
    return false;
  }
  best_ = landing;
  bestPath_ = std::move(path);
  samples_.narrow(wantedInHand());
  ++counts_.improved;
  return true;
}

/// The glides with two neighbours, of which this number is the second, replaced by one; none if there is none.
std::vector<AnytimeSearch::Glide> AnytimeSearch::without(const std::vector<Glide>& glides, std::size_t number) const {
  const flight::DubinsPath& first = glides[number - 1].path;
  const flight::DubinsPath& second = glides[number].path;
  const geo::Pose to = flight::endOf(flight::toCurve(second), world_.glide.airspeed());
  const flight::PosePair pair(first.start, to);
  const double altitude = number >= 2 ? glides[number - 2].altitude : request_.altitude;
  Glide best;
  for (std::size_t radius = 0; radius < world_.glide.glideRadii().size(); ++radius) {
    const flight::DubinsPath path = pair.leastLoss(world_.glide.glideRadii()[radius], flight::turnLossAt(world_.glide, radius));
    const double end = flight_.endOf(path, radius, altitude);
    if (end > best.altitude) {
      best = {path, radius, end, 0.0};
    }
  }
  std::vector<Glide> fewer;
  if (best.exists()) {
    fewer.assign(glides.begin(), glides.begin() + static_cast<std::ptrdiff_t>(number) - 1);
    fewer.push_back(best);
    fewer.insert(fewer.end(), glides.begin() + static_cast<std::ptrdiff_t>(number) + 1, glides.end());
    for (std::size_t i = number; i < fewer.size(); ++i) {
      fewer[i].altitude = flight_.endOf(fewer[i].path, fewer[i].radius, fewer[i - 1].altitude);
    }
  }
  return fewer;
}

std::vector<int> AnytimeSearch::chainOf(int node) const {
  std::vector<int> chain;
  for (; node >= 0; node = nodes_[static_cast<std::size_t>(node)].parent) {
    chain.push_back(node);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

std::vector<AnytimeSearch::Glide> AnytimeSearch::glidesOf(const Landing& landing) const {
  std::vector<Glide> glides;
  for (const int node : chainOf(landing.node)) {
    if (node != 0) {
      glides.push_back(nodes_[static_cast<std::size_t>(node)].glide);
    }
  }
  glides.push_back(landing.glide);
  return glides;
}

/** The whole path of these glides to the goal of the landing, whose height in hand and risk become those of the path. */
std::optional<mission::LandingPath> AnytimeSearch::pathOf(const std::vector<Glide>& glides, Landing& landing) const {
  std::vector<flight::Piece> pieces;
  for (const Glide& glide : glides) {
    flight::appendPieces(glide.path, pieces);
  }
  const landing::Approach& approach = goals_.inRange()[landing.goal].approach;
  std::vector<mission::LandingLeg> legs;
  geo::Pose pose = request_.pose;
  const double altitude = flight_.fly(pose, request_.altitude, landing::joinedGlide(world_, {}, pieces), &legs);
  if (altitude <= GlideFlight::kTouches) {
    return std::nullopt;
  }
  std::optional<mission::LandingPath> path = withApproach(request_, approach, std::move(legs), altitude);
  if (path) {
    landing.inHand = altitude - approach.altitude - kPerManoeuvre * manoeuvresOf(*path);
    landing.risk = riskOf(request_, *path);
  }
  return path;
}

}  // namespace vp::emergency
