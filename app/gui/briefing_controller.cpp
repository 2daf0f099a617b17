#include "app/gui/briefing_controller.h"

#include "app/gui/suggested_file.h"
#include "core/formats/atomic_file.h"
#include "core/geo/magnetic_field.h"
#include "ui/briefing/write_briefing.h"
#include "ui/dialogs/briefing_dialog.h"
#include "ui/jobs/job_runner.h"
#include "ui/style/core_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>

namespace vp::gui {
namespace {

/// What the work tells the window.
struct Outcome {
  int pages = 0;
  bool isSafe = false;
};

Result<Outcome> writeFile(const mission::Plan& plan, const briefing::BriefingOptions& options, const std::string& path, bool mayBeUnsafe,
                          const vp::Job& job) {
  const Result<briefing::BriefingSource> source = briefing::briefingSource(plan, {}, options.date, job.part(0.0, 0.6));
  if (!source) {
    return forward(source);
  }
  if (!source->report.isSafe() && !mayBeUnsafe) {
    const auto& findings = source->report.findings;
    const auto fault = std::find_if(findings.begin(), findings.end(), [](const safety::Finding& finding) {
      return finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown;
    });
    return fail(
        Errc::OutOfRange,
        BriefingController::tr("the plan could not be verified again, so no briefing was written; plan the tour again, or look at the findings")
                .toStdString() +
            (fault == findings.end() ? std::string() : ": " + fault->text));
  }
  const Result<QByteArray> pdf = briefing::writeBriefing(*source, options, job.part(0.6, 1.0));
  if (!pdf) {
    return forward(pdf);
  }
  const Result<void> written = formats::writeFileAtomically(path, {pdf->constData(), static_cast<std::size_t>(pdf->size())});
  if (!written) {
    return forward(written);
  }
  return Outcome{briefing::pageCount(*pdf), source->report.isSafe()};
}

}  // namespace

using dialogs::MessageBanner;

class BriefingController::Job {
public:
  jobs::JobRunner runner;
};

BriefingController::BriefingController(jobs::Workspace& workspace, MessageBanner& banner, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), window_(window), job_(std::make_unique<Job>()) {
  options_.paper = QLocale::system().measurementSystem() == QLocale::ImperialUSSystem ? briefing::Paper::Letter : briefing::Paper::A4;
}

BriefingController::~BriefingController() = default;

QString BriefingController::doubt() const {
  const document::MissionDocument& document = workspace_.document();
  if (!document.plan()->certificate) {
    return tr("This plan is UNVERIFIED: nobody has shown that a glide to a runway exists from every point of it. Every page will say so.");
  }
  return document.planIsCurrent()
             ? QString()
             : tr("This plan is out of date: the mission has been changed since it was made. The briefing is that of the old plan.");
}

QString BriefingController::suggestedPath() const {
  const QString folder = suggestedFolder(workspace_.document());
  const QString name = suggestedName(workspace_.document());
  return QDir(folder).filePath(tr("%1-briefing.pdf").arg(name));
}

void BriefingController::openDialog() {
  if (workspace_.document().plan() == nullptr) {
    banner_.show(MessageBanner::Kind::Warning, tr("There is no plan to brief; plan the tour first."));
    return;
  }
  const QString reason = doubt();
  const bool mayBeUnsafe = !workspace_.document().plan()->certificate;
  options_.units = workspace_.view().units();
  options_.date = geo::today();
  dialogs::BriefingDialog dialog(options_, reason, window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  options_ = dialog.options();
  QString path = QFileDialog::getSaveFileName(window_, tr("Save briefing"), suggestedPath(), QStringLiteral("*.pdf"));
  if (path.isEmpty()) {
    return;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    path += QStringLiteral(".pdf");
  }
  if (workspace_.document().plan() != nullptr) {  // a job may have taken it away meanwhile
    write(options_, path, mayBeUnsafe);
  }
}

void BriefingController::write(const briefing::BriefingOptions& options, const QString& path, bool mayBeUnsafe) {
  briefing::BriefingOptions named = options;
  named.program = QStringLiteral("Volplane ") + QCoreApplication::applicationVersion();
  job_->runner.start<Outcome>([plan = workspace_.document().plan(), named, file = path.toStdString(),
                               mayBeUnsafe](const vp::Job& job) { return writeFile(*plan, named, file, mayBeUnsafe, job); },
                              [this, path](const Result<Outcome>& result) {
                                if (!result) {
                                  banner_.show(MessageBanner::Kind::Failure, style::coreText(result.error()));
                                } else if (result->isSafe) {
                                  banner_.show(MessageBanner::Kind::Success, tr("Briefing of %1 pages written to %2").arg(result->pages).arg(path));
                                } else {
                                  banner_.show(MessageBanner::Kind::Warning,
                                               tr("UNVERIFIED briefing of %1 pages written to %2").arg(result->pages).arg(path));
                                }
                                emit finished(result.has_value(), path);
                              });
}

}  // namespace vp::gui
