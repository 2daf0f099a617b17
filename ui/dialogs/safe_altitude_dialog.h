#pragma once

#include "core/charts/safe_altitude_chart.h"

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;

namespace vp::dialogs {

/** Asks what a map of lowest safe altitudes is to hold: which courses, cells and contours. */
class SafeAltitudeDialog : public QDialog {
  Q_OBJECT

public:
  explicit SafeAltitudeDialog(QWidget* parent = nullptr);

  /** Without area and threads. */
  [[nodiscard]] charts::ChartRequest request() const;

private:
  void showChoice();

  QComboBox* courses_ = nullptr;
  QDoubleSpinBox* course_ = nullptr;
  QSpinBox* cell_ = nullptr;
  QSpinBox* interval_ = nullptr;
};

}  // namespace vp::dialogs
