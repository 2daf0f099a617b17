#pragma once

#include "core/landing/site_roadmaps.h"
#include "ui/panels/state_icons.h"
#include "ui/style/units.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace vp::panels {

/** The next-best runways of a point, in the order of the height that they need. */
class AlternativesModel : public QAbstractTableModel {
  Q_OBJECT

public:
  enum Column { Runway, Reach, Margin, Required, Distance, Time, ColumnCount };

  explicit AlternativesModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  /** @param source  gives the names of the answers' sites */
  void setAnswers(std::shared_ptr<const landing::SiteRoadmaps> source, std::vector<landing::SiteAnswer> answers);
  void setStyle(const style::Units& units, style::Theme theme);
  [[nodiscard]] const std::vector<landing::SiteAnswer>& answers() const { return answers_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] const mission::LandingSite& siteOf(const landing::SiteAnswer& answer) const;
  [[nodiscard]] QString textOf(const landing::SiteAnswer& answer, int column) const;
  [[nodiscard]] static Sign signOf(const landing::SiteAnswer& answer);

  std::shared_ptr<const landing::SiteRoadmaps> source_;
  std::vector<landing::SiteAnswer> answers_;
  style::Units units_;
  style::Theme theme_ = style::Theme::Light;
};

/** "LSZS 03/21": both ends of the runway that a site is an end of. */
QString physicalRunwayName(const landing::SiteRoadmaps& source, int site);

}  // namespace vp::panels
