#include "ui/style/chart_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::style {
namespace {

ChartColors lightColors() {
  ChartColors c;
  c.route = QColor(0xC4, 0x00, 0x8F);
  c.routeOutdated = QColor(0x8A, 0x7F, 0x88);
  c.routeCasing = QColor(0xFF, 0xFF, 0xFF, 210);
  c.glideAmple = QColor(0x00, 0x7A, 0x5E);
  c.glideTight = QColor(0xE6, 0x9F, 0x00);
  c.violation = QColor(0xD5, 0x1C, 0x1C);
  c.target = QColor(0x12, 0x3A, 0x6B);
  c.runway = QColor(0x1E, 0x1E, 0x26);
  c.runwayExcluded = QColor(0x8C, 0x8C, 0x94);
  c.safeAltitude = QColor(0x1F, 0x5F, 0xBF);
  c.pitchOnly = QColor(0x6B, 0x4F, 0xA0);
  c.ground = QColor(0x7A, 0x62, 0x48);
  c.corridor = QColor(0xCD, 0xBC, 0xA3);
  c.sky = QColor(0xF3, 0xF7, 0xFB);
  c.unknown = QColor(0x7B, 0x7B, 0x86);
  c.unknownBase = QColor(0xDD, 0xDD, 0xE1);
  c.selection = QColor(0x00, 0x6F, 0xD6);
  c.weather = QColor(0x5B, 0x21, 0xA6);
  c.cursor = QColor(0x10, 0x10, 0x14);
  c.text = QColor(0x1B, 0x1E, 0x24);
  c.textHalo = QColor(0xFF, 0xFF, 0xFF, 225);
  c.mutedText = QColor(0x56, 0x5C, 0x66);
  c.panel = QColor(0xFB, 0xFB, 0xFC);
  c.panelBorder = QColor(0xC9, 0xCD, 0xD4);
  c.grid = QColor(0xD8, 0xDD, 0xE4);
  return c;
}

ChartColors darkColors() {
  ChartColors c;
  c.route = QColor(0xFF, 0x5C, 0xD6);
  c.routeOutdated = QColor(0x9A, 0x92, 0x9C);
  c.routeCasing = QColor(0x0B, 0x0D, 0x12, 220);
  c.glideAmple = QColor(0x2F, 0xD0, 0xA4);
  c.glideTight = QColor(0xFF, 0xB8, 0x2E);
  c.violation = QColor(0xFF, 0x5A, 0x52);
  c.target = QColor(0xA9, 0xD0, 0xFF);
  c.runway = QColor(0xF2, 0xF4, 0xF8);
  c.runwayExcluded = QColor(0x84, 0x8A, 0x95);
  c.safeAltitude = QColor(0x6F, 0xB1, 0xFF);
  c.pitchOnly = QColor(0xB9, 0xA0, 0xF0);
  c.ground = QColor(0x8E, 0x77, 0x5C);
  c.corridor = QColor(0x55, 0x4A, 0x3E);
  c.sky = QColor(0x17, 0x1C, 0x25);
  c.unknown = QColor(0x74, 0x79, 0x84);
  c.unknownBase = QColor(0x2A, 0x2D, 0x34);
  c.selection = QColor(0x5A, 0xB0, 0xFF);
  c.weather = QColor(0xE6, 0xDC, 0xFF);
  c.cursor = QColor(0xF5, 0xF7, 0xFA);
  c.text = QColor(0xE8, 0xEB, 0xF0);
  c.textHalo = QColor(0x0B, 0x0D, 0x12, 225);
  c.mutedText = QColor(0xA3, 0xAB, 0xB8);
  c.panel = QColor(0x1E, 0x22, 0x2A);
  c.panelBorder = QColor(0x3B, 0x42, 0x4E);
  c.grid = QColor(0x33, 0x3A, 0x46);
  return c;
}

template <std::size_t N>
QColor interpolate(const std::array<QColor, N>& stops, double fraction) {
  const double at = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(N - 1);
  const auto low = std::min(static_cast<std::size_t>(at), N - 2);
  const double t = at - static_cast<double>(low);
  const auto mix = [t](int a, int b) { return static_cast<int>(std::lround(a + t * (b - a))); };
  const QColor& a = stops[low];
  const QColor& b = stops[low + 1];
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()), mix(a.alpha(), b.alpha())};
}

}  // namespace

const ChartColors& ChartColors::of(Theme theme) {
  static const ChartColors light = lightColors();
  static const ChartColors dark = darkColors();
  return theme == Theme::Light ? light : dark;
}

QColor ChartColors::glide(double margin) const {
  if (margin < 0.0) {
    return violation;
  }
  return interpolate(std::array{glideTight, glideAmple}, margin / kAmpleMargin);
}

QColor ChartColors::tint(Theme theme, double fraction) {
  static const std::array light{QColor(0xBF, 0xD6, 0xB4), QColor(0xD9, 0xE3, 0xBE), QColor(0xEC, 0xE5, 0xC4), QColor(0xE0, 0xCC, 0xA8),
                                QColor(0xCC, 0xB4, 0x98), QColor(0xD8, 0xCE, 0xC6), QColor(0xF4, 0xF4, 0xF5)};
  static const std::array dark{QColor(0x2C, 0x40, 0x34), QColor(0x3A, 0x4A, 0x38), QColor(0x4A, 0x4B, 0x3A), QColor(0x55, 0x4B, 0x3C),
                               QColor(0x5C, 0x50, 0x47), QColor(0x6E, 0x69, 0x68), QColor(0x93, 0x96, 0x9E)};
  return interpolate(theme == Theme::Light ? light : dark, fraction);
}

QColor ChartColors::altitudeScale(double fraction) {
  static const std::array stops{QColor(0x44, 0x01, 0x54), QColor(0x47, 0x2D, 0x7B), QColor(0x3B, 0x52, 0x8B),
                                QColor(0x2C, 0x72, 0x8E), QColor(0x21, 0x91, 0x8C), QColor(0x28, 0xAE, 0x80),
                                QColor(0x5E, 0xC9, 0x62), QColor(0xAD, 0xDC, 0x30), QColor(0xFD, 0xE7, 0x25)};
  return interpolate(stops, fraction);
}

QColor ChartColors::airspace(Theme theme, const std::string& kind) {
  const bool isDark = theme == Theme::Dark;
  if (kind == "R" || kind == "P" || kind == "Q" || kind == "GP") {
    return isDark ? QColor(222, 140, 110) : QColor(150, 60, 30);
  }
  const bool isControlled = kind.size() == 1 || kind == "CTR";
  return isControlled ? (isDark ? QColor(120, 170, 240) : QColor(30, 80, 170)) : (isDark ? QColor(170, 170, 190) : QColor(90, 90, 110));
}

}  // namespace vp::style
