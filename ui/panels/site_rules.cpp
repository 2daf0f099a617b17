#include "ui/panels/site_rules.h"

#include "ui/panels/site_text.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::panels {
namespace {

constexpr double kLongestAsked = 5000.0;      // m, no airport is excluded for less
constexpr double kWidestAsked = 100.0;        // m, wider than any runway
constexpr double kFarthestAsked = 1000000.0;  // m
constexpr std::array kSurfaces{mission::Surface::Hard, mission::Surface::Gravel, mission::Surface::Grass,  mission::Surface::Dirt,
                               mission::Surface::Snow, mission::Surface::Water,  mission::Surface::Unknown};

/// What a box says, or what it said before where nobody touched it: showing must not round a value.
std::optional<Length> lengthOf(const QDoubleSpinBox& box, const std::optional<Length>& before, double shown, double metres) {
  const double step = std::pow(10.0, -box.decimals());
  if (std::abs(box.value() - shown) < 0.5 * step) {
    return before;
  }
  return box.value() > 0.0 ? std::optional(Length::fromSi(metres)) : std::nullopt;
}

}  // namespace

SiteRules::SiteRules(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  minLength_ = addBox(*grid, 0, tr("&Shortest runway"), tr("any length"), tr("Shortest runway that is used"));
  minWidth_ = addBox(*grid, 1, tr("&Narrowest runway"), tr("any width"), tr("Narrowest runway that is used"));
  maxDistance_ = addBox(*grid, 2, tr("Within, of a tar&get"), tr("any distance"), tr("Longest distance of a runway from the nearest target"));
  maxDistance_->setDecimals(1);
  buildSurfaces();
  auto* label = new QLabel(tr("S&urfaces"), this);
  label->setBuddy(surfaces_);
  grid->addWidget(label, 3, 0);
  grid->addWidget(surfaces_, 3, 1, Qt::AlignLeft);
  approximate_ = new QCheckBox(tr("Use runways whose position is &estimated"), this);
  closed_ = new QCheckBox(tr("Use &closed runways"), this);
  water_ = new QCheckBox(tr("Use &water"), this);
  lighted_ = new QCheckBox(tr("&Lighted runways only"), this);
  // below and not beside the numbers: the panel must be narrow enough for small screens
  grid->addWidget(approximate_, 4, 0, 1, 2);
  grid->addWidget(closed_, 5, 0);
  grid->addWidget(water_, 5, 1);
  grid->addWidget(lighted_, 6, 0, 1, 2);
  for (const QCheckBox* box : {approximate_, closed_, water_, lighted_}) {
    connect(box, &QCheckBox::toggled, this, &SiteRules::emitFilter);
  }
  grid->setColumnStretch(1, 1);
  showFilter();
}

QDoubleSpinBox* SiteRules::addBox(QGridLayout& grid, int place, const QString& label, const QString& any, const QString& name) {
  auto* box = new QDoubleSpinBox(this);
  auto* text = new QLabel(label, this);
  box->setDecimals(0);
  box->setSpecialValueText(any);
  box->setAccessibleName(name);
  box->setKeyboardTracking(false);  // 9, 90, 900 must not filter three times
  text->setBuddy(box);
  grid.addWidget(text, place, 0);
  grid.addWidget(box, place, 1);
  connect(box, &QDoubleSpinBox::valueChanged, this, &SiteRules::emitFilter);
  return box;
}

void SiteRules::buildSurfaces() {
  surfaces_ = new QToolButton(this);
  surfaces_->setPopupMode(QToolButton::InstantPopup);
  surfaces_->setAccessibleName(tr("Surfaces that may be landed on"));
  auto* menu = new QMenu(surfaces_);
  for (const mission::Surface surface : kSurfaces) {
    QAction* action = menu->addAction(surfaceName(surface));
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, &SiteRules::emitFilter);
    surfaceActions_.push_back(action);
  }
  surfaces_->setMenu(menu);
}

void SiteRules::setFilter(const mission::SiteFilter& filter) {
  filter_ = filter;
  showFilter();
}

