#pragma once

#include "core/base/quantity.h"

#include <array>

namespace vp::emergency {

/** Parameters of the gradient-guided search: Table 2 of [3], its names in comments. Lengths that the paper gives for its turn radius of 3000 ft are
 *  multiples of the radius here, and heights count from the elevation of the site, so that other aircraft and other ground mean the same. */
struct GradientOptions {
  /** Bank of turns in still air: 3000 ft (R) at the 79 kt that the Cessna 182 glides at. In wind the radius over ground is that of the wind from
   * behind. */
  Angle turnBank = Angle::radians(0.18353);                                // atan(40.8^2 / (9.80665 * 914.4))
  Length crossover = Length::fromSi(5000.0 * kMetresPerFoot);              ///< h_c, above the site
  std::array<double, 5> courseChanges_deg{-30.0, -15.0, 0.0, 15.0, 30.0};  ///< X
  Length floor = Length::fromSi(2000.0 * kMetresPerFoot);                  ///< of the adaptive segment length, above the site
  double lengthPerHeight = 0.1;                                            ///< m: metres of segment for each metre above that
  Length inner = Length::fromSi(0.5 * kMetresPerNauticalMile);             ///< r: nearer than this the optimal descent counts alone
  double annulusInner = 1.0;                                               ///< R_i, radii
  double annulusOuter = 2.0;                                               ///< R_o, radii
  Length holdingFloor = Length::fromSi(1000.0 * kMetresPerFoot);           ///< h_h, above the site
  Length holdingBuffer = Length::fromSi(2000.0 * kMetresPerFoot);          ///< h_buffer
  Angle courseStep = Angle::degrees(5.0);                                  ///< Delta psi of the closed set
  Length noFly = Length::fromSi(0.5 * kMetresPerNauticalMile);             ///< around the site: no holding there ([3] section 6.1)
};

}  // namespace vp::emergency
