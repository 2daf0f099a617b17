// The window's whole job over and over, told line by line, until it is killed: welcome, edit, plan, stop, save, export, brief.
// crash_victim FOLDER [CYCLES]: works on FOLDER/job.vpm; with CYCLES it closes properly after so many.
#include "app/gui/briefing_controller.h"
#include "app/gui/export_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "ui/document/autosave.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QTimer>

#include <cstdio>
#include <functional>
#include <unistd.h>

using namespace vp;
using Activity = jobs::Workspace::Activity;

namespace {

void say(const QString& line) {
  std::puts(qPrintable(line));
  std::fflush(stdout);
}

/// Nothing may be asked in this job; whatever is would wait for ever.
void refuseQuestions() {
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [] {
    if (const QWidget* asking = QApplication::activeModalWidget()) {
      const auto* box = qobject_cast<const QMessageBox*>(asking);
      say(QStringLiteral("asked ") + (box != nullptr ? box->text().simplified() : asking->windowTitle()));
      ::_exit(3);
    }
  });
  timer->start(50);
}

void waitFor(const std::function<bool()>& reached) {
  while (!reached()) {
    QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
}

class WholeJob {
public:
  explicit WholeJob(QString folder) : folder_(std::move(folder)), heartbeat_() { heartbeat_.start(20); }

  void begin() {
    window_.show();
    window_.welcome();
    waitFor([this] { return !window_.files().isBusy() && (!path().isEmpty() || document().isModified()); });
    if (document().isModified()) {
      count_ = numberOf(QString::fromStdString(document().mission().name));
      say(QStringLiteral("recovered %1").arg(count_));
    } else if (path() != mission()) {  // the example, at the very first start
      window_.take({mission()});
      waitFor([this] { return path() == mission(); });
    }
    if (!document().isModified()) {
      count_ = numberOf(QString::fromStdString(document().mission().name));
      say(QStringLiteral("opened %1").arg(count_));
    }
    waitFor([this] { return desk().activity() == Activity::Idle && desk().situation().sites != nullptr; });
  }

  void cycle() {
    ++count_;
    document().edit(QStringLiteral("Name"), [this](mission::Mission& m) { m.name = "work " + std::to_string(count_); });
    say(QStringLiteral("edited %1").arg(count_));
    plan(true);
    plan(false);
    switch (count_ % 3) {
      case 0:
        keep();
        break;
      case 1:
        save();
        exportAndBrief();
        break;
      default:
        save();
        break;
    }
  }

  void end() {
    save();
    window_.close();
    waitFor([this] { return !window_.isVisible(); });
    say(QStringLiteral("closed"));
  }

private:
  [[nodiscard]] jobs::Workspace& desk() { return window_.workspace(); }
  [[nodiscard]] document::MissionDocument& document() { return window_.workspace().document(); }
  [[nodiscard]] QString path() { return document().path(); }
  [[nodiscard]] QString mission() const { return folder_ + QStringLiteral("/job.vpm"); }
  static int numberOf(const QString& name) { return name.startsWith(QStringLiteral("work ")) ? name.mid(5).toInt() : 0; }

  void plan(bool isStopped) {
    say(QStringLiteral("planning %1").arg(count_));
    window_.action(QStringLiteral("planStart"))->trigger();
    if (isStopped) {
      window_.action(QStringLiteral("planStop"))->trigger();
    }
    waitFor([this] { return desk().activity() == Activity::Idle; });
  }

  void save() {
    say(QStringLiteral("saving %1").arg(count_));
    window_.files().saveTo(mission());
    waitFor([this] { return !document().isModified() && !window_.files().isBusy(); });
    say(QStringLiteral("saved %1").arg(count_));
  }

  /// Leaves the work unsaved until autosave has it.
  void keep() {
    say(QStringLiteral("waiting for autosave %1").arg(count_));
    const QByteArray words = "\"work " + QByteArray::number(count_) + '"';
    const QDir recovery(document::Autosave::defaultFolder());
    waitFor([&] {
      for (const QString& name : recovery.entryList({QStringLiteral("%1-*.recovery").arg(QCoreApplication::applicationPid())}, QDir::Files)) {
        QFile file(recovery.filePath(name));
        if (file.open(QIODevice::ReadOnly) && file.readAll().contains(words)) {
          return true;
        }
      }
      return false;
    });
    say(QStringLiteral("kept %1").arg(count_));
  }

  void exportAndBrief() {
    bool isDone = false;
    auto* exports = window_.findChild<gui::ExportController*>();
    say(QStringLiteral("exporting"));
    const auto exported = QObject::connect(exports, &gui::ExportController::finished, [&isDone](bool written) { isDone = written; });
    exports->exportTo("gpx", folder_ + QStringLiteral("/job.gpx"));
    waitFor([&isDone] { return isDone; });
    say(QStringLiteral("exported"));
    QObject::disconnect(exported);
    isDone = false;
    const auto briefed = QObject::connect(&window_.briefings(), &gui::BriefingController::finished, [&isDone](bool written) { isDone = written; });
    window_.briefings().write({}, folder_ + QStringLiteral("/job.pdf"), false);
    waitFor([&isDone] { return isDone; });
    say(QStringLiteral("briefed"));
    QObject::disconnect(briefed);
  }

  QString folder_;
  gui::MainWindow window_;
  QTimer heartbeat_;  ///< so that waiting looks again
  int count_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication::setOrganizationName(QStringLiteral("Volplane"));
  QCoreApplication::setApplicationName(QStringLiteral("volplane"));
  QApplication application(argc, argv);
  if (argc < 2) {
    std::fputs("crash_victim FOLDER [CYCLES]\n", stderr);
    return 2;
  }
  refuseQuestions();
  WholeJob job(QString::fromLocal8Bit(argv[1]));
  job.begin();
  const int cycles = argc > 2 ? QByteArray(argv[2]).toInt() : -1;
  for (int i = 0; cycles < 0 || i < cycles; ++i) {
    job.cycle();
  }
  job.end();
  return 0;
}
