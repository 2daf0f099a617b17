#pragma once

#include "core/mission/mission.h"
#include "ui/document/situation.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace vp::panels {

/** All runway ends of the mission's airfields, used or not. The tick asks by a signal for a runway to be excluded or let in
 *  again; it shows what the next situation says. */
class SiteModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Runway, Name, Course, Length, Surface, Elevation, Remarks, ColumnCount };

  explicit SiteModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  void setSites(std::shared_ptr<const std::vector<document::ShownSite>> sites);
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

private:
  [[nodiscard]] QString textOf(const document::ShownSite& shown, int column) const;
  [[nodiscard]] QVariant sortKey(const document::ShownSite& shown, int column) const;
  [[nodiscard]] QString remarks(const document::ShownSite& shown) const;
  [[nodiscard]] bool isExcludedByHand(const mission::LandingSite& site) const;

  std::shared_ptr<const std::vector<document::ShownSite>> sites_;
  mission::SiteFilter filter_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

}  // namespace vp::panels
