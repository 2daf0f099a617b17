#include "ui/dialogs/jump_dialog.h"

#include "ui/panels/position_text.h"
#include "ui/style/units.h"

#include <QCompleter>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {

constexpr int kWidth = 460;  // px: the hint in two lines

QString runwayText(const mission::LandingSite& site) {
  return QString::fromStdString(site.id).replace(QLatin1Char('/'), QLatin1Char(' '));
}

std::optional<geo::Point> findSite(const document::Situation& situation, const QString& text) {
  if (situation.sites == nullptr) {
    return std::nullopt;
  }
  const auto is = [&text](const QString& name) { return name.compare(text, Qt::CaseInsensitive) == 0; };
  for (const document::ShownSite& shown : *situation.sites) {
    const mission::LandingSite& site = shown.site.site;
    if (is(QString::fromStdString(site.airportIdent)) || is(QString::fromStdString(site.id)) || is(runwayText(site))) {
      return shown.site.pose.point();
    }
  }
  return std::nullopt;
}

QStringList knownNames(const document::Situation& situation) {
  QStringList names;
  if (situation.targets != nullptr) {
    for (const document::ShownTarget& shown : *situation.targets) {
      names << QString::fromStdString(shown.target.name);
    }
  }
  if (situation.sites != nullptr) {
    for (const document::ShownSite& shown : *situation.sites) {
      names << QString::fromStdString(shown.site.site.airportIdent) << runwayText(shown.site.site);
    }
  }
  names.removeDuplicates();
  names.removeAll(QString());
  return names;
}

}  // namespace

FoundPlace findPlace(const document::Situation& situation, const QString& text) {
  const QString wanted = text.simplified();
  const auto none = [](const QString& problem) { return FoundPlace{std::nullopt, -1, problem}; };
  if (situation.terrain == nullptr) {
    return none(JumpDialog::tr("There is no terrain yet: add a terrain file first, then places on it can be shown."));
  }
  if (wanted.isEmpty()) {
    return none(JumpDialog::tr("Type a position, the ident of an airfield or the name of a target."));
  }
  if (situation.targets != nullptr) {
    for (std::size_t i = 0; i < situation.targets->size(); ++i) {
      if (QString::fromStdString((*situation.targets)[i].target.name).compare(wanted, Qt::CaseInsensitive) == 0) {
        return {(*situation.targets)[i].point, static_cast<int>(i), {}};
      }
    }
  }
  if (const auto site = findSite(situation, wanted)) {
    return {site, -1, {}};
  }
  const std::optional<geo::LatLon> place = panels::parsePosition(wanted);
  if (!place) {
    return none(
        JumpDialog::tr("“%1” is no target or airfield here, and not a position such as 46.6003 9.9017 or 46°36.02′ N 9°54.10′ E.").arg(wanted));
  }
  const geo::Point point = situation.terrain->frame.toPoint(*place);
  if (!situation.terrain->grid->extent().contains(point)) {
    return none(JumpDialog::tr("%1 lies outside the terrain that is loaded.").arg(style::Units::position(*place)));
  }
  return {point, -1, {}};
}

JumpDialog::JumpDialog(document::Situation situation, QWidget* parent) : QDialog(parent), situation_(std::move(situation)) {
  setWindowTitle(tr("Jump to"));
  setObjectName(QStringLiteral("jumpDialog"));
  text_ = new QLineEdit;
  text_->setObjectName(QStringLiteral("jumpText"));
  text_->setPlaceholderText(QStringLiteral("46°36.02′ N 9°54.10′ E"));
  auto* completer = new QCompleter(knownNames(situation_), text_);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  text_->setCompleter(completer);
  auto* label = new QLabel(tr("&Position, airfield or target"));
  label->setBuddy(text_);
  text_->setAccessibleName(tr("Position, airfield or target"));
  auto* hint =
      new QLabel(tr("Degrees, degrees and minutes, or degrees, minutes and seconds, with N, S, E, W or latitude first: 46.6003 9.9017, N46 36.02 "
                    "E9 54.10, 46°36′01″ N 9°54′06″ E."));
  hint->setWordWrap(true);
  hint->setForegroundRole(QPalette::PlaceholderText);
  problem_ = new QLabel;
  problem_->setObjectName(QStringLiteral("jumpProblem"));
  problem_->setWordWrap(true);
  problem_->setMinimumHeight(2 * fontMetrics().lineSpacing());  // room for it from the start: nothing jumps, nothing is cut
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("&Jump"));
  connect(buttons, &QDialogButtonBox::accepted, this, &JumpDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(text_, &QLineEdit::textEdited, problem_, &QLabel::clear);
  auto* column = new QVBoxLayout(this);
  column->addWidget(label);
  column->addWidget(text_);
  column->addWidget(hint);
  column->addWidget(problem_);
  column->addStretch(1);
  column->addWidget(buttons);
  setMinimumWidth(kWidth);
}

void JumpDialog::accept() {
  found_ = findPlace(situation_, text_->text());
  if (found_.point) {
    QDialog::accept();
    return;
  }
  problem_->setText(found_.problem);
  problem_->setAccessibleName(found_.problem);
  text_->selectAll();
  text_->setFocus();
}

}  // namespace vp::dialogs
