// crash_test [KILLS] [SEED]: kills the window's whole job at random moments and looks at what is left. After every kill: what was
// reported saved is whole and as new as reported; work that autosave had is offered at the next start; the dead one's lock is no
// obstacle; no temporary files pile up. Exit 0 if all of that held.
#include "core/formats/mission_file.h"
#include "core/formats/plan_file.h"
#include "tests/support/work_folder.h"
#include "ui/document/autosave.h"
#include "ui/document/document_files.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>
#include <cstdio>

using namespace vp;

namespace {

constexpr int kPatience = 300'000;  // ms

/// What the job has told so far, over all its lives.
struct Told {
  int edited = 0;
  int saved = 0;  ///< number of the last work that was reported saved
  int kept = 0;   ///< the same of autosave
  QString last;
};

void hear(const QByteArray& output, Told& told) {
  for (const QByteArray& line : output.split('\n')) {
    const QList<QByteArray> words = line.split(' ');
    if (line.isEmpty()) {
      continue;
    }
    told.last = QString::fromUtf8(line);
    int* number = words[0] == "saved" ? &told.saved : words[0] == "kept" ? &told.kept : words[0] == "edited" ? &told.edited : nullptr;
    if (number != nullptr && words.size() > 1) {
      *number = std::max(*number, words[1].toInt());
    }
  }
}

int numberOf(const std::string& name) {
  return name.starts_with("work ") ? std::atoi(name.c_str() + 5) : 0;
}

class CrashTest {
public:
  explicit CrashTest(unsigned seed) : random_(seed) {
    environment_ = QProcessEnvironment::systemEnvironment();
    for (const auto& [name, place] : {std::pair{"HOME", "home"}, std::pair{"XDG_CONFIG_HOME", "home/config"}, std::pair{"XDG_DATA_HOME", "home/data"},
                                      std::pair{"XDG_CACHE_HOME", "home/cache"}, std::pair{"TMPDIR", "tmp"}, std::pair{"XDG_RUNTIME_DIR", "run"}}) {
      QDir().mkpath(root_.filePath(QLatin1String(place)));
      environment_.insert(QLatin1String(name), root_.filePath(QLatin1String(place)));
    }
    QFile::setPermissions(root_.filePath(QStringLiteral("run")), QFile::Permissions(0x7700));
    environment_.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    test::makeWorkFolder(folder());
  }

  /// The whole job without a kill, for its length and for the end. @return whether it ended well
  bool runToItsEnd(int cycles) {
    QProcess process;
    start(process, {folder(), QString::number(cycles)});
    QElapsedTimer clock;
    clock.start();
    const bool isDone = process.waitForFinished(kPatience) && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    length_ = static_cast<double>(clock.elapsed());
    hear(process.readAllStandardOutput(), told_);
    return check(isDone && told_.last == QStringLiteral("closed"),
                 QStringLiteral("the whole job, unkilled, ends with: ") + told_.last + QString::fromUtf8(process.readAllStandardError()));
  }
  [[nodiscard]] double length() const { return length_; }

  bool killOnce(int round) {
    QProcess process;
    start(process, {folder()});
    const double delay = length_ * random_.generateDouble();
    QThread::usleep(static_cast<unsigned long>(delay * 1e3));
    process.kill();
    process.waitForFinished(kPatience);
    const QByteArray output = process.readAllStandardOutput();
    const Told before = told_;
    told_.last = QStringLiteral("started");
    hear(output, told_);
    bool isGood = check(process.exitStatus() == QProcess::CrashExit, QStringLiteral("it ended by itself: ") + QString::fromUtf8(output));
    isGood = checkStart(output, before) && isGood;
    isGood = checkFiles() && isGood;
    std::printf("%4d  killed after %6.2f s, last heard: %-26s  %s\n", round, delay / 1e3, qPrintable(told_.last), isGood ? "ok" : "FAILED");
    std::fflush(stdout);
    return isGood;
  }

