#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QWidget>

namespace vp::dialogs {

/** The glide of an aircraft as a picture: height lost in a half turn against the bank angle, the banks that glides may use
 *  marked, the bank from which the wing stalls hatched, and the straight glide ratio in words. */
class PolarPreview : public QWidget {
  Q_OBJECT

public:
  explicit PolarPreview(QWidget* parent = nullptr);
  void setProfile(const aircraft::AircraftProfile& profile, const style::Units& units, style::Theme theme);
  [[nodiscard]] QSize sizeHint() const override { return {380, 260}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {280, 200}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  aircraft::AircraftProfile profile_;
  bool isValid_ = false;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

/** Bank angle from which level turns at the glide speed stall [deg]; 90 if the profile has no stall speed. n = (v / v_s)^2. */
double stallBank_deg(const aircraft::AircraftProfile& profile);

}  // namespace vp::dialogs
