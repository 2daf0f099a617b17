#include "ui/dialogs/fetch_terrain_dialog.h"

#include "core/fetch/airfield_fetch.h"
#include "core/fetch/cache_folder.h"
#include "ui/jobs/job_runner.h"
#include "ui/panels/position_text.h"
#include "ui/style/core_text.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace vp::dialogs {
namespace {

constexpr int kWidth = 560;  // px: addresses and paths to be read without scrolling

/// The place by coordinates, else by the code of an airfield in the first file that has it.
Result<geo::LatLon> findAirfield(const std::vector<std::string>& files, const std::string& code) {
  for (const std::string& file : files) {
    const Result<geo::LatLon> place = fetch::placeOfAirfield(file, code);
    if (place) {
      return place;
    }
  }
  return fail(Errc::OutOfRange,
              (files.empty()
                   ? FetchTerrainDialog::tr("no airfields are known yet to look this up; update the airfields first (File menu), or type a position")
                   : FetchTerrainDialog::tr("no airfield has this code; correct it, or type a position such as 46.6003 9.9017"))
                  .toStdString());
}

}  // namespace

/// What an estimate was asked for, and what came.
struct FetchTerrainDialog::Asked {
  fetch::TerrainRequest request;
  fetch::TerrainEstimate estimate;
};

FetchTerrainDialog::FetchTerrainDialog(Offer offer, jobs::JobRunner& runner, QWidget* parent)
    : QDialog(parent), offer_(std::move(offer)), runner_(runner) {
  setWindowTitle(tr("Fetch terrain"));
  setObjectName(QStringLiteral("fetchTerrainDialog"));
  build();
  connect(&runner_, &jobs::JobRunner::progressed, this, [this](double fraction, const QString& text) {
    bar_->setValue(static_cast<int>(1000.0 * fraction));
    bar_->setFormat(text);
  });
  setBusy(false);
}

FetchTerrainDialog::~FetchTerrainDialog() = default;

