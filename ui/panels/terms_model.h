#pragma once

#include "ui/document/landing_case.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <string>
#include <vector>

namespace vp::panels {

/** The terms of all answers side by side: a row a term, a column a planner. What an answer does not tell is left blank; a term that counts in an
 * answer's cost is marked there by bold type, so that it is seen what each planner keeps low. */
class TermsModel : public QAbstractTableModel {
  Q_OBJECT

public:
  explicit TermsModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setCase(std::shared_ptr<const document::LandingCase> shown);
  void setUnits(const style::Units& units);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] QString textOf(const emergency::CostTerm& term) const;
  [[nodiscard]] const emergency::CostTerm* termAt(const QModelIndex& index) const;

  std::shared_ptr<const document::LandingCase> case_;
  std::vector<std::string> names_;  ///< of the rows, in the order in which the answers tell them
  style::Units units_;
};

}  // namespace vp::panels
