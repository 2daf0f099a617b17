#pragma once

#include "core/mission/mission.h"
#include "ui/document/situation.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <optional>
#include <vector>

namespace vp::panels {

/** All runway ends of the mission's airfields, used or not. The ticks ask by a signal for a runway to be excluded or let in
 *  again, or to be landed on from one side only; they show what the next situation says. The note can be edited. */
class SiteModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Runway, Name, Course, Length, Width, Surface, Lighted, Elevation, Distance, OneWay, Remarks, Note, ColumnCount };

  explicit SiteModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setSites(std::shared_ptr<const std::vector<document::ShownSite>> sites);
  /** Where distances are counted from, unless the filter names a place. */
  void setTargets(std::shared_ptr<const std::vector<document::ShownTarget>> targets);
  void setFilter(const mission::SiteFilter& filter);
  void setStyle(const style::Units& units, style::Theme theme);
  [[nodiscard]] const document::ShownSite* site(int row) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
  void excludeRequested(const QString& siteId, bool excluded);
  void oneWayRequested(const QString& siteId, bool oneWay);
  void noteEdited(const QString& siteId, const QString& text);

private:
  [[nodiscard]] std::optional<double> distanceOf(const document::ShownSite& shown) const;
  [[nodiscard]] QString noteOf(const mission::LandingSite& site) const;
  [[nodiscard]] bool isOneWay(const mission::LandingSite& site) const;
  [[nodiscard]] QVariant checkState(const document::ShownSite& shown, int column) const;
  void redraw();
  [[nodiscard]] QString textOf(const document::ShownSite& shown, int column) const;
  [[nodiscard]] QVariant sortKey(const document::ShownSite& shown, int column) const;
  [[nodiscard]] QString remarks(const document::ShownSite& shown) const;
  [[nodiscard]] bool isExcludedByHand(const mission::LandingSite& site) const;

  std::shared_ptr<const std::vector<document::ShownSite>> sites_;
  std::shared_ptr<const std::vector<document::ShownTarget>> targets_;
  mission::SiteFilter filter_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

}  // namespace vp::panels
