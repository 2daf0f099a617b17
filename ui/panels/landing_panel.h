#pragma once

#include "ui/document/landing_case.h"
#include "ui/document/situation.h"
#include "ui/document/view_state.h"

#include <QString>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QStackedLayout;

namespace vp::panels {

class GlidePicture;
class LandingAnswers;

/** The engine stops, here, at this height, on this course: where to? What each planner answers, side by side, and every runway by its risk; the
 * chosen one with its profile.
 *
 *  Shows ViewState::landing; a question is asked by a place of the map (askAt) and again when height, course, planner or time are changed. */
class LandingPanel : public QWidget {
  Q_OBJECT

public:
  /** @param planners  names, as emergency::plannerNames() gives them */
  LandingPanel(document::ViewState& state, std::vector<std::string> planners, QWidget* parent = nullptr);
  ~LandingPanel() override;

  void setSituation(const document::Situation& situation);

  /** Asks about a place; about a point of the tour with its altitude and course, elsewhere with those of the panel, raised well above the ground
   *  where they are not.  @param distance  m along the tour */
  void askAt(geo::Point place, std::optional<double> distance);
  /** Why a question could not be asked. */
  void showProblem(const QString& sentence);

signals:
  /// @param altitude  m MSL  @param deadline  s for each planner
  void asked(vp::geo::Pose pose, double altitude, double deadline, const std::vector<std::string>& planners);
  void stopRequested();
  void clearRequested();

private:
  void buildLayout();
  QWidget* buildQuestion();
  void ask();
  void refresh();
  void showSelected();
  void restyle();
  [[nodiscard]] QString sentenceOf(const document::ShownLanding& landing) const;

  document::ViewState& state_;
  document::Situation situation_;
  std::vector<std::string> planners_;
  std::optional<geo::Point> place_;    ///< asked about
  double altitude_ = 0.0;              ///< m MSL, as exact as it was given
  double heading_ = 0.5 * Angle::kPi;  ///< rad from East
  bool isFilling_ = false;             ///< the fields change by program

  QStackedLayout* stack_ = nullptr;
  QLabel* empty_ = nullptr;
  QLabel* where_ = nullptr;
  QDoubleSpinBox* altitudeField_ = nullptr;
  QDoubleSpinBox* courseField_ = nullptr;
  QComboBox* planner_ = nullptr;
  QComboBox* time_ = nullptr;
  QPushButton* stop_ = nullptr;
  LandingAnswers* answers_ = nullptr;
  QLabel* sentence_ = nullptr;
  GlidePicture* picture_ = nullptr;
};

}  // namespace vp::panels
