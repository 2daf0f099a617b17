#include "ui/dialogs/polar_preview.h"

#include "core/aircraft/glide_model.h"
#include "ui/profile/plot_text.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vp::dialogs {
namespace {

constexpr int kFirstBank = 10;
constexpr int kLastBank = 70;

/// Height lost in a turn by 180 degrees [m].
double halfTurnLoss(const aircraft::GlideModel& model, double bank_deg) {
  const double radius = model.radiusOf(Angle::degrees(bank_deg));
  return model.lossAt(radius) * Angle::kPi * radius;
}

bool hasPolar(const aircraft::AircraftProfile& p) {
  return p.mass_kg > 0.0 && p.wingArea_m2 > 0.0 && p.zeroLiftDrag > 0.0 && p.inducedDrag > 0.0 && p.airDensity_kgm3 > 0.0 &&
         p.bestGlideSpeed.si() > 0.0;
}

double niceStep(double range, int parts) {
  const double raw = range / parts;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

}  // namespace

double stallBank_deg(const aircraft::AircraftProfile& profile) {
  if (!profile.stallSpeed || profile.stallSpeed->si() <= 0.0) {
    return 90.0;
  }
  const double ratio = profile.bestGlideSpeed / *profile.stallSpeed;
  return ratio <= 1.0 ? 0.0 : Angle::radians(std::acos(1.0 / (ratio * ratio))).degrees();
}

PolarPreview::PolarPreview(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Glide performance"));
}

void PolarPreview::setProfile(const aircraft::AircraftProfile& profile, const style::Units& units, style::Theme theme) {
  profile_ = profile;
  units_ = units;
  theme_ = theme;
  isValid_ = hasPolar(profile);
  if (isValid_) {
    const aircraft::GlideModel model(profile_);
    setAccessibleDescription(tr("Straight glide ratio %1").arg(1.0 / model.straightLoss(), 0, 'f', 1));
  }
  update();
}

void PolarPreview::paintEvent(QPaintEvent* /*event*/) {
  const style::ChartColors& c = style::ChartColors::of(theme_);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), c.panel);
  painter.setPen(c.text);
  if (!isValid_) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Mass, wing area, drag, density and speed must be positive."));
    return;
  }
  const aircraft::GlideModel model(profile_);
  double highest = 0.0;
  std::vector<std::pair<double, double>> curve;
  for (int bank = kFirstBank; bank <= kLastBank; ++bank) {
    const double loss = halfTurnLoss(model, bank);
    if (std::isfinite(loss)) {
      curve.emplace_back(bank, loss);
    }
  }
  const auto at30 = std::find_if(curve.begin(), curve.end(), [](const auto& p) { return p.first >= 15.0; });
  for (auto it = at30; it != curve.end(); ++it) {
    highest = std::max(highest, std::min(it->second, 3.0 * at30->second));
  }
  highest = std::max(highest, 1.0);
  const QFontMetrics metrics = painter.fontMetrics();
  const QString top = tr("Glide ratio %1 : 1 (%2) at %3, wings level")
                          .arg(1.0 / model.straightLoss(), 0, 'f', 1)
                          .arg(style::Units::angle(Angle::radians(std::atan(model.straightLoss())).degrees()), units_.speed(model.airspeed()));
  const QRectF header(8, 6, width() - 16, metrics.height() * 2.2);
  painter.drawText(header, Qt::TextWordWrap | Qt::AlignLeft, top);
  painter.setPen(c.mutedText);
  painter.drawText(QRectF(8, height() - metrics.height() - 4, width() - 16, metrics.height()), Qt::AlignCenter, tr("Bank angle"));
  const double left = metrics.horizontalAdvance(QStringLiteral("0 000")) + 34.0;
  const QRectF plot(left, header.bottom() + metrics.height() + 2, width() - left - 14, height() - header.bottom() - 3.4 * metrics.height() - 12);
  painter.drawText(QRectF(8, header.bottom() - 2, width() - 16, metrics.height()), Qt::AlignLeft, tr("Height lost in a half turn"));
  const auto toX = [&](double bank) { return plot.left() + (bank - kFirstBank) / (kLastBank - kFirstBank) * plot.width(); };
  const auto toY = [&](double loss) { return plot.bottom() - loss / highest * plot.height(); };

  const double shownMost = units_.heightFromSi(highest);
  const double step = niceStep(shownMost, 4);
  const int ticks = static_cast<int>(shownMost / step + 1e-9);
  for (int i = 0; i <= ticks; ++i) {
    const double tick = i * step;
    const double y = toY(units_.heightToSi(tick));
    painter.setPen(c.grid);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(c.mutedText);
    painter.drawText(QRectF(0, y - 10, left - 6, 20), Qt::AlignRight | Qt::AlignVCenter, units_.height(units_.heightToSi(tick)));
  }
  for (int bank = kFirstBank; bank <= kLastBank; bank += 10) {
    painter.drawText(QRectF(toX(bank) - 30, plot.bottom() + 3, 60, metrics.height()), Qt::AlignHCenter, QStringLiteral("%1°").arg(bank));
  }
  if (const double stall = stallBank_deg(profile_); stall < kLastBank) {
    const QRectF zone(QPointF(toX(std::max<double>(stall, kFirstBank)), plot.top()), plot.bottomRight());
    QColor hatch = c.violation;
    hatch.setAlpha(120);
    painter.fillRect(zone, QBrush(hatch, Qt::BDiagPattern));
    painter.setPen(c.violation);
    painter.drawText(zone.adjusted(0, 2, -4, 0), Qt::AlignTop | Qt::AlignRight, tr("stalls"));
  }
  painter.setClipRect(plot.adjusted(-2, -2, 2, 2));
  QPainterPath path;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const QPointF p(toX(curve[i].first), toY(curve[i].second));
    i == 0 ? path.moveTo(p) : path.lineTo(p);
  }
  painter.setPen(QPen(c.safeAltitude, 2.0));
  painter.drawPath(path);
  painter.setClipping(false);
  for (const Angle bank : profile_.glideBanks) {
    const double loss = halfTurnLoss(model, bank.degrees());
    if (std::isfinite(loss) && bank.degrees() >= kFirstBank && bank.degrees() <= kLastBank) {
      const QPointF p(toX(bank.degrees()), toY(loss));
      painter.setPen(QPen(c.panel, 2.0));
      painter.setBrush(c.route);
      painter.drawEllipse(p, 5.0, 5.0);
      painter.setPen(c.text);
      const QString label = tr("%1, r %2").arg(units_.height(loss), units_.height(model.radiusOf(bank)));
      const double w = metrics.horizontalAdvance(label);
      // to the upper right, where the falling curve is not
      const QPointF at(std::clamp(p.x() + 4.0, plot.left() + 2.0, plot.right() - w), p.y() - 9.0);
      profile::drawHaloText(painter, at, label, c.text, c.panel);
    }
  }
}

}  // namespace vp::dialogs
