#include "ui/map/target_marks.h"

#include "ui/map/words.h"
#include "ui/style/short_name.h"

#include <algorithm>
#include <cctype>

namespace vp::map {

QString targetTitle(const document::ShownTarget& target) {
  const QString name = QString::fromStdString(target.target.name);
  const QString word = Words::tr("target");
  if (name.startsWith(word, Qt::CaseInsensitive)) {
    return word + name.mid(word.size());
  }
  const bool isNumber = !name.isEmpty() && std::all_of(name.begin(), name.end(), [](QChar c) { return c.isDigit(); });
  return isNumber ? word + QLatin1Char(' ') + name : Words::tr("target %1").arg(name);
}

QString targetHeight(const document::ShownTarget& target, const style::Units& units) {
  return target.target.reference == mission::HeightReference::AboveGround
             ? Words::tr("%1 AGL").arg(units.height(target.target.height_m))  // asked for, no margin: as the table rounds it
             : units.altitudeMsl(target.target.height_m);
}

void drawTargetSymbol(QPainter& painter, QPointF at, const style::ChartColors& colors, bool selected, bool hasProblem) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (selected) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.routeCasing, 6.0));
    painter.drawEllipse(at, kTargetRadius + 5.0, kTargetRadius + 5.0);
    painter.setPen(QPen(colors.selection, 3.0));
    painter.drawEllipse(at, kTargetRadius + 5.0, kTargetRadius + 5.0);
  }
  const double tick = kTargetRadius + 4.0;
  const auto ticks = [&](const QPen& pen) {
    painter.setPen(pen);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
      painter.drawLine(at + way * (kTargetRadius - 2.0), at + way * tick);
    }
  };
  ticks(QPen(colors.routeCasing, 4.5, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(colors.routeCasing);
  painter.setPen(QPen(colors.routeCasing, 5.0));
  painter.drawEllipse(at, kTargetRadius, kTargetRadius);
  painter.setPen(QPen(colors.target, 2.2, hasProblem ? Qt::DotLine : Qt::SolidLine));
  painter.drawEllipse(at, kTargetRadius, kTargetRadius);
  ticks(QPen(colors.target, 2.0, Qt::SolidLine, Qt::FlatCap));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.target);
  painter.drawEllipse(at, 2.6, 2.6);
  if (hasProblem) {
    const QPointF corner = at + QPointF(11.0, -11.0);
    const QPolygonF sign{corner + QPointF(0.0, -8.5), corner + QPointF(8.5, 6.5), corner + QPointF(-8.5, 6.5)};
    painter.setPen(QPen(colors.text, 1.4, Qt::SolidLine, Qt::SquareCap, Qt::RoundJoin));
    painter.setBrush(colors.glideTight);
    painter.drawPolygon(sign);
    painter.setPen(QPen(Qt::black, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(corner + QPointF(0.0, -4.0), corner + QPointF(0.0, 1.8));
    painter.drawLine(corner + QPointF(0.0, 3.2), corner + QPointF(0.0, 5.2));
  }
  painter.restore();
}

void TargetMarks::drawSymbols(QPainter& painter, LabelPlacer& labels) const {
  if (scene_.situation.targets == nullptr) {
    return;
  }
  const std::vector<document::ShownTarget>& targets = *scene_.situation.targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const QPointF at = camera_.toScreen(targets[i].point);
    if (camera_.screen().adjusted(-30, -30, 30, 30).contains(at)) {
      drawTargetSymbol(painter, at, scene_.colors(), static_cast<int>(i) == scene_.selectedTarget, !targets[i].problem.empty());
      labels.reserve(QRectF(at.x() - 9.0, at.y() - 9.0, 18.0, 18.0));
    }
  }
}

void TargetMarks::drawLabels(QPainter& painter, LabelPlacer& labels) const {
  if (scene_.situation.targets == nullptr) {
    return;
  }
  const style::ChartColors& colors = scene_.colors();
  const QFont nameFont = chartFont(TextSize::Normal, true);
  const QFont heightFont = chartFont(TextSize::Small);
  for (const document::ShownTarget& target : *scene_.situation.targets) {
    const QPointF at = camera_.toScreen(target.point);
    if (!camera_.screen().adjusted(-60, -60, 60, 60).contains(at)) {
      continue;
    }
    const QStringList name{style::shortName(QString::fromStdString(target.target.name))};
    const QStringList height = scene_.options.targetHeights ? QStringList{targetHeight(target, scene_.units)} : QStringList();
    const QSizeF first = textSize(name, nameFont);
    const QSizeF second = textSize(height, heightFont);
    const double radius = target.problem.empty() ? kTargetRadius + 6.0 : kTargetRadius + 15.0;
    if (const auto both = labels.place(at, radius, {std::max(first.width(), second.width()), first.height() + second.height()})) {
      drawHaloText(painter, *both, name, nameFont, colors.target, colors.textHalo);
      drawHaloText(painter, *both + QPointF(0.0, first.height()), height, heightFont, colors.target, colors.textHalo);
    } else if (const auto alone = labels.place(at, radius, first)) {
      drawHaloText(painter, *alone, name, nameFont, colors.target, colors.textHalo);
    }
  }
}

}  // namespace vp::map
