#pragma once

#include "ui/document/plan_view.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>
#include <QString>

#include <memory>
#include <vector>

namespace vp::panels {

/** All decision points of a plan as a table that sorts and filters itself: numbers are compared as numbers, and text is made
 *  only for the rows that are seen, so 10,000 rows cost some milliseconds. */
class DecisionModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Number, Distance, Target, Altitude, Ground, SafeAltitude, Margin, Runway, GlideLength, GlideTime, ColumnCount };

  explicit DecisionModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setPlan(std::shared_ptr<const document::PlanView> plan);
  void setStyle(const style::Units& units, style::Theme theme);
  /** Shows the points whose number, target or runway contains the text; all for empty text. */
  void setFilter(const QString& text);

  /** Decision point shown in a row. */
  [[nodiscard]] int pointOf(int row) const { return order_[static_cast<std::size_t>(row)]; }
  /** Row that shows a decision point, -1 if the filter leaves it out. */
  [[nodiscard]] int rowOf(int point) const;
  [[nodiscard]] const document::PlanView* plan() const { return plan_.get(); }
  /** The number behind a cell, SI; for texts their place in the alphabet. */
  [[nodiscard]] double valueOf(int point, int column) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

private:
  struct Row {
    double ground = 0.0;
    double glideLength = 0.0;
    double glideTime = 0.0;
  };
  void collectRows();
  void reorder();
  [[nodiscard]] bool passes(int point) const;
  [[nodiscard]] QString textOf(int point, int column) const;

  std::shared_ptr<const document::PlanView> plan_;
  std::vector<Row> rows_;
  std::vector<QString> targetNames_;  ///< by target
  std::vector<QString> runwayNames_;  ///< by site
  std::vector<int> runwayRank_;       ///< by site, place of its name in the alphabet
  std::vector<int> targetRank_;
  std::vector<int> order_;  ///< decision point by row
  std::vector<int> rowOf_;  ///< row by decision point, -1: left out
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
  QString filter_;
  int sortColumn_ = Number;
  Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
};

}  // namespace vp::panels
