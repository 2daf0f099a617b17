#include "ui/panels/plan_summary_panel.h"

#include "core/aircraft/glide_model.h"
#include "core/mission/glide_conditions.h"
#include "ui/document/condition_words.h"
#include "ui/panels/guarantee_text.h"
#include "ui/panels/state_icons.h"
#include "ui/panels/table_tools.h"
#include "ui/profile/plot_text.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace vp::panels {
namespace {

constexpr int kIconSize = 32;      // px
constexpr int kLeastMessages = 5;  // lines

struct MarginWords {
  const char* kind;
  const char* words;
};
constexpr std::array kMarginWords{
    MarginWords{"tour.clearance", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Tour above terrain and clearance")},
    MarginWords{"tour.glide", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Tour above what the glide needs")},
    MarginWords{"tour.climb", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Climb below the steepest allowed")},
    MarginWords{"tour.descent", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Descent below the steepest allowed")},
    MarginWords{"tour.ceiling", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Tour below the ceiling")},
    MarginWords{"glide.clearance", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Glides above terrain and clearance")},
    MarginWords{"glide.dynamics", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Glides above terrain less what rolling may cost")},
    MarginWords{"glide.arrival", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Glides above the runway on arrival")},
    MarginWords{"target.height", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Tour above the targets")},
    MarginWords{"spiral.clearance", QT_TRANSLATE_NOOP("PlanSummaryPanel", "Spirals above terrain and clearance")},
};

QString marginValue(const mission::Margin& margin, const style::Units& units) {
  if (margin.unit == "m") {
    return units.margin(margin.value);
  }
  return margin.unit == "deg" ? style::Units::angle(margin.value)
                              : QStringLiteral("%1 %2").arg(margin.value, 0, 'f', 1).arg(QString::fromStdString(margin.unit));
}

Sign signOf(safety::Severity severity) {
  switch (severity) {
    case safety::Severity::Note:
      return Sign::Note;
    case safety::Severity::Warning:
      return Sign::Warning;
    case safety::Severity::Violated:
    case safety::Severity::Unknown:
      break;
  }
  return Sign::Violation;
}

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  return label;
}

}  // namespace

QString marginName(const std::string& kind) {
  const auto found = std::find_if(kMarginWords.begin(), kMarginWords.end(), [&](const MarginWords& words) { return kind == words.kind; });
  return found == kMarginWords.end() ? QString::fromStdString(kind) : QCoreApplication::translate("PlanSummaryPanel", found->words);
}

PlanSummaryPanel::PlanSummaryPanel(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Plan"));
  auto* column = scrolledColumn();
  auto* head = new QHBoxLayout;
  icon_ = new QLabel(this);
  icon_->setFixedSize(kIconSize, kIconSize);
  title_ = sentenceLabel(this);
  QFont big = title_->font();
  big.setPointSizeF(big.pointSizeF() * 1.35);
  big.setBold(true);
  title_->setFont(big);
  head->addWidget(icon_);
  head->addWidget(title_, 1);
  column->addLayout(head);
  statement_ = sentenceLabel(this);
  column->addWidget(statement_);

  figures_ = new QWidget(this);
  auto* form = new QFormLayout(figures_);
  form->setContentsMargins(0, 6, 0, 0);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  length_ = addFigure(*form, tr("Length"));
  time_ = addFigure(*form, tr("Time"));
  altitudes_ = addFigure(*form, tr("Altitudes"));
  cost_ = addFigure(*form, tr("Cost"));
  gap_ = addFigure(*form, tr("Could be shorter by"));
  checked_ = addFigure(*form, tr("Checked"));
  column->addWidget(figures_);

  marginsTitle_ = heading(tr("Least margins"), this);
  column->addWidget(marginsTitle_);
  margins_ = new QTreeWidget(this);
  margins_->setAccessibleName(tr("Least margins"));
  margins_->setColumnCount(2);
  margins_->setHeaderLabels({tr("Kind"), tr("Margin")});
  margins_->setRootIsDecorated(false);
  margins_->setAlternatingRowColors(true);
  margins_->setFont(profile::tabularFont(margins_->font()));
  margins_->setTextElideMode(Qt::ElideRight);
  margins_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  margins_->header()->setStretchLastSection(false);
  margins_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  margins_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  column->addWidget(margins_);
  messagesTitle_ = heading(QString(), this);
  column->addWidget(messagesTitle_);
  messages_ = new QListWidget(this);
  messages_->setAccessibleName(tr("Warnings and findings"));
  messages_->setWordWrap(true);
  messages_->setResizeMode(QListView::Adjust);
  messages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  messages_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  messages_->setMinimumHeight(kLeastMessages * fontMetrics().lineSpacing());
  messages_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // takes what is left before the page scrolls
  column->addWidget(messages_, 3);
  column->addStretch(0);

  connect(margins_, &QTreeWidget::itemActivated, this, &PlanSummaryPanel::jumpToMargin);
  connect(margins_, &QTreeWidget::itemClicked, this, &PlanSummaryPanel::jumpToMargin);
  connect(messages_, &QListWidget::itemActivated, this, &PlanSummaryPanel::jumpToFinding);
  connect(messages_, &QListWidget::itemClicked, this, &PlanSummaryPanel::jumpToFinding);
  connect(&state_, &document::ViewState::unitsChanged, this, &PlanSummaryPanel::refresh);
  connect(&state_, &document::ViewState::themeChanged, this, &PlanSummaryPanel::refresh);
  refresh();
}

/// The column of everything, which scrolls where the screen is too low for it.
QVBoxLayout* PlanSummaryPanel::scrolledColumn() {
  auto* page = new QWidget;
  area_ = new QScrollArea(this);
  area_->setWidgetResizable(true);
  area_->setFrameShape(QFrame::NoFrame);
  area_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area_->setWidget(page);
  area_->viewport()->setAutoFillBackground(false);
  area_->viewport()->installEventFilter(this);
  page->setAutoFillBackground(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(area_);
  return new QVBoxLayout(page);
}

QLabel* PlanSummaryPanel::addFigure(QFormLayout& form, const QString& name) {
  QLabel* value = sentenceLabel(this);
  value->setFont(profile::tabularFont(value->font()));
  value->setAccessibleName(name);
  form.addRow(name, value);
  return value;
}

void PlanSummaryPanel::setSituation(const document::Situation& situation) {
  const bool changed = situation.plan != situation_.plan || situation.planIsCurrent != situation_.planIsCurrent;
  situation_ = situation;
  if (changed) {
    refresh();
  }
}

void PlanSummaryPanel::setReport(const safety::SafetyReport& report) {
  report_ = report;
  refresh();
}

PlanSummaryPanel::State PlanSummaryPanel::planState() const {
  if (situation_.plan == nullptr) {
    return State::NoPlan;
  }
  if (!situation_.planIsCurrent) {
    return State::OutOfDate;
  }
  return situation_.plan->isVerified() ? State::Verified : State::Unverified;
}

void PlanSummaryPanel::refresh() {
  showState();
  showFigures();
  showMargins();
  showMessages();
  fitPage();
}

/// The page gets the height that its sentences need at this width; the area knows only what single lines would need.
void PlanSummaryPanel::fitPage() {
  QWidget* page = area_->widget();
  page->setMinimumHeight(page->layout()->totalMinimumHeightForWidth(area_->viewport()->width()));
}

bool PlanSummaryPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == area_->viewport() && event->type() == QEvent::Resize) {
    fitPage();
  }
  return QWidget::eventFilter(watched, event);
}

void PlanSummaryPanel::showState() {
  Sign sign = Sign::Note;
  switch (planState()) {
    case State::NoPlan:
      title_->setText(tr("No plan yet"));
      statement_->setText(tr("Load terrain and airports, mark targets, then plan the tour."));
      break;
    case State::Verified:
      sign = Sign::Verified;
      title_->setText(tr("VERIFIED"));
      statement_->setText(guaranteeStatement(situation_.plan->plan(), state_.units()));
      break;
    case State::Unverified:
      sign = Sign::Unverified;
      title_->setText(tr("UNVERIFIED"));
      statement_->setText(tr("The checker has not confirmed that a runway can be reached from every point. Do not fly this plan."));
      break;
    case State::OutOfDate:
      sign = Sign::OutOfDate;
      title_->setText(tr("OUT OF DATE"));
      statement_->setText(
          tr("An input has changed since this plan was made. Plan again, or undo the change. The figures below are those of the old plan."));
      break;
  }
  icon_->setPixmap(signIcon(sign, state_.theme()).pixmap(QSize(kIconSize, kIconSize), devicePixelRatioF()));
  icon_->setAccessibleName(title_->text());
}

void PlanSummaryPanel::showFigures() {
  figures_->setVisible(situation_.plan != nullptr);
  if (situation_.plan == nullptr) {
    return;
  }
  const style::Units& units = state_.units();
  const mission::Plan& plan = situation_.plan->plan();
  const mission::PlanMetrics& metrics = plan.metrics;
  length_->setText(tr("%1, %2 over ground").arg(units.distance(metrics.length), units.distance(situation_.plan->length())));
  const double middle = 0.5 * (situation_.plan->lowestAltitude() + situation_.plan->highestAltitude());
  const double speed = mission::tourAirspeedAt(plan.mission, geo::HeightMsl::fromMetres(middle));
  time_->setText(tr("%1 at %2").arg(document::flightWords(plan, units), units.speed(speed)));
  altitudes_->setText(
      tr("%1 to %2").arg(units.altitudeMsl(situation_.plan->lowestAltitude()), units.altitudeMsl(situation_.plan->highestAltitude())));
  cost_->setText(tr("%1, of which %2 for passing above targets").arg(units.distance(metrics.cost), units.distance(metrics.penalty)));
  if (metrics.optimal) {
    gap_->setText(tr("nothing: proved best over these headings and glides"));
  } else if (metrics.lowerBound > 0.0 && metrics.sampledCost > metrics.cost) {
    // the bound speaks of the sampled headings, which a refined tour has left
    gap_->setText(tr("refined: %1 % below the tour over sampled headings, which need at least %2")
                      .arg(100.0 * (1.0 - metrics.cost / metrics.sampledCost), 0, 'f', 1)
                      .arg(units.distance(metrics.lowerBound)));
  } else if (metrics.lowerBound > 0.0 && metrics.cost > 0.0) {
    const double gap = std::max(0.0, metrics.cost - metrics.lowerBound) / metrics.cost * 100.0;
    gap_->setText(tr("at most %1 %, at least %2 is needed").arg(gap, 0, 'f', 1).arg(units.distance(metrics.lowerBound)));
  } else {
    gap_->setText(tr("not known"));
  }
  if (metrics.freeLowerBound > 0.0) {
    gap_->setText(tr("%1; at most %2 % above the best of all safe tours")
                      .arg(gap_->text())
                      .arg(100.0 * (metrics.cost / metrics.freeLowerBound - 1.0), 0, 'f', 1));
  }
  checked_->setText(plan.certificate ? tr("%1 points, %2 glides").arg(plan.certificate->pointsChecked).arg(plan.certificate->glidesChecked)
                                     : tr("not passed"));
}

void PlanSummaryPanel::showMargins() {
  margins_->clear();
  const std::vector<mission::Margin>* margins = nullptr;
  if (situation_.plan != nullptr && situation_.plan->plan().certificate) {
    margins = &situation_.plan->plan().certificate->margins;
  } else if (!report_.margins.empty()) {
    margins = &report_.margins;
  }
  margins_->setVisible(margins != nullptr);
  marginsTitle_->setVisible(margins != nullptr);
  if (margins == nullptr) {
    return;
  }
  for (const mission::Margin& margin : *margins) {
    const QString name = marginName(margin.kind);
    const QString value = marginValue(margin, state_.units());
    auto* item = new QTreeWidgetItem(margins_, {name, value});
    const QString hint = tr("%1: %2 at %3. Click to go there.").arg(name, value, style::Units::position(margin.where));
    item->setToolTip(0, hint);
    item->setToolTip(1, hint);
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setSizeHint(0, QSize(0, margins_->fontMetrics().height() + 8));
    item->setData(0, Qt::UserRole, QPointF(margin.where.longitude_deg, margin.where.latitude_deg));
  }
  const int rows = static_cast<int>(margins->size());
  margins_->setFixedHeight(margins_->header()->sizeHint().height() + rows * (margins_->fontMetrics().height() + 8) + 2 * margins_->frameWidth());
}

void PlanSummaryPanel::showMessages() {
  messages_->clear();
  const bool refused = !report_.isSafe() && !report_.findings.empty();
  if (refused) {
    for (std::size_t i = 0; i < report_.findings.size(); ++i) {
      const safety::Finding& finding = report_.findings[i];
      auto* item = new QListWidgetItem(signIcon(signOf(finding.severity), state_.theme()), state_.units().inSentence(finding.text), messages_);
      item->setData(Qt::UserRole, static_cast<int>(i));
      item->setToolTip(QStringLiteral("%1 [%2]").arg(item->text(), QString::fromStdString(finding.rule)));
    }
    messagesTitle_->setText(tr("Why the plan was refused"));
  } else if (situation_.plan != nullptr && situation_.plan->plan().certificate) {
    for (const std::string& warning : situation_.plan->plan().certificate->warnings) {
      auto* item = new QListWidgetItem(signIcon(Sign::Warning, state_.theme()), state_.units().inSentence(warning), messages_);
      item->setToolTip(item->text());
    }
    messagesTitle_->setText(tr("Warnings"));
  }
  messages_->setVisible(messages_->count() > 0);
  messagesTitle_->setVisible(messages_->count() > 0);
}

void PlanSummaryPanel::jumpToMargin(QTreeWidgetItem* item) {
  if (situation_.terrain != nullptr) {
    const QPointF place = item->data(0, Qt::UserRole).toPointF();
    jumpTo(state_, situation_.plan.get(), situation_.terrain->frame.toPoint({place.y(), place.x()}));
  }
}

void PlanSummaryPanel::jumpToFinding(QListWidgetItem* item) {
  const QVariant number = item->data(Qt::UserRole);
  if (!number.isValid() || situation_.terrain == nullptr) {
    return;
  }
  const safety::Finding& finding = report_.findings[static_cast<std::size_t>(number.toInt())];
  const bool onTour =
      situation_.plan != nullptr && finding.tourPoint >= 0 && static_cast<std::size_t>(finding.tourPoint) < situation_.plan->plan().tour.size();
  if (onTour) {
    state_.setPinned(situation_.plan->distanceOf(static_cast<std::size_t>(finding.tourPoint)));
  }
  if (finding.where) {
    state_.showPlace(situation_.terrain->frame.toPoint(*finding.where));
  } else if (onTour) {
    state_.showPlace(situation_.plan->plan().tour[static_cast<std::size_t>(finding.tourPoint)].pose.point());
  }
}

}  // namespace vp::panels
