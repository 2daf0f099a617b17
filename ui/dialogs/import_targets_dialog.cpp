#include "ui/dialogs/import_targets_dialog.h"

#include "ui/dialogs/target_choice_model.h"
#include "ui/panels/table_tools.h"
#include "ui/style/core_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace vp::dialogs {
namespace {

enum Heights { AsMeant, FromFile, AboveGround, Msl };
constexpr double kUsualHeight = 100.0;      // m, as targets have it that are clicked on the map
constexpr double kUsualSpacing = 500.0;     // m
constexpr double kWidestSpacing = 20000.0;  // m
constexpr int kRest = 300;                  // ms without a change before the file is read again
constexpr int kTableHeight = 150;           // px, at least: five rows
constexpr QSize kSmallest{560, 540};        // px: three lines of an explanation and five rows of the table
constexpr QSize kSize{640, 680};
constexpr int kWidestPlace = 480;  // px of the file and place that an error is about

QString numberText(std::size_t count) {
  return QString::number(static_cast<qulonglong>(count));
}

}  // namespace

ImportTargetsDialog::ImportTargetsDialog(jobs::TargetsOfFile file, const style::Units& units, QWidget* parent)
    : QDialog(parent), file_(std::move(file)), units_(units) {
  setWindowTitle(tr("Import targets from %1").arg(QFileInfo(file_.path).fileName()));
  setObjectName(QStringLiteral("importTargetsDialog"));
  rest_.setSingleShot(true);
  rest_.setInterval(kRest);
  auto* hint = panels::sentenceLabel(this);
  hint->setText(tr("Points, corners of lines and waypoints become targets. Areas become parallel survey lines; the ends of the lines are targets."));
  hint->setForegroundRole(QPalette::PlaceholderText);
  problem_ = panels::sentenceLabel(this);
  problem_->setObjectName(QStringLiteral("importProblem"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  import_ = buttons->button(QDialogButtonBox::Ok);
  import_->setText(tr("&Import"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(makeOptions());
  column->addWidget(hint);
  makeTable();
  column->addLayout(makeSearch());
  column->addWidget(table_, 1);
  column->addWidget(count_);
  column->addWidget(problem_);
  column->addWidget(buttons);
  connectFields();
  showFound(std::exchange(file_.found, {}));
  setMinimumSize(kSmallest);
  resize(kSize);
  search_->setFocus();
}

QFormLayout* ImportTargetsDialog::makeOptions() {
  heights_ = new QComboBox;
  heights_->setObjectName(QStringLiteral("importHeights"));
  heights_->addItem(tr("those of the file where they are flown at, else %1").arg(units_.heightAboveGround(kUsualHeight)), AsMeant);
  heights_->addItem(tr("elevations of the file (.cup, GPX, Little Navmap) too"), FromFile);
  heights_->addItem(tr("one height above ground (AGL)"), AboveGround);
  heights_->addItem(tr("one altitude above mean sea level (MSL)"), Msl);
  height_ = new QDoubleSpinBox;
  height_->setObjectName(QStringLiteral("importHeight"));
  height_->setDecimals(0);
  height_->setRange(std::ceil(units_.heightFromSi(-500.0)), std::floor(units_.heightFromSi(20000.0)));
  height_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  height_->setValue(units_.heightFromSi(kUsualHeight));
  spacing_ = new QDoubleSpinBox;
  spacing_->setObjectName(QStringLiteral("importSpacing"));
  spacing_->setDecimals(0);
  spacing_->setRange(std::ceil(units_.heightFromSi(1.0)), std::floor(units_.heightFromSi(kWidestSpacing)));
  spacing_->setSuffix(QLatin1Char(' ') + units_.heightUnit());
  spacing_->setValue(units_.heightFromSi(kUsualSpacing));
  alongLongest_ = new QCheckBox(tr("along the &longest side of each area"));
  alongLongest_->setChecked(true);
  course_ = new QDoubleSpinBox;
  course_->setDecimals(0);
  course_->setRange(0.0, 359.0);
  course_->setWrapping(true);
  course_->setSuffix(QStringLiteral("° T"));
  tracks_ = new QCheckBox(tr("Points of &tracks too"));
  tracks_->setObjectName(QStringLiteral("importTracks"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Heights"), heights_);
  form->addRow(tr("H&eight"), height_);
  form->addRow(tr("&Spacing of survey lines"), spacing_);
  form->addRow(tr("Lines run"), alongLongest_);
  form->addRow(tr("True &course of lines"), course_);
  form->addRow(QString(), tracks_);
  return form;
}

void ImportTargetsDialog::makeTable() {
  model_ = new TargetChoiceModel(units_, this);
  table_ = new QTableView;
  table_->setObjectName(QStringLiteral("importTable"));
  table_->setModel(model_);
  panels::setUpTable(*table_, tr("Targets of the file"));
  panels::fitColumns(*table_, {QStringLiteral("MMMMMM"), QStringLiteral("46°36.02′ N  009°54.10′ WM"), QStringLiteral("10 000 ft MSLM")});
  table_->horizontalHeader()->setStretchLastSection(false);
  table_->horizontalHeader()->setSectionResizeMode(TargetChoiceModel::Name, QHeaderView::Stretch);
  table_->setMinimumHeight(kTableHeight);
  count_ = panels::sentenceLabel(this);
  count_->setObjectName(QStringLiteral("importCount"));
}

QLayout* ImportTargetsDialog::makeSearch() {
  search_ = new QLineEdit;
  search_->setObjectName(QStringLiteral("importSearch"));
  search_->setPlaceholderText(tr("Search names"));
  search_->setAccessibleName(tr("Search names"));
  search_->setClearButtonEnabled(true);
  auto* row = new QHBoxLayout;
  row->addWidget(search_, 1);
  const auto add = [&](const QString& text, const QString& tip, const char* name, bool chosen) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setAutoDefault(false);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, chosen] { model_->chooseShown(chosen); });
  };
  add(tr("Choose &all"), tr("Chooses all targets that the search shows"), "importAll", true);
  add(tr("Choose &none"), tr("Leaves out all targets that the search shows"), "importNone", false);
  return row;
}

void ImportTargetsDialog::connectFields() {
  connect(heights_, &QComboBox::currentIndexChanged, this, &ImportTargetsDialog::optionsChanged);
  for (QDoubleSpinBox* box : {height_, spacing_, course_}) {
    connect(box, &QDoubleSpinBox::valueChanged, this, &ImportTargetsDialog::optionsChanged);
  }
  for (QCheckBox* box : {alongLongest_, tracks_}) {
    connect(box, &QCheckBox::toggled, this, &ImportTargetsDialog::optionsChanged);
  }
  connect(&rest_, &QTimer::timeout, this, &ImportTargetsDialog::readAgain);
  connect(search_, &QLineEdit::textChanged, model_, &TargetChoiceModel::setFilter);
  connect(model_, &TargetChoiceModel::choiceChanged, this, &ImportTargetsDialog::showState);
}

/// Enter in the search line looks for something; it must not import everything.
void ImportTargetsDialog::keyPressEvent(QKeyEvent* event) {
  const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!isEnter || !search_->hasFocus()) {
    QDialog::keyPressEvent(event);
  }
}

/// From this moment the table is of the past, also before the file is read again: nothing may be imported from it.
void ImportTargetsDialog::optionsChanged() {
  isOld_ = true;
  rest_.start();
  showState();
}

void ImportTargetsDialog::readAgain() {
  reader_.start<formats::ImportedTargets>([read = file_.read, options = options()](const Job& job) { return read(options, job); },
                                          [this](jobs::TargetsOfFile::Found found) {
                                            if (!rest_.isActive()) {  // else they have changed again
                                              showFound(std::move(found));
                                            }
                                          });
}

void ImportTargetsDialog::showFound(jobs::TargetsOfFile::Found found) {
  isOld_ = false;
  file_.found = std::move(found);
  if (file_.found) {
    model_->setTargets(std::exchange(file_.found->targets, {}), formats::kMostImportedTargets);
  }
  showState();
}

/// Why nothing can be imported as it is; empty if it can.
QString ImportTargetsDialog::problem() const {
  if (isOld_) {
    return tr("Reading the file again…");
  }
  if (!file_.found) {
    const Error& error = file_.found.error();
    const QString where = QString::fromStdString(error.where).replace(file_.path, QFileInfo(file_.path).fileName());
    const QString shortened = fontMetrics().elidedText(where, Qt::ElideMiddle, kWidestPlace);  // a name is no word that can be broken
    return (where.isEmpty() ? QString() : shortened + QStringLiteral(": ")) + style::coreText(error.what) + QLatin1Char('.');
  }
  if (model_->count() == 0) {
    return tr("All places of this file are points of tracks; choose “Points of tracks too” to take them.");
  }
  if (model_->chosenCount() == 0) {
    return tr("Choose at least one target to import.");
  }
  return model_->chosenCount() <= formats::kMostImportedTargets
             ? QString()
             : tr("At most %1 targets are imported at once; choose fewer.").arg(numberText(formats::kMostImportedTargets));
}

void ImportTargetsDialog::showState() {
  const int heights = heights_->currentData().toInt();
  height_->setEnabled(heights == AboveGround || heights == Msl);
  course_->setEnabled(!alongLongest_->isChecked());
  const bool isThere = file_.found.has_value();
  table_->setEnabled(isThere && !isOld_);
  const auto shown = static_cast<std::size_t>(model_->rowCount());
  count_->setText(
      !isThere ? QString()
      : shown == model_->count()
          ? tr("%1 of %2 chosen").arg(numberText(model_->chosenCount()), numberText(model_->count()))
          : tr("%1 of %2 chosen; the search shows %3").arg(numberText(model_->chosenCount()), numberText(model_->count()), numberText(shown)));
  const QString why = problem();
  problem_->setText(why);
  import_->setEnabled(why.isEmpty());
}

formats::ImportedTargets ImportTargetsDialog::chosen() const {
  formats::ImportedTargets chosen = file_.found ? *file_.found : formats::ImportedTargets();
  chosen.targets = model_->chosen();
  return chosen;
}

formats::TargetImportOptions ImportTargetsDialog::options() const {
  formats::TargetImportOptions options;
  const double height = units_.heightToSi(height_->value());
  switch (heights_->currentData().toInt()) {
    case FromFile:
      options.fileHeights = true;
      break;
    case AboveGround:
      options.heightAboveGround_m = height;
      break;
    case Msl:
      options.heightMsl_m = height;
      break;
    default:
      break;
  }
  options.spacing = Length::fromSi(units_.heightToSi(spacing_->value()));
  if (!alongLongest_->isChecked()) {
    options.lineCourse = Angle::degrees(course_->value());
  }
  options.tracks = tracks_->isChecked();
  return options;
}

}  // namespace vp::dialogs
