#pragma once

#include "ui/document/landing_case.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>

namespace vp::panels {

/** What each planner answers to one engine failure, a row each, in the order of the answers; a sign beside the runway says whether it was checked. */
class LandingModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Planner, Runway, InHand, Weather, Time, Distance, Clearance, ColumnCount };

  explicit LandingModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setCase(std::shared_ptr<const document::LandingCase> shown);
  void setStyle(const style::Units& units, style::Theme theme);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] QString textOf(const document::ShownLanding& landing, int column) const;
  [[nodiscard]] static QString verdictOf(const document::ShownLanding& landing);

  std::shared_ptr<const document::LandingCase> case_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

/** What a planner is called on screen: "roadmap" is "Roadmap". */
QString plannerTitle(std::string_view name);

}  // namespace vp::panels
