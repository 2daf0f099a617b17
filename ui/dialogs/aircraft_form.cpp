// The fields of the aircraft dialog.
#include "ui/dialogs/aircraft_dialog.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vp::dialogs {
namespace {

using aircraft::AircraftProfile;

constexpr double kHighestCeiling = 20000.0;  // m MSL
constexpr double kMostLandingWind = 50.0;    // m/s, the most that a profile may say
constexpr double kNoLimit = -1.0;            // shown as words; 0 is a limit: no tailwind at all

}  // namespace

QDoubleSpinBox* AircraftDialog::addNumber(QFormLayout* form, const QString& label, const QString& unit, int decimals, double min, double max,
                                          std::function<double(const AircraftProfile&)> get, std::function<void(AircraftProfile&, double)> set) {
  auto* box = new QDoubleSpinBox;
  box->setDecimals(decimals);
  box->setRange(min, max);
  box->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
  box->setSingleStep(std::pow(10.0, -decimals) * (decimals > 2 ? 10.0 : 1.0));
  box->setAccessibleName(label);
  form->addRow(label, box);
  fields_.push_back({box, std::move(get), std::move(set), 0.0});
  connect(box, &QDoubleSpinBox::valueChanged, this, &AircraftDialog::fieldEdited);
  return box;
}

QDoubleSpinBox* AircraftDialog::addSpeed(QFormLayout* form, const QString& label, double least, double most, SpeedGetter get, SpeedSetter set) {
  const style::Units units = units_;
  return addNumber(
      form, label, units.speedUnit(), 1, units.speedFromSi(least), units.speedFromSi(most),
      [units, get = std::move(get)](const AircraftProfile& p) { return units.speedFromSi(get(p).value_or(Speed()).si()); },
      [units, set = std::move(set)](AircraftProfile& p, double v) {
        set(p, v > 0.0 ? std::optional(Speed::fromSi(units.speedToSi(v))) : std::nullopt);
      });
}

QDoubleSpinBox* AircraftDialog::addWindLimit(QFormLayout* form, const QString& label, SpeedGetter get, SpeedSetter set) {
  const style::Units units = units_;
  QDoubleSpinBox* box = addNumber(
      form, label, units.speedUnit(), 1, kNoLimit, units.speedFromSi(kMostLandingWind),
      [units, get = std::move(get)](const AircraftProfile& p) {
        const std::optional<Speed> limit = get(p);
        return limit ? units.speedFromSi(limit->si()) : kNoLimit;
      },
      [units, set = std::move(set)](AircraftProfile& p, double v) {
        set(p, v >= 0.0 ? std::optional(Speed::fromSi(std::min(kMostLandingWind, units.speedToSi(v)))) : std::nullopt);
      });
  box->setSingleStep(1.0);
  box->setSpecialValueText(tr("no limit"));
  box->setToolTip(tr("Runway directions that the wind of the mission may bring more to are not landed on; one step below 0 is no limit"));
  return box;
}

QWidget* AircraftDialog::buildForm() {
  form_ = new QWidget;
  auto* form = new QFormLayout(form_);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  name_ = new QLineEdit;
  name_->setObjectName(QStringLiteral("aircraftName"));
  form->addRow(tr("Name"), name_);
  connect(name_, &QLineEdit::textEdited, this, &AircraftDialog::fieldEdited);
  using P = AircraftProfile;
  addNumber(
      form, tr("Mass"), tr("kg"), 0, 1, 600000, [](const P& p) { return p.mass_kg; }, [](P& p, double v) { p.mass_kg = v; });
  addNumber(
      form, tr("Wing area"), tr("m²"), 2, 0.01, 1000, [](const P& p) { return p.wingArea_m2; }, [](P& p, double v) { p.wingArea_m2 = v; });
  addNumber(
      form, tr("Zero-lift drag C_D0"), {}, 4, 0.001, 1, [](const P& p) { return p.zeroLiftDrag; }, [](P& p, double v) { p.zeroLiftDrag = v; })
      ->setObjectName(QStringLiteral("zeroLiftDrag"));
  addNumber(
      form, tr("Induced drag factor L"), {}, 4, 0.001, 1, [](const P& p) { return p.inducedDrag; }, [](P& p, double v) { p.inducedDrag = v; });
  addNumber(
      form, tr("Air density"), tr("kg/m³"), 3, 0.1, 1.6, [](const P& p) { return p.airDensity_kgm3; }, [](P& p, double v) { p.airDensity_kgm3 = v; });
  addSpeed(
      form, tr("Best glide speed (TAS)"), 5, 150, [](const P& p) { return std::optional(p.bestGlideSpeed); },
      [](P& p, std::optional<Speed> v) { p.bestGlideSpeed = v.value_or(Speed()); })
      ->setObjectName(QStringLiteral("bestGlideSpeed"));
  addBankFields(form);
  addLimitFields(form);
  addGlideFields(form);
  addRunwayFields(form);
  sources_ = new QPlainTextEdit;
  sources_->setPlaceholderText(tr("Where each number comes from, one sentence a line"));
  sources_->setMinimumHeight(90);
  form->addRow(tr("Sources"), sources_);
  connect(sources_, &QPlainTextEdit::textChanged, this, &AircraftDialog::fieldEdited);
  return form_;
}

