#pragma once

#include "core/fetch/terrain_fetch.h"
#include "core/geo/geo_box.h"

#include <QDialog>
#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QRadioButton;

namespace vp::jobs {
class JobRunner;
}

namespace vp::dialogs {

/** Asks for an area, says how much there is to fetch, and fetches its terrain. The network is used only after a press of a button.
 *  Accepted when the terrain has been written; files() and notes() tell what came of it. */
class FetchTerrainDialog : public QDialog {
  Q_OBJECT

public:
  struct Offer {
    std::optional<geo::GeoBox> mapArea;     ///< what the map shows; nothing without terrain
    std::vector<std::string> airportFiles;  ///< where an airfield's code may be looked up, first match counts
    QString server;                         ///< empty: the default
    std::string cache;                      ///< empty: the default
    QString output;                         ///< where the terrain is to be written
    fetch::Patience patience;
  };

  /** @param runner  does the work; must outlive the dialog, which may close while a stopped piece of work is still ending */
  FetchTerrainDialog(Offer offer, jobs::JobRunner& runner, QWidget* parent = nullptr);
  ~FetchTerrainDialog() override;

  [[nodiscard]] QStringList files() const { return files_; }
  [[nodiscard]] QStringList notes() const { return notes_; }
  [[nodiscard]] QString server() const;
  void reject() override;

private:
  struct Asked;
  void build();
  void askForSize();
  void startFetching();
  void forgetSize();
  void setBusy(bool busy);
  void showProblem(const QString& problem);
  void chooseOutput();

  Offer offer_;
  jobs::JobRunner& runner_;
  std::optional<fetch::TerrainRequest> request_;  ///< that estimate_ belongs to
  std::optional<fetch::TerrainEstimate> estimate_;
  QStringList files_;
  QStringList notes_;
  bool isBusy_ = false;
  QRadioButton* ofMap_ = nullptr;
  QRadioButton* around_ = nullptr;
  QLineEdit* place_ = nullptr;
  QDoubleSpinBox* radius_ = nullptr;
  QLineEdit* server_ = nullptr;
  QLineEdit* output_ = nullptr;
  QLabel* size_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* ask_ = nullptr;
  QPushButton* fetch_ = nullptr;
};

}  // namespace vp::dialogs
