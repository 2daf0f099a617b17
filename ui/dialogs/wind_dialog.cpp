#include "ui/dialogs/wind_dialog.h"

#include "core/aircraft/wind_check.h"
#include "core/formats/wind_text.h"
#include "ui/document/wind_words.h"
#include "ui/style/core_text.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::dialogs {
namespace {

constexpr double kLayerStep = 914.4;  // m: a new layer lies 3,000 ft above the last, as forecasts of winds aloft do
constexpr int kTableHeight = 170;     // px: four rows and the header
constexpr int kTextWidth = 460;       // px

QString sentence(const std::string& text) {
  QString shown = style::coreText(text);
  if (!shown.isEmpty()) {
    shown[0] = shown[0].toUpper();
    shown += shown.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral(".");
  }
  return shown;
}

}  // namespace

WindDialog::WindDialog(const std::vector<air::WindLayer>& winds, aircraft::AircraftProfile aircraft, const style::Units& units, QWidget* parent)
    : QDialog(parent), aircraft_(std::move(aircraft)), units_(units) {
  setWindowTitle(tr("Wind"));
  auto* column = new QVBoxLayout(this);
  buildReader();
  table_ = new QTableWidget(0, Columns);
  table_->setObjectName(QStringLiteral("windTable"));
  table_->setAccessibleName(tr("Layers of wind"));
  table_->setHorizontalHeaderLabels({tr("Altitude MSL"), tr("From, true"), tr("± direction"), tr("Speed"), tr("± speed")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setMinimumHeight(kTableHeight);
  column->addWidget(table_, 1);
  auto* buttons = new QHBoxLayout;
  auto* add = new QPushButton(tr("&Add layer"));
  remove_ = new QPushButton(tr("&Remove layer"));
  auto* calm = new QPushButton(tr("&Still air"));
  add->setObjectName(QStringLiteral("addLayer"));
  remove_->setObjectName(QStringLiteral("removeLayer"));
  calm->setObjectName(QStringLiteral("stillAir"));
  for (QPushButton* button : {add, remove_, calm}) {
    button->setAutoDefault(false);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  column->addLayout(buttons);
  summary_ = new QLabel;
  summary_->setWordWrap(true);
  summary_->setObjectName(QStringLiteral("windSummary"));
  column->addWidget(summary_);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  column->addWidget(buttons_);
  connect(add, &QPushButton::clicked, this, &WindDialog::addLayer);
  connect(remove_, &QPushButton::clicked, this, &WindDialog::removeLayers);
  connect(calm, &QPushButton::clicked, this, [this] {
    table_->selectAll();
    removeLayers();
  });
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (const air::WindLayer& layer : winds) {
    addRow(layer);
  }
  check();
}

/// The line that takes a text, and what was made of it.
void WindDialog::buildReader() {
  auto* column = qobject_cast<QVBoxLayout*>(layout());
  auto* line = new QHBoxLayout;
  auto* label = new QLabel(tr("Read &from text"));
  text_ = new QLineEdit;
  text_->setObjectName(QStringLiteral("windText"));
  text_->setPlaceholderText(tr("270±20/15±5kt, a METAR, or 2000ft 270/15kt; 6000ft 290/25kt"));
  text_->setMinimumWidth(kTextWidth);
  label->setBuddy(text_);
  auto* read = new QPushButton(tr("Rea&d"));
  read->setObjectName(QStringLiteral("readWind"));
  read->setAutoDefault(false);
  line->addWidget(label);
  line->addWidget(text_, 1);
  line->addWidget(read);
  column->addLayout(line);
  notes_ = new QLabel;
  notes_->setWordWrap(true);
  notes_->setObjectName(QStringLiteral("windNotes"));
  notes_->hide();
  column->addWidget(notes_);
  connect(read, &QPushButton::clicked, this, &WindDialog::readText);
}

void WindDialog::addRow(const air::WindLayer& layer) {
  Row row;
  row.given = layer;
  const air::WindSector& wind = layer.wind;
  const int at = table_->rowCount();
  table_->insertRow(at);
  const QString degrees = QStringLiteral("°");
  const auto add = [&](Column column, double value, double least, double most, double step, const QString& suffix) {
    auto* box = new QDoubleSpinBox;
    box->setDecimals(0);
    box->setRange(least, most);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    box->setValue(value);
    box->setFrame(false);
    box->setWrapping(column == From);
    box->setAccessibleName(table_->horizontalHeaderItem(column)->text());
    row.boxes.push_back(box);
    row.shown.push_back(box->value());
    table_->setCellWidget(at, column, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &WindDialog::check);
  };
  const QString height = QLatin1Char(' ') + units_.heightUnit();
  const QString speed = QLatin1Char(' ') + units_.speedUnit();
  const double fastest = std::floor(units_.speedFromSi(aircraft::kMostWind));
  add(Altitude, units_.heightFromSi(layer.altitude.metres()), std::ceil(units_.heightFromSi(aircraft::kLowestWind)),
      std::floor(units_.heightFromSi(aircraft::kHighestWind)), units_.system() == style::UnitSystem::Aviation ? 500.0 : 100.0, height);
  add(From, wind.from_deg, 0.0, 360.0, 10.0, degrees);
  add(Spread, wind.spread_deg, 0.0, 180.0, 5.0, degrees);
  add(Speed, units_.speedFromSi(0.5 * (wind.leastSpeed + wind.mostSpeed)), 0.0, fastest, 5.0, speed);
  add(SpeedSpread, units_.speedFromSi(0.5 * (wind.mostSpeed - wind.leastSpeed)), 0.0, fastest, 5.0, speed);
  rows_.push_back(std::move(row));
}

void WindDialog::addLayer() {
  air::WindLayer layer;
  if (!rows_.empty()) {
    layer = layerOf(rows_.back());
    layer.altitude = geo::HeightMsl::fromMetres(std::min(aircraft::kHighestWind, layer.altitude.metres() + kLayerStep));
  }
  addRow(layer);
  check();
  rows_.back().boxes[rows_.size() == 1 ? From : Altitude]->setFocus();
}

void WindDialog::removeLayers() {
  for (int row = table_->rowCount() - 1; row >= 0; --row) {
    const bool hasFocus = std::any_of(rows_[static_cast<std::size_t>(row)].boxes.begin(), rows_[static_cast<std::size_t>(row)].boxes.end(),
                                      [](const QDoubleSpinBox* box) { return box->hasFocus(); });
    if (hasFocus || table_->selectionModel()->isRowSelected(row, {})) {
      table_->removeRow(row);
      rows_.erase(rows_.begin() + row);
    }
  }
  check();
}

void WindDialog::readText() {
  const Result<formats::WindReading> reading = formats::parseWind(text_->text().toStdString());
  QStringList notes;
  if (reading) {
    table_->setRowCount(0);
    rows_.clear();
    for (const air::WindLayer& layer : reading->layers) {
      addRow(layer);
    }
    for (const std::string& note : reading->notes) {
      notes << sentence(note);
    }
  } else {
    notes << sentence(reading.error().what);
  }
  notes_->setText(notes.join(QLatin1Char(' ')));
  notes_->setVisible(!notes.isEmpty());
  check();
}

void WindDialog::check() {
  const std::vector<air::WindLayer> winds = result();
  const auto fault = aircraft::windFault(winds, aircraft_);
  QStringList lines;
  if (fault) {
    lines << sentence(fault->sentence);
  } else {
    lines = document::windLines(winds, units_);
    lines.front().prepend(tr("The plan will hold for: "));
    if (winds.size() > 1) {
      lines << tr("Between the layers, everything between their winds.");
    }
  }
  summary_->setText(lines.join(QLatin1Char('\n')));
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(!fault);
  remove_->setEnabled(!rows_.empty());
}

air::WindLayer WindDialog::layerOf(const Row& row) const {
  const auto value = [&](Column column) { return row.boxes[column]->value(); };
  const auto isTouched = [&](Column column) { return value(column) != row.shown[column]; };
  air::WindLayer layer = row.given;
  if (isTouched(Altitude)) {
    layer.altitude = geo::HeightMsl::fromMetres(units_.heightToSi(value(Altitude)));
  }
  layer.wind.from_deg = isTouched(From) ? value(From) : layer.wind.from_deg;
  layer.wind.spread_deg = isTouched(Spread) ? value(Spread) : layer.wind.spread_deg;
  if (isTouched(Speed) || isTouched(SpeedSpread)) {
    const double speed = isTouched(Speed) ? units_.speedToSi(value(Speed)) : 0.5 * (layer.wind.leastSpeed + layer.wind.mostSpeed);
    const double spread = isTouched(SpeedSpread) ? units_.speedToSi(value(SpeedSpread)) : 0.5 * (layer.wind.mostSpeed - layer.wind.leastSpeed);
    layer.wind.leastSpeed = std::max(0.0, speed - spread);
    layer.wind.mostSpeed = speed + spread;
  }
  return layer;
}

std::vector<air::WindLayer> WindDialog::result() const {
  std::vector<air::WindLayer> winds;
  std::transform(rows_.begin(), rows_.end(), std::back_inserter(winds), [this](const Row& row) { return layerOf(row); });
  std::stable_sort(winds.begin(), winds.end(), [](const air::WindLayer& a, const air::WindLayer& b) { return a.altitude < b.altitude; });
  if (winds.size() == 1 && winds.front().wind.isCalm()) {
    winds.clear();
  }
  return winds;
}

}  // namespace vp::dialogs
