#include "ui/panels/target_delegate.h"

#include "ui/panels/target_model.h"

#include <QComboBox>
#include <QDoubleSpinBox>

#include <algorithm>
#include <cmath>

namespace vp::panels {
namespace {

constexpr double kHighest = 12000.0;  // m, above any target of a light aircraft
constexpr double kLowest = -500.0;    // m MSL, the lowest land

}  // namespace

QWidget* TargetDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* model = qobject_cast<const TargetModel*>(index.model());
  if (model == nullptr) {
    return QStyledItemDelegate::createEditor(parent, option, index);
  }
  if (index.column() == TargetModel::Height) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(0);
    box->setRange(std::ceil(model->units().heightFromSi(kLowest)), std::floor(model->units().heightFromSi(kHighest)));
    box->setSingleStep(model->units().system() == style::UnitSystem::Aviation ? 100.0 : 50.0);
    box->setSuffix(QLatin1Char(' ') + model->units().heightUnit());
    box->setAccessibleName(tr("Height of the target"));
    return box;
  }
  if (index.column() == TargetModel::Datum) {
    auto* box = new QComboBox(parent);
    for (const mission::HeightReference reference : {mission::HeightReference::AboveGround, mission::HeightReference::Msl}) {
      box->addItem(datumName(reference), static_cast<int>(reference));
    }
    box->setAccessibleName(tr("Datum of the height"));
    return box;
  }
  return QStyledItemDelegate::createEditor(parent, option, index);
}

void TargetDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  if (auto* spin = qobject_cast<QDoubleSpinBox*>(editor)) {
    spin->setValue(index.data(Qt::EditRole).toDouble());
  } else if (auto* combo = qobject_cast<QComboBox*>(editor)) {
    combo->setCurrentIndex(combo->findData(index.data(Qt::EditRole)));
  } else {
    QStyledItemDelegate::setEditorData(editor, index);
  }
}

void TargetDelegate::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
  if (auto* spin = qobject_cast<QDoubleSpinBox*>(editor)) {
    spin->interpretText();
    const bool touched = std::abs(spin->value() - index.data(Qt::EditRole).toDouble()) >= 0.5;  // the box shows whole units
    if (touched) {
      model->setData(index, spin->value(), Qt::EditRole);
    }
  } else if (auto* combo = qobject_cast<QComboBox*>(editor)) {
    model->setData(index, combo->currentData(), Qt::EditRole);
  } else {
    QStyledItemDelegate::setModelData(editor, model, index);
  }
}

void TargetDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyledItemDelegate::updateEditorGeometry(editor, option, index);
  editor->resize(std::max(editor->width(), editor->sizeHint().width()), editor->height());
}

}  // namespace vp::panels
