#include "ui/map/site_marks.h"

#include "ui/map/words.h"
#include "ui/style/short_name.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace vp::map {
namespace {

using document::ShownSite;

constexpr double kUnknownLength = 500.0;  // m, drawn where a file has no length; the mark of approximation says so
constexpr double kUnknownWidth = 20.0;    // m
constexpr double kLeastWidth = 4.0;       // px
constexpr double kSameStrip = 400.0;      // m between thresholds that belong to one strip's ends
constexpr double kIdentPixels = 56.0;     // px of strip from which runway idents are written at its ends
constexpr double kNamesScale = 45.0;      // m per px below which names and elevations are written
constexpr double kRingBorder = 3.0;       // px of the ring's line, outside
constexpr double kStripRoom = 5.0;        // px on either side of the middle of a strip
constexpr double kTurned = 0.35;          // rad by which two ends of a strip may differ from opposite

double lengthOf(const mission::SiteInFrame& site) {
  return site.site.length ? site.site.length->si() : kUnknownLength;
}

double lengthOf(const ShownSite& site) {
  return lengthOf(site.site);
}

geo::Point farEnd(const mission::SiteInFrame& site) {
  const geo::Pose& pose = site.pose;
  return {pose.x + lengthOf(site) * std::cos(pose.heading), pose.y + lengthOf(site) * std::sin(pose.heading)};
}

geo::Point farEnd(const ShownSite& site) {
  return farEnd(site.site);
}

const std::string& airportOf(const ShownSite& site) {
  return site.site.site.airportIdent.empty() ? site.site.site.id : site.site.site.airportIdent;
}

QRectF boxAround(QPointF centre, double radius) {
  return {centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius};
}

QPointF forward(const ShownSite& site) {
  return {std::cos(site.site.pose.heading), -std::sin(site.site.pose.heading)};
}

}  // namespace

QString siteTitle(const mission::LandingSite& site) {
  const QString airport = QString::fromStdString(site.airportIdent.empty() ? site.id : site.airportIdent);
  return site.runwayIdent.empty() ? airport : airport + QLatin1Char(' ') + QString::fromStdString(site.runwayIdent);
}

std::vector<QRectF> runwayBoxes(const mission::SiteInFrame& site, const MapCamera& camera) {
  const QPointF from = camera.toScreen(site.pose.point());
  const QPointF strip = camera.toScreen(farEnd(site)) - from;
  std::vector<QRectF> boxes{boxAround(from, kRingRadius + kRingBorder)};
  const double length = std::hypot(strip.x(), strip.y());
  if (length < kStripPixels) {
    return boxes;  // the ring lies around the symbol
  }
  const double halfWidth = std::max(kStripRoom, 0.5 * (site.site.width ? site.site.width->si() : kUnknownWidth) / camera.metresPerPixel() + 1.5);
  const double most = std::min(length, camera.screen().width() + camera.screen().height());  // the rest is out of view
  const int count = static_cast<int>(std::ceil(most / halfWidth));
  for (int i = 0; i <= count; ++i) {
    boxes.push_back(boxAround(from + strip * (std::min(most, i * halfWidth) / length), halfWidth));
  }
  return boxes;
}

QRectF SiteLabel::firstBox() const {
  const QSizeF size = textSize(lines, font);
  return {anchor + QPointF(radius, -0.5 * size.height()), size};
}

bool SiteMarks::isShown(const ShownSite& site) const {
  return site.usable || scene_.options.excludedSites;
}

double SiteMarks::stripPixels(const ShownSite& site) const {
  return lengthOf(site) / camera_.metresPerPixel();
}

bool SiteMarks::isOtherEndDrawn(std::size_t index) const {
  const std::vector<ShownSite>& sites = *scene_.situation.sites;
  const ShownSite& site = sites[index];
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const ShownSite& other = sites[i];
    const bool isBefore = other.usable == site.usable ? i < index : other.usable;
    if (isBefore && isShown(other) && other.site.site.airportIdent == site.site.site.airportIdent &&
        std::abs(wrapPi(other.site.pose.heading - site.site.pose.heading - Angle::kPi)) < kTurned &&
        geo::distance(other.site.pose.point(), farEnd(site)) < kSameStrip) {
      return true;
    }
  }
  return false;
}

