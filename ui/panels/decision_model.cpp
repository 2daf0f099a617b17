#include "ui/panels/decision_model.h"

#include "core/aircraft/glide_model.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/mission/glide_conditions.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/tour_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vp::panels {
namespace {

constexpr double kTolerance = 1e-3;  // m, as the checker's

/// Place of each text in the alphabet, case aside.
std::vector<int> ranksOf(const std::vector<QString>& texts) {
  std::vector<int> byText(texts.size());
  std::iota(byText.begin(), byText.end(), 0);
  std::sort(byText.begin(), byText.end(),
            [&](int a, int b) { return QString::localeAwareCompare(texts[static_cast<std::size_t>(a)], texts[static_cast<std::size_t>(b)]) < 0; });
  std::vector<int> ranks(texts.size());
  for (std::size_t i = 0; i < byText.size(); ++i) {
    ranks[static_cast<std::size_t>(byText[i])] = static_cast<int>(i);
  }
  return ranks;
}

}  // namespace

void DecisionModel::setPlan(std::shared_ptr<const document::PlanView> plan) {
  beginResetModel();
  plan_ = std::move(plan);
  collectRows();
  reorder();
  endResetModel();
}

void DecisionModel::setStyle(const style::Units& units, style::Theme theme) {
  units_ = units;
  theme_ = theme;
  if (!order_.empty()) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

void DecisionModel::setFilter(const QString& text) {
  if (text.trimmed() != filter_) {
    beginResetModel();
    filter_ = text.trimmed();
    reorder();
    endResetModel();
  }
}

void DecisionModel::collectRows() {
  rows_.clear();
  targetNames_.clear();
  runwayNames_.clear();
  if (plan_ == nullptr) {
    return;
  }
  const mission::Plan& plan = plan_->plan();
  for (const mission::TargetInFrame& target : plan.targets) {
    targetNames_.push_back(QString::fromStdString(target.target.name));
  }
  for (const mission::SiteInFrame& site : plan.sites) {
    runwayNames_.push_back(profile::runwayName(site.site));
  }
  targetRank_ = ranksOf(targetNames_);
  runwayRank_ = ranksOf(runwayNames_);
  const aircraft::GlideModel glide(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites));
  for (const mission::DecisionPoint& point : plan.tour) {
    Row row;
    row.ground = plan_->terrain().grid->upperAt(point.pose.point());
    geo::Pose pose = point.pose;
    for (const flight::Piece& piece : point.witness.pieces) {
      row.glideLength += piece.length;
      row.glideTime += flight::glideSeconds(glide, pose, piece);
      pose = flight::endOf(pose, piece);
    }
    rows_.push_back(row);
  }
}

double DecisionModel::valueOf(int point, int column) const {
  const mission::DecisionPoint& decision = plan_->plan().tour[static_cast<std::size_t>(point)];
  const Row& row = rows_[static_cast<std::size_t>(point)];
  switch (column) {
    case Number:
      return point;
    case Distance:
      return plan_->distanceOf(static_cast<std::size_t>(point));
    case Target:  // points without one come last
      return decision.target >= 0 ? targetRank_[static_cast<std::size_t>(decision.target)] : std::numeric_limits<double>::infinity();
    case Altitude:
      return decision.altitude;
    case Ground:
      return row.ground;
    case SafeAltitude:
      return decision.safeAltitude;
    case Margin:
      return decision.altitude - decision.safeAltitude;
    case Runway:
      return decision.witness.site >= 0 ? runwayRank_[static_cast<std::size_t>(decision.witness.site)] : std::numeric_limits<double>::infinity();
    case GlideLength:
      return row.glideLength;
    case GlideTime:
      return row.glideTime;
    default:
      return 0.0;
  }
}

bool DecisionModel::passes(int point) const {
  if (filter_.isEmpty()) {
    return true;
  }
  const mission::DecisionPoint& decision = plan_->plan().tour[static_cast<std::size_t>(point)];
  const auto contains = [this](const QString& text) { return text.contains(filter_, Qt::CaseInsensitive); };
  return QString::number(point + 1) == filter_ || (decision.target >= 0 && contains(targetNames_[static_cast<std::size_t>(decision.target)])) ||
         (decision.witness.site >= 0 && contains(runwayNames_[static_cast<std::size_t>(decision.witness.site)]));
}

