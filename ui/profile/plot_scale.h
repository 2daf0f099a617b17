#pragma once

#include <QRectF>

#include <vector>

namespace vp::profile {

/** What part of a profile is shown: distances m over ground, altitudes m MSL. */
struct PlotWindow {
  double from = 0.0;
  double to = 1.0;
  double low = 0.0;
  double high = 1.0;
  [[nodiscard]] double width() const { return to - from; }
  [[nodiscard]] double height() const { return high - low; }
  bool operator==(const PlotWindow&) const = default;
};

/** Maps distance and altitude to the logical pixels of a plot. Altitudes far outside are held near the plot's edge, so that
 *  the painter never meets numbers that it cannot draw. @pre the window has a width and a height > 0 */
class PlotScale {
public:
  PlotScale() = default;
  PlotScale(const QRectF& area, const PlotWindow& window) : area_(area), window_(window) {}

  [[nodiscard]] const QRectF& area() const { return area_; }
  [[nodiscard]] const PlotWindow& window() const { return window_; }
  [[nodiscard]] double xOf(double distance) const { return area_.left() + (distance - window_.from) / window_.width() * area_.width(); }
  [[nodiscard]] double yOf(double altitude) const;
  [[nodiscard]] double distanceAt(double x) const { return window_.from + (x - area_.left()) / area_.width() * window_.width(); }
  [[nodiscard]] double altitudeAt(double y) const { return window_.high - (y - area_.top()) / area_.height() * window_.height(); }

private:
  QRectF area_;
  PlotWindow window_;
};

/** Round values (1, 2 or 5 times a power of ten apart) in [low, high], at most `most` of them. Any unit. */
std::vector<double> niceTicks(double low, double high, int most);

/** Digits after the point that tell such ticks apart. */
int tickDecimals(const std::vector<double>& ticks);

}  // namespace vp::profile