void SiteMarks::drawStrip(QPainter& painter, const ShownSite& site) const {
  const style::ChartColors& colors = scene_.colors();
  const double metres = site.site.site.width ? site.site.site.width->si() : kUnknownWidth;
  const double width = std::max(kLeastWidth, metres / camera_.metresPerPixel());
  const QPointF from = camera_.toScreen(site.site.pose.point());
  const QPointF to = camera_.toScreen(farEnd(site));
  if (site.usable) {
    painter.setPen(QPen(colors.routeCasing, width + 3.0, Qt::SolidLine, Qt::SquareCap));
    painter.drawLine(from, to);
    painter.setPen(QPen(colors.runway, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(from, to);
    if (width >= 7.0) {
      painter.setPen(QPen(colors.textHalo, std::max(1.0, width * 0.07), Qt::CustomDashLine, Qt::FlatCap));
      QPen pen = painter.pen();
      pen.setDashPattern({8.0, 6.0});
      painter.setPen(pen);
      painter.drawLine(from, to);
    }
    return;
  }
  const QPointF across = QPointF(-forward(site).y(), forward(site).x()) * (0.5 * width);
  painter.setPen(QPen(colors.routeCasing, 3.0));
  painter.setBrush(Qt::NoBrush);
  const QPolygonF outline{from + across, to + across, to - across, from - across};
  painter.drawPolygon(outline);
  painter.setPen(QPen(colors.runwayExcluded, 1.4, Qt::DashLine));
  painter.drawPolygon(outline);
}

void SiteMarks::drawSymbol(QPainter& painter, const ShownSite& site) const {
  const style::ChartColors& colors = scene_.colors();
  const QPointF centre = camera_.toScreen(site.site.pose.point());
  const QPointF along = forward(site) * (kSiteRadius + 4.0);
  painter.setPen(QPen(colors.routeCasing, 5.0, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(Qt::NoBrush);
  painter.drawLine(centre - along, centre + along);
  painter.drawEllipse(centre, kSiteRadius, kSiteRadius);
  const QColor ink = site.usable ? colors.runway : colors.runwayExcluded;
  painter.setBrush(colors.routeCasing);
  painter.setPen(QPen(ink, 1.8, site.usable ? Qt::SolidLine : Qt::DotLine));
  painter.drawEllipse(centre, kSiteRadius, kSiteRadius);
  painter.setPen(QPen(ink, site.usable ? 3.0 : 1.6, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(centre - along, centre + along);
}

void SiteMarks::drawThreshold(QPainter& painter, const ShownSite& site, LabelPlacer& labels) const {
  if (!site.usable || stripPixels(site) < kIdentPixels) {
    return;
  }
  // a chevron on the approach side, pointing the way that is landed
  const QPointF ahead = forward(site);
  const QPointF across(-ahead.y(), ahead.x());
  const QPointF tip = camera_.toScreen(site.site.pose.point()) - ahead * 3.0;
  const QPolygonF chevron{tip - ahead * 8.0 + across * 6.0, tip, tip - ahead * 8.0 - across * 6.0};
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(scene_.colors().routeCasing, 5.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(chevron);
  painter.setPen(QPen(scene_.colors().runway, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(chevron);
  labels.reserve(chevron.boundingRect());
}

void SiteMarks::drawSymbols(QPainter& painter, LabelPlacer& labels) const {
  if (scene_.situation.sites == nullptr) {
    return;
  }
  const std::vector<ShownSite>& sites = *scene_.situation.sites;
  const geo::Box view = camera_.visible(40.0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const geo::Box near = view.grown(lengthOf(sites[i]));
    if (!isShown(sites[i]) || !near.contains(sites[i].site.pose.point())) {
      continue;
    }
    const QPointF at = camera_.toScreen(sites[i].site.pose.point());
    if (!isOtherEndDrawn(i)) {
      if (stripPixels(sites[i]) >= kStripPixels) {
        drawStrip(painter, sites[i]);
        const QPointF end = camera_.toScreen(farEnd(sites[i]));
        for (int k = 0; k <= 4; ++k) {
          const QPointF on = at + (end - at) * (k / 4.0);
          labels.reserve(QRectF(on.x() - 5.0, on.y() - 5.0, 10.0, 10.0));
        }
      } else {
        drawSymbol(painter, sites[i]);
        labels.reserve(QRectF(at.x() - kSiteRadius, at.y() - kSiteRadius, 2.0 * kSiteRadius, 2.0 * kSiteRadius));
      }
    }
    drawThreshold(painter, sites[i], labels);
  }
  painter.restore();
}

SiteLabel SiteMarks::labelOf(const std::string& ident, const ShownSite& site, bool isApproximate) const {
  const bool isDetailed = camera_.metresPerPixel() < kNamesScale;
  const bool isStrip = stripPixels(site) >= kStripPixels;
  const geo::Point end = farEnd(site);
  const geo::Point middle{0.5 * (site.site.pose.x + end.x), 0.5 * (site.site.pose.y + end.y)};
  SiteLabel label;
  label.usable = site.usable;
  label.anchor = camera_.toScreen(isStrip ? middle : site.site.pose.point());
  label.radius = isStrip ? 10.0 + 0.5 * std::abs(forward(site).x()) * stripPixels(site) : kSiteRadius + 6.0;
  label.font = chartFont(site.usable ? TextSize::Normal : TextSize::Small, site.usable);
  label.lines.push_back(QString::fromStdString(ident) + (isApproximate ? QStringLiteral(" ≈") : QString()));
  if (isDetailed && !site.site.site.airportName.empty()) {
    label.lines.push_back(style::shortName(QString::fromStdString(site.site.site.airportName)));
  }
  if (isDetailed) {
    label.lines.push_back(site.usable ? scene_.units.altitudeMsl(site.site.site.elevation.metres()) : Words::tr("not used"));
  }
  return label;
}

std::vector<SiteLabel> SiteMarks::labelsOf(const std::string& only) const {
  struct Airport {
    const ShownSite* first = nullptr;
    bool isApproximate = false;
  };
  std::map<std::string, Airport> airports;
  for (const ShownSite& site : *scene_.situation.sites) {
    if (!isShown(site) || (!only.empty() && airportOf(site) != only)) {
      continue;
    }
    Airport& airport = airports[airportOf(site)];
    airport.first = airport.first == nullptr || (site.usable && !airport.first->usable) ? &site : airport.first;
    airport.isApproximate = airport.isApproximate || site.site.site.isApproximate();
  }
  std::vector<SiteLabel> made;
  for (const bool usable : {true, false}) {
    for (const auto& [ident, airport] : airports) {
      if (airport.first->usable == usable) {
        made.push_back(labelOf(ident, *airport.first, airport.isApproximate));
      }
    }
  }
  return made;
}

void SiteMarks::drawLabels(QPainter& painter, LabelPlacer& labels) const {
  if (scene_.situation.sites == nullptr) {
    return;
  }
  drawIdents(painter, labels);
  const style::ChartColors& colors = scene_.colors();
  for (const SiteLabel& label : labelsOf()) {
    if (!camera_.screen().adjusted(-60, -60, 60, 60).contains(label.anchor)) {
      continue;
    }
    const std::optional<QPointF> place = labels.place(label.anchor, label.radius, textSize(label.lines, label.font));
    if (place) {
      drawHaloText(painter, *place, label.lines, label.font, label.usable ? colors.runway : colors.mutedText, colors.textHalo);
    }
  }
}

void SiteMarks::drawIdents(QPainter& painter, LabelPlacer& labels) const {
  const style::ChartColors& colors = scene_.colors();
  for (const ShownSite& site : *scene_.situation.sites) {
    if (!site.usable || site.site.site.runwayIdent.empty() || stripPixels(site) < kIdentPixels) {
      continue;
    }
    const QStringList text{QString::fromStdString(site.site.site.runwayIdent)};
    const QFont font = chartFont(TextSize::Small, true);
    QRectF box(QPointF(), textSize(text, font));
    box.moveCenter(camera_.toScreen(site.site.pose.point()) - forward(site) * 22.0);
    if (labels.placeAt(box)) {
      drawHaloText(painter, box.topLeft(), text, font, colors.runway, colors.textHalo);
    }
  }
}

}  // namespace vp::map