void DecisionModel::reorder() {
  order_.clear();
  rowOf_.assign(rows_.size(), -1);
  std::vector<double> values(rows_.size());
  for (int point = 0; point < static_cast<int>(rows_.size()); ++point) {
    if (passes(point)) {
      order_.push_back(point);
      values[static_cast<std::size_t>(point)] = valueOf(point, sortColumn_);
    }
  }
  const bool ascending = sortOrder_ == Qt::AscendingOrder;
  std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) {
    const double x = values[static_cast<std::size_t>(a)];
    const double y = values[static_cast<std::size_t>(b)];
    return ascending ? x < y : x > y;
  });
  for (std::size_t row = 0; row < order_.size(); ++row) {
    rowOf_[static_cast<std::size_t>(order_[row])] = static_cast<int>(row);
  }
}

int DecisionModel::rowOf(int point) const {
  return point >= 0 && static_cast<std::size_t>(point) < rowOf_.size() ? rowOf_[static_cast<std::size_t>(point)] : -1;
}

void DecisionModel::sort(int column, Qt::SortOrder order) {
  if (column < 0 || column >= ColumnCount) {
    return;
  }
  emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
  const QModelIndexList before = persistentIndexList();
  std::vector<int> points;
  for (const QModelIndex& held : before) {
    points.push_back(pointOf(held.row()));
  }
  sortColumn_ = column;
  sortOrder_ = order;
  reorder();
  QModelIndexList after;
  for (int i = 0; i < before.size(); ++i) {
    after << index(rowOf(points[static_cast<std::size_t>(i)]), before[i].column());
  }
  changePersistentIndexList(before, after);
  emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

int DecisionModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(order_.size());
}

int DecisionModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString DecisionModel::textOf(int point, int column) const {
  const double value = valueOf(point, column);
  const mission::DecisionPoint& decision = plan_->plan().tour[static_cast<std::size_t>(point)];
  switch (column) {
    case Number:
      return QString::number(point + 1);
    case Distance:
    case GlideLength:
      return units_.distance(value);
    case Target:
      return decision.target >= 0 ? targetNames_[static_cast<std::size_t>(decision.target)] : QString();
    case Altitude:
      return units_.altitudeMsl(value);
    case Ground:
      return std::isfinite(value) ? units_.requiredMsl(value) : tr("unknown");
    case SafeAltitude:
      return std::isfinite(value) ? units_.requiredMsl(value) : tr("none");
    case Margin:
      return std::isfinite(value) ? units_.margin(profile::shownMargin(value)) : tr("no glide");
    case Runway:
      return decision.witness.site >= 0 ? runwayNames_[static_cast<std::size_t>(decision.witness.site)] : tr("none");
    case GlideTime:
      return style::Units::duration(value);
    default:
      return {};
  }
}

QVariant DecisionModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const int point = pointOf(index.row());
  switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
      return textOf(point, index.column());
    case kSortRole:
      return valueOf(point, index.column());
    case Qt::TextAlignmentRole:
      return index.column() == Target || index.column() == Runway ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                                  : QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      if (index.column() == Margin && !(valueOf(point, Margin) >= -kTolerance)) {
        return style::ChartColors::of(theme_).violation;
      }
      return {};
    default:
      return {};
  }
}

QVariant DecisionModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return section == Target || section == Runway ? QVariant(Qt::AlignLeft | Qt::AlignVCenter) : QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Number:
      return tr("No.");
    case Distance:
      return tr("Distance");
    case Target:
      return tr("Target");
    case Altitude:
      return tr("Altitude");
    case Ground:
      return tr("Ground");
    case SafeAltitude:
      return tr("Safe altitude");
    case Margin:
      return tr("Margin");
    case Runway:
      return tr("Runway");
    case GlideLength:
      return tr("Glide");
    case GlideTime:
      return tr("Time");
    default:
      return {};
  }
}

}  // namespace vp::panels
