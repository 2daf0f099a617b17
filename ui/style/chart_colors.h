#pragma once

#include <QColor>

#include <string>

namespace vp::style {

enum class Theme { Light, Dark };

/** The one colour language of map, 3D view, profile, panels and pictures. Meaning never rests on colour alone: every use
 *  adds a pattern, a shape or a text. Magenta for the route is the convention of cockpit displays; green to amber grades
 *  glide margins; red stands for a violation and nothing else; unknown terrain is hatched.
 *  Route, glide and amber stay apart under deuteranopia and protanopia (tst_style). */
struct ChartColors {
  QColor route;           ///< tour
  QColor routeOutdated;   ///< tour of a plan that no longer fits its inputs
  QColor routeCasing;     ///< thin outline under the route, so that it stands on any ground
  QColor glideAmple;      ///< glide with the margin `kAmpleMargin` or more
  QColor glideTight;      ///< glide with no margin to spare
  QColor violation;       ///< red, violations only
  QColor target;          ///< targets
  QColor runway;          ///< usable runways
  QColor runwayExcluded;  ///< runways that the filter leaves out
  QColor safeAltitude;    ///< lowest safe altitude curve and contours
  QColor pitchOnly;       ///< "pitch limits only" profile
  QColor ground;          ///< terrain in the profile, centre line
  QColor corridor;        ///< terrain in the profile, highest within the corridor
  QColor sky;             ///< background of profile and 3D view
  QColor unknown;         ///< hatch of unknown terrain
  QColor unknownBase;     ///< ground under that hatch
  QColor selection;       ///< selected object
  QColor weather;         ///< bad weather: violet, hatched
  QColor cursor;          ///< tour cursor in all views
  QColor text;
  QColor textHalo;  ///< outline of text over terrain
  QColor mutedText;
  QColor panel;  ///< background of docks and legends
  QColor panelBorder;
  QColor grid;

  static const ChartColors& of(Theme theme);

  /// Margin from which a glide is drawn in full green [m]; a shade of it below, by margin.
  static constexpr double kAmpleMargin = 150.0;
  /** Colour of a glide by its margin [m]: violation below zero, glideTight at zero, glideAmple from kAmpleMargin on. */
  [[nodiscard]] QColor glide(double margin) const;

  /** Airspaces as charts have them: blue what takes a clearance, red-brown danger, restricted and prohibited, grey the rest.
   *  @param kind  class or type of the airspace */
  static QColor airspace(Theme theme, const std::string& kind);

  /** Hypsometric tint of a ground height as a fraction of the shown range, 0 lowest .. 1 highest. Light theme: muted chart
   *  greens to browns to near white; dark theme: the same order, darker. */
  static QColor tint(Theme theme, double fraction);

  /** Colour scale of altitudes on 3D glides and curtains and of the safe-altitude overlay, fraction 0 .. 1: ordered in
   *  lightness, so readable without colour vision. @source viridis, S. van der Walt and N. Smith 2015, matplotlib, CC0 */
  static QColor altitudeScale(double fraction);
};

}  // namespace vp::style
