#include "ui/panels/engine_out_panel.h"

#include "ui/panels/alternatives_model.h"
#include "ui/panels/alternatives_worker.h"
#include "ui/panels/glide_picture.h"
#include "ui/panels/site_text.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStackedLayout>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace vp::panels {
namespace {

using std::chrono::milliseconds;

constexpr int kMostAlternatives = 6;
constexpr milliseconds kRest(150);    // the point must rest so long before other runways are looked up
constexpr milliseconds kFrame(33);    // between steps of the play button
constexpr double kPlaySpeed = 30.0;   // times the true speed: a tour of 40 minutes in 80 seconds
constexpr double kSliderStep = 10.0;  // m
constexpr double kNotable = 5.0;      // m, less surplus is none
constexpr double kTolerance = 1e-3;   // m, as the checker's

}  // namespace

EngineOutPanel::EngineOutPanel(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Engine out"));
  model_ = new AlternativesModel(this);
  worker_ = new AlternativesWorker(this);
  buildLayout();
  askTimer_.setSingleShot(true);
  askTimer_.setInterval(kRest);
  playTimer_.setInterval(kFrame);
  playTimer_.setParent(this);
  playTimer_.setObjectName(QStringLiteral("playTimer"));
  connect(&askTimer_, &QTimer::timeout, this, &EngineOutPanel::askAlternatives);
  connect(&playTimer_, &QTimer::timeout, this, &EngineOutPanel::advance);
  connect(worker_, &AlternativesWorker::answered, this, &EngineOutPanel::showAlternatives);
  connect(worker_, &AlternativesWorker::failed, this, [this](const QString& reason) { closed_->setText(reason); });
  connect(&state_, &document::ViewState::cursorChanged, this, &EngineOutPanel::refresh);
  connect(&state_, &document::ViewState::unitsChanged, this, &EngineOutPanel::restyle);
  connect(&state_, &document::ViewState::themeChanged, this, &EngineOutPanel::restyle);
  restyle();
}

EngineOutPanel::~EngineOutPanel() = default;

