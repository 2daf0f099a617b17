#include "ui/dialogs/mission_files_dialog.h"

#include "ui/panels/table_tools.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace vp::dialogs {
namespace {

enum Column { File, Kind, State, Folder, ColumnCount };
enum FileKind { Terrain, Airfields, Airspaces, Population };
constexpr int kKindRole = Qt::UserRole;
constexpr int kIndexRole = Qt::UserRole + 1;
constexpr QSize kSize{760, 360};

}  // namespace

MissionFilesDialog::MissionFilesDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Files of the mission"));
  setObjectName(QStringLiteral("missionFilesDialog"));
  list_ = new QTableWidget(0, ColumnCount);
  list_->setObjectName(QStringLiteral("missionFiles"));
  panels::setUpTable(*list_, tr("Files of the mission"));
  list_->setHorizontalHeaderLabels({tr("File"), tr("Kind"), tr("Size"), tr("Folder")});
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  list_->horizontalHeader()->setStretchLastSection(true);
  hint_ = new QLabel;
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  remove_ = buttons->addButton(tr("&Remove from mission"), QDialogButtonBox::ActionRole);
  QPushButton* addTerrain = buttons->addButton(tr("Add &terrain…"), QDialogButtonBox::ActionRole);
  QPushButton* addAirfields = buttons->addButton(tr("Add &airfields…"), QDialogButtonBox::ActionRole);
  QPushButton* addAirspaces = buttons->addButton(tr("Add air&spaces…"), QDialogButtonBox::ActionRole);
  QPushButton* addPopulation = buttons->addButton(tr("Add &population…"), QDialogButtonBox::ActionRole);
  remove_->setObjectName(QStringLiteral("removeFile"));
  remove_->setToolTip(tr("Remove from mission (Del)"));
  for (QPushButton* button : {remove_, addTerrain, addAirfields, addAirspaces, addPopulation}) {
    button->setAutoDefault(false);
  }
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_, 1);
  column->addWidget(hint_);
  column->addWidget(buttons);
  list_->installEventFilter(this);
  connect(remove_, &QPushButton::clicked, this, &MissionFilesDialog::removeCurrent);
  connect(addTerrain, &QPushButton::clicked, this, &MissionFilesDialog::addTerrainRequested);
  connect(addAirfields, &QPushButton::clicked, this, &MissionFilesDialog::addAirfieldsRequested);
  connect(addAirspaces, &QPushButton::clicked, this, &MissionFilesDialog::addAirspacesRequested);
  connect(addPopulation, &QPushButton::clicked, this, &MissionFilesDialog::addPopulationRequested);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTableWidget::currentItemChanged, this, &MissionFilesDialog::showState);
  resize(kSize);
  showState();
}

void MissionFilesDialog::addRow(const QString& kindName, int kind, int index, const QStringList& paths) {
  QStringList names;
  qint64 bytes = 0;
  bool isMissing = false;
  for (const QString& path : paths) {
    const QFileInfo info(path);
    names << info.fileName();
    bytes += info.size();
    isMissing = isMissing || !info.exists();
  }
  const QString folder = QFileInfo(paths.front()).absolutePath();
  const QStringList texts{names.join(QStringLiteral(" + ")), kindName, isMissing ? tr("not there!") : QLocale().formattedDataSize(bytes), folder};
  const int row = list_->rowCount();
  list_->insertRow(row);
  for (int column = 0; column < ColumnCount; ++column) {
    auto* item = new QTableWidgetItem(texts[column]);
    item->setToolTip(column == File ? paths.join(QLatin1Char('\n')) : texts[column]);
    item->setData(kKindRole, kind);
    item->setData(kIndexRole, index);
    if (column == State) {
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    list_->setItem(row, column, item);
  }
}

void MissionFilesDialog::setMission(const mission::Mission& mission) {
  const int before = list_->currentRow();
  list_->setRowCount(0);
  for (std::size_t i = 0; i < mission.terrain.size(); ++i) {
    addRow(tr("Terrain"), Terrain, static_cast<int>(i), {QString::fromStdString(mission.terrain[i])});
  }
  for (std::size_t i = 0; i < mission.airfields.size(); ++i) {
    QStringList paths{QString::fromStdString(mission.airfields[i].airports)};
    if (!mission.airfields[i].runways.empty()) {
      paths << QString::fromStdString(mission.airfields[i].runways);
    }
    addRow(tr("Airfields"), Airfields, static_cast<int>(i), paths);
  }
  for (std::size_t i = 0; i < mission.airspace.files.size(); ++i) {
    addRow(tr("Airspaces"), Airspaces, static_cast<int>(i), {QString::fromStdString(mission.airspace.files[i])});
  }
  for (std::size_t i = 0; i < mission.populationFiles.size(); ++i) {
    addRow(tr("Population"), Population, static_cast<int>(i), {QString::fromStdString(mission.populationFiles[i])});
  }
  if (list_->rowCount() > 0) {
    list_->setCurrentCell(std::clamp(before, 0, list_->rowCount() - 1), File);
  }
  showState();
}

void MissionFilesDialog::removeCurrent() {
  const QTableWidgetItem* marked = list_->currentItem();
  if (marked == nullptr) {
    return;
  }
  const int index = marked->data(kIndexRole).toInt();
  if (marked->data(kKindRole).toInt() == Terrain) {
    emit terrainRemoveRequested(index);
  } else if (marked->data(kKindRole).toInt() == Airspaces) {
    emit airspacesRemoveRequested(index);
  } else if (marked->data(kKindRole).toInt() == Population) {
    emit populationRemoveRequested(index);
  } else {
    emit airfieldsRemoveRequested(index);
  }
}

bool MissionFilesDialog::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Delete) {
    removeCurrent();
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void MissionFilesDialog::showState() {
  remove_->setEnabled(list_->currentItem() != nullptr);
  hint_->setText(
      list_->rowCount() == 0
          ? tr("No files yet. Add terrain, airfields, airspaces and population here, or drop them on the window.")
          : tr("Removing takes a file out of the mission; the file itself stays where it is, and Undo brings it back. A plan that was made "
               "with it is then out of date, but not by population, which only landing now looks at."));
}

}  // namespace vp::dialogs
