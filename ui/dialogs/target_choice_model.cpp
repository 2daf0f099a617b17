#include "ui/dialogs/target_choice_model.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace vp::dialogs {

void TargetChoiceModel::setTargets(std::vector<mission::Target> targets, std::size_t most) {
  const bool chooseNew = rows_.empty() ? targets.size() <= most : chosenCount_ == rows_.size();
  std::unordered_map<std::string, bool> before;
  for (Row& row : rows_) {
    before.emplace(std::move(row.target.name), row.isChosen);
  }
  beginResetModel();
  rows_.clear();
  chosenCount_ = 0;
  for (mission::Target& target : targets) {
    const auto known = before.find(target.name);
    const bool isChosen = known == before.end() ? chooseNew : known->second;
    chosenCount_ += isChosen ? 1 : 0;
    rows_.push_back({std::move(target), isChosen});
  }
  collectShown();
  endResetModel();
  emit choiceChanged();
}

void TargetChoiceModel::collectShown() {
  shown_.clear();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (filter_.isEmpty() || QString::fromStdString(rows_[i].target.name).contains(filter_, Qt::CaseInsensitive)) {
      shown_.push_back(i);
    }
  }
}

void TargetChoiceModel::setFilter(const QString& text) {
  beginResetModel();
  filter_ = text;
  collectShown();
  endResetModel();
  emit choiceChanged();
}

void TargetChoiceModel::choose(Row& row, bool chosen) {
  if (row.isChosen != chosen) {
    row.isChosen = chosen;
    chosenCount_ = chosen ? chosenCount_ + 1 : chosenCount_ - 1;
  }
}

void TargetChoiceModel::chooseShown(bool chosen) {
  for (const std::size_t i : shown_) {
    choose(rows_[i], chosen);
  }
  if (!shown_.empty()) {
    emit dataChanged(index(0, Name), index(rowCount() - 1, Name), {Qt::CheckStateRole});
  }
  emit choiceChanged();
}

std::vector<mission::Target> TargetChoiceModel::chosen() const {
  std::vector<mission::Target> targets;
  for (const Row& row : rows_) {
    if (row.isChosen) {
      targets.push_back(row.target);
    }
  }
  return targets;
}

int TargetChoiceModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int TargetChoiceModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString TargetChoiceModel::textOf(const mission::Target& target, int column) const {
  switch (column) {
    case Name:
      return QString::fromStdString(target.name);
    case Position:
      return style::Units::position(target.position);
    default:
      return target.reference == mission::HeightReference::Msl ? units_.altitudeMsl(target.height_m) : units_.heightAboveGround(target.height_m);
  }
}

QVariant TargetChoiceModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || static_cast<std::size_t>(index.row()) >= shown_.size()) {
    return {};
  }
  const Row& row = rows_[shown_[static_cast<std::size_t>(index.row())]];
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return textOf(row.target, index.column());
    case Qt::CheckStateRole:
      return index.column() == Name ? QVariant(row.isChosen ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == Height ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool TargetChoiceModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != Name || static_cast<std::size_t>(index.row()) >= shown_.size()) {
    return false;
  }
  choose(rows_[shown_[static_cast<std::size_t>(index.row())]], value.toInt() == Qt::Checked);
  emit dataChanged(index, index, {Qt::CheckStateRole});
  emit choiceChanged();
  return true;
}

QVariant TargetChoiceModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole && section == Height) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  return role != Qt::DisplayRole ? QVariant() : section == Name ? tr("Name") : section == Position ? tr("Position") : tr("Height");
}

Qt::ItemFlags TargetChoiceModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  return index.column() == Name ? flags | Qt::ItemIsUserCheckable : flags;
}

}  // namespace vp::dialogs
