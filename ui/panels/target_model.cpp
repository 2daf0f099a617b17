#include "ui/panels/target_model.h"

#include "ui/panels/position_text.h"
#include "ui/panels/state_icons.h"
#include "ui/style/core_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vp::panels {

QString datumName(mission::HeightReference reference) {
  return reference == mission::HeightReference::AboveGround ? QCoreApplication::translate("TargetModel", "AGL")
                                                            : QCoreApplication::translate("TargetModel", "MSL");
}

void TargetModel::setTargets(std::shared_ptr<const std::vector<document::ShownTarget>> targets,
                             std::shared_ptr<const document::TerrainData> terrain) {
  const std::size_t before = targets_ == nullptr ? 0 : targets_->size();
  const std::size_t after = targets == nullptr ? 0 : targets->size();
  if (before == after) {  // an edit keeps the selection
    targets_ = std::move(targets);
    terrain_ = std::move(terrain);
    if (after > 0) {
      emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
    return;
  }
  beginResetModel();
  targets_ = std::move(targets);
  terrain_ = std::move(terrain);
  endResetModel();
}

void TargetModel::setStyle(const style::Units& units, style::Theme theme) {
  units_ = units;
  theme_ = theme;
  if (rowCount() > 0) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  }
}

const document::ShownTarget* TargetModel::target(int row) const {
  return targets_ != nullptr && row >= 0 && static_cast<std::size_t>(row) < targets_->size() ? &(*targets_)[static_cast<std::size_t>(row)] : nullptr;
}

int TargetModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || targets_ == nullptr ? 0 : static_cast<int>(targets_->size());
}

int TargetModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString TargetModel::textOf(const document::ShownTarget& shown, int column) const {
  switch (column) {
    case Name:
      return QString::fromStdString(shown.target.name);
    case Height:
      return units_.height(shown.target.height_m);
    case Datum:
      return datumName(shown.target.reference);
    case Altitude:
      return shown.altitude ? units_.altitudeMsl(*shown.altitude) : QStringLiteral("–");
    case Ground: {
      const double ground = terrain_ == nullptr ? std::numeric_limits<double>::infinity() : terrain_->grid->upperAt(shown.point);
      return std::isfinite(ground) ? units_.requiredMsl(ground) : tr("unknown");
    }
    case Position:
      return style::Units::position(shown.target.position);
    case Problem:
      return style::coreText(shown.problem);
    default:
      return {};
  }
}

QVariant TargetModel::data(const QModelIndex& index, int role) const {
  const document::ShownTarget* shown = index.isValid() ? target(index.row()) : nullptr;
  if (shown == nullptr) {
    return {};
  }
  switch (role) {
    case Qt::DisplayRole:
      return textOf(*shown, index.column());
    case Qt::ToolTipRole:
      return shown->problem.empty() ? textOf(*shown, index.column()) : style::coreText(shown->problem);
    case Qt::EditRole:
      if (index.column() == Height) {
        return units_.heightFromSi(shown->target.height_m);
      }
      return index.column() == Datum ? QVariant(static_cast<int>(shown->target.reference)) : QVariant(textOf(*shown, index.column()));
    case Qt::DecorationRole:
      return index.column() == Name && !shown->problem.empty() ? QVariant(signIcon(Sign::Violation, theme_)) : QVariant();
    case Qt::AccessibleTextRole:
      return index.column() == Name && !shown->problem.empty() ? QVariant(textOf(*shown, Name) + QStringLiteral(", ") + textOf(*shown, Problem))
                                                               : QVariant();
    case Qt::TextAlignmentRole:
      return index.column() == Height || index.column() == Altitude || index.column() == Ground ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                                                                : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    default:
      return {};
  }
}

bool TargetModel::isTaken(const QString& name, int exceptRow) const {
  for (int row = 0; row < rowCount(); ++row) {
    if (row != exceptRow && QString::fromStdString(target(row)->target.name) == name) {
      return true;
    }
  }
  return false;
}

bool TargetModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const document::ShownTarget* shown = index.isValid() ? target(index.row()) : nullptr;
  if (shown == nullptr || role != Qt::EditRole) {
    return false;
  }
  mission::Target edited = shown->target;
  switch (index.column()) {
    case Name: {
      const QString name = value.toString().trimmed();
      if (name.isEmpty() || isTaken(name, index.row())) {
        emit editRefused(name.isEmpty() ? tr("A target needs a name.") : tr("There is a target %1 already; give another name.").arg(name));
        return false;
      }
      edited.name = name.toStdString();
      break;
    }
    case Height: {
      bool ok = false;
      const double height = value.toDouble(&ok);
      if (!ok || !std::isfinite(height)) {
        return false;
      }
      if (height != units_.heightFromSi(edited.height_m)) {  // untouched text must not round the value
        edited.height_m = units_.heightToSi(height);
      }
      break;
    }
    case Datum: {
      const auto reference = static_cast<mission::HeightReference>(value.toInt());
      if (reference != edited.reference) {
        // the target stays where it is: only the way its height is given changes
        const double ground = terrain_ == nullptr ? std::numeric_limits<double>::infinity() : terrain_->grid->upperAt(shown->point);
        if (std::isfinite(ground)) {
          edited.height_m += reference == mission::HeightReference::Msl ? ground : -ground;
        }
        edited.reference = reference;
      }
      break;
    }
    case Position: {
      if (value.toString() == textOf(*shown, Position)) {
        break;
      }
      const std::optional<geo::LatLon> position = parsePosition(value.toString());
      if (!position) {
        emit editRefused(tr("\"%1\" is no position. Write for example 46°36.02′ N 009°54.10′ E or 46.6003, 9.9017.").arg(value.toString()));
        return false;
      }
      edited.position = *position;
      break;
    }
    default:
      return false;
  }
  if (!(edited == shown->target)) {
    emit targetEdited(index.row(), edited);
  }
  return true;
}

Qt::ItemFlags TargetModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  switch (index.column()) {
    case Name:
    case Height:
    case Datum:
    case Position:
      return flags | Qt::ItemIsEditable;
    default:
      return flags;
  }
}

QVariant TargetModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::TextAlignmentRole && (section == Height || section == Altitude || section == Ground)) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  if (orientation == Qt::Vertical) {
    return section + 1;
  }
  switch (section) {
    case Name:
      return tr("Name");
    case Height:
      return tr("Height");
    case Datum:
      return tr("Above");
    case Altitude:
      return tr("Altitude");
    case Ground:
      return tr("Ground");
    case Position:
      return tr("Position");
    case Problem:
      return tr("Problem");
    default:
      return {};
  }
}

}  // namespace vp::panels
