#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_request.h"

namespace vp::emergency {

/** Judges the path of an answer by the independent checker (safety::checkLanding).
 *  @return the answer with `verified` set; or, where the checker has something against it, without the path and with its first reason as whyNot:
 *  what is not verified is not returned. An answer without a path stays as it is.
 *  @threads pure   @cost that of the checker: some 0.2 ms with the request's judge, milliseconds in wind without */
LandingAnswer verifiedAnswer(const LandingRequest& request, LandingAnswer answer);

}  // namespace vp::emergency
