#pragma once

#include "core/geo/pose.h"
#include "ui/document/situation.h"
#include "ui/scene3d/scene_math.h"
#include "ui/scene3d/scene_options.h"
#include "ui/scene3d/terrain_model.h"

#include <QColor>
#include <QString>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace vp::scene3d {

/** A point of the scene in metres east, north and MSL (no exaggeration). */
using ScenePoint = Vec3;

/** A range of altitudes, m MSL, that the colour scale spans. */
struct AltitudeRange {
  double low = 0.0;
  double high = 1.0;
  [[nodiscard]] double fraction(double altitude) const { return (altitude - low) / (high - low); }
  bool operator==(const AltitudeRange&) const = default;
};

/** A line through the air. By altitude: coloured by style::ChartColors::altitudeScale over the scene's range. */
struct SceneLine {
  std::vector<ScenePoint> points;
  QColor color;             ///< one colour; invalid: by altitude
  double width = 3.0;       ///< px at 96 dpi
  QColor casing;            ///< outline; invalid: none
  bool showHidden = false;  ///< shines faintly through the ground in front of it
};

/** The vertical surface between a line and the ground below it. */
struct SceneCurtain {
  std::vector<ScenePoint> top;
  std::vector<double> bottom;  ///< m MSL at each point of `top`
};

/** A translucent volume with upright sides over a closed outline. */
struct SceneVolume {
  std::vector<ScenePoint> top;  ///< not closed: the last joins the first
  std::vector<double> bottom;   ///< m MSL at each point of `top`
  QColor color;
  double opacity = 0.2;  ///< of a side, 0 .. 1
};

/** A pole from the ground to a height, with a head. */
struct ScenePole {
  ScenePoint foot;
  ScenePoint head;
  QColor color;
  bool isSelected = false;
};

/** A runway as it lies on the ground. */
struct SceneRunway {
  geo::Pose threshold;         ///< touchdown point and landing heading
  double elevation = 0.0;      ///< m MSL
  double length = 0.0;         ///< m, from the threshold
  double width = 0.0;          ///< m
  bool usable = true;          ///< from this end
  bool usableBack = false;     ///< from the other end too
  bool isDestination = false;  ///< of the glide that is shown
};

/** A text at a place, upright on the picture. */
struct SceneLabel {
  enum class Kind { Target, Airport, RunwayEnd, Airspace, Cursor };
  Kind kind = Kind::Target;
  ScenePoint anchor;
  QString text;
  QString detail;            ///< second line, left out where there is no room
  QColor color;              ///< of the text
  double priority = 0.0;     ///< the higher goes first where labels would overlap
  double showWithin = 1e12;  ///< m from the eye
};

/** An aircraft seen from behind at a place. */
struct SceneAircraft {
  ScenePoint position;
  double heading = 0.0;
};

/** What is drawn, as plain values: no graphics library. The terrain is shared; everything else belongs to this scene. */
struct SceneData {
  SceneStyle style;
  std::shared_ptr<const TerrainModel> terrain;  ///< null: none
  AltitudeRange altitudes;
  std::vector<SceneLine> lines;
  std::vector<SceneCurtain> curtains;
  std::vector<SceneVolume> volumes;
  std::vector<ScenePole> poles;
  std::vector<SceneRunway> runways;
  std::vector<SceneLabel> labels;
  std::optional<SceneAircraft> aircraft;
};

/** Altitudes that the colour scale spans: from the lowest runway that a glide may end at to the highest point of the tour,
 *  without a plan the range of the terrain; at least 100 m. */
AltitudeRange altitudeRangeOf(const document::Situation& situation);

/** Tour, curtain, targets, runways and, if asked for, all glides. Built off the GUI thread.
 *  @return nothing if asked to stop   @pre terrain, if not null, is of situation.terrain   @threads pure
 *  @cost some ms; with all glides up to some 100 ms per 1000 decision points */
std::optional<SceneData> buildScene(const document::Situation& situation, std::shared_ptr<const TerrainModel> terrain, const SceneOptions& options,
                                    const SceneStyle& style, const std::stop_token& stop = {});

/** What is chosen: the point of the tour that is looked at with its aircraft, its height above the ground and the glide that
 *  would be flown from there (nothing without a plan or a distance), and the selected target, -1: none. @threads pure   @cost well below 1 ms */
SceneData buildCursorScene(const document::Situation& situation, std::shared_ptr<const TerrainModel> terrain, std::optional<double> distance,
                           int selectedTarget, const SceneStyle& style);

/** The part of a scene that a camera should show: tour, runways that its glides end at, and targets; without a tour the terrain.
 *  Metres MSL, no exaggeration. */
Bounds interestOf(const document::Situation& situation);

}  // namespace vp::scene3d
