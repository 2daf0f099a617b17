#pragma once

#include "ui/document/view_state.h"

#include <QWidget>

#include <memory>

class QLabel;
class QTabWidget;
class QTableView;

namespace vp::document {
struct LandingCase;
}

namespace vp::panels {

class LandingModel;
class RankingLinesModel;
class RankingModel;
class TermsModel;

/** What was answered to one engine failure, three ways: by planner, by runway in the order of risk with the reasons of each, and term by term beside
 *  each other. Which answer is looked at goes into ViewState::landing. */
class LandingAnswers : public QWidget {
  Q_OBJECT

public:
  explicit LandingAnswers(document::ViewState& state, QWidget* parent = nullptr);

  /** Shows ViewState::landing. */
  void refresh();
  void restyle();

private:
  QWidget* buildRunways();
  void showLines();
  void choose(int landing, int runway);

  document::ViewState& state_;
  bool isFilling_ = false;
  QTabWidget* tabs_ = nullptr;
  QTableView* planners_ = nullptr;
  QTableView* runways_ = nullptr;
  QTableView* lines_ = nullptr;
  QTableView* terms_ = nullptr;
  QLabel* ranking_ = nullptr;
  LandingModel* plannersModel_ = nullptr;
  RankingModel* runwaysModel_ = nullptr;
  RankingLinesModel* linesModel_ = nullptr;
  TermsModel* termsModel_ = nullptr;
};

}  // namespace vp::panels
