#include "ui/panels/alternatives_model.h"

#include "ui/panels/site_text.h"
#include "ui/profile/tour_curves.h"

namespace vp::panels {

QString physicalRunwayName(const landing::SiteRoadmaps& source, int site) {
  const std::vector<mission::SiteInFrame>& sites = source.world().sites;
  QString name = profile::runwayName(sites[static_cast<std::size_t>(site)].site);
  for (const int end : source.runways()[static_cast<std::size_t>(source.runwayOf(site))]) {
    const std::string& ident = sites[static_cast<std::size_t>(end)].site.runwayIdent;
    if (end != site && !ident.empty()) {
      name += QLatin1Char('/') + QString::fromStdString(ident);
    }
  }
  return name;
}

void AlternativesModel::setAnswers(std::shared_ptr<const landing::SiteRoadmaps> source, std::vector<landing::SiteAnswer> answers) {
  beginResetModel();
  source_ = std::move(source);
  answers_ = std::move(answers);
  endResetModel();
}

void AlternativesModel::setStyle(const style::Units& units, style::Theme theme) {
  beginResetModel();
  units_ = units;
  theme_ = theme;
  endResetModel();
}

int AlternativesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(answers_.size());
}

int AlternativesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

Sign AlternativesModel::signOf(const landing::SiteAnswer& answer) {
  return !answer.isReachable() ? Sign::NotReachable : answer.isAroundTerrain() ? Sign::AroundTerrain : Sign::Reachable;
}

const mission::LandingSite& AlternativesModel::siteOf(const landing::SiteAnswer& answer) const {
  return source_->world().sites[static_cast<std::size_t>(answer.site)].site;
}

QString AlternativesModel::textOf(const landing::SiteAnswer& answer, int column) const {
  switch (column) {
    case Runway:
      return profile::runwayName(siteOf(answer));
    case Margin:
      return units_.margin(profile::shownMargin(answer.margin));
    case Required:
      return units_.requiredMsl(answer.altitude);
    case Distance:
      return units_.distance(answer.length);
    case Time:
      return style::Units::duration(answer.seconds);
    case Reach:
      return !answer.isReachable() ? tr("not reachable") : answer.isAroundTerrain() ? tr("only around terrain") : tr("reachable");
    default:
      return {};
  }
}

QVariant AlternativesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const landing::SiteAnswer& answer = answers_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return textOf(answer, index.column());
    case Qt::ToolTipRole:
      return index.column() == Runway ? profile::runwayNameLong(siteOf(answer)) + QLatin1Char('\n') + runwayDetails(siteOf(answer), units_)
                                      : textOf(answer, index.column());
    case Qt::AccessibleTextRole:
      return index.column() == Runway ? QVariant(textOf(answer, Runway) + QStringLiteral(", ") + textOf(answer, Reach)) : QVariant();
    case Qt::DecorationRole:
      return index.column() == Reach ? QVariant(signIcon(signOf(answer), theme_)) : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == Runway || index.column() == Reach ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                                 : QVariant(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return index.column() == Margin && !answer.isReachable() ? QVariant(style::ChartColors::of(theme_).violation) : QVariant();
    default:
      return {};
  }
}

QVariant AlternativesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && section != Runway && section != Reach) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Runway:
      return tr("Runway");
    case Margin:
      return tr("Margin");
    case Required:
      return tr("Needs");
    case Distance:
      return tr("Glide");
    case Time:
      return tr("Time");
    case Reach:
      return tr("Reach");
    default:
      return {};
  }
}

}  // namespace vp::panels
