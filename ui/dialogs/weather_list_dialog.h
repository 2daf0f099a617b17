#pragma once

#include "core/mission/weather.h"
#include "ui/style/units.h"

#include <QDialog>

#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace vp::dialogs {

/** The weather of the mission, a line a cell; name, floor, top and probability are edited in the table. Changes nothing itself; whoever owns the
 *  document answers the signals and shows it the weather again. Does not block the window. */
class WeatherListDialog : public QDialog {
  Q_OBJECT

public:
  explicit WeatherListDialog(QWidget* parent = nullptr);

  void setWeather(const std::vector<mission::WeatherCell>& cells, const style::Units& units);
  /** Marks a line; -1: none. */
  void select(int cell);
  [[nodiscard]] QTableWidget& list() { return *list_; }

signals:
  void cellEdited(int cell, const vp::mission::WeatherCell& value);
  void editRequested(int cell);
  void removeRequested(int cell);
  void selected(int cell);
  void drawRequested();
  void addRequested();
  void exportRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void fillRow(int row);
  void take(const QTableWidgetItem& item);
  [[nodiscard]] bool readInto(mission::WeatherCell& cell, int column, const QString& text) const;
  void refresh();

  std::vector<mission::WeatherCell> cells_;
  style::Units units_;
  bool isFilling_ = false;
  QTableWidget* list_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* edit_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* export_ = nullptr;
};

}  // namespace vp::dialogs
