#pragma once

#include "ui/briefing/briefing_options.h"

#include <QDialog>
#include <QString>

#include <utility>
#include <vector>

class QCheckBox;
class QComboBox;
class QDateEdit;
class QFormLayout;

namespace vp::dialogs {

/** Asks what a briefing shall be like: paper, units, day of the flight, which parts. Written only when the operator says so. */
class BriefingDialog : public QDialog {
  Q_OBJECT

public:
  /** @param doubt  what speaks against this plan, in a sentence; empty: nothing */
  BriefingDialog(const briefing::BriefingOptions& options, const QString& doubt, QWidget* parent = nullptr);

  [[nodiscard]] briefing::BriefingOptions options() const;

private:
  void addPart(QFormLayout* form, const char* name, const QString& text, bool briefing::BriefingOptions::*part);

  briefing::BriefingOptions options_;
  QComboBox* paper_ = nullptr;
  QComboBox* units_ = nullptr;
  QDateEdit* date_ = nullptr;
  std::vector<std::pair<QCheckBox*, bool briefing::BriefingOptions::*>> parts_;
};

}  // namespace vp::dialogs
