#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QDialog>
#include <QStringList>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace vp::dialogs {

/** Name, place and height of one target. Places are typed as degrees, degrees and minutes, or degrees, minutes and seconds. */
class TargetDialog : public QDialog {
  Q_OBJECT

public:
  /** @param takenNames  names of the other targets, which this one may not have */
  TargetDialog(const mission::Target& target, const QStringList& takenNames, const style::Units& units, QWidget* parent = nullptr);
  [[nodiscard]] mission::Target result() const;

private:
  void check();

  mission::Target target_;
  QStringList taken_;
  style::Units units_;
  QString shownPlace_;
  QLineEdit* name_ = nullptr;
  QLineEdit* place_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  QComboBox* reference_ = nullptr;
  QLabel* problem_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace vp::dialogs
