#pragma once

#include "core/mission/mission.h"
#include "ui/style/units.h"

#include <QWidget>

#include <vector>

class QAction;
class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QToolButton;

namespace vp::panels {

/** The rules that leave runways out: length, width, distance, surface, light, and what is doubtful. Changes nothing itself. */
class SiteRules : public QWidget {
  Q_OBJECT

public:
  explicit SiteRules(QWidget* parent = nullptr);

  /** The mission's rules, as edited elsewhere; emits nothing. */
  void setFilter(const mission::SiteFilter& filter);
  void setUnits(const style::Units& units);

signals:
  void filterChanged(const vp::mission::SiteFilter& filter);

private:
  QDoubleSpinBox* addBox(QGridLayout& grid, int place, const QString& label, const QString& any, const QString& name);
  void buildSurfaces();
  void showFilter();
  void showSurfaces();
  void emitFilter();

  mission::SiteFilter filter_;
  style::Units units_;
  QDoubleSpinBox* minLength_ = nullptr;
  QDoubleSpinBox* minWidth_ = nullptr;
  QDoubleSpinBox* maxDistance_ = nullptr;
  QToolButton* surfaces_ = nullptr;
  std::vector<QAction*> surfaceActions_;
  QCheckBox* approximate_ = nullptr;
  QCheckBox* closed_ = nullptr;
  QCheckBox* water_ = nullptr;
  QCheckBox* lighted_ = nullptr;
};

}  // namespace vp::panels
