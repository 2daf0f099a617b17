#include "ui/profile/tour_curves.h"

#include "core/safety/limits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace vp::profile {
namespace {

using document::TourSample;

/// First, lowest, highest and last point of one column, in the order in which they come.
class Column {
public:
  void add(QPointF p) {
    if (count_ == 0) {
      first_ = top_ = bottom_ = p;
      topAt_ = bottomAt_ = 0;
    }
    if (p.y() < top_.y()) {
      top_ = p;
      topAt_ = count_;
    }
    if (p.y() > bottom_.y()) {
      bottom_ = p;
      bottomAt_ = count_;
    }
    last_ = p;
    ++count_;
  }

  void flushTo(QPolygonF& line, bool topOnly) {
    if (count_ == 0) {
      return;
    }
    if (topOnly) {
      line << top_;
      count_ = 0;
      return;
    }
    line << first_;
    const bool topFirst = topAt_ < bottomAt_;
    for (const bool top : {topFirst, !topFirst}) {
      const int at = top ? topAt_ : bottomAt_;
      if (at > 0 && at + 1 < count_) {
        line << (top ? top_ : bottom_);
      }
    }
    if (count_ > 1) {
      line << last_;
    }
    count_ = 0;
  }

private:
  QPointF first_, top_, bottom_, last_;
  int topAt_ = 0;
  int bottomAt_ = 0;
  int count_ = 0;
};

std::vector<Stretch> stretchesWhere(const document::PlanView& plan, const std::function<bool(const TourSample&)>& holds) {
  std::vector<Stretch> found;
  bool open = false;
  for (const TourSample& sample : plan.samples()) {
    const bool inside = holds(sample);
    if (inside && !open) {
      found.push_back({sample.state.distance, sample.state.distance});
    } else if (inside) {
      found.back().to = sample.state.distance;
    }
    open = inside;
  }
  return found;
}

double altitudeOf(const TourSample& sample) {
  return sample.state.altitude;
}

/// The samples in the window by columns; see curveOf and upperEdgeOf.
std::vector<QPolygonF> reduced(const std::vector<TourSample>& samples, AltitudeOf altitude, const PlotScale& scale, double column, bool topOnly) {
  const auto before = [](const TourSample& s, double distance) { return s.state.distance < distance; };
  auto first = std::lower_bound(samples.begin(), samples.end(), scale.window().from, before);
  auto last = std::lower_bound(first, samples.end(), scale.window().to, before);
  first -= first != samples.begin() ? 1 : 0;
  last += last != samples.end() ? 1 : 0;
  std::vector<QPolygonF> lines;
  QPolygonF line;
  Column current;
  double currentAt = 0.0;
  const auto finish = [&] {
    current.flushTo(line, topOnly);
    if (!line.isEmpty()) {
      lines.push_back(line);
      line.clear();
    }
  };
  for (auto sample = first; sample != last; ++sample) {
    const double value = altitude(*sample);
    if (!std::isfinite(value)) {
      finish();
      continue;
    }
    const QPointF p(scale.xOf(sample->state.distance), scale.yOf(value));
    const double at = std::floor(p.x() / column);
    if (at != currentAt) {
      current.flushTo(line, topOnly);
      currentAt = at;
    }
    current.add(p);
  }
  finish();
  return lines;
}

}  // namespace

std::vector<QPolygonF> curveOf(const std::vector<TourSample>& samples, AltitudeOf altitude, const PlotScale& scale, double column) {
  return reduced(samples, altitude, scale, column, false);
}

std::vector<QPolygonF> upperEdgeOf(const std::vector<TourSample>& samples, AltitudeOf altitude, const PlotScale& scale, double column) {
  return reduced(samples, altitude, scale, column, true);
}

QPolygonF thinned(const QPolygonF& line, double tolerance) {
  // from the last kept point on, the slopes that still pass all points left out since then
  QPolygonF kept;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  for (qsizetype i = 0; i < line.size(); ++i) {
    if (kept.isEmpty()) {
      kept << line[i];
      continue;
    }
    const QPointF from = kept.last();
    const double run = line[i].x() - from.x();
    const double rise = line[i].y() - from.y();
    const bool fits = run > 0.0 && rise / run >= least && rise / run <= most;
    if (!fits && line[i - 1] != from) {
      kept << line[i - 1];
      least = -std::numeric_limits<double>::infinity();
      most = std::numeric_limits<double>::infinity();
    }
    const double newRun = line[i].x() - kept.last().x();
    const double newRise = line[i].y() - kept.last().y();
    if (newRun > 0.0) {
      least = std::max(least, (newRise - tolerance) / newRun);
      most = std::min(most, (newRise + tolerance) / newRun);
    } else {  // straight up or down
      kept << line[i];
      least = -std::numeric_limits<double>::infinity();
      most = std::numeric_limits<double>::infinity();
    }
  }
  if (!line.isEmpty() && kept.last() != line.last()) {
    kept << line.last();
  }
  return kept;
}