void EngineOutPanel::buildLayout() {
  stack_ = new QStackedLayout(this);
  empty_ = sentenceLabel(this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(16);
  stack_->addWidget(empty_);

  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  runway_ = sentenceLabel(page);
  QFont big = runway_->font();
  big.setPointSizeF(big.pointSizeF() * 1.35);
  big.setBold(true);
  runway_->setFont(big);
  runwayDetails_ = sentenceLabel(page);
  column->addWidget(runway_);
  column->addWidget(runwayDetails_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(14);
  grid->setVerticalSpacing(3);
  addFact(*grid, Position, 0, 0, tr("On the tour"));
  addFact(*grid, Altitude, 0, 2, tr("Altitude"));
  addFact(*grid, Distance, 1, 0, tr("Glide distance"));
  addFact(*grid, Time, 1, 2, tr("Time"));
  addFact(*grid, Margin, 2, 0, tr("Altitude margin"));
  addFact(*grid, Surplus, 3, 0, tr("On arrival"));
  addFact(*grid, Clearance, 4, 0, tr("Least clearance"));
  facts_[Time]->setAccessibleName(tr("Time to touchdown"));
  facts_[Time]->setToolTip(tr("From here to touchdown"));
  grid->setColumnStretch(1, 2);
  grid->setColumnStretch(3, 3);
  column->addLayout(grid);
  picture_ = new GlidePicture(state_, page);
  column->addWidget(picture_, 2);
  column->addWidget(buildControls());
  closed_ = sentenceLabel(page);
  closed_->setAccessibleName(tr("If this runway were closed"));
  column->addWidget(closed_);
  table_ = new QTableView(page);
  table_->setModel(model_);
  setUpTable(*table_, tr("Next-best runways"));
  fitColumns(*table_, {QStringLiteral("IT-0049 19"), tr("only around terrain") + QStringLiteral("MMM"), QStringLiteral("+1 000 ft"),
                       QStringLiteral("10 000 ft MSL"), QStringLiteral("88.8 NM"), QStringLiteral("88:88 min")});
  table_->setMinimumHeight(5 * table_->verticalHeader()->defaultSectionSize());
  column->addWidget(table_, 2);
  stack_->addWidget(page);
}

void EngineOutPanel::addFact(QGridLayout& grid, Fact fact, int row, int column, const QString& name) {
  auto* label = new QLabel(name, this);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setForegroundRole(QPalette::PlaceholderText);
  QLabel* value = sentenceLabel(this);
  value->setFont(profile::tabularFont(value->font()));
  value->setAccessibleName(name);
  value->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  facts_[static_cast<std::size_t>(fact)] = value;
  grid.addWidget(label, row, column, Qt::AlignTop);
  grid.addWidget(value, row, column + 1, 1, fact == Margin || fact == Clearance || fact == Surplus ? 3 : 1);
}

QWidget* EngineOutPanel::buildControls() {
  auto* controls = new QWidget(this);
  auto* row = new QHBoxLayout(controls);
  row->setContentsMargins(0, 0, 0, 0);
  const auto button = [&](const QString& name, const char* objectName) {
    auto* made = new QToolButton(controls);
    made->setToolTip(name);
    made->setAccessibleName(name);
    made->setObjectName(QLatin1String(objectName));
    made->setFocusPolicy(Qt::TabFocus);
    row->addWidget(made);
    return made;
  };
  previous_ = button(tr("Previous decision point"), "previousPoint");
  slider_ = new QSlider(Qt::Horizontal, controls);
  slider_->setAccessibleName(tr("Point of the tour"));
  slider_->setObjectName(QStringLiteral("tourSlider"));
  row->addWidget(slider_, 1);
  next_ = button(tr("Next decision point"), "nextPoint");
  play_ = button(tr("Fly along the tour"), "play");
  play_->setCheckable(true);
  auto* worst = new QToolButton(controls);
  worst->setText(tr("Worst point"));
  worst->setToolTip(tr("Go to the point with the least glide margin"));
  worst->setObjectName(QStringLiteral("worstPoint"));
  worst->setFocusPolicy(Qt::TabFocus);
  row->addWidget(worst);
  connect(previous_, &QToolButton::clicked, this, [this] { stepPoint(-1); });
  connect(next_, &QToolButton::clicked, this, [this] { stepPoint(1); });
  connect(worst, &QToolButton::clicked, this, &EngineOutPanel::goToWorstPoint);
  connect(play_, &QToolButton::toggled, this, &EngineOutPanel::setPlaying);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    if (situation_.plan != nullptr) {
      state_.setPinned(std::min(value * kSliderStep, situation_.plan->length()));
    }
  });
  return controls;
}

void EngineOutPanel::setSituation(const document::Situation& situation) {
  const bool changed = situation.plan != situation_.plan || situation.planIsCurrent != situation_.planIsCurrent;
  situation_ = situation;
  if (!changed) {
    return;
  }
  setPlaying(false);
  if (situation_.plan != nullptr) {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, static_cast<int>(std::floor(situation_.plan->length() / kSliderStep)));
    slider_->setSingleStep(std::max(1, static_cast<int>(situation_.plan->plan().mission.planner.step.si() / kSliderStep)));
    slider_->setPageStep(std::max(1, slider_->maximum() / 20));
  }
  refresh();
}

void EngineOutPanel::setAlternativesSource(std::shared_ptr<landing::SiteRoadmaps> source) {
  if (source != source_) {
    worker_->cancel();
    source_ = std::move(source);
    model_->setAnswers(source_, {});
    refresh();
  }
}

