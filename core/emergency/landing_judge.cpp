#include "core/emergency/landing_judge.h"

#include <vector>

namespace vp::emergency {

LandingJudge::LandingJudge(const LandingRequest& request)
    : world_(request.world),
      mission_(request.mission),
      frameOrigin_(request.frameOrigin),
      checker_({*mission_, world_->sites, frameOrigin_, world_->terrain.grid()}) {
  if (world_->rollRate_dps) {
    rolling_.emplace(*world_);
  }
}

bool LandingJudge::isOf(const LandingRequest& request) const {
  return world_ == request.world && mission_ == request.mission && frameOrigin_ == request.frameOrigin;
}

std::optional<double> LandingJudge::rollingOf(const mission::LandingPath& path) const {
  if (!rolling_) {
    return std::nullopt;
  }
  std::vector<flight::Piece> pieces;
  for (const mission::LandingLeg& leg : path.legs) {
    pieces.push_back(leg.piece);
  }
  return rolling_->of({}, pieces);
}

LandingRequest withJudge(LandingRequest request) {
  if (request.judge == nullptr || !request.judge->isOf(request)) {
    request.judge = std::make_shared<const LandingJudge>(request);
  }
  return request;
}

}  // namespace vp::emergency