void AircraftDialog::addBankFields(QFormLayout* form) {
  using P = AircraftProfile;
  glideBanks_ = new QLineEdit;
  glideBanks_->setObjectName(QStringLiteral("glideBanks"));
  glideBanks_->setToolTip(tr("Bank angles that a glide may choose among in its turns, in degrees, separated by commas"));
  form->addRow(tr("Banks in a glide (°)"), glideBanks_);
  connect(glideBanks_, &QLineEdit::textEdited, this, &AircraftDialog::fieldEdited);
  addNumber(
      form, tr("Bank on the tour"), tr("°"), 1, 1, 80, [](const P& p) { return p.tourBank.degrees(); },
      [](P& p, double v) { p.tourBank = Angle::degrees(v); });
  addNumber(
      form, tr("Steepest climb"), tr("°"), 1, 0.1, 60, [](const P& p) { return p.maxClimb.degrees(); },
      [](P& p, double v) { p.maxClimb = Angle::degrees(v); });
  addNumber(
      form, tr("Steepest descent"), tr("°"), 1, 0.1, 60, [](const P& p) { return p.maxDescent.degrees(); },
      [](P& p, double v) { p.maxDescent = Angle::degrees(v); });
}

void AircraftDialog::addLimitFields(QFormLayout* form) {
  using P = AircraftProfile;
  QDoubleSpinBox* stall = addSpeed(
      form, tr("Stall speed, wings level"), 0, 150, [](const P& p) { return p.stallSpeed; }, [](P& p, std::optional<Speed> v) { p.stallSpeed = v; });
  QDoubleSpinBox* load = addNumber(
      form, tr("Highest load factor"), {}, 2, 0, 20, [](const P& p) { return p.maxLoadFactor.value_or(0.0); },
      [](P& p, double v) { p.maxLoadFactor = v >= 1.0 ? std::optional(v) : std::nullopt; });
  const style::Units units = units_;
  QDoubleSpinBox* ceiling = addNumber(
      form, tr("Ceiling"), tr("%1 MSL").arg(units.heightUnit()), 0, 0, std::floor(units.heightFromSi(kHighestCeiling)),
      [units](const P& p) { return p.ceiling ? units.heightFromSi(p.ceiling->metres()) : 0.0; },
      [units](P& p, double v) { p.ceiling = v > 0.0 ? std::optional(geo::HeightMsl::fromMetres(units.heightToSi(v))) : std::nullopt; });
  ceiling->setSingleStep(100.0);
  QDoubleSpinBox* tailwind = addWindLimit(
      form, tr("Most tailwind on landing"), [](const P& p) { return p.maxTailwind; }, [](P& p, std::optional<Speed> v) { p.maxTailwind = v; });
  QDoubleSpinBox* crosswind = addWindLimit(
      form, tr("Most crosswind on landing"), [](const P& p) { return p.maxCrosswind; }, [](P& p, std::optional<Speed> v) { p.maxCrosswind = v; });
  for (QDoubleSpinBox* box : {stall, load, ceiling}) {
    box->setSpecialValueText(tr("not given"));
  }
  stall->setObjectName(QStringLiteral("stallSpeed"));
  ceiling->setObjectName(QStringLiteral("ceiling"));
  tailwind->setObjectName(QStringLiteral("maxTailwind"));
  crosswind->setObjectName(QStringLiteral("maxCrosswind"));
}

QDoubleSpinBox* AircraftDialog::addOptional(QFormLayout* form, const char* objectName, const QString& label, const Shown& shown, NumberGetter get,
                                            NumberSetter set) {
  const double scale = shown.perSi;
  QDoubleSpinBox* box = addNumber(
      form, label, shown.unit, shown.decimals, 0.0, shown.most,
      [scale, get = std::move(get)](const AircraftProfile& p) { return scale * get(p).value_or(0.0); },
      [scale, set = std::move(set)](AircraftProfile& p, double v) { set(p, v > 0.0 ? std::optional(v / scale) : std::nullopt); });
  box->setSpecialValueText(tr("not given"));
  box->setObjectName(QLatin1String(objectName));
  return box;
}