void EngineOutPanel::refresh() {
  glide_.reset();
  if (situation_.plan == nullptr) {
    empty_->setText(tr("Plan a tour, then choose a point of it to see the glide that would be flown if the engine stopped there."));
    stack_->setCurrentIndex(0);
    clearGlide();
    return;
  }
  stack_->setCurrentIndex(1);
  const std::optional<double> position = state_.position();
  if (!position) {
    clearGlide();
    runway_->setText(tr("No point chosen"));
    runwayDetails_->setText(tr("Move along the tour on the map, in the profile or with the slider below."));
    return;
  }
  glide_ = situation_.plan->engineOutAt(*position);
  if (state_.pinned()) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(*state_.pinned() / kSliderStep)));
  }
  showGlide(*glide_);
  worker_->cancel();
  table_->setEnabled(false);
  if (source_ == nullptr) {
    closed_->clear();
  } else if (glide_->site >= 0) {
    closed_->setText(tr("Comparing other runways."));
    askTimer_.start();
  }
}

void EngineOutPanel::clearGlide() {
  askTimer_.stop();
  worker_->cancel();
  model_->setAnswers(source_, {});
  closed_->clear();
  runway_->clear();
  runwayDetails_->clear();
  for (QLabel* fact : facts_) {
    fact->setText(QStringLiteral("–"));
    fact->setPalette(palette());
  }
  picture_->setGlide(nullptr, std::nullopt);
}

void EngineOutPanel::showGlide(const document::EngineOut& glide) {
  const style::Units& units = state_.units();
  const auto set = [this](Fact fact, const QString& text) { facts_[static_cast<std::size_t>(fact)]->setText(text); };
  set(Position, units.distance(glide.from.distance));
  set(Altitude, units.altitudeMsl(glide.from.altitude));
  picture_->setGlide(situation_.plan, glide);
  if (glide.site < 0 || glide.path.empty()) {
    runway_->setText(tr("No glide is known from here"));
    runwayDetails_->clear();
    for (const Fact fact : {Margin, Distance, Time, Clearance, Surplus}) {
      set(fact, QStringLiteral("–"));
    }
    return;
  }
  const mission::LandingSite& site = situation_.plan->plan().sites[static_cast<std::size_t>(glide.site)].site;
  runway_->setText(profile::runwayNameLong(site));
  runwayDetails_->setText(runwayDetails(site, units));
  const double clearance = situation_.plan->plan().mission.safety.clearance.si();
  set(Margin, std::isfinite(glide.margin) ? units.margin(profile::shownMargin(glide.margin)) : tr("not reachable"));
  colorFact(Margin, !(glide.margin >= -kTolerance));
  set(Distance, units.distance(glide.length));
  set(Time, style::Units::duration(glide.seconds));
  const document::GlidePoint& low = glide.path[glide.leastClearanceAt];
  set(Clearance, std::isfinite(glide.leastClearance)
                     ? tr("%1 after %2").arg(units.heightAboveGround(glide.leastClearance), units.distance(low.distance))
                     : tr("unknown: the glide crosses ground without data"));
  colorFact(Clearance, !(glide.leastClearance >= clearance - kTolerance));
  set(Surplus, glide.surplus >= kNotable ? tr("%1 to lose by circling").arg(units.margin(glide.surplus)) : tr("nothing to spare"));
}

void EngineOutPanel::colorFact(Fact fact, bool isBad) {
  QLabel* label = facts_[static_cast<std::size_t>(fact)];
  QPalette colors = palette();
  if (isBad) {
    colors.setColor(QPalette::WindowText, style::ChartColors::of(state_.theme()).violation);
    label->setText(QStringLiteral("⚠ ") + label->text());
  }
  label->setPalette(colors);
}

int EngineOutPanel::siteInSource(int planSite) const {
  const std::string& id = situation_.plan->plan().sites[static_cast<std::size_t>(planSite)].site.id;
  const std::vector<mission::SiteInFrame>& sites = source_->world().sites;
  const auto found = std::find_if(sites.begin(), sites.end(), [&](const mission::SiteInFrame& site) { return site.site.id == id; });
  return found == sites.end() ? -1 : static_cast<int>(found - sites.begin());
}

