#include "ui/dialogs/weather_list_dialog.h"

#include "ui/document/weather_view.h"
#include "ui/panels/table_tools.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::dialogs {
namespace {

enum Column { Name, Floor, Top, Success, ColumnCount };
constexpr QSize kSize{720, 360};

/// A number as a pilot types it: with blanks between thousands, a comma for the point, a unit behind it that is the one of the column.
std::optional<double> numberIn(QString text, const QStringList& units) {
  text = text.trimmed();
  for (const QString& unit : units) {
    if (text.endsWith(unit, Qt::CaseInsensitive)) {
      text.chop(unit.size());
      text = text.trimmed();
    }
  }
  text.remove(QChar(0x2009)).remove(QLatin1Char(' ')).replace(QChar(0x2212), QLatin1Char('-')).replace(QLatin1Char(','), QLatin1Char('.'));
  bool ok = false;
  const double value = text.toDouble(&ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

WeatherListDialog::WeatherListDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Weather of the mission"));
  setObjectName(QStringLiteral("weatherListDialog"));
  list_ = new QTableWidget(0, ColumnCount);
  list_->setObjectName(QStringLiteral("weatherList"));
  panels::setUpTable(*list_, tr("Weather of the mission"));
  list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed | QAbstractItemView::AnyKeyPressed);
  list_->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  hint_ = new QLabel;
  hint_->setWordWrap(true);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* draw = buttons->addButton(tr("&Draw"), QDialogButtonBox::ActionRole);
  edit_ = buttons->addButton(tr("&Edit…"), QDialogButtonBox::ActionRole);
  remove_ = buttons->addButton(tr("&Remove"), QDialogButtonBox::ActionRole);
  QPushButton* add = buttons->addButton(tr("&Add from file…"), QDialogButtonBox::ActionRole);
  export_ = buttons->addButton(tr("E&xport…"), QDialogButtonBox::ActionRole);
  remove_->setObjectName(QStringLiteral("removeWeather"));
  for (QPushButton* button : {draw, edit_, remove_, add, export_}) {
    button->setAutoDefault(false);
  }
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_, 1);
  column->addWidget(hint_);
  column->addWidget(buttons);
  list_->installEventFilter(this);
  connect(draw, &QPushButton::clicked, this, &WeatherListDialog::drawRequested);
  connect(edit_, &QPushButton::clicked, this, [this] { emit editRequested(list_->currentRow()); });
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeRequested(list_->currentRow()); });
  connect(add, &QPushButton::clicked, this, &WeatherListDialog::addRequested);
  connect(export_, &QPushButton::clicked, this, &WeatherListDialog::exportRequested);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
    if (!isFilling_) {
      take(*item);
    }
  });
  connect(list_, &QTableWidget::currentCellChanged, this, [this](int row) {
    refresh();
    if (!isFilling_) {
      emit selected(row);
    }
  });
  resize(kSize);
  setWeather({}, {});
}

void WeatherListDialog::setWeather(const std::vector<mission::WeatherCell>& cells, const style::Units& units) {
  const QScopedValueRollback filling(isFilling_, true);
  const int before = list_->currentRow();
  cells_ = cells;
  units_ = units;
  list_->setHorizontalHeaderLabels({tr("Name"), tr("Floor"), tr("Top"), tr("Coming through")});
  list_->setRowCount(static_cast<int>(cells_.size()));
  for (int row = 0; row < list_->rowCount(); ++row) {
    fillRow(row);
  }
  for (const int column : {Floor, Top, Success}) {
    list_->setColumnWidth(column, std::max(list_->horizontalHeader()->sectionSizeHint(column), 130));
  }
  if (list_->rowCount() > 0) {
    list_->setCurrentCell(std::clamp(before, 0, list_->rowCount() - 1), Name);
  }
  refresh();
}