void AircraftDialog::addGlideFields(QFormLayout* form) {
  using P = AircraftProfile;
  using Number = std::optional<double>;
  const Shown mass{tr("kg"), 0, 600000.0, 1.0};
  const Shown drag{{}, 4, 1.0, 1.0};
  addOptional(
      form, "leastMass", tr("Least mass"), mass, [](const P& p) { return p.leastMass_kg; }, [](P& p, Number v) { p.leastMass_kg = v; })
      ->setToolTip(tr("Plans hold for all masses between the two, each flown at its best glide speed"));
  addOptional(
      form, "mostMass", tr("Greatest mass"), mass, [](const P& p) { return p.mostMass_kg; }, [](P& p, Number v) { p.mostMass_kg = v; });
  addOptional(
      form, "windmillingDrag", tr("C_D0, propeller windmilling"), drag, [](const P& p) { return p.windmillingDrag; },
      [](P& p, Number v) { p.windmillingDrag = v; });
  addOptional(
      form, "stoppedDrag", tr("C_D0, propeller stopped"), drag, [](const P& p) { return p.stoppedDrag; }, [](P& p, Number v) { p.stoppedDrag = v; });
  addOptional(
      form, "steepestDescent", tr("Steepest without engine"), {tr("°"), 1, 45.0, 180.0 / Angle::kPi},
      [](const P& p) { return p.steepestDescent ? Number(p.steepestDescent->radians()) : Number(); },
      [](P& p, Number v) { p.steepestDescent = v ? std::optional(Angle::radians(*v)) : std::nullopt; })
      ->setToolTip(tr("Steepest steady descent through the air with flaps, brakes or a slip; approaches at a slope of your choice need it"));
  addOptional(
      form, "rollRate", tr("Rate of roll"), {tr("°/s"), 1, 360.0, 1.0}, [](const P& p) { return p.rollRate_dps; },
      [](P& p, Number v) { p.rollRate_dps = v; })
      ->setToolTip(tr("Degrees of bank per second, at least; certificates then say what rolling into turns may cost a glide"));
  addOptional(
      form, "maxSpeed", tr("Never exceed (TAS)"), {units_.speedUnit(), 1, units_.speedFromSi(350.0), units_.speedFromSi(1.0)},
      [](const P& p) { return p.maxSpeed ? Number(p.maxSpeed->si()) : Number(); },
      [](P& p, Number v) { p.maxSpeed = v ? std::optional(Speed::fromSi(*v)) : std::nullopt; });
}

void AircraftDialog::addRunwayFields(QFormLayout* form) {
  using P = AircraftProfile;
  using Number = std::optional<double>;
  const double feet = units_.heightFromSi(1.0);
  addOptional(
      form, "landingDistance", tr("Landing distance"), {units_.heightUnit(), 0, std::floor(units_.heightFromSi(10000.0)), feet},
      [](const P& p) { return p.landingDistance ? Number(p.landingDistance->si()) : Number(); },
      [](P& p, Number v) { p.landingDistance = v ? std::optional(Length::fromSi(*v)) : std::nullopt; })
      ->setToolTip(
          tr("Over 15 m (50 ft) to standstill at the greatest mass: sea level, standard air, no wind, dry hard runway. Runways too short for it on "
             "the day are not used"));
  const bool isAviation = units_.system() == style::UnitSystem::Aviation;
  constexpr double kSecondsPerMinute = 60.0;
  const double climb = isAviation ? feet * kSecondsPerMinute : 1.0;
  addOptional(
      form, "climbRate", tr("Climb at sea level"), {isAviation ? tr("ft/min") : tr("m/s"), isAviation ? 0 : 1, 100.0 * climb, climb},
      [](const P& p) { return p.climbRate ? Number(p.climbRate->si()) : Number(); },
      [](P& p, Number v) { p.climbRate = v ? std::optional(Speed::fromSi(*v)) : std::nullopt; });
  addOptional(
      form, "serviceCeiling", tr("Service ceiling"),
      {tr("%1 MSL").arg(units_.heightUnit()), 0, std::floor(units_.heightFromSi(kHighestCeiling)), feet},
      [](const P& p) { return p.serviceCeiling ? Number(p.serviceCeiling->metres()) : Number(); },
      [](P& p, Number v) { p.serviceCeiling = v ? std::optional(geo::HeightMsl::fromMetres(*v)) : std::nullopt; });
}

}  // namespace vp::dialogs
