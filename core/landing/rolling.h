#pragma once

#include "core/aircraft/roll_loss.h"
#include "core/landing/world.h"

#include <vector>

namespace vp::landing {

/** What rolling into turns and out of them may cost a glide given as pieces, at the rate of the world's aircraft, or the usual one
 *  (aircraft/roll_loss.h).  @threads const */
class Rolling {
public:
  explicit Rolling(const World& world);

  /** Up to and on each piece of a glide [m], never falling; level at the end.
   *  @param tour  the piece that is flown before it, at the airspeed of the tour; straight: level */
  [[nodiscard]] std::vector<double> along(const flight::Piece& tour, const std::vector<flight::Piece>& pieces) const;
  /** Of a whole glide [m]. */
  [[nodiscard]] double of(const flight::Piece& tour, const std::vector<flight::Piece>& pieces) const;
  /** From one piece to the next [m], nearly what along() says of it. */
  [[nodiscard]] double between(const flight::Piece& before, const flight::Piece& after) const;

private:
  aircraft::RollLoss loss_;
};

}  // namespace vp::landing
