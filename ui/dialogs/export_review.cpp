#include "ui/dialogs/export_review.h"

#include "ui/style/core_text.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vp::dialogs {
namespace {

constexpr QSize kSize{760, 560};
constexpr double kMetresPerDegree = 111200.0;
constexpr double kTenth = 0.1;
constexpr double kRounding = 1e-6;  // of a tenth: figures that are exact

/// Rounded down, as margins are.
QString marginText(double value, const std::string& unit, const style::Units& units) {
  if (unit == "m") {
    return units.margin(value);
  }
  const QString number = QString::number(std::floor(value / kTenth + kRounding) * kTenth, 'f', 1);
  return unit == "deg" ? number + QChar(0xB0) : number + QLatin1Char(' ') + QString::fromStdString(unit);
}

/// A loss is rounded up, so that it looks no smaller.
QString lossText(const exports::MarginChange& margin, const style::Units& units) {
  const double loss = margin.tour - margin.route;
  return loss <= kRounding ? ExportReview::tr("none") : marginText(-loss, margin.unit, units);
}

QTableWidgetItem* cell(const QString& text, bool isNumber) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignVCenter | (isNumber ? Qt::AlignRight : Qt::AlignLeft));
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

QLabel* label(const QString& text, const char* name) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

}  // namespace

ExportReview::ExportReview(const exports::PreparedExport& prepared, const style::Units& units, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Export: what the waypoints cost"));
  setObjectName(QStringLiteral("exportReview"));
  QStringList warnings;
  QStringList notes;
  for (const exports::Remark& remark : prepared.remarks) {
    (remark.isWarning ? warnings : notes).append(style::coreText(remark.text));
  }
  auto* column = new QVBoxLayout(this);
  if (!warnings.isEmpty()) {
    QLabel* warning = label(tr("Really export?") + QLatin1Char('\n') + warnings.join(QLatin1Char('\n')), "exportWarnings");
    QFont bold = warning->font();
    bold.setBold(true);
    warning->setFont(bold);
    column->addWidget(warning);
  }
  column->addWidget(label(tr("Least margins of the tour, and of the path that fly-by turns from waypoint to waypoint give:"), "exportMarginsTitle"));
  column->addWidget(makeTable(prepared, units), 3);
  auto* text = new QPlainTextEdit(notes.join(QLatin1Char('\n')));
  text->setObjectName(QStringLiteral("exportNotes"));
  text->setAccessibleName(tr("Notes"));
  text->setReadOnly(true);
  text->setTabChangesFocus(true);
  column->addWidget(text, 2);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* write = buttons->addButton(warnings.isEmpty() ? tr("&Write") : tr("Export &anyway"),
                                          warnings.isEmpty() ? QDialogButtonBox::AcceptRole : QDialogButtonBox::DestructiveRole);
  write->setObjectName(QStringLiteral("exportWrite"));
  column->addWidget(buttons);
  // Only now: before it lies in the dialog, a button becomes no default of it.
  QPushButton* cancel = buttons->button(QDialogButtonBox::Cancel);
  QPushButton* chosen = warnings.isEmpty() ? write : cancel;
  write->setAutoDefault(warnings.isEmpty());
  chosen->setDefault(true);
  chosen->setFocus();
  connect(write, &QPushButton::clicked, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(kSize);
}

QTableWidget* ExportReview::makeTable(const exports::PreparedExport& prepared, const style::Units& units) const {
  auto* table = new QTableWidget(0, 5);
  table->setObjectName(QStringLiteral("exportMargins"));
  table->setAccessibleName(tr("Margins"));
  table->setHorizontalHeaderLabels({tr("Least margin"), tr("Places to"), tr("Tour"), tr("Waypoints"), tr("Change")});
  table->verticalHeader()->hide();
  table->setTabKeyNavigation(false);  // Tab leaves the table; arrows move in it
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  for (const exports::CheckedRoute& route : prepared.routes) {
    const QString places = tr("%1 m").arg(kMetresPerDegree / route.route.stepsPerDegree, 0, 'f', 1);
    const auto add = [&](const QStringList& texts) {
      const int row = table->rowCount();
      table->insertRow(row);
      for (int i = 0; i < texts.size(); ++i) {
        table->setItem(row, i, cell(texts[i], i > 0));
      }
    };
    if (route.margins.empty()) {
      add({tr("not known: the waypoints could not be checked"), places, {}, {}, {}});
    }
    for (const exports::MarginChange& margin : route.margins) {
      add({QString::fromStdString(exports::marginInWords(margin.kind)), places, marginText(margin.tour, margin.unit, units),
           marginText(margin.route, margin.unit, units), lossText(margin, units)});
    }
  }
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  return table;
}

}  // namespace vp::dialogs
