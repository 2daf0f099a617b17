#pragma once

#include "core/formats/targets/target_import.h"
#include "ui/jobs/file_intake.h"
#include "ui/jobs/job_runner.h"
#include "ui/style/units.h"

#include <QDialog>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QTableView;

namespace vp::dialogs {

class TargetChoiceModel;

/** Shows the targets of a file to choose from, and asks how its places and areas become targets: at which height, and how far apart and in which
 *  direction survey lines run. When one of that changes, a worker reads the file again; what was chosen stays chosen. */
class ImportTargetsDialog : public QDialog {
  Q_OBJECT

public:
  ImportTargetsDialog(jobs::TargetsOfFile file, const style::Units& units, QWidget* parent = nullptr);

  [[nodiscard]] formats::TargetImportOptions options() const;
  /** What was chosen, with the notes of the reading that it comes from. */
  [[nodiscard]] formats::ImportedTargets chosen() const;

protected:
  void keyPressEvent(QKeyEvent* event) override;

private:
  QFormLayout* makeOptions();
  void makeTable();
  QLayout* makeSearch();
  void connectFields();
  void showState();
  void optionsChanged();
  void readAgain();
  void showFound(jobs::TargetsOfFile::Found found);
  [[nodiscard]] QString problem() const;

  jobs::TargetsOfFile file_;
  style::Units units_;
  bool isOld_ = false;  ///< the table is of other options than those that are set
  jobs::JobRunner reader_;
  QTimer rest_;  ///< gathers changes that follow each other
  QComboBox* heights_ = nullptr;
  QDoubleSpinBox* height_ = nullptr;
  QDoubleSpinBox* spacing_ = nullptr;
  QCheckBox* alongLongest_ = nullptr;
  QDoubleSpinBox* course_ = nullptr;
  QCheckBox* tracks_ = nullptr;
  QLineEdit* search_ = nullptr;
  TargetChoiceModel* model_ = nullptr;
  QTableView* table_ = nullptr;
  QLabel* count_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* import_ = nullptr;
};

}  // namespace vp::dialogs
