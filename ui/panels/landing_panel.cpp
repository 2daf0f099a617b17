#include "ui/panels/landing_panel.h"

#include "core/emergency/landing_outcome.h"
#include "core/emergency/planners.h"
#include "core/emergency/weather/weather_planner.h"
#include "ui/document/weather_view.h"
#include "ui/panels/glide_picture.h"
#include "ui/panels/landing_answers.h"
#include "ui/panels/landing_model.h"
#include "ui/panels/site_text.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/tour_curves.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStackedLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace vp::panels {
namespace {

constexpr double kFirstHeight = 914.4;  // m above ground: 3000 ft, where nothing is known of the height
constexpr double kRoundTo = 100.0;      // of the unit of heights
constexpr double kHighest = 20000.0;    // m MSL, as all altitudes of a mission
constexpr double kLowest = -500.0;
constexpr std::array kSeconds{0.2, 1.0, 5.0, 20.0};
constexpr int kUsualSeconds = 1;  // index

constexpr QLatin1String kSideBySide("side by side");  // data of choices that are no planner
constexpr QLatin1String kAll("all");

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a planner is one of [4], which keep out of weather.
bool isForWeather(const std::string& name) {
  const std::vector<std::string_view> all = emergency::weatherPlannerNames();
  return std::find(all.begin(), all.end(), name) != all.end();
}

}  // namespace

LandingPanel::LandingPanel(document::ViewState& state, std::vector<std::string> planners, QWidget* parent)
    : QWidget(parent), state_(state), planners_(std::move(planners)) {
  setAccessibleName(tr("Landing now"));
  buildLayout();
  connect(&state_, &document::ViewState::landingChanged, this, &LandingPanel::refresh);
  connect(&state_, &document::ViewState::unitsChanged, this, &LandingPanel::restyle);
  connect(&state_, &document::ViewState::themeChanged, this, &LandingPanel::restyle);
  restyle();
}

LandingPanel::~LandingPanel() = default;

