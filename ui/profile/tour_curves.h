#pragma once

#include "ui/document/plan_view.h"
#include "ui/profile/plot_scale.h"

#include <QPainterPath>
#include <QPolygonF>
#include <QString>

#include <vector>

namespace vp::profile {

/// One altitude of a sample [m MSL]; infinite or no number where there is none.
using AltitudeOf = double (*)(const document::TourSample&);

/** A curve of the tour as polylines for the painter: in every pixel column its first, lowest, highest and last sample, so no
 *  peak is lost however many samples fall into one. Broken where the altitude is not finite. One sample beyond each side
 *  of the window is kept, so that lines run out of the plot.
 *  @param column  width of a column in logical pixels, for example 1 / devicePixelRatio */
std::vector<QPolygonF> curveOf(const std::vector<document::TourSample>& samples, AltitudeOf altitude, const PlotScale& scale, double column);

/** The upper edge of a curve: one point per column, the highest. What is filled below it covers at least the ground that is
 *  there, with a quarter of the points. */
std::vector<QPolygonF> upperEdgeOf(const std::vector<document::TourSample>& samples, AltitudeOf altitude, const PlotScale& scale, double column);

/** Leaves out points that lie within `tolerance` pixels, measured along y, of the line through their neighbours: straight
 *  stretches become one piece. @return a polyline that passes every given point within `tolerance` */
QPolygonF thinned(const QPolygonF& line, double tolerance);

/** The area below such polylines down to the plot's lower edge. */
QPainterPath areaBelow(const std::vector<QPolygonF>& curve, const PlotScale& scale);

/** A stretch of the tour. */
struct Stretch {
  double from = 0.0;  ///< m
  double to = 0.0;
};

/** Lowest altitude that the plan may have at a sample: the safe altitude, and the clearance above the ground. */
double lowestAllowed(const document::TourSample& sample, double clearance);

/** Stretches where the tour is lower than allowed by more than the checker's tolerance; unknown ground counts. */
std::vector<Stretch> violations(const document::PlanView& plan);

/** Stretches over unknown ground. */
std::vector<Stretch> unknownGround(const document::PlanView& plan);

/** The area between the tour and what it should not be below, where it is below. */
QPainterPath violatedArea(const document::PlanView& plan, const PlotScale& scale);

/** A margin as shown: one that is negative only by the checker's tolerance is none at all and no violation [m]. */
double shownMargin(double margin);

/** Index into Plan::sites of the runway that the glide from a state ends at, -1 if there is none. */
int glideSite(const document::PlanView& plan, const document::TourState& state);

/** "LSZS 03": airport and runway end; the id where the file has no idents. */
QString runwayName(const mission::LandingSite& site);

/** "LSZS 03 Samedan". */
QString runwayNameLong(const mission::LandingSite& site);

}  // namespace vp::profile
