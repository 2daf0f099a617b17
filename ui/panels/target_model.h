#pragma once

#include "ui/document/situation.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace vp::panels {

/** The targets of the mission as an editable table. It holds no truth of its own: an edit is asked for by a signal, and
 *  shown when the next situation brings it. */
class TargetModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Name, Height, Datum, Altitude, Ground, Position, Problem, ColumnCount };

  explicit TargetModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setTargets(std::shared_ptr<const std::vector<document::ShownTarget>> targets, std::shared_ptr<const document::TerrainData> terrain);
  void setStyle(const style::Units& units, style::Theme theme);
  [[nodiscard]] const document::ShownTarget* target(int row) const;
  [[nodiscard]] const style::Units& units() const { return units_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
  void targetEdited(int row, const vp::mission::Target& target);
  /// A text that is no position or name; for the status line.
  void editRefused(const QString& reason);

private:
  [[nodiscard]] QString textOf(const document::ShownTarget& shown, int column) const;
  [[nodiscard]] bool isTaken(const QString& name, int exceptRow) const;

  std::shared_ptr<const std::vector<document::ShownTarget>> targets_;
  std::shared_ptr<const document::TerrainData> terrain_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

/** "above ground", "above sea level". */
QString datumName(mission::HeightReference reference);

}  // namespace vp::panels