void SiteRules::setUnits(const style::Units& units) {
  units_ = units;
  showFilter();
}

void SiteRules::showFilter() {
  const std::array<QSignalBlocker, 7> quiet{QSignalBlocker(minLength_),   QSignalBlocker(minWidth_), QSignalBlocker(maxDistance_),
                                            QSignalBlocker(approximate_), QSignalBlocker(closed_),   QSignalBlocker(water_),
                                            QSignalBlocker(lighted_)};
  const bool isAviation = units_.system() == style::UnitSystem::Aviation;
  minLength_->setRange(0.0, std::round(units_.heightFromSi(kLongestAsked)));
  minLength_->setSingleStep(isAviation ? 100.0 : 50.0);
  minWidth_->setRange(0.0, std::round(units_.heightFromSi(kWidestAsked)));
  minWidth_->setSingleStep(isAviation ? 10.0 : 5.0);
  maxDistance_->setRange(0.0, std::round(units_.distanceFromSi(kFarthestAsked)));
  maxDistance_->setSingleStep(5.0);
  minLength_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  minWidth_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  maxDistance_->setSuffix(QLatin1Char(' ') + units_.distanceUnit());
  minLength_->setValue(filter_.minLength ? units_.heightFromSi(filter_.minLength->si()) : 0.0);
  minWidth_->setValue(filter_.minWidth ? units_.heightFromSi(filter_.minWidth->si()) : 0.0);
  maxDistance_->setValue(filter_.maxDistance ? units_.distanceFromSi(filter_.maxDistance->si()) : 0.0);
  approximate_->setChecked(filter_.approximate);
  closed_->setChecked(filter_.closed);
  water_->setChecked(filter_.water);
  lighted_->setChecked(filter_.lighted);
  showSurfaces();
}

void SiteRules::showSurfaces() {
  QStringList chosen;
  for (std::size_t i = 0; i < kSurfaces.size(); ++i) {
    const QSignalBlocker quiet(surfaceActions_[i]);
    const bool isChosen = std::find(filter_.surfaces.begin(), filter_.surfaces.end(), kSurfaces[i]) != filter_.surfaces.end();
    surfaceActions_[i]->setChecked(isChosen);
    if (isChosen) {
      chosen << surfaceName(kSurfaces[i]);
    }
  }
  surfaces_->setText(chosen.isEmpty() ? tr("any surface") : chosen.join(QStringLiteral(", ")));
}

void SiteRules::emitFilter() {
  mission::SiteFilter changed = filter_;
  changed.approximate = approximate_->isChecked();
  changed.closed = closed_->isChecked();
  changed.water = water_->isChecked();
  changed.lighted = lighted_->isChecked();
  const auto height = [&](const std::optional<Length>& value) { return value ? units_.heightFromSi(value->si()) : 0.0; };
  changed.minLength = lengthOf(*minLength_, filter_.minLength, std::round(height(filter_.minLength)), units_.heightToSi(minLength_->value()));
  changed.minWidth = lengthOf(*minWidth_, filter_.minWidth, std::round(height(filter_.minWidth)), units_.heightToSi(minWidth_->value()));
  const double distance = filter_.maxDistance ? units_.distanceFromSi(filter_.maxDistance->si()) : 0.0;
  changed.maxDistance = lengthOf(*maxDistance_, filter_.maxDistance, std::round(distance * 10.0) / 10.0, units_.distanceToSi(maxDistance_->value()));
  changed.surfaces.clear();
  for (std::size_t i = 0; i < kSurfaces.size(); ++i) {
    if (surfaceActions_[i]->isChecked()) {
      changed.surfaces.push_back(kSurfaces[i]);
    }
  }
  if (changed.surfaces.size() == filter_.surfaces.size() &&
      std::is_permutation(changed.surfaces.begin(), changed.surfaces.end(), filter_.surfaces.begin())) {
    changed.surfaces = filter_.surfaces;  // the order of a file is no change
  }
  if (!(changed == filter_)) {
    filter_ = changed;
    showSurfaces();
    emit filterChanged(filter_);
  }
}

}  // namespace vp::panels
