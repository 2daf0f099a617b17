#include "ui/panels/landing_answers.h"

#include "ui/document/landing_case.h"
#include "ui/panels/landing_model.h"
#include "ui/panels/ranking_model.h"
#include "ui/panels/table_tools.h"
#include "ui/panels/terms_model.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTabWidget>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vp::panels {
namespace {

constexpr double kRows = 8.6;  // of the planners that are seen, their header among them
constexpr int kRunwaysTab = 1;
constexpr int kTermWidth = 132;  // px, of the names of terms at most

}  // namespace

LandingAnswers::LandingAnswers(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  plannersModel_ = new LandingModel(this);
  runwaysModel_ = new RankingModel(this);
  linesModel_ = new RankingLinesModel(this);
  termsModel_ = new TermsModel(this);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName(QStringLiteral("landingTabs"));
  tabs_->setDocumentMode(true);
  planners_ = new QTableView;
  planners_->setObjectName(QStringLiteral("landingPlanners"));
  planners_->setModel(plannersModel_);
  setUpTable(*planners_, tr("Answers of the planners"));
  tabs_->addTab(planners_, tr("Planners"));
  tabs_->addTab(buildRunways(), tr("Runways"));
  terms_ = new QTableView;
  terms_->setObjectName(QStringLiteral("landingTerms"));
  terms_->setModel(termsModel_);
  setUpTable(*terms_, tr("Terms of the answers, side by side"));
  terms_->setSelectionMode(QAbstractItemView::NoSelection);
  terms_->setWordWrap(true);  // names of terms are long, and the figures beside them matter
  tabs_->addTab(terms_, tr("Terms"));
  tabs_->setTabToolTip(kRunwaysTab, tr("Every runway by total risk: the way there, its length and surface, wind, people under the approach"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs_);
  tabs_->setMinimumHeight(static_cast<int>(kRows * planners_->verticalHeader()->defaultSectionSize()));
  connect(planners_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
    if (now.isValid()) {
      choose(now.row(), -1);
    }
  });
  connect(planners_, &QTableView::clicked, this, [this](const QModelIndex& at) { choose(at.row(), -1); });
  connect(runways_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
    if (now.isValid() && state_.landing() != nullptr) {
      choose(state_.landing()->selected, now.row());
    }
  });
  connect(tabs_, &QTabWidget::currentChanged, this, [this](int tab) {
    const bool isRanked = state_.landing() != nullptr && !state_.landing()->runways.empty();
    if (tab == kRunwaysTab && isRanked && state_.landing()->selectedRunway < 0) {
      choose(state_.landing()->selected, 0);  // the best of them, with its reasons
    } else if (tab == 0 && state_.landing() != nullptr) {
      choose(state_.landing()->selected, -1);
    }
  });
}

QWidget* LandingAnswers::buildRunways() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  ranking_ = sentenceLabel(page);
  runways_ = new QTableView;
  runways_->setObjectName(QStringLiteral("landingRunways"));
  runways_->setModel(runwaysModel_);
  setUpTable(*runways_, tr("Runways by total risk"));
  lines_ = new QTableView;
  lines_->setObjectName(QStringLiteral("landingReasons"));
  lines_->setModel(linesModel_);
  setUpTable(*lines_, tr("Why this runway stands where it does"));
  lines_->setSelectionMode(QAbstractItemView::NoSelection);
  lines_->setWordWrap(true);
  lines_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  lines_->horizontalHeader()->setSectionResizeMode(RankingLinesModel::Cost, QHeaderView::ResizeToContents);
  column->addWidget(ranking_);
  column->addWidget(runways_, 1);
  column->addWidget(lines_, 1);
  return page;
}

void LandingAnswers::choose(int landing, int runway) {
  const std::shared_ptr<const document::LandingCase>& shown = state_.landing();
  if (isFilling_ || shown == nullptr || (landing == shown->selected && runway == shown->selectedRunway)) {
    return;
  }
  document::LandingCase other = *shown;
  other.selected = landing;
  other.selectedRunway = runway;
  state_.setLanding(std::make_shared<const document::LandingCase>(std::move(other)));
}

void LandingAnswers::refresh() {
  const QScopedValueRollback filling(isFilling_, true);
  const std::shared_ptr<const document::LandingCase>& shown = state_.landing();
  plannersModel_->setCase(shown);
  runwaysModel_->setCase(shown);
  termsModel_->setCase(shown);
  planners_->setColumnHidden(LandingModel::Weather, shown == nullptr || !shown->hasWeather);
  fitWholeColumns(*planners_);
  fitWholeColumns(*runways_);
  if (termsModel_->columnCount() > 1) {
    terms_->resizeColumnsToContents();
    terms_->setColumnWidth(0, std::min(terms_->columnWidth(0), kTermWidth));
    terms_->resizeRowsToContents();
  }
  if (shown != nullptr) {
    const bool isEmpty = shown->runways.empty();
    ranking_->setVisible(isEmpty);
    ranking_->setText(shown->isRunning ? tr("Comes after the planners' answers.")
                                       : tr("Not ranked: planning was stopped before, or no way can be asked for."));
    if (shown->selected >= 0) {
      planners_->selectRow(shown->selected);
    }
    if (shown->selectedRunway >= 0) {
      runways_->selectRow(shown->selectedRunway);
    }
  }
  showLines();
}

void LandingAnswers::showLines() {
  const std::shared_ptr<const document::LandingCase>& shown = state_.landing();
  const bool isChosen = shown != nullptr && shown->selectedRunway >= 0 && shown->selectedRunway < static_cast<int>(shown->runways.size());
  linesModel_->setLines(isChosen ? shown->runways[static_cast<std::size_t>(shown->selectedRunway)].lines : std::vector<emergency::RankingLine>(),
                        state_.units());
}

void LandingAnswers::restyle() {
  const QScopedValueRollback filling(isFilling_, true);
  plannersModel_->setStyle(state_.units(), state_.theme());
  runwaysModel_->setStyle(state_.units(), state_.theme());
  termsModel_->setUnits(state_.units());
}

}  // namespace vp::panels