void WeatherListDialog::fillRow(int row) {
  const mission::WeatherCell& cell = cells_[static_cast<std::size_t>(row)];
  const QStringList texts{QString::fromStdString(cell.name), cell.floor ? units_.altitudeMsl(*cell.floor) : QStringLiteral("GND"),
                          cell.top ? units_.altitudeMsl(*cell.top) : QStringLiteral("UNL"), document::weatherSuccessText(cell, units_)};
  for (int column = 0; column < ColumnCount; ++column) {
    QTableWidgetItem* item = list_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      item->setTextAlignment((column == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      list_->setItem(row, column, item);
    }
    item->setText(texts[column]);
    item->setToolTip(column == Name ? document::weatherTitle(cell, static_cast<std::size_t>(row)) : texts[column]);
  }
}

/// @return false: the text says nothing that fits the column
bool WeatherListDialog::readInto(mission::WeatherCell& cell, int column, const QString& text) const {
  if (column == Name) {
    cell.name = text.trimmed().toStdString();
    return true;
  }
  if (column == Success) {
    const QString shown = text.section(tr("per"), 0, 0);
    const std::optional<double> percent = numberIn(shown, {QStringLiteral("%")});
    if (!percent || !(*percent > 0.0) || *percent > 100.0) {
      return false;
    }
    cell.success = *percent / 100.0;
    cell.perDistance = units_.distanceToSi(1.0);
    return true;
  }
  std::optional<double>& limit = column == Floor ? cell.floor : cell.top;
  const QString word = text.trimmed().toUpper();
  const QStringList none = column == Floor ? QStringList{QString(), QStringLiteral("GND"), QStringLiteral("SFC")}
                                           : QStringList{QString(), QStringLiteral("UNL"), QStringLiteral("UNLIM")};
  if (none.contains(word)) {
    limit.reset();
    return true;
  }
  const std::optional<double> height = numberIn(text, {QStringLiteral("MSL"), units_.heightUnit()});
  if (height) {
    limit = units_.heightToSi(*height);
  }
  return height.has_value() && !(cell.floor && cell.top && *cell.floor >= *cell.top);
}

void WeatherListDialog::take(const QTableWidgetItem& item) {
  const int row = item.row();
  mission::WeatherCell changed = cells_[static_cast<std::size_t>(row)];
  if (readInto(changed, item.column(), item.text())) {
    emit cellEdited(row, changed);
  } else {
    const QString written = item.text();
    const QScopedValueRollback filling(isFilling_, true);
    fillRow(row);
    hint_->setText(item.column() == Success
                       ? tr("“%1” is no probability; give a number above 0 up to 100, in percent for each %2.").arg(written, units_.distanceUnit())
                       : tr("“%1” does not fit; give an altitude in %2 above mean sea level, the top above the floor, or GND and UNL.")
                             .arg(written, units_.heightUnit()));
    return;
  }
  const QScopedValueRollback filling(isFilling_, true);
  if (row < list_->rowCount()) {
    fillRow(row);  // what was typed becomes what is, or what it was again
  }
}

void WeatherListDialog::select(int cell) {
  const QScopedValueRollback filling(isFilling_, true);
  if (cell >= 0 && cell < list_->rowCount() && cell != list_->currentRow()) {
    list_->setCurrentCell(cell, Name);
  }
  refresh();
}

bool WeatherListDialog::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress && static_cast<const QKeyEvent*>(event)->key() == Qt::Key_Delete &&
      list_->currentRow() >= 0) {
    emit removeRequested(list_->currentRow());
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void WeatherListDialog::refresh() {
  const bool hasCurrent = list_->currentRow() >= 0;
  edit_->setEnabled(hasCurrent);
  remove_->setEnabled(hasCurrent);
  export_->setEnabled(!cells_.empty());
  hint_->setText(cells_.empty() ? tr("No weather yet. Draw it on the map, add a file here, or drop one on the window.")
                                : tr("Planners of landings keep out of weather where they can and tell how likely the rest is. The tour and its "
                                     "certificate know nothing of weather."));
}

}  // namespace vp::dialogs
