#include "ui/document/weather_view.h"

#include "core/risk/weather.h"

#include <QCoreApplication>

#include <cmath>
#include <string_view>
#include <utility>

namespace vp::document {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(vp::document::WeatherWords)
};

constexpr std::string_view kFirst = "weather cell 1";
constexpr double kTenths = 1000.0;         // of a percent in a probability of one
constexpr double kConversionNoise = 1e-9;  // so that 0.9 does not read 89.9 %

}  // namespace

ShownWeather shownWeather(mission::WeatherCell cell, const geo::LocalFrame& frame) {
  ShownWeather shown;
  for (const geo::LatLon& corner : cell.outline) {
    shown.outline.push_back(frame.toPoint(corner));
    shown.box.add(shown.outline.back());
  }
  shown.cell = std::move(cell);
  return shown;
}

bool isInside(const ShownWeather& shown, geo::Point place) {
  if (!shown.box.contains(place)) {
    return false;
  }
  bool inside = false;
  for (std::size_t i = 0; i < shown.outline.size(); ++i) {
    const geo::Point& a = shown.outline[i];
    const geo::Point& b = shown.outline[(i + 1) % shown.outline.size()];
    if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

int weatherAt(const std::vector<ShownWeather>& cells, geo::Point place) {
  int found = -1;
  double least = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const geo::Box& box = cells[i].box;
    const double size = (box.maxX - box.minX) * (box.maxY - box.minY);
    if ((found < 0 || size <= least) && isInside(cells[i], place)) {
      found = static_cast<int>(i);
      least = size;
    }
  }
  return found;
}

std::string weatherProblem(const mission::WeatherCell& cell, const geo::LocalFrame& frame) {
  const auto made = risk::Weather::from({cell}, frame);
  if (made) {
    return {};
  }
  std::string sentence = made.error().what;
  if (const std::size_t at = sentence.find(kFirst); at != std::string::npos) {
    sentence.replace(at, kFirst.size(), "weather");  // it is alone here, whatever its number in the mission
  }
  return sentence.ends_with('.') ? sentence : sentence + '.';
}

QString weatherTitle(const mission::WeatherCell& cell, std::size_t index) {
  return cell.name.empty() ? Words::tr("Weather %1").arg(index + 1) : QString::fromStdString(cell.name);
}

QString weatherAltitudes(const mission::WeatherCell& cell, const style::Units& units) {
  return Words::tr("%1 to %2")
      .arg(cell.floor ? units.altitudeMsl(*cell.floor) : QStringLiteral("GND"), cell.top ? units.altitudeMsl(*cell.top) : QStringLiteral("UNL"));
}

double weatherSuccess(const mission::WeatherCell& cell, const style::Units& units) {
  return std::pow(cell.success, units.distanceToSi(1.0) / cell.perDistance);
}

QString percentText(double probability) {
  const double rounded = std::floor(probability * kTenths + kConversionNoise) * 0.1;
  return QStringLiteral("%1 %").arg(rounded, 0, 'f', rounded == std::floor(rounded) ? 0 : 1);
}

QString weatherSuccessText(const mission::WeatherCell& cell, const style::Units& units) {
  return Words::tr("%1 per %2", "probability of coming through a unit of distance")
      .arg(percentText(weatherSuccess(cell, units)), units.distanceUnit());
}

}  // namespace vp::document
