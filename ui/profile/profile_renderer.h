#pragma once

#include "ui/document/situation.h"
#include "ui/profile/plot_scale.h"
#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"

#include <QImage>
#include <QRectF>
#include <QSize>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

class QFontMetricsF;
class QPainter;

namespace vp::profile {

/** A sentence in the strip above the plot that says where the least of something is. */
struct ProfileFact {
  Mark mark = Mark::LeastClearance;
  QString text;           ///< "Least clearance 412 ft AGL at 12.3 NM"
  double distance = 0.0;  ///< m, where
  bool isViolated = false;
  QRectF rect = {};  ///< where it is written
};

/** How a point of the tour is marked. */
enum class Cursor { Hovered, Pinned };

/** The altitude profile of a tour, on any paint device: terrain, lowest safe altitude, tour, targets, least margins.
 *
 *  A strip with the least clearance and the least glide margin stands above the plot and the legend below it, so nothing
 *  written covers data; names of targets have lanes of their own on top. Curves are drawn from PlanView::samples(), reduced
 *  to the pixels of the device without losing a peak.
 *  @threads any thread that may use fonts; const members are pure   @cost paint: some ms for 10,000 samples */
class ProfileRenderer {
public:
  /** @pre situation.plan is not null  @param size  logical pixels  @param window  shown part; all of it if absent */
  ProfileRenderer(const document::Situation& situation, ProfileStyle style, QSizeF size, std::optional<PlotWindow> window = {});

  /** All of the tour, and altitudes from below the terrain to above the highest curve. */
  [[nodiscard]] static PlotWindow fullWindow(const document::PlanView& plan);

  [[nodiscard]] const PlotScale& scale() const { return scale_; }
  /** The plot with the lanes of the target names: where the mouse is on the profile. */
  [[nodiscard]] const QRectF& frame() const { return frame_; }
  [[nodiscard]] const std::vector<ProfileFact>& facts() const { return facts_; }

  /** Everything but the cursor. */
  void paint(QPainter& painter) const;
  /** Vertical line, the tour's place in it, and the height between it and the safe altitude. */
  void paintCursor(QPainter& painter, double distance, Cursor kind) const;

private:
  static constexpr double kLeastWithWind = 110.0;  ///< px: lower plots need all their height
  struct LegendEntry;
  struct Badge {
    QString text;
    QRectF rect;
  };
  struct TargetLabel {
    double x = 0.0;
    int lane = -1;  ///< -1: no room for the name
    QString name;
    int target = -1;
    double distance = 0.0;
  };
  void layOut(QSizeF size, const std::optional<PlotWindow>& window);
  void collectFacts();
  double layOutStrip(const QFontMetricsF& metrics, double width);
  void layOutTargets(const QFontMetricsF& metrics);
  [[nodiscard]] std::vector<LegendEntry> legend() const;
  [[nodiscard]] double legendHeight(double width) const;

  void paintFrame(QPainter& painter) const;
  void paintAxes(QPainter& painter) const;
  void paintAirspaces(QPainter& painter) const;
  void paintTerrain(QPainter& painter, double column) const;
  void paintCurves(QPainter& painter, double column) const;
  void paintViolations(QPainter& painter) const;
  void paintTargets(QPainter& painter) const;
  void paintSpirals(QPainter& painter) const;
  void paintDecisionPoints(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;
  void paintWind(QPainter& painter) const;
  void paintStrip(QPainter& painter) const;
  void paintLegend(QPainter& painter) const;
  [[nodiscard]] bool showsDecisionPoints() const;
  [[nodiscard]] bool showsWind() const { return hasWind_ && frame_.height() > kLeastWithWind; }
  [[nodiscard]] bool isDimmed() const { return !situation_.planIsCurrent; }

  document::Situation situation_;
  const document::PlanView& plan_;
  ProfileStyle style_;
  QFont font_;
  QFont small_;
  QSizeF size_;
  QRectF frame_;
  PlotScale scale_;
  std::vector<double> altitudeTicks_;  ///< in the shown unit
  std::vector<double> distanceTicks_;
  std::vector<ProfileFact> facts_;
  std::vector<Badge> badges_;
  std::vector<TargetLabel> labels_;
  std::vector<Stretch> violations_;
  std::vector<Stretch> unknown_;
  double legendTop_ = 0.0;
  bool hasWind_ = false;
};

/** The profile as a picture without any widget; what is missing is said in it if there is no plan.
 *  @param size  logical pixels; the picture has size * dpr   @param cursor  m along the tour, marked if given */
QImage renderProfile(const document::Situation& situation, QSize size, double dpr, style::Theme theme, const style::Units& units,
                     std::optional<double> cursor = {});

/** What to do next, in a sentence, while there is no plan to draw. */
QString emptyProfileText(const document::Situation& situation);

/** That sentence, centred. */
void paintEmptyProfile(QPainter& painter, const QRectF& area, const document::Situation& situation, const ProfileStyle& style);

}  // namespace vp::profile
