#pragma once

#include "ui/document/landing_case.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace vp::panels {

/** Every runway by total risk, a row each, the least risk first; those out of reach last, with "not reached" in place of a figure. */
class RankingModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Runway, GoesWell, InHand, Distance, ColumnCount };

  explicit RankingModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setCase(std::shared_ptr<const document::LandingCase> shown);
  void setStyle(const style::Units& units, style::Theme theme);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] QString textOf(const document::ShownRunway& runway, int column) const;

  std::shared_ptr<const document::LandingCase> case_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

/** Why a runway stands where it does in the ranked list: a row a reason, what it costs and a sentence, the costliest first. */
class RankingLinesModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Cost, Reason, ColumnCount };

  explicit RankingLinesModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  /** @param units  in which their sentences give lengths */
  void setLines(std::vector<emergency::RankingLine> lines, const style::Units& units);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] QString sentenceOf(const emergency::RankingLine& line) const { return units_.inSentence(line.sentence); }

  std::vector<emergency::RankingLine> lines_;
  style::Units units_;
};

}  // namespace vp::panels
