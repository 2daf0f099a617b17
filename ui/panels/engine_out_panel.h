#pragma once

#include "core/landing/site_roadmaps.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QSlider;
class QStackedLayout;
class QTableView;
class QToolButton;

namespace vp::panels {

class AlternativesModel;
class AlternativesWorker;
class GlidePicture;

/** What happens if the engine stops at the point of the tour that is looked at: the runway, the glide, its margins, the
 *  next-best runways, and what would be missing if that runway were closed.
 *
 *  Follows ViewState::position(). Everything about the plan's own glide is shown at once; the other runways are worked out
 *  on another thread a moment after the point has come to rest. */
class EngineOutPanel : public QWidget {
  Q_OBJECT

public:
  explicit EngineOutPanel(document::ViewState& state, QWidget* parent = nullptr);
  ~EngineOutPanel() override;

  void setSituation(const document::Situation& situation);
  /** Where other runways are looked up; null while there is none. */
  void setAlternativesSource(std::shared_ptr<landing::SiteRoadmaps> source);

  /** Sentence about the closed runway, as shown. */
  [[nodiscard]] QString closedSentence() const;

public slots:
  void goToWorstPoint();
  void stepPoint(int by);
  void setPlaying(bool playing);

private:
  enum Fact { Position, Altitude, Margin, Distance, Time, Clearance, Surplus, FactCount };

  void buildLayout();
  QWidget* buildControls();
  void addFact(QGridLayout& grid, Fact fact, int row, int column, const QString& name);
  void refresh();
  void showGlide(const document::EngineOut& glide);
  void clearGlide();
  void askAlternatives();
  void showAlternatives(const std::vector<landing::SiteAnswer>& answers);
  void advance();
  void restyle();
  void colorFact(Fact fact, bool isBad);
  [[nodiscard]] int siteInSource(int planSite) const;

  document::ViewState& state_;
  document::Situation situation_;
  std::shared_ptr<landing::SiteRoadmaps> source_;
  std::optional<document::EngineOut> glide_;

  QStackedLayout* stack_ = nullptr;
  QLabel* empty_ = nullptr;
  QLabel* runway_ = nullptr;
  QLabel* runwayDetails_ = nullptr;
  std::array<QLabel*, FactCount> facts_{};
  GlidePicture* picture_ = nullptr;
  QSlider* slider_ = nullptr;
  QToolButton* previous_ = nullptr;
  QToolButton* next_ = nullptr;
  QToolButton* play_ = nullptr;
  QLabel* closed_ = nullptr;
  QTableView* table_ = nullptr;
  AlternativesModel* model_ = nullptr;
  AlternativesWorker* worker_ = nullptr;
  QTimer askTimer_;
  QTimer playTimer_;
  QElapsedTimer playClock_;
};

}  // namespace vp::panels