void FetchTerrainDialog::build() {
  ofMap_ = new QRadioButton(tr("What the &map shows"));
  around_ = new QRadioButton(tr("&Around an airfield or position"));
  ofMap_->setObjectName(QStringLiteral("fetchOfMap"));
  around_->setObjectName(QStringLiteral("fetchAround"));
  ofMap_->setEnabled(offer_.mapArea.has_value());
  (offer_.mapArea ? ofMap_ : around_)->setChecked(true);
  place_ = new QLineEdit;
  place_->setObjectName(QStringLiteral("fetchPlace"));
  place_->setPlaceholderText(tr("LSZS, or 46.534 9.884"));
  place_->setAccessibleName(tr("Airfield or position"));
  radius_ = new QDoubleSpinBox;
  radius_->setObjectName(QStringLiteral("fetchRadius"));
  radius_->setRange(1.0, 300.0);
  radius_->setDecimals(0);
  radius_->setValue(30.0);
  radius_->setSuffix(tr(" km"));
  server_ = new QLineEdit(offer_.server);
  server_->setObjectName(QStringLiteral("fetchServer"));
  server_->setPlaceholderText(QString::fromStdString(fetch::fromEnvironment("VOLPLANE_TERRAIN_URL", fetch::kTerrainServer)));
  output_ = new QLineEdit(offer_.output);
  output_->setObjectName(QStringLiteral("fetchOutput"));
  auto* browse = new QPushButton(tr("&Browse…"));
  connect(browse, &QPushButton::clicked, this, &FetchTerrainDialog::chooseOutput);
  auto* file = new QHBoxLayout;
  file->addWidget(output_, 1);
  file->addWidget(browse);
  size_ = new QLabel(tr("Ask for the size first. Tiles that have been fetched once stay on this machine and need no network."));
  size_->setObjectName(QStringLiteral("fetchSize"));
  size_->setWordWrap(true);
  size_->setMinimumHeight(3 * fontMetrics().lineSpacing());  // room for it from the start: nothing jumps
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  ask_ = new QPushButton(tr("Ask for &size"));
  ask_->setObjectName(QStringLiteral("fetchAsk"));
  fetch_ = new QPushButton(tr("&Fetch"));
  fetch_->setObjectName(QStringLiteral("fetchStart"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(ask_, QDialogButtonBox::ActionRole);
  buttons->addButton(fetch_, QDialogButtonBox::ActionRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &FetchTerrainDialog::reject);
  connect(ask_, &QPushButton::clicked, this, &FetchTerrainDialog::askForSize);
  connect(fetch_, &QPushButton::clicked, this, &FetchTerrainDialog::startFetching);
  connect(ofMap_, &QRadioButton::toggled, this, &FetchTerrainDialog::forgetSize);
  connect(place_, &QLineEdit::textEdited, this, [this] {
    around_->setChecked(true);
    forgetSize();
  });
  connect(radius_, &QDoubleSpinBox::valueChanged, this, &FetchTerrainDialog::forgetSize);
  connect(server_, &QLineEdit::textEdited, this, &FetchTerrainDialog::forgetSize);
  auto* form = new QFormLayout;
  form->addRow(ofMap_);
  form->addRow(around_, place_);
  form->addRow(tr("&Radius"), radius_);
  auto* writeTo = new QLabel(tr("&Write to"));
  writeTo->setBuddy(output_);
  form->addRow(writeTo, file);
  form->addRow(tr("&Server"), server_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(size_);
  column->addWidget(bar_);
  column->addWidget(buttons);
  setMinimumWidth(kWidth);
}

QString FetchTerrainDialog::server() const {
  return server_->text().trimmed();
}

void FetchTerrainDialog::chooseOutput() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Write terrain to"), output_->text(), QStringLiteral("GeoTIFF (*.tif)"));
  if (!path.isEmpty()) {
    output_->setText(path.endsWith(QStringLiteral(".tif"), Qt::CaseInsensitive) ? path : path + QStringLiteral(".tif"));
  }
}

void FetchTerrainDialog::setBusy(bool busy) {
  isBusy_ = busy;
  bar_->setEnabled(busy);
  bar_->setTextVisible(busy);
  if (!busy) {
    bar_->setValue(0);
  }
  for (QWidget* input : {static_cast<QWidget*>(ofMap_), static_cast<QWidget*>(around_), static_cast<QWidget*>(place_), static_cast<QWidget*>(radius_),
                         static_cast<QWidget*>(server_), static_cast<QWidget*>(output_), static_cast<QWidget*>(ask_)}) {
    input->setEnabled(!busy);
  }
  ofMap_->setEnabled(!busy && offer_.mapArea.has_value());
  fetch_->setEnabled(!busy && estimate_.has_value());
  (fetch_->isEnabled() ? fetch_ : ask_)->setDefault(true);
}

void FetchTerrainDialog::forgetSize() {
  if (estimate_) {
    estimate_.reset();
    size_->setText(tr("Ask for the size again."));
  }
  setBusy(isBusy_);
}

void FetchTerrainDialog::showProblem(const QString& problem) {
  size_->setText(problem);
  size_->setAccessibleName(problem);
}

void FetchTerrainDialog::askForSize() {
  fetch::TerrainRequest request;
  request.server = server().toStdString();
  request.cache = offer_.cache;
  request.patience = offer_.patience;
  std::optional<geo::LatLon> place;
  const bool isAround = around_->isChecked();
  if (isAround) {
    place = panels::parsePosition(place_->text());
  } else {
    request.area = *offer_.mapArea;
  }
  setBusy(true);
  runner_.start<Asked>(
      [request, place, isAround, files = offer_.airportFiles, code = place_->text().trimmed().toStdString(),
       radius = 1000.0 * radius_->value()](const Job& job) mutable -> Result<Asked> {
        if (isAround) {
          const Result<geo::LatLon> middle = place ? Result<geo::LatLon>(*place) : findAirfield(files, code);
          if (!middle) {
            return forward(middle);
          }
          const Result<geo::GeoBox> box = fetch::boxAround(*middle, radius);
          if (!box) {
            return forward(box);
          }
          request.area = *box;
        }
        Result<fetch::TerrainEstimate> estimate = fetch::estimateTerrain(request, job);
        return estimate ? Result<Asked>(Asked{request, std::move(*estimate)}) : forward(estimate);
      },
      [this](Result<Asked> result) {
        if (result) {
          request_ = result->request;
          estimate_ = std::move(result->estimate);
          showProblem(tr("%1. Copernicus GLO-30 from %2").arg(style::coreText(estimate_->inWords()), QString::fromStdString(estimate_->server)));
        } else {
          showProblem(style::coreText(result.error()));
        }
        setBusy(false);
      });
}

void FetchTerrainDialog::startFetching() {
  if (output_->text().trimmed().isEmpty()) {
    showProblem(tr("Say where the terrain is to be written."));
    return;
  }
  setBusy(true);
  runner_.start<fetch::FetchedTerrain>([request = *request_, estimate = *estimate_, output = output_->text().trimmed().toStdString()](
                                           const Job& job) { return fetch::fetchTerrain(request, estimate, output, job); },
                                       [this](const Result<fetch::FetchedTerrain>& result) {
                                         setBusy(false);
                                         if (!result) {
                                           showProblem(style::coreText(result.error()));
                                           return;
                                         }
                                         for (const std::string& file : result->files) {
                                           files_ << QString::fromStdString(file);
                                         }
                                         for (const std::string& note : result->notes) {
                                           notes_ << style::coreText(note);
                                         }
                                         accept();
                                       });
}

/// While something runs, Cancel stops that; what came so far is kept and the dialog stays.
void FetchTerrainDialog::reject() {
  runner_.cancel();  // its result must not come to a dialog that is gone
  if (isBusy_) {
    setBusy(false);
    showProblem(tr("Stopped. What came so far is kept and will be continued."));
    return;
  }
  QDialog::reject();
}

}  // namespace vp::dialogs
