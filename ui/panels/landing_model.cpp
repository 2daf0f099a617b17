#include "ui/panels/landing_model.h"

#include "core/emergency/landing_outcome.h"
#include "ui/document/weather_view.h"
#include "ui/panels/state_icons.h"
#include "ui/profile/tour_curves.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <utility>

namespace vp::panels {

QString plannerTitle(std::string_view name) {
  struct Title {
    std::string_view name;
    const char* shown;
  };
  static constexpr std::array kTitles{Title{"roadmap", QT_TRANSLATE_NOOP("LandingModel", "Roadmap")},
                                      Title{"anytime", QT_TRANSLATE_NOOP("LandingModel", "Any-time")},
                                      Title{"dubins", QT_TRANSLATE_NOOP("LandingModel", "One curve")},
                                      Title{"fmt", QT_TRANSLATE_NOOP("LandingModel", "FMT*")},
                                      Title{"fmt-octree", QT_TRANSLATE_NOOP("LandingModel", "FMT*, octree")},
                                      Title{"gradient", QT_TRANSLATE_NOOP("LandingModel", "Gradient")},
                                      Title{"combined", QT_TRANSLATE_NOOP("LandingModel", "Best of all")},
                                      Title{"straight", QT_TRANSLATE_NOOP("LandingModel", "Straight")},
                                      Title{"vg", QT_TRANSLATE_NOOP("LandingModel", "VG")},
                                      Title{"tg", QT_TRANSLATE_NOOP("LandingModel", "TG")},
                                      Title{"lvg", QT_TRANSLATE_NOOP("LandingModel", "LVG")},
                                      Title{"hrm", QT_TRANSLATE_NOOP("LandingModel", "HRM")},
                                      Title{"prm", QT_TRANSLATE_NOOP("LandingModel", "PRM")},
                                      Title{"vprm", QT_TRANSLATE_NOOP("LandingModel", "VPRM")},
                                      Title{"dlvg", QT_TRANSLATE_NOOP("LandingModel", "DLVG")},
                                      Title{"dprm", QT_TRANSLATE_NOOP("LandingModel", "DPRM")},
                                      Title{"dvprm", QT_TRANSLATE_NOOP("LandingModel", "DVPRM")}};
  for (const Title& title : kTitles) {
    if (title.name == name) {
      return QCoreApplication::translate("LandingModel", title.shown);
    }
  }
  return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

void LandingModel::setCase(std::shared_ptr<const document::LandingCase> shown) {
  beginResetModel();
  case_ = std::move(shown);
  endResetModel();
}

void LandingModel::setStyle(const style::Units& units, style::Theme theme) {
  beginResetModel();
  units_ = units;
  theme_ = theme;
  endResetModel();
}

int LandingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || case_ == nullptr ? 0 : static_cast<int>(case_->landings.size());
}

int LandingModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString LandingModel::textOf(const document::ShownLanding& landing, int column) const {
  const QString none = QStringLiteral("–");
  const bool hasPath = landing.answer.path.has_value();
  switch (column) {
    case Planner:
      return plannerTitle(landing.answer.planner);
    case Runway:
      return landing.site ? profile::runwayName(landing.site->site) : tr("no runway");
    case InHand:
      return landing.site ? units_.margin(profile::shownMargin(landing.answer.heightInHand)) : none;
    case Weather: {
      const std::optional<double> success = document::termOf(landing.answer, emergency::kWeatherSuccess);
      return success ? document::percentText(*success) : none;
    }
    case Distance:
      return hasPath ? units_.distance(landing.glide.length) : none;
    case Time:
      return hasPath ? style::Units::duration(landing.glide.seconds) : none;
    case Clearance:
      return hasPath && std::isfinite(landing.glide.leastClearance) ? units_.heightAboveGround(landing.glide.leastClearance) : none;
    default:
      return {};
  }
}

QString LandingModel::verdictOf(const document::ShownLanding& landing) {
  return !landing.site ? tr("not a runway") : landing.answer.verified ? tr("checked") : tr("not checked");
}

QVariant LandingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const document::ShownLanding& landing = case_->landings[static_cast<std::size_t>(index.row())];
  const bool isText = index.column() == Planner || index.column() == Runway;
  switch (role) {
    case Qt::DisplayRole:
      return textOf(landing, index.column());
    case Qt::ToolTipRole:
      return index.column() == Runway && landing.site ? QStringLiteral("%1, %2").arg(profile::runwayNameLong(landing.site->site), verdictOf(landing))
                                                      : textOf(landing, index.column());
    case Qt::AccessibleTextRole:
      return index.column() == Planner
                 ? QVariant(QStringList{textOf(landing, Planner), textOf(landing, Runway), verdictOf(landing)}.join(QStringLiteral(", ")))
                 : QVariant();
    case Qt::DecorationRole:
      return index.column() == Runway ? QVariant(signIcon(landing.site && landing.answer.verified ? Sign::Reachable : Sign::NotReachable, theme_))
                                      : QVariant();
    case Qt::TextAlignmentRole:
      return QVariant((isText ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::ForegroundRole:
      return index.column() == Runway && !landing.site ? QVariant(style::ChartColors::of(theme_).violation) : QVariant();
    default:
      return {};
  }
}

QVariant LandingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  const bool isText = section == Planner || section == Runway;
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && !isText) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
    case Planner:
      return tr("Planner");
    case Runway:
      return tr("Runway");
    case InHand:
      return tr("In hand");
    case Weather:
      return tr("Weather");
    case Distance:
      return tr("Glide");
    case Time:
      return tr("Time");
    case Clearance:
      return tr("Lowest");
    default:
      return {};
  }
}

}  // namespace vp::panels
