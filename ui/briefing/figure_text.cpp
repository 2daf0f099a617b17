#include "ui/briefing/figure_text.h"

#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"

#include <cmath>

namespace vp::briefing {
namespace {

constexpr double kShortTour = 40e3;  // m: legs of a few hundred metres want two decimals
constexpr int kStretchDecimals = 2;  // 20 m, less than decision points are apart
QString none() {
  return QStringLiteral("–");
}

/// The number of "1 230 ft AGL".
QString bare(const QString& withUnit) {
  const QString number = withUnit.left(withUnit.indexOf(QLatin1Char(' ')));
  return number.startsWith(QLatin1Char('+')) ? number.mid(1) : number;
}

QString threeDigits(double degrees) {
  const QString course = style::Units::course(degrees);
  return course.left(course.indexOf(QChar(0x00B0)));
}

QString range(const QString& from, const QString& to) {
  return from == to ? from : from + QChar(0x2013) + to;
}

}  // namespace

FigureText::FigureText(const style::Units& units, double length) : units_(units), decimals_(length < kShortTour ? 2 : 1) {}

QString FigureText::altitude(double metres) const {
  return std::isfinite(metres) ? bare(units_.altitudeMsl(metres)) : none();
}

QString FigureText::needed(double metres) const {
  return std::isfinite(metres) ? bare(units_.requiredMsl(metres)) : none();
}

QString FigureText::clearance(double metres) const {
  return std::isfinite(metres) ? bare(units_.heightAboveGround(metres)) : none();
}

QString FigureText::margin(double metres) const {
  return std::isfinite(metres) ? bare(units_.margin(profile::shownMargin(metres))) : none();
}

QString FigureText::distance(double metres) const {
  return profile::groupedNumber(units_.distanceFromSi(metres), decimals_);
}

QString FigureText::distanceWithUnit(double metres) const {
  return distance(metres) + QChar(QChar::Nbsp) + units_.distanceUnit();
}

QString FigureText::distances(double from, double to) const {
  return range(distance(from), distance(to));
}

QString FigureText::stretch(double from, double to) const {
  const auto shown = [this](double metres) { return profile::groupedNumber(units_.distanceFromSi(metres), kStretchDecimals); };
  return range(shown(from), shown(to));
}

QString FigureText::time(double seconds) {
  return bare(style::Units::duration(seconds));
}

QString FigureText::times(double from, double to) {
  return range(time(from), time(to));
}

QString FigureText::trueCourse(const Track& track) {
  return threeDigits(track.trueCourse.degrees());
}

QString FigureText::magneticCourse(const Track& track) {
  return track.variation ? threeDigits(wrapTwoPi((track.trueCourse - *track.variation).radians()) * 180.0 / Angle::kPi) : none();
}

QString FigureText::variation(const Track& track) {
  if (!track.variation) {
    return none();
  }
  return style::Units::variation(track.variation->degrees());
}

QString FigureText::letter(int index) {
  constexpr int kLetters = 26;
  const QString last(QChar(static_cast<char16_t>(u'A' + index % kLetters)));
  return index < kLetters ? last : letter(index / kLetters - 1) + last;
}

}  // namespace vp::briefing