double shownMargin(double margin) {
  return margin < 0.0 && margin >= -safety::kAltitudeTolerance ? 0.0 : margin;
}

QPainterPath areaBelow(const std::vector<QPolygonF>& curve, const PlotScale& scale) {
  QPainterPath path;
  const double floor = scale.area().bottom() + 1.0;
  for (const QPolygonF& line : curve) {
    path.moveTo(line.first().x(), floor);
    for (const QPointF& p : line) {
      path.lineTo(p);
    }
    path.lineTo(line.last().x(), floor);
    path.closeSubpath();
  }
  return path;
}

double lowestAllowed(const TourSample& sample, double clearance) {
  return std::max(sample.state.safeAltitude, sample.state.ground + clearance);
}

std::vector<Stretch> violations(const document::PlanView& plan) {
  const double clearance = plan.plan().mission.safety.clearance.si();
  return stretchesWhere(plan,
                        [clearance](const TourSample& s) { return s.state.altitude < lowestAllowed(s, clearance) - safety::kAltitudeTolerance; });
}

std::vector<Stretch> unknownGround(const document::PlanView& plan) {
  return stretchesWhere(plan, [](const TourSample& s) { return !std::isfinite(s.state.ground); });
}

QPainterPath violatedArea(const document::PlanView& plan, const PlotScale& scale) {
  const double clearance = plan.plan().mission.safety.clearance.si();
  const double ceiling = scale.window().high + scale.window().height();
  const std::vector<TourSample>& samples = plan.samples();
  QPainterPath path;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double xa = samples[i].state.distance;
    const double xb = samples[i + 1].state.distance;
    if (xb < scale.window().from || xa > scale.window().to) {
      continue;
    }
    const double tourA = altitudeOf(samples[i]);
    const double tourB = altitudeOf(samples[i + 1]);
    const double limitA = std::min(lowestAllowed(samples[i], clearance), ceiling);
    const double limitB = std::min(lowestAllowed(samples[i + 1], clearance), ceiling);
    const double missingA = limitA - tourA;
    const double missingB = limitB - tourB;
    if (std::max(missingA, missingB) <= safety::kAltitudeTolerance) {
      continue;
    }
    const double cross = missingA == missingB ? 0.0 : missingA / (missingA - missingB);
    const double from = missingA < 0.0 ? cross : 0.0;
    const double to = missingB < 0.0 ? cross : 1.0;
    const auto at = [&](double t, double a, double b) { return QPointF(scale.xOf(xa + t * (xb - xa)), scale.yOf(a + t * (b - a))); };
    path.moveTo(at(from, tourA, tourB));
    path.lineTo(at(to, tourA, tourB));
    path.lineTo(at(to, limitA, limitB));
    path.lineTo(at(from, limitA, limitB));
    path.closeSubpath();
  }
  return path;
}

int glideSite(const document::PlanView& plan, const document::TourState& state) {
  const std::vector<mission::DecisionPoint>& tour = plan.plan().tour;
  const auto point = static_cast<std::size_t>(state.point);
  const bool beyond = state.distance > plan.distanceOf(point);
  const int site = tour[beyond ? (point + 1) % tour.size() : point].witness.site;
  return site >= 0 && static_cast<std::size_t>(site) < plan.plan().sites.size() ? site : -1;
}

QString runwayName(const mission::LandingSite& site) {
  if (site.airportIdent.empty() || site.runwayIdent.empty()) {
    return QString::fromStdString(site.id).replace(QLatin1Char('/'), QLatin1Char(' '));
  }
  return QString::fromStdString(site.airportIdent + " " + site.runwayIdent);
}

QString runwayNameLong(const mission::LandingSite& site) {
  const QString name = QString::fromStdString(site.airportName);
  return name.isEmpty() ? runwayName(site) : runwayName(site) + QLatin1Char(' ') + name;
}

}  // namespace vp::profile