void LandingPanel::buildLayout() {
  stack_ = new QStackedLayout(this);
  empty_ = sentenceLabel(this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setMargin(16);
  stack_->addWidget(empty_);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  where_ = sentenceLabel(page);
  QFont bold = where_->font();
  bold.setBold(true);
  where_->setFont(bold);
  column->addWidget(where_);
  column->addWidget(buildQuestion());
  answers_ = new LandingAnswers(state_, page);
  column->addWidget(answers_, 2);
  sentence_ = sentenceLabel(page);
  sentence_->setObjectName(QStringLiteral("landingSentence"));
  sentence_->setAccessibleName(tr("What this landing is"));
  column->addWidget(sentence_);
  picture_ = new GlidePicture(state_, page);
  column->addWidget(picture_, 1);
  stack_->addWidget(page);
}

QWidget* LandingPanel::buildQuestion() {
  auto* question = new QWidget(this);
  auto* form = new QFormLayout(question);
  form->setContentsMargins(0, 0, 0, 0);
  altitudeField_ = new QDoubleSpinBox(question);
  altitudeField_->setObjectName(QStringLiteral("landingAltitude"));
  altitudeField_->setDecimals(0);
  altitudeField_->setSingleStep(kRoundTo);
  altitudeField_->setKeyboardTracking(false);
  courseField_ = new QDoubleSpinBox(question);
  courseField_->setObjectName(QStringLiteral("landingCourse"));
  courseField_->setRange(1.0, 360.0);
  courseField_->setDecimals(0);
  courseField_->setSuffix(QStringLiteral("° T"));
  courseField_->setWrapping(true);
  courseField_->setKeyboardTracking(false);
  planner_ = new QComboBox(question);
  planner_->setObjectName(QStringLiteral("landingPlanner"));
  planner_->addItem(tr("Side by side"), QString(kSideBySide));
  planner_->setItemData(0, tr("Each general planner; where there is weather, also the two that keep out of it best"), Qt::ToolTipRole);
  planner_->addItem(tr("All %1, side by side").arg(planners_.size() - 1), QString(kAll));
  for (const std::string& name : planners_) {
    planner_->addItem(isForWeather(name) ? tr("Weather: %1").arg(plannerTitle(name)) : plannerTitle(name), QString::fromStdString(name));
  }
  time_ = new QComboBox(question);
  time_->setObjectName(QStringLiteral("landingTime"));
  for (const double seconds : kSeconds) {
    time_->addItem(tr("%1 s").arg(seconds), seconds);
  }
  time_->setCurrentIndex(kUsualSeconds);
  time_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  time_->setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
  stop_ = new QPushButton(tr("Stop"), question);
  stop_->setObjectName(QStringLiteral("landingStop"));
  auto* clear = new QPushButton(tr("Clear"), question);
  clear->setObjectName(QStringLiteral("landingClear"));
  form->addRow(tr("Altitude"), altitudeField_);
  form->addRow(tr("Course over ground"), courseField_);
  form->addRow(tr("Planner"), planner_);
  auto* row = new QHBoxLayout;
  row->addWidget(time_, 1);
  row->addWidget(stop_);
  row->addWidget(clear);
  form->addRow(tr("Time for each"), row);
  connect(altitudeField_, &QDoubleSpinBox::valueChanged, this, [this](double shown) {
    if (!isFilling_) {
      altitude_ = state_.units().heightToSi(shown);
      ask();
    }
  });
  connect(courseField_, &QDoubleSpinBox::valueChanged, this, [this](double course) {
    if (!isFilling_ && situation_.terrain != nullptr && place_) {
      heading_ = situation_.terrain->frame.headingOf(Angle::degrees(course), situation_.terrain->frame.toLatLon(*place_));
      ask();
    }
  });
  connect(planner_, &QComboBox::activated, this, &LandingPanel::ask);
  connect(time_, &QComboBox::activated, this, &LandingPanel::ask);
  connect(stop_, &QPushButton::clicked, this, &LandingPanel::stopRequested);
  connect(clear, &QPushButton::clicked, this, [this] {
    place_.reset();
    emit clearRequested();
    refresh();
  });
  return question;
}

void LandingPanel::setSituation(const document::Situation& situation) {
  const bool isOtherFrame = situation.terrain == nullptr || situation_.terrain == nullptr || !(situation.terrain->frame == situation_.terrain->frame);
  const bool isOtherChoice =
      (situation.weatherRisk != nullptr) != (situation_.weatherRisk != nullptr) && planner_->currentData() == QString(kSideBySide);
  situation_ = situation;
  if (isOtherFrame && place_) {
    place_.reset();  // it meant a place in the other frame
    emit clearRequested();
  }
  if (isOtherFrame) {
    refresh();
  } else if (isOtherChoice && place_ && state_.landing() != nullptr) {
    ask();  // the planners that keep out of weather belong to the choice now, or no longer
  }
}

void LandingPanel::askAt(geo::Point place, std::optional<double> distance) {
  if (situation_.terrain == nullptr) {
    return;
  }
  const style::Units& units = state_.units();
  place_ = place;
  if (distance && situation_.plan != nullptr) {
    const document::TourState there = situation_.plan->at(*distance);
    place_ = there.pose.point();
    altitude_ = there.altitude;
    heading_ = there.pose.heading;
  } else {
    const double ground = situation_.terrain->grid->upperAt(place);
    const double clearance = state_.landing() != nullptr ? state_.landing()->clearance : 0.0;
    if (std::isfinite(ground) && !(altitude_ > ground + clearance)) {
      altitude_ = units.heightToSi(std::ceil(units.heightFromSi(ground + kFirstHeight) / kRoundTo) * kRoundTo);
    }
  }
  ask();
}

void LandingPanel::ask() {
  if (!place_) {
    return;
  }
  std::vector<std::string> wanted;
  const QString one = planner_->currentData().toString();
  if (one == kAll || one == kSideBySide) {
    const std::vector<std::string> usual = emergency::combinedNames(situation_.weatherRisk != nullptr);
    // the combined answer is one of the others', so beside them it would be told twice
    std::copy_if(planners_.begin(), planners_.end(), std::back_inserter(wanted),
                 [&](const std::string& name) { return one == kAll ? name != "combined" : holds(usual, name); });
  } else {
    wanted.push_back(one.toStdString());
  }
  emit asked({place_->x, place_->y, heading_}, altitude_, time_->currentData().toDouble(), wanted);
  refresh();
}

void LandingPanel::showProblem(const QString& sentence) {
  place_.reset();
  empty_->setText(sentence);
  stack_->setCurrentIndex(0);
}

void LandingPanel::refresh() {
  const std::shared_ptr<const document::LandingCase>& shown = state_.landing();
  const QScopedValueRollback filling(isFilling_, true);
  answers_->refresh();
  if (shown == nullptr || situation_.terrain == nullptr) {
    empty_->setText(
        tr("Right-click a place on the map, or a point of the tour, and choose \"Engine out here\" to see where the aircraft can land "
           "from there, at any altitude and on any course."));
    stack_->setCurrentIndex(0);
    return;
  }
  stack_->setCurrentIndex(1);
  const style::Units& units = state_.units();
  const geo::Point place = shown->pose.point();
  where_->setText(tr("%1, %2").arg(
      style::Units::position(situation_.terrain->frame.toLatLon(place)),
      std::isfinite(shown->ground) ? units.heightAboveGround(shown->altitude - shown->ground) : tr("over ground of unknown height")));
  altitudeField_->setRange(units.heightFromSi(kLowest), units.heightFromSi(kHighest));
  altitudeField_->setSuffix(QStringLiteral(" %1 MSL").arg(units.heightUnit()));
  if (!altitudeField_->hasFocus()) {  // else somebody is writing there
    altitudeField_->setValue(units.heightFromSi(shown->altitude));
  }
  if (!courseField_->hasFocus()) {
    const double whole = std::round(situation_.terrain->frame.trueCourseOf(shown->pose.heading, place).degrees());
    courseField_->setValue(whole < 1.0 ? whole + 360.0 : whole);
  }
  stop_->setEnabled(shown->isRunning);
  showSelected();
}

void LandingPanel::showSelected() {
  const std::shared_ptr<const document::LandingCase>& shown = state_.landing();
  const document::ShownLanding* landing = shown->shown();
  if (landing == nullptr && !shown->landings.empty() && !shown->isRunning) {
    landing = &shown->landings.front();  // why there is no way at all
  }
  if (landing == nullptr) {
    sentence_->setText(shown->isRunning ? tr("Looking for a way down.") : tr("No planner has been asked."));
    picture_->setGlide(std::nullopt, std::nullopt, 0.0);
    return;
  }
  sentence_->setText(sentenceOf(*landing));
  std::optional<mission::LandingSite> site;
  if (landing->site) {
    site = landing->site->site;
  }
  picture_->setGlide(landing->glide, site, shown->clearance);
}

QString LandingPanel::sentenceOf(const document::ShownLanding& landing) const {
  const style::Units& units = state_.units();
  QStringList said;
  if (landing.site) {
    said << tr("%1: %2 in hand at the beginning of the approach.")
                .arg(profile::runwayNameLong(landing.site->site), units.margin(profile::shownMargin(landing.answer.heightInHand)));
    if (const std::optional<double> success = document::termOf(landing.answer, emergency::kWeatherSuccess)) {
      said << (*success < 1.0 ? tr("Comes through the weather with a probability of %1.").arg(document::percentText(*success))
                              : tr("Keeps out of the weather."));
    }
    if (!landing.answer.verified) {
      said << tr("The checker has not confirmed this path: do not rely on it.");
    }
    said << runwayDetails(landing.site->site, units);
  } else if (landing.answer.path) {
    said << tr("NOT A RUNWAY: the best that can be had is %1 of glide over ground that stays clear.").arg(units.distance(landing.glide.length));
  }
  if (!landing.answer.whyNot.empty()) {
    said << units.inSentence(landing.answer.whyNot);
  }
  if (landing.answer.missing > 0.0) {
    said << tr("%1 of height are missing.").arg(units.required(landing.answer.missing));
  }
  for (const std::string& note : landing.answer.notes) {
    said << units.inSentence(note);
  }
  return said.join(QLatin1Char(' '));
}

void LandingPanel::restyle() {
  const QScopedValueRollback filling(isFilling_, true);
  answers_->restyle();
  refresh();
}

}  // namespace vp::panels
