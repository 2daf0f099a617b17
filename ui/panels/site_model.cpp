#include "ui/panels/site_model.h"

#include "ui/panels/site_text.h"
#include "ui/panels/state_icons.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/tour_curves.h"
#include "ui/style/core_text.h"

#include <QStringList>

#include <algorithm>

namespace vp::panels {
namespace {

bool isNumber(int column) {
  return column == SiteModel::Course || column == SiteModel::Length || column == SiteModel::Width || column == SiteModel::Elevation ||
         column == SiteModel::Distance;
}

}  // namespace

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

void SiteModel::redraw() {
  if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

void SiteModel::setTargets(std::shared_ptr<const std::vector<document::ShownTarget>> targets) {
  targets_ = std::move(targets);
  redraw();
}

void SiteModel::setFilter(const mission::SiteFilter& filter) {
  filter_ = filter;
  redraw();
}

void SiteModel::setStyle(const style::Units& units, style::Theme theme) {
  units_ = units;
  theme_ = theme;
  redraw();
}

/// Metres from the touchdown point to the filter's place, else to the nearest target.
std::optional<double> SiteModel::distanceOf(const document::ShownSite& shown) const {
  if (filter_.distanceFrom) {
    return geo::geodesicDistance(*filter_.distanceFrom, shown.site.site.touchdown).si();
  }
  std::optional<double> nearest;
  for (std::size_t i = 0; targets_ != nullptr && i < targets_->size(); ++i) {
    const double distance = geo::distance(shown.site.pose.point(), (*targets_)[i].point);
    nearest = nearest ? std::min(*nearest, distance) : distance;
  }
  return nearest;
}

/// What is noted on the runway end, else on its airport.
QString SiteModel::noteOf(const mission::LandingSite& site) const {
  for (const std::string& name : {site.id, site.airportIdent}) {
    for (const mission::SiteNote& note : filter_.notes) {
      if (note.site == name && !name.empty()) {
        return QString::fromStdString(note.text);
      }
    }
  }
  return {};
}

bool SiteModel::isOneWay(const mission::LandingSite& site) const {
  return std::find(filter_.oneWay.begin(), filter_.oneWay.end(), site.id) != filter_.oneWay.end();
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
    parts << tr("estimated: %1").arg(style::coreText(shown.site.site.approximations.front()));
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
    case Width:
      return site.width ? units_.shortDistance(site.width->si()) : QString();
    case Surface:
      return surfaceName(site.surface);
    case Lighted:
      return site.lighted ? tr("lit") : QString();
    case Elevation:
      return units_.altitudeMsl(site.elevation.metres());
    case Distance: {
      const std::optional<double> distance = distanceOf(shown);
      return distance ? units_.distance(*distance) : QString();
    }
    case OneWay:
      return isOneWay(site) ? tr("one way") : QString();
    case Remarks:
      return remarks(shown);
    case Note:
      return noteOf(site);
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
    case Width:
      return site.width ? site.width->si() : -1.0;
    case Distance:
      return distanceOf(shown).value_or(-1.0);
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
        lines << style::coreText(approximation);
      }
      return lines.join(QLatin1Char('\n'));
    }
    case Qt::AccessibleTextRole:
      return index.column() == Runway ? QVariant(textOf(*shown, Runway) + QStringLiteral(", ") + remarks(*shown)) : QVariant();
    case kSortRole:
      return sortKey(*shown, index.column());
    case Qt::EditRole:
      return index.column() == Note ? QVariant(noteOf(landing)) : QVariant();
    case Qt::CheckStateRole:
      return checkState(*shown, index.column());
    case Qt::DecorationRole:
      return index.column() == Remarks && landing.isApproximate() ? QVariant(signIcon(Sign::Warning, theme_)) : QVariant();
    case Qt::ForegroundRole:
      return shown->usable ? QVariant() : QVariant(style::ChartColors::of(theme_).mutedText);
    case Qt::TextAlignmentRole:
      return QVariant((isNumber(index.column()) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant SiteModel::checkState(const document::ShownSite& shown, int column) const {
  if (column != Runway && column != OneWay) {
    return {};
  }
  const bool isChecked = column == Runway ? shown.usable : isOneWay(shown.site.site);
  return static_cast<int>(isChecked ? Qt::Checked : Qt::Unchecked);
}

bool SiteModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const document::ShownSite* shown = index.isValid() ? site(index.row()) : nullptr;
  if (shown == nullptr) {
    return false;
  }
  const QString id = QString::fromStdString(shown->site.site.id);
  if (role == Qt::EditRole && index.column() == Note) {
    if (value.toString().trimmed() != noteOf(shown->site.site)) {
      emit noteEdited(id, value.toString().trimmed());
    }
    return true;
  }
  if (role == Qt::CheckStateRole && index.column() == OneWay) {
    emit oneWayRequested(id, value.toInt() == Qt::Checked);
    return true;
  }
  if (role != Qt::CheckStateRole || index.column() != Runway) {
    return false;
  }
  const bool used = value.toInt() == Qt::Checked;
  if (used != shown->usable) {
    emit excludeRequested(id, !used);
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
  if (index.column() == OneWay && shown != nullptr && (shown->usable || isOneWay(shown->site.site))) {
    flags |= Qt::ItemIsUserCheckable;
  }
  if (index.column() == Note && shown != nullptr) {
    flags |= Qt::ItemIsEditable;
  }
  return flags;
}

QVariant SiteModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && isNumber(section)) {
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
    case Width:
      return tr("Width");
    case Surface:
      return tr("Surface");
    case Lighted:
      return tr("Lights");
    case Elevation:
      return tr("Elevation");
    case Distance:
      return tr("Distance");
    case OneWay:
      return tr("This way only");
    case Remarks:
      return tr("Remarks");
    case Note:
      return tr("Note");
    default:
      return {};
  }
}

}  // namespace vp::panels
