#pragma once

#include "core/formats/targets/target_import.h"
#include "ui/style/units.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace vp::dialogs {

/** Asks how the places and areas of a file become targets: at which height, and how far apart and in which direction survey
 *  lines run. */
class ImportTargetsDialog : public QDialog {
  Q_OBJECT

public:
  explicit ImportTargetsDialog(const QString& fileName, const style::Units& units, QWidget* parent = nullptr);

  [[nodiscard]] formats::TargetImportOptions options() const;

private:
  void showState();

  style::Units units_;
  QComboBox* heights_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  QCheckBox* alongLongest_ = nullptr;
  QDoubleSpinBox* course_ = nullptr;
  QCheckBox* tracks_ = nullptr;
};

}  // namespace vp::dialogs
