#pragma once

#include "core/mission/mission.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace vp::dialogs {

/** The files that a mission is made from, terrain first, one line each; each can be taken out of the mission. Changes nothing
 *  itself; whoever owns the document answers the signals and shows it the mission again. Does not block the window. */
class MissionFilesDialog : public QDialog {
  Q_OBJECT

public:
  explicit MissionFilesDialog(QWidget* parent = nullptr);

  void setMission(const mission::Mission& mission);
  [[nodiscard]] QTableWidget& list() { return *list_; }

signals:
  /// @param index  into Mission::terrain
  void terrainRemoveRequested(int index);
  /// @param index  into Mission::airfields
  void airfieldsRemoveRequested(int index);
  /// @param index  into AirspaceSettings::files
  void airspacesRemoveRequested(int index);
  /// @param index  into Mission::populationFiles
  void populationRemoveRequested(int index);
  void addTerrainRequested();
  void addAirfieldsRequested();
  void addAirspacesRequested();
  void addPopulationRequested();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void addRow(const QString& kindName, int kind, int index, const QStringList& paths);
  void removeCurrent();
  void showState();

  QTableWidget* list_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* remove_ = nullptr;
};

}  // namespace vp::dialogs
