#pragma once

#include "core/mission/weather.h"
#include "ui/style/units.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace vp::dialogs {

/** Name, altitudes and probability of one weather cell, in the units that the pilot has chosen. Values that nobody touches stay as they are. */
class WeatherDialog : public QDialog {
  Q_OBJECT

public:
  /** @param title  what it is called where it has no name */
  WeatherDialog(const mission::WeatherCell& cell, const QString& title, const style::Units& units, QWidget* parent = nullptr);
  [[nodiscard]] mission::WeatherCell result() const;

private:
  void check();
  [[nodiscard]] std::optional<double> heightOf(const QCheckBox& none, const QDoubleSpinBox& field, const std::optional<double>& before) const;

  mission::WeatherCell cell_;
  style::Units units_;
  double shownSuccess_;  ///< percent for a unit of distance, as it was when the dialog opened
  QLineEdit* name_ = nullptr;
  QCheckBox* fromGround_ = nullptr;
  QDoubleSpinBox* floor_ = nullptr;
  QCheckBox* unlimited_ = nullptr;
  QDoubleSpinBox* top_ = nullptr;
  QDoubleSpinBox* success_ = nullptr;
  QLabel* problem_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace vp::dialogs
