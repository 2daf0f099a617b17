#pragma once

#include "ui/style/units.h"

#include <QString>

#include <chrono>

namespace vp::briefing {

enum class Paper { A4, Letter };

/** What a briefing is made like. The date is printed and decides the magnetic variation; with the same plan, files and
 *  options two briefings are the same byte for byte. */
struct BriefingOptions {
  Paper paper = Paper::A4;
  style::Units units;
  bool monochrome = false;  ///< pictures in greys; the rest is black on white anyway
  std::chrono::year_month_day date{};
  QString program;  ///< "Volplane 0.1.0"
  bool map = true;
  bool profile = true;
  bool targets = true;
  bool legs = true;
  bool engineOut = true;
  bool glides = true;  ///< pictures of the glides from the worst points
};

}  // namespace vp::briefing
