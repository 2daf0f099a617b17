#include "ui/panels/ranking_model.h"

#include "ui/document/weather_view.h"
#include "ui/panels/state_icons.h"
#include "ui/profile/tour_curves.h"
#include "ui/style/core_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::panels {

void RankingModel::setCase(std::shared_ptr<const document::LandingCase> shown) {
  beginResetModel();
  case_ = std::move(shown);
  endResetModel();
}

void RankingModel::setStyle(const style::Units& units, style::Theme theme) {
  beginResetModel();
  units_ = units;
  theme_ = theme;
  endResetModel();
}

int RankingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || case_ == nullptr ? 0 : static_cast<int>(case_->runways.size());
}

int RankingModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString RankingModel::textOf(const document::ShownRunway& runway, int column) const {
  const QString none = QStringLiteral("–");
  switch (column) {
    case Runway:
      return profile::runwayName(runway.site.site);
    case GoesWell:
      return runway.isReached ? document::percentText(std::exp(-runway.logRisk)) : tr("not reached");
    case InHand:
      return runway.isReached ? units_.margin(profile::shownMargin(runway.landing.answer.heightInHand)) : none;
    case Distance:
      return runway.isReached ? units_.distance(runway.landing.glide.length) : none;
    default:
      return {};
  }
}

QVariant RankingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const document::ShownRunway& runway = case_->runways[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(runway, index.column());
    case Qt::ToolTipRole:
      return index.column() == Runway ? profile::runwayNameLong(runway.site.site) : textOf(runway, index.column());
    case Qt::AccessibleTextRole:
      return index.column() == Runway
                 ? QVariant(tr("%1. %2, %3").arg(index.row() + 1).arg(profile::runwayNameLong(runway.site.site), textOf(runway, GoesWell)))
                 : QVariant();
    case Qt::DecorationRole:
      return index.column() == Runway ? QVariant(signIcon(runway.isReached ? Sign::Reachable : Sign::NotReachable, theme_)) : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant((index.column() == Runway ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return runway.isReached ? QVariant() : QVariant(style::ChartColors::of(theme_).mutedText);
    default:
      return {};
  }
}

QVariant RankingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section != Runway) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == GoesWell) {
    return tr("How likely way and landing go well, all lines below together; to compare runways, not to fly by");
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Runway:
      return tr("Runway");
    case GoesWell:
      return tr("Goes well");
    case InHand:
      return tr("In hand");
    case Distance:
      return tr("Glide");
    default:
      return {};
  }
}

void RankingLinesModel::setLines(std::vector<emergency::RankingLine> lines, const style::Units& units) {
  beginResetModel();
  units_ = units;
  lines_ = std::move(lines);
  std::stable_sort(lines_.begin(), lines_.end(),
                   [](const emergency::RankingLine& a, const emergency::RankingLine& b) { return a.logRisk > b.logRisk; });
  endResetModel();
}

int RankingLinesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int RankingLinesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant RankingLinesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const emergency::RankingLine& line = lines_[static_cast<std::size_t>(index.row())];
  const double cost = 100.0 * (1.0 - std::exp(-line.logRisk));
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == Cost ? tr("%1%2 %").arg(cost >= 0.05 ? QString(QChar(0x2212)) : QString()).arg(cost, 0, 'f', 1) : sentenceOf(line);
    case Qt::ToolTipRole:
      return QStringLiteral("%1: %2").arg(style::coreText(line.name), sentenceOf(line));
    case Qt::TextAlignmentRole:
      return QVariant((index.column() == Cost ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
    default:
      return {};
  }
}

QVariant RankingLinesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  return section == Cost ? tr("Costs") : tr("Because");
}

}  // namespace vp::panels
