#pragma once

#include "ui/document/situation.h"

#include <QColor>
#include <QImage>

#include <functional>
#include <memory>

namespace vp::map::testing {

inline constexpr double kFieldSize = 10000.0;  ///< m, side of the square of ground about the origin
inline constexpr double kFieldCell = 50.0;     ///< m

/** Ground from a function of place; infinity: unknown. */
std::shared_ptr<const document::TerrainData> groundOf(const std::function<double(double x, double y)>& height);

/** A field of safe altitudes over the same square in cells of 250 m, four headings from east on; infinity: no glide. */
std::shared_ptr<const landing::SafeAltitudeField> fieldOf(const std::function<float(double x, double y, int heading)>& altitude);

/** Level ground at 400 m with a racetrack of a tour over it, 4 km by 1 km about the origin, flown at `altitude`; from every
 *  decision point a straight glide of 900 m; two targets on the straights, one two-ended runway in the south-west and an
 *  excluded one in the north-east. Safe altitude 800 m everywhere. */
document::Situation racetrack(double altitude = 1000.0);

/** Largest difference of red, green and blue. */
int difference(QRgb a, QRgb b);
/** True if a pixel within `reach` px of a place is like a colour. */
bool hasColorNear(const QImage& image, QPointF at, int reach, const QColor& color, int tolerance = 24);
/** Number of pixels like a colour. */
int countColor(const QImage& image, const QColor& color, int tolerance = 24);

}  // namespace vp::map::testing
