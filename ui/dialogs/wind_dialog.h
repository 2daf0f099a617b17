#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "core/air/wind_layer.h"
#include "ui/style/units.h"

#include <QDialog>

#include <vector>

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vp::dialogs {

/** The wind that the guarantee has to hold for: a table of layers, each with its range of directions and speeds, filled by hand or
 *  from a text such as 270±20/15±5kt, a METAR or a line of winds aloft. No rows: still air. */
class WindDialog : public QDialog {
  Q_OBJECT

public:
  WindDialog(const std::vector<air::WindLayer>& winds, aircraft::AircraftProfile aircraft, const style::Units& units, QWidget* parent = nullptr);

  /** As the rows say, by altitude; a row that nobody touched is what it was, not what it was rounded to. */
  [[nodiscard]] std::vector<air::WindLayer> result() const;

private:
  enum Column { Altitude, From, Spread, Speed, SpeedSpread, Columns };
  struct Row {
    air::WindLayer given;  ///< as long as its boxes show it
    std::vector<double> shown;
    std::vector<QDoubleSpinBox*> boxes;
  };

  void buildReader();
  void addRow(const air::WindLayer& layer);
  void addLayer();
  void removeLayers();
  void readText();
  void check();
  [[nodiscard]] air::WindLayer layerOf(const Row& row) const;

  aircraft::AircraftProfile aircraft_;
  style::Units units_;
  std::vector<Row> rows_;
  QLineEdit* text_ = nullptr;
  QLabel* notes_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton* remove_ = nullptr;
  QLabel* summary_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace vp::dialogs
