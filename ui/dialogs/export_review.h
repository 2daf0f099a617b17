#pragma once

#include "ui/exports/prepare_export.h"
#include "ui/style/units.h"

#include <QDialog>

class QTableWidget;

namespace vp::dialogs {

/** Shows, before anything is written, what flying the waypoints costs: the least margins of the tour beside those of the waypoint route, for each
 *  precision of places that the formats need, and all remarks. Warnings stand first and make Cancel the default. */
class ExportReview : public QDialog {
  Q_OBJECT

public:
  ExportReview(const exports::PreparedExport& prepared, const style::Units& units, QWidget* parent = nullptr);

private:
  QTableWidget* makeTable(const exports::PreparedExport& prepared, const style::Units& units) const;
};

}  // namespace vp::dialogs