  /// After a proper end nothing is left but the job's own files.
  bool checkNothingLeft() {
    bool isGood = true;
    QDirIterator entry(root_.path(), QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (entry.hasNext()) {
      const QString file = entry.next();
      const QString name = QFileInfo(file).fileName();
      const bool isLeft = name.startsWith(QStringLiteral(".volplane-")) || name.endsWith(QStringLiteral(".lock")) ||
                          name.endsWith(QStringLiteral(".recovery")) || file.startsWith(root_.filePath(QStringLiteral("tmp/")));
      isGood = check(!isLeft, QStringLiteral("left behind: ") + file) && isGood;
    }
    return isGood;
  }

private:
  [[nodiscard]] QString folder() const { return root_.filePath(QStringLiteral("flights")); }
  static bool check(bool holds, const QString& what) {
    if (!holds) {
      std::printf("FAILED: %s\n", qPrintable(what.simplified()));
    }
    return holds;
  }

  void start(QProcess& process, const QStringList& arguments) const {
    process.setProcessEnvironment(environment_);
    process.start(QStringLiteral(VOLPLANE_BIN_DIR "/crash_victim"), arguments);
    process.waitForStarted(kPatience);
  }

  /// What the start after a kill showed, if it came that far.
  bool checkStart(const QByteArray& output, const Told& before) const {
    const int owed = std::max(before.saved, before.kept);
    for (const QByteArray& line : output.split('\n')) {
      if (line.startsWith("recovered ") || line.startsWith("opened ")) {
        const int found = line.split(' ').value(1).toInt();
        return check(found >= owed, QStringLiteral("the start shows work %1, but %2 had been saved or kept").arg(found).arg(owed)) &&
               check(found <= before.edited, QStringLiteral("the start shows work that nobody did"));
      }
    }
    return true;
  }

  /// Files are whole; what was kept is somewhere; little is left over.
  bool checkFiles() const {
    bool isGood = true;
    int best = 0;
    const std::string path = folder().toStdString();
    const Result<mission::Mission> mission = formats::readDraft(path + "/job.vpm");
    isGood = check(mission.has_value(), QStringLiteral("job.vpm: ") + (mission ? QString() : QString::fromStdString(mission.error().message())));
    if (mission) {
      best = numberOf(mission->name);
      isGood = check(best >= told_.saved, QStringLiteral("job.vpm holds work %1, but %2 was reported saved").arg(best).arg(told_.saved)) && isGood;
    }
    if (QFile::exists(folder() + QStringLiteral("/job.vpp"))) {
      const Result<mission::Plan> plan = formats::readPlan(path + "/job.vpp");
      isGood = check(plan && plan->certificate, QStringLiteral("job.vpp: ") + (plan ? QString() : QString::fromStdString(plan.error().message()))) &&
               isGood;
    }
    isGood = checkEnds(QStringLiteral("job.gpx"), "</gpx>") && checkEnds(QStringLiteral("job.pdf"), "%%EOF") && isGood;
    int recoveries = 0;
    int temporaries = 0;
    QDirIterator entry(root_.path(), QDir::Files | QDir::Hidden | QDir::System, QDirIterator::Subdirectories);
    while (entry.hasNext()) {
      const QString file = entry.next();
      temporaries += QFileInfo(file).fileName().startsWith(QStringLiteral(".volplane-")) ? 1 : 0;
      if (file.endsWith(QStringLiteral(".recovery"))) {
        ++recoveries;
        QFile kept(file);
        const Result<document::DocumentContents> contents =
            kept.open(QIODevice::ReadOnly) ? document::readRecoveryText(kept.readAll().toStdString()) : fail(Errc::BadFile, "cannot be opened");
        isGood = check(contents.has_value(), file + (contents ? QString() : QString::fromStdString(contents.error().message()))) && isGood;
        best = std::max(best, contents ? numberOf(contents->mission->name) : 0);
      }
    }
    isGood =
        check(best >= told_.kept, QStringLiteral("work %1 was kept by autosave, but the newest found is %2").arg(told_.kept).arg(best)) && isGood;
    isGood = check(recoveries <= 2, QStringLiteral("%1 copies of unsaved work").arg(recoveries)) && isGood;  // that of the one before, and its own
    return check(temporaries <= 3, QStringLiteral("%1 temporary files").arg(temporaries)) && isGood;         // of this kill alone
  }

  [[nodiscard]] bool checkEnds(const QString& name, const char* ending) const {
    QFile file(folder() + QLatin1Char('/') + name);
    return !file.exists() ||
           check(file.open(QIODevice::ReadOnly) && file.readAll().trimmed().endsWith(ending), name + QStringLiteral(" is not whole"));
  }

  QTemporaryDir root_;
  QProcessEnvironment environment_;
  QRandomGenerator random_;
  Told told_;
  double length_ = 0.0;  ///< ms
};

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  const int kills = argc > 1 ? QByteArray(argv[1]).toInt() : 100;
  const unsigned seed = argc > 2 ? QByteArray(argv[2]).toUInt() : 1;
  if (kills < 1) {
    std::fputs("crash_test [KILLS] [SEED]\n", stderr);
    return 2;
  }
  constexpr int kCycles = 3;  // once of each kind: saved, exported, kept by autosave
  CrashTest test(seed);
  bool isGood = test.runToItsEnd(kCycles);
  std::printf("%d kills within %.1f s of the job's start, seed %u\n", kills, test.length() / 1e3, seed);
  for (int round = 1; round <= kills && isGood; ++round) {
    isGood = test.killOnce(round);
  }
  isGood = isGood && test.runToItsEnd(1) && test.checkNothingLeft();
  std::puts(isGood ? "nothing that was saved or kept was lost" : "FAILED");
  return isGood ? 0 : 1;
}
