#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>
#include <QString>

#include <vector>

namespace vp::dialogs {

/** Targets to choose from, each with a check box; filters itself. Text is made only for the rows that are seen, so 100,000 targets cost some
 *  milliseconds. */
class TargetChoiceModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Name, Position, Height, ColumnCount };

  explicit TargetChoiceModel(const style::Units& units, QObject* parent = nullptr) : QAbstractTableModel(parent), units_(units) {}

  /** Names are unique. Those that were there before by name keep their choice; new ones are chosen if all were, at first unless there are more than
   *  `most`. */
  void setTargets(std::vector<mission::Target> targets, std::size_t most);
  /** Shows the targets whose names contain the text, whatever its case; all for empty text. */
  void setFilter(const QString& text);
  /** Chooses all that are shown, or none of them; the others stay as they are. */
  void chooseShown(bool chosen);

  [[nodiscard]] std::vector<mission::Target> chosen() const;  ///< in the order of the file, shown or not
  [[nodiscard]] std::size_t chosenCount() const { return chosenCount_; }
  [[nodiscard]] std::size_t count() const { return rows_.size(); }  ///< shown or not

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
  void choiceChanged();

private:
  struct Row {
    mission::Target target;
    bool isChosen = true;
  };
  void collectShown();
  void choose(Row& row, bool chosen);
  [[nodiscard]] QString textOf(const mission::Target& target, int column) const;

  style::Units units_;
  std::vector<Row> rows_;
  std::vector<std::size_t> shown_;  ///< places in rows_
  std::size_t chosenCount_ = 0;
  QString filter_;
};

}  // namespace vp::dialogs
