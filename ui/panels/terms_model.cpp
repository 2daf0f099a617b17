#include "ui/panels/terms_model.h"

#include "core/emergency/landing_outcome.h"
#include "ui/document/weather_view.h"
#include "ui/panels/landing_model.h"
#include "ui/style/core_text.h"

#include <QFont>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::panels {

void TermsModel::setCase(std::shared_ptr<const document::LandingCase> shown) {
  beginResetModel();
  case_ = std::move(shown);
  names_.clear();
  for (std::size_t i = 0; case_ != nullptr && i < case_->landings.size(); ++i) {
    for (const emergency::CostTerm& term : case_->landings[i].answer.terms) {
      if (std::find(names_.begin(), names_.end(), term.name) == names_.end()) {
        names_.push_back(term.name);
      }
    }
  }
  const auto weather = std::find(names_.begin(), names_.end(), emergency::kWeatherSuccess);
  if (weather != names_.end()) {
    std::rotate(names_.begin(), weather, weather + 1);  // what a pilot asks first where there is weather
  }
  endResetModel();
}

void TermsModel::setUnits(const style::Units& units) {
  beginResetModel();
  units_ = units;
  endResetModel();
}

int TermsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(names_.size());
}

int TermsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : 1 + (case_ != nullptr ? static_cast<int>(case_->landings.size()) : 0);
}

QString TermsModel::textOf(const emergency::CostTerm& term) const {
  if (term.name == emergency::kWeatherSuccess) {
    return document::percentText(term.value);
  }
  if (term.unit == "m") {
    return term.name == emergency::kDistance || term.name == emergency::kHowFar ? units_.distance(term.value) : units_.height(term.value);
  }
  if (term.unit == "s") {
    return style::Units::duration(term.value);
  }
  const QString number = QString::number(term.value, 'g', 3);
  return term.unit.empty() ? number : QStringLiteral("%1 %2").arg(number, QString::fromStdString(term.unit));
}

const emergency::CostTerm* TermsModel::termAt(const QModelIndex& index) const {
  const auto& terms = case_->landings[static_cast<std::size_t>(index.column() - 1)].answer.terms;
  const std::string& name = names_[static_cast<std::size_t>(index.row())];
  const auto found = std::find_if(terms.begin(), terms.end(), [&](const emergency::CostTerm& term) { return term.name == name; });
  return found == terms.end() ? nullptr : &*found;
}

QVariant TermsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount() || index.column() >= columnCount()) {
    return {};
  }
  if (index.column() == 0) {
    const QString name = style::coreText(names_[static_cast<std::size_t>(index.row())]);
    return role == Qt::DisplayRole || role == Qt::ToolTipRole ? QVariant(name) : QVariant();
  }
  const emergency::CostTerm* term = termAt(index);
  switch (role) {
    case Qt::DisplayRole:
      return term != nullptr ? textOf(*term) : QString();
    case Qt::ToolTipRole:
      return term == nullptr       ? tr("This planner does not tell it.")
             : term->weight != 0.0 ? tr("%1, kept low by this planner").arg(textOf(*term))
                                   : textOf(*term);
    case Qt::FontRole: {
      QFont bold;
      bold.setBold(true);
      return term != nullptr && term->weight != 0.0 ? QVariant(bold) : QVariant();
    }
    case Qt::TextAlignmentRole:
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant TermsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole && section > 0) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  return section == 0 ? tr("Term") : plannerTitle(case_->landings[static_cast<std::size_t>(section - 1)].answer.planner);
}

}  // namespace vp::panels
