#pragma once

#include <QStyledItemDelegate>

namespace vp::panels {

/** Editors of the target table: a spin box with the unit for heights, a list for the datum, a line for the rest. */
class TargetDelegate : public QStyledItemDelegate {
  Q_OBJECT

public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;
  /// At least as wide as the editor needs: columns are no wider than their texts.
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace vp::panels
