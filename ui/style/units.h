#pragma once

#include "core/geo/local_frame.h"

#include <QString>

#include <string>

namespace vp::style {

enum class UnitSystem { Aviation, Metric };  ///< ft, NM, kt, ft/min or m, km, km/h, m/s

/** Values as a pilot reads them: number, unit and datum. Input in SI; digit grouping by a thin space; rounding never
 *  makes a margin look larger: margins and clearances round down, required altitudes round up, others to the nearest.
 *  @threads pure */
class Units {
public:
  Units() = default;
  explicit Units(UnitSystem system) : system_(system) {}
  [[nodiscard]] UnitSystem system() const { return system_; }
  bool operator==(const Units&) const = default;

  [[nodiscard]] QString altitudeMsl(double metres) const;        ///< "6 480 ft MSL"
  [[nodiscard]] QString requiredMsl(double metres) const;        ///< the same, rounded up
  [[nodiscard]] QString heightAboveGround(double metres) const;  ///< "1 230 ft AGL", rounded down
  [[nodiscard]] QString margin(double metres) const;             ///< "+340 ft", rounded down; a true minus sign
  [[nodiscard]] QString height(double metres) const;             ///< "340 ft", a difference of heights
  [[nodiscard]] QString required(double metres) const;           ///< "340 ft", a height that is missing, rounded up
  [[nodiscard]] QString distance(double metres) const;           ///< "12.4 NM"
  [[nodiscard]] QString shortDistance(double metres) const;      ///< runway lengths: "2 950 ft" or "900 m"
  [[nodiscard]] QString speed(double mps) const;                 ///< "68 kt"
  [[nodiscard]] QString verticalSpeed(double mps) const;         ///< "-640 ft/min"
  [[nodiscard]] static QString duration(double seconds);         ///< "4:05" min, "1:12:00" h
  [[nodiscard]] static QString course(double trueCourse_deg);    ///< "043° T", 000 is written 360
  [[nodiscard]] static QString position(geo::LatLon place);      ///< "46°36.02′ N  009°54.10′ E"
  [[nodiscard]] static QString angle(double degrees);            ///< "4.9°"
  [[nodiscard]] static QString variation(double east_deg);       ///< magnetic, east positive: "3.1° E"

  /** A sentence of the core in the language of the window (core_text.h), with its lengths in these units: "is 312.5 m below" reads "is 1 025.3 ft
   * below", with as many decimals as there were; "5.2 km" reads "2.8 NM". All else stays, figures of speed and area too. */
  [[nodiscard]] QString inSentence(const std::string& sentence) const;

  [[nodiscard]] QString heightUnit() const;                ///< "ft" or "m"
  [[nodiscard]] QString distanceUnit() const;              ///< "NM" or "km"
  [[nodiscard]] double heightFromSi(double metres) const;  ///< for axes and spin boxes
  [[nodiscard]] double heightToSi(double shown) const;
  [[nodiscard]] double distanceFromSi(double metres) const;
  [[nodiscard]] double distanceToSi(double shown) const;
  [[nodiscard]] QString speedUnit() const;  ///< "kt" or "km/h"
  [[nodiscard]] double speedFromSi(double mps) const;
  [[nodiscard]] double speedToSi(double shown) const;

private:
  UnitSystem system_ = UnitSystem::Aviation;
};

}  // namespace vp::style