void EngineOutPanel::askAlternatives() {
  if (glide_ && glide_->site >= 0 && source_ != nullptr) {
    worker_->ask({source_, glide_->from.pose, glide_->from.altitude, kMostAlternatives + 1});
  }
}

void EngineOutPanel::showAlternatives(const std::vector<landing::SiteAnswer>& answers) {
  if (!glide_ || glide_->site < 0 || source_ == nullptr) {
    return;
  }
  const int own = siteInSource(glide_->site);
  std::vector<landing::SiteAnswer> others;
  for (const landing::SiteAnswer& answer : answers) {
    if (own < 0 || source_->runwayOf(answer.site) != source_->runwayOf(own)) {
      others.push_back(answer);
    }
  }
  others.resize(std::min<std::size_t>(others.size(), kMostAlternatives));
  table_->setEnabled(true);
  if (own < 0) {
    closed_->setText(tr("The runways have changed since this plan was made; plan again to compare them."));
  } else {
    const QString runway = physicalRunwayName(*source_, own);
    if (others.empty()) {
      closed_->setText(tr("If %1 were closed: no other runway has a glide from here.").arg(runway));
    } else {
      const landing::SiteAnswer& best = others.front();
      const QString name = profile::runwayName(source_->world().sites[static_cast<std::size_t>(best.site)].site);
      closed_->setText(
          best.isReachable()
              ? tr("If %1 were closed: still %2 to %3.").arg(runway, state_.units().margin(profile::shownMargin(best.margin)), name)
              : tr("If %1 were closed: %2 missing to the next best, %3.").arg(runway, missingHeight(-best.margin, state_.units()), name));
    }
  }
  model_->setAnswers(source_, std::move(others));
}

QString EngineOutPanel::closedSentence() const {
  return closed_->text();
}

void EngineOutPanel::goToWorstPoint() {
  if (situation_.plan != nullptr) {
    jumpTo(state_, *situation_.plan, situation_.plan->leastGlideMargin().state.distance);
  }
}

void EngineOutPanel::stepPoint(int by) {
  if (situation_.plan == nullptr) {
    return;
  }
  const auto count = static_cast<int>(situation_.plan->plan().tour.size());
  const document::TourState now = situation_.plan->at(state_.position().value_or(0.0));
  const bool between = now.distance > situation_.plan->distanceOf(static_cast<std::size_t>(now.point));
  const int next = now.point + (by > 0 ? 1 : between ? 0 : -1);
  state_.setPinned(situation_.plan->distanceOf(static_cast<std::size_t>((next + count) % count)));
}

void EngineOutPanel::setPlaying(bool playing) {
  playing = playing && situation_.plan != nullptr;
  play_->setChecked(playing);
  play_->setIcon(signIcon(playing ? Sign::Pause : Sign::Play, state_.theme()));
  if (playing) {
    playClock_.start();
    playTimer_.start();
  } else {
    playTimer_.stop();
  }
}

void EngineOutPanel::advance() {
  if (situation_.plan == nullptr) {
    setPlaying(false);
    return;
  }
  const double seconds = static_cast<double>(playClock_.restart()) / 1000.0;
  const double speed = situation_.plan->plan().mission.aircraft.bestGlideSpeed.si();
  const double next = state_.pinned().value_or(0.0) + seconds * kPlaySpeed * speed;
  state_.setPinned(std::fmod(next, situation_.plan->length()));
}

void EngineOutPanel::restyle() {
  previous_->setIcon(signIcon(Sign::Previous, state_.theme()));
  next_->setIcon(signIcon(Sign::Next, state_.theme()));
  play_->setIcon(signIcon(play_->isChecked() ? Sign::Pause : Sign::Play, state_.theme()));
  model_->setStyle(state_.units(), state_.theme());
  refresh();
}

}  // namespace vp::panels
