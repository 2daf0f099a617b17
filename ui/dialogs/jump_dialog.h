#pragma once

#include "ui/document/situation.h"

#include <QDialog>
#include <QString>

#include <optional>

class QLabel;
class QLineEdit;

namespace vp::dialogs {

/** A place that was asked for, or a sentence that says why there is none. */
struct FoundPlace {
  std::optional<geo::Point> point;
  int target = -1;  ///< index into Situation::targets if it is one
  QString problem;  ///< empty if there is a point
};

/** Finds the name of a target, the ident of an airfield, a runway ("LSZS 21") or a position as panels::parsePosition reads
 *  it; capital letters do not matter. */
FoundPlace findPlace(const document::Situation& situation, const QString& text);

/** Asks where to go. Stays open with one sentence when the text is no place inside the terrain. */
class JumpDialog : public QDialog {
  Q_OBJECT

public:
  explicit JumpDialog(document::Situation situation, QWidget* parent = nullptr);

  [[nodiscard]] const FoundPlace& found() const { return found_; }
  void accept() override;

private:
  document::Situation situation_;
  FoundPlace found_;
  QLineEdit* text_ = nullptr;
  QLabel* problem_ = nullptr;
};

}  // namespace vp::dialogs
