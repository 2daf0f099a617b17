#include "ui/panels/site_model.h"

#include "ui/panels/site_text.h"
#include "ui/panels/state_icons.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/tour_curves.h"

#include <QStringList>

#include <algorithm>

namespace vp::panels {

void SiteModel::setSites(std::shared_ptr<const std::vector<document::ShownSite>> sites) {
  const std::size_t before = sites_ == nullptr ? 0 : sites_->size();
  const std::size_t after = sites == nullptr ? 0 : sites->size();
  if (before == after) {
    sites_ = std::move(sites);
    if (after > 0) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
    return;
  }
  beginResetModel();
  sites_ = std::move(sites);
  endResetModel();
}

void SiteModel::setFilter(const mission::SiteFilter& filter) {
  filter_ = filter;
  if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

void SiteModel::setStyle(const style::Units& units, style::Theme theme) {
  units_ = units;
  theme_ = theme;
  if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

const document::ShownSite* SiteModel::site(int row) const {
  return sites_ != nullptr && row >= 0 && static_cast<std::size_t>(row) < sites_->size() ? &(*sites_)[static_cast<std::size_t>(row)] : nullptr;
}

int SiteModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || sites_ == nullptr ? 0 : static_cast<int>(sites_->size());
}

int SiteModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

bool SiteModel::isExcludedByHand(const mission::LandingSite& site) const {
  return std::any_of(filter_.exclude.begin(), filter_.exclude.end(),
                     [&](const std::string& name) { return name == site.id || name == site.airportIdent; });
}

QString SiteModel::remarks(const document::ShownSite& shown) const {
  QStringList parts;
  if (!shown.usable) {
    parts << (isExcludedByHand(shown.site.site) ? tr("excluded") : tr("left out by the filter"));
  }
  if (shown.site.site.isApproximate()) {
    parts << tr("estimated: %1").arg(QString::fromStdString(shown.site.site.approximations.front()));
  }
  return parts.join(QStringLiteral("; "));
}

QString SiteModel::textOf(const document::ShownSite& shown, int column) const {
  const mission::LandingSite& site = shown.site.site;
  switch (column) {
    case Runway:
      return profile::runwayName(site);
    case Name:
      return QString::fromStdString(site.airportName);
    case Course:
      return style::Units::course(site.landingCourse.degrees());
    case Length:
      return site.length ? units_.shortDistance(site.length->si()) : tr("unknown");
    case Surface:
      return surfaceName(site.surface);
    case Elevation:
      return units_.altitudeMsl(site.elevation.metres());
    case Remarks:
      return remarks(shown);
    default:
      return {};
  }
}

QVariant SiteModel::sortKey(const document::ShownSite& shown, int column) const {
  const mission::LandingSite& site = shown.site.site;
  switch (column) {
    case Course:
      return site.landingCourse.degrees();
    case Length:
      return site.length ? site.length->si() : -1.0;
    case Elevation:
      return site.elevation.metres();
    default:
      return textOf(shown, column);
  }
}

QVariant SiteModel::data(const QModelIndex& index, int role) const {
  const document::ShownSite* shown = index.isValid() ? site(index.row()) : nullptr;
  if (shown == nullptr) {
    return {};
  }
  const mission::LandingSite& landing = shown->site.site;
  switch (role) {
    case Qt::DisplayRole:
      return textOf(*shown, index.column());
    case Qt::ToolTipRole: {
      QStringList lines{textOf(*shown, index.column())};
      for (const std::string& approximation : landing.approximations) {
        lines << QString::fromStdString(approximation);
      }
      return lines.join(QLatin1Char('\n'));
    }
    case Qt::AccessibleTextRole:
      return index.column() == Runway ? QVariant(textOf(*shown, Runway) + QStringLiteral(", ") + remarks(*shown)) : QVariant();
    case kSortRole:
      return sortKey(*shown, index.column());
    case Qt::CheckStateRole:
      return index.column() == Runway ? QVariant(static_cast<int>(shown->usable ? Qt::Checked : Qt::Unchecked)) : QVariant();
    case Qt::DecorationRole:
      return index.column() == Remarks && landing.isApproximate() ? QVariant(signIcon(Sign::Warning, theme_)) : QVariant();
    case Qt::ForegroundRole:
      return shown->usable ? QVariant() : QVariant(style::ChartColors::of(theme_).mutedText);
    case Qt::TextAlignmentRole:
      return index.column() == Course || index.column() == Length || index.column() == Elevation ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                                                                 : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool SiteModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const document::ShownSite* shown = index.isValid() ? site(index.row()) : nullptr;
  if (shown == nullptr || role != Qt::CheckStateRole || index.column() != Runway) {
    return false;
  }
  const bool used = value.toInt() == Qt::Checked;
  if (used != shown->usable) {
    emit excludeRequested(QString::fromStdString(shown->site.site.id), !used);
  }
  return true;
}

Qt::ItemFlags SiteModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  const document::ShownSite* shown = site(index.row());
  // a runway that a rule of the filter leaves out comes back by changing the rule, not by its tick
  if (index.column() == Runway && shown != nullptr && (shown->usable || isExcludedByHand(shown->site.site))) {
    flags |= Qt::ItemIsUserCheckable;
  }
  return flags;
}

QVariant SiteModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && (section == Course || section == Length || section == Elevation)) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Runway:
      return tr("Use runway");
    case Name:
      return tr("Airport");
    case Course:
      return tr("Course");
    case Length:
      return tr("Length");
    case Surface:
      return tr("Surface");
    case Elevation:
      return tr("Elevation");
    case Remarks:
      return tr("Remarks");
    default:
      return {};
  }
}

}  // namespace vp::panels
