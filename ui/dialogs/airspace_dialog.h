#pragma once

#include "core/mission/airspace.h"
#include "ui/style/units.h"

#include <QDialog>

#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace vp::dialogs {

/** What a mission does about airspaces: a line for each class with those of the class under it, each with a choice of its own.
 *  Changes nothing itself: result() has the rules when it was accepted. */
class AirspaceDialog : public QDialog {
  Q_OBJECT

public:
  /** @param airspaces  near the terrain, shown or hidden
   *  @param kinds  classes of all airspaces of the files; those that are not near can be ruled on all the same */
  AirspaceDialog(const std::vector<mission::Airspace>& airspaces, const std::vector<std::string>& kinds, const mission::AirspaceSettings& settings,
                 const style::Units& units, QWidget* parent = nullptr);

  [[nodiscard]] const mission::AirspaceSettings& result() const { return settings_; }

  /** The choice for a class, or for one airspace of it; null if there is none. */
  [[nodiscard]] QComboBox* choiceOf(const QString& kind, const QString& name = {});

signals:
  void addFilesRequested();

private:
  void addKinds(const std::vector<mission::Airspace>& airspaces, const std::vector<std::string>& found, const style::Units& units);
  QTreeWidgetItem* addKind(const std::string& kind, int count);
  void addAirspace(QTreeWidgetItem& parent, const mission::Airspace& airspace, const style::Units& units);
  void addChoice(QTreeWidgetItem& item, const std::string& kind, const std::string& name);
  void addChoices(QTreeWidgetItem& parent);
  void showHint(bool isEmpty);

  mission::AirspaceSettings settings_;
  QTreeWidget* tree_ = nullptr;
  QComboBox* otherwise_ = nullptr;
  QLabel* hint_ = nullptr;
};

}  // namespace vp::dialogs
