#pragma once

#include "core/aircraft/aircraft_profile.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QDialog>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace vp::dialogs {

class PolarPreview;

/** Choose, duplicate and edit the aircraft profile of a mission, with the glide that follows from it drawn live. Bundled
 *  profiles are not changed: duplicate one first; what is edited becomes part of the mission, or a file of its own. */
class AircraftDialog : public QDialog {
  Q_OBJECT

public:
  /** @param reference  as in Mission::aircraftReference: a bundled name, a file, or empty for a profile of the mission */
  AircraftDialog(const aircraft::AircraftProfile& profile, std::string reference, const style::Units& units, style::Theme theme,
                 QWidget* parent = nullptr);

  [[nodiscard]] const aircraft::AircraftProfile& profile() const { return profile_; }
  [[nodiscard]] const std::string& reference() const { return reference_; }

private:
  struct Field {
    QDoubleSpinBox* box = nullptr;
    std::function<double(const aircraft::AircraftProfile&)> get;
    std::function<void(aircraft::AircraftProfile&, double)> set;
    double shown = 0.0;  ///< what the box said before anybody touched it
  };
  using SpeedGetter = std::function<std::optional<Speed>(const aircraft::AircraftProfile&)>;
  using SpeedSetter = std::function<void(aircraft::AircraftProfile&, std::optional<Speed>)>;
  QDoubleSpinBox* addNumber(QFormLayout* form, const QString& label, const QString& unit, int decimals, double min, double max,
                            std::function<double(const aircraft::AircraftProfile&)> get, std::function<void(aircraft::AircraftProfile&, double)> set);
  /// A speed in the chosen unit; 0 is none. @param least,most  m/s
  QDoubleSpinBox* addSpeed(QFormLayout* form, const QString& label, double least, double most, SpeedGetter get, SpeedSetter set);
  /// A limit of wind, up to what a profile may say; below 0 is none.
  QDoubleSpinBox* addWindLimit(QFormLayout* form, const QString& label, SpeedGetter get, SpeedSetter set);
  using NumberGetter = std::function<std::optional<double>(const aircraft::AircraftProfile&)>;
  using NumberSetter = std::function<void(aircraft::AircraftProfile&, std::optional<double>)>;
  /// How a number of SI units is shown.
  struct Shown {
    QString unit;
    int decimals = 0;
    double most = 0.0;   ///< as shown
    double perSi = 1.0;  ///< shown for one SI unit
  };
  /// A number that a profile need not have; 0 is none. Getter and setter speak SI.
  QDoubleSpinBox* addOptional(QFormLayout* form, const char* objectName, const QString& label, const Shown& shown, NumberGetter get,
                              NumberSetter set);
  QWidget* buildForm();
  void addBankFields(QFormLayout* form);
  void addLimitFields(QFormLayout* form);
  void addGlideFields(QFormLayout* form);
  void addRunwayFields(QFormLayout* form);
  void fillChoices();
  void choose(int index);
  void duplicate();
  void openFile();
  void saveFile();
  void showProfile();
  void fieldEdited();
  void check();

  aircraft::AircraftProfile profile_;
  std::string reference_;
  style::Units units_;
  style::Theme theme_;
  bool filling_ = false;
  std::vector<Field> fields_;
  QComboBox* choice_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLineEdit* glideBanks_ = nullptr;
  QPlainTextEdit* sources_ = nullptr;
  QWidget* form_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* save_ = nullptr;
  PolarPreview* preview_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
  std::optional<std::string> fault_;
};

}  // namespace vp::dialogs
