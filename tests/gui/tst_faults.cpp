// What the window does when the machine fails it: full disk, read-only or vanished folder, terrain gone or replaced while it is
// open, a mission that another program has open or has changed, no OpenGL. Every time the work stays, and a sentence says why.
#include "app/gui/briefing_controller.h"
#include "app/gui/export_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "app/gui/preferences_controller.h"
#include "tests/gui/operator.h"
#include "tests/support/faults.h"
#include "tests/support/work_folder.h"
#include "ui/document/document_lock.h"
#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QFileInfo>
#include <QLabel>
#include <QProcess>
#include <QSysInfo>
#include <QTableWidget>
#include <QTemporaryDir>

#include <filesystem>
#include <memory>

using namespace vp;
using namespace vp::test;
using dialogs::MessageBanner;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr int kLong = 120'000;  // ms; patience, not a measurement

/// Presses a button of the next message box. @return its whole text, once it was there
std::shared_ptr<QString> answerBox(const QString& button) {
  auto said = std::make_shared<QString>();
  auto* timer = new QTimer(qApp);
  QObject::connect(timer, &QTimer::timeout, timer, [timer, button, said] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) {
      return;
    }
    timer->stop();
    timer->deleteLater();
    *said = box->windowTitle() + ": " + box->text() + ' ' + box->informativeText();
    for (QAbstractButton* one : box->buttons()) {
      if (one->text().remove(QLatin1Char('&')).contains(button)) {
        one->click();
        return;
      }
    }
    *said += QStringLiteral(" [has no button %1]").arg(button);
    box->reject();
  });
  timer->start(20);
  return said;
}

}  // namespace

class TestFaults : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<SmallDisk> disk_;
  std::unique_ptr<gui::MainWindow> window_;
  QString mission_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] document::MissionDocument& document() const { return window_->workspace().document(); }
  [[nodiscard]] QString banner() const { return window_->banner().isVisible() ? window_->banner().text() : QString(); }
  void rename(const char* name) const {
    document().edit(QStringLiteral("Name"), [name](mission::Mission& m) { m.name = name; });
  }
  void open(const QString& path) const {
    window_->take({path});
    QTRY_COMPARE_WITH_TIMEOUT(document().path(), path, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle && desk().situation().sites != nullptr, kLong);
  }
  void plan() const {
    window_->action(QStringLiteral("planStart"))->trigger();
    QCOMPARE(desk().activity(), Activity::Planning);
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr && desk().activity() == Activity::Idle, kLong);
    QVERIFY2(desk().situation().plan->isVerified(), qPrintable(banner()));
  }
  /// Saves, expecting to be refused by a message box. @return what that says
  [[nodiscard]] QString refusedSave() const {
    const auto said = answerBox(QStringLiteral("OK"));
    window_->action(QStringLiteral("fileSave"))->trigger();
    [said] { QTRY_VERIFY_WITH_TIMEOUT(!said->isEmpty(), kLong); }();
    [this] { QTRY_VERIFY_WITH_TIMEOUT(!window_->files().isBusy(), kLong); }();
    return *said;
  }
  void save() const {
    window_->action(QStringLiteral("fileSave"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!document().isModified(), kLong);
  }

private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    qputenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent");  // no OpenGL in all of this
  }

  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(QFile::setPermissions(folder_->path(), QFile::Permissions(0x7755)));
    disk_ = std::make_unique<SmallDisk>(folder_->filePath(QStringLiteral("drive")), 8192);
    mission_ = makeWorkFolder(disk_->path(QStringLiteral("flights")));
    QVERIFY(!mission_.isEmpty());
    window_ = std::make_unique<gui::MainWindow>(folder_->filePath(QStringLiteral("settings.ini")));
    window_->show();
  }
  void cleanup() {
    window_.reset();
    disk_.reset();
    folder_.reset();
  }

  void saving_onAFullDisk_saysSo_keepsTheFileAndTheWork() {
    open(mission_);
    plan();
    save();
    rename("later");
    plan();
    disk_->fill();
    const auto before = contentsOf(disk_->folder());
    const QString said = refusedSave();
    QVERIFY2(said.contains(QString::fromLatin1(disk_->fullWords())) && said.contains(QFileInfo(mission_).path()), qPrintable(said));
    QVERIFY(contentsOf(disk_->folder()) == before);  // neither the plan without its mission nor half a file
    QVERIFY(document().isModified() && document().plan() != nullptr);
    disk_->free();
    save();
    QVERIFY(contentsOf(disk_->folder()).value(QStringLiteral("flights/job.vpm")).contains("\"later\""));
  }

  void autosave_onAFullDisk_saysSoOnce_andWorksAgainWhenThereIsRoom() {
    window_.reset();
    window_ = std::make_unique<gui::MainWindow>(disk_->path(QStringLiteral("settings.ini")));
    window_->show();
    open(mission_);
    disk_->fill();
    rename("unsaved");
    QTRY_VERIFY_WITH_TIMEOUT(banner().contains(QStringLiteral("cannot be kept")), kLong);
    QVERIFY2(banner().contains(QString::fromLatin1(disk_->fullWords())) && banner().contains(QStringLiteral("save the mission")),
             qPrintable(banner()));
    QCOMPARE(document().mission().name, std::string("unsaved"));
    disk_->free();
    save();
  }

  void settings_onAFullDisk_applyAndSayThatTheyWillBeForgotten() {
    window_.reset();
    const QString ini = disk_->path(QStringLiteral("settings.ini"));
    window_ = std::make_unique<gui::MainWindow>(ini);
    window_->show();
    disk_->fill();
    window_->preferences().setUnits(style::UnitSystem::Metric);
    QVERIFY2(banner().contains(QStringLiteral("settings cannot be remembered")) && banner().contains(ini), qPrintable(banner()));
    QVERIFY(desk().view().units().system() == style::UnitSystem::Metric);
    disk_->free();
  }

  void exportPictureAndBriefing_onAFullDisk_sayWhyAndLeaveNothing() {
    open(mission_);
    plan();
    save();
    disk_->fill();
    const auto before = contentsOf(disk_->folder());
    const auto fails = [&](const QString& name) {
      QTRY_VERIFY_WITH_TIMEOUT(banner().contains(name), kLong);
      QVERIFY2(window_->banner().kind() == MessageBanner::Kind::Failure && banner().contains(QString::fromLatin1(disk_->fullWords())),
               qPrintable(banner()));
      QVERIFY(contentsOf(disk_->folder()) == before);
    };
    auto* exports = window_->findChild<gui::ExportController*>();
    exports->exportTo("gpx", disk_->path(QStringLiteral("tour.gpx")));
    fails(QStringLiteral("tour.gpx"));
    exports->exportTo("map", disk_->path(QStringLiteral("tour.png")));
    fails(QStringLiteral("tour.png"));
    window_->briefings().write({}, disk_->path(QStringLiteral("tour.pdf")), false);
    fails(QStringLiteral("tour.pdf"));
    disk_->free();
  }

  void saving_withoutPermission_saysSo_andElsewhereWorks() {
    open(mission_);
    rename("not mine to write");
    const auto before = contentsOf(disk_->folder());
    QString said;
    if (::geteuid() == 0) {
      const AsNobody nobody;
      QVERIFY(nobody.isHeld());
      said = refusedSave();
    } else {
      QVERIFY(QFile::setPermissions(QFileInfo(mission_).path(), QFile::Permissions(0x5555)));
      said = refusedSave();
      QFile::setPermissions(QFileInfo(mission_).path(), QFile::Permissions(0x7755));
    }
    QVERIFY2(said.contains(QStringLiteral("job.vpm")) && said.contains(QStringLiteral("no permission")), qPrintable(said));
    QVERIFY(contentsOf(disk_->folder()) == before);
    QVERIFY(document().isModified());
    const QString elsewhere = folder_->filePath(QStringLiteral("mine.vpm"));
    window_->files().saveTo(elsewhere);
    QTRY_COMPARE_WITH_TIMEOUT(document().path(), elsewhere, kLong);
    QVERIFY(!document().isModified());
  }

  void missionOnAReadOnlyDrive_isOpened_andSavingSaysWhyNot() {
    disk_->makeReadOnly();
    const auto before = contentsOf(disk_->folder());
    if (::geteuid() != 0) {
      QSKIP("only root may mount a drive; permissions are tried above");
    }
    open(mission_);
    rename("read-only");
    const QString said = refusedSave();
    QVERIFY2(said.contains(QStringLiteral("read-only")), qPrintable(said));
    QVERIFY(contentsOf(disk_->folder()) == before);
    QVERIFY(document().isModified());
    disk_->makeWritable();
    save();  // the drive is writable again
  }

  void folderThatVanished_isNamed_andTheWorkIsKeptForTheCaseOfACrash() {
    open(mission_);
    rename("only here");
    QVERIFY(QDir(QFileInfo(mission_).path()).removeRecursively());
    const QString said = refusedSave();
    QVERIFY2(said.contains(mission_) && said.contains(QStringLiteral("no such folder")), qPrintable(said));
    QVERIFY(document().isModified());
    const auto kept = [this] {
      for (const QByteArray& bytes : contentsOf(folder_->filePath(QStringLiteral("recovery")))) {
        if (bytes.contains("only here")) {
          return true;
        }
      }
      return false;
    };
    QTRY_VERIFY_WITH_TIMEOUT(kept(), kLong);
    QVERIFY(QDir().mkpath(QFileInfo(mission_).path()));  // the drive is back
    save();
    QVERIFY(QFile::exists(mission_));
  }

  void terrainThatVanished_isNamedBeforePlanningAndExporting() {
    open(mission_);
    plan();
    QVERIFY(QFile::remove(disk_->path(QStringLiteral("flights/mountain.tif"))));
    QStringList remarks;
    inDialog(QStringLiteral("exportReview"), [&remarks](QDialog& dialog) {
      for (const QLabel* label : dialog.findChildren<QLabel*>()) {
        remarks << label->text();
      }
      dialog.reject();
    });
    window_->findChild<gui::ExportController*>()->exportTo("fms", disk_->path(QStringLiteral("tour.fms")));
    QTRY_VERIFY_WITH_TIMEOUT(!remarks.isEmpty(), kLong);
    QVERIFY2(remarks.join(' ').contains(QStringLiteral("mountain.tif")) && remarks.join(' ').contains(QStringLiteral("there is no such file")),
             qPrintable(remarks.join('|')));
    QVERIFY(!QFile::exists(disk_->path(QStringLiteral("tour.fms"))));
    window_->action(QStringLiteral("planStart"))->trigger();
    QVERIFY2(banner().contains(QStringLiteral("terrain files have changed")), qPrintable(banner()));
    QTRY_VERIFY_WITH_TIMEOUT(banner().contains(QStringLiteral("mountain.tif")), kLong);
    QVERIFY2(window_->banner().kind() == MessageBanner::Kind::Failure, qPrintable(banner()));
    QVERIFY(document().plan() != nullptr);  // not drawn any more, but not lost
  }

  void terrainThatWasReplaced_isToldBeforePlanningAndExporting() {
    open(mission_);
    plan();
    const QString terrain = disk_->path(QStringLiteral("flights/mountain.tif"));
    QFile old(terrain);
    QVERIFY(old.open(QIODevice::ReadOnly));
    const QByteArray bytes = old.readAll();
    const QDateTime time = QFileInfo(terrain).lastModified();
    old.close();
    QFile other(terrain + ".new");
    QVERIFY(other.open(QIODevice::WriteOnly));
    QVERIFY(bytes.contains("Local metric frame"));
    other.write(QByteArray(bytes).replace("Local metric frame", "Other metric frame"));  // as long and as old as the one before
    QVERIFY(other.flush() && other.setFileTime(time, QFileDevice::FileModificationTime));
    other.close();
    std::filesystem::rename((terrain + ".new").toStdString(), terrain.toStdString());
    QCOMPARE(QFileInfo(terrain).lastModified(), time);
    QStringList remarks;
    inDialog(QStringLiteral("exportReview"), [&remarks](QDialog& dialog) {
      for (const QLabel* label : dialog.findChildren<QLabel*>()) {
        remarks << label->text();
      }
      dialog.reject();
    });
    window_->findChild<gui::ExportController*>()->exportTo("fms", disk_->path(QStringLiteral("tour.fms")));
    QTRY_VERIFY_WITH_TIMEOUT(!remarks.isEmpty(), kLong);
    QVERIFY2(remarks.join(' ').contains(QStringLiteral("is not the terrain that the plan was made with")), qPrintable(remarks.join('|')));
    window_->briefings().write({}, disk_->path(QStringLiteral("tour.pdf")), false);
    QTRY_VERIFY_WITH_TIMEOUT(banner().contains(QStringLiteral("no briefing was written")), kLong);
    QVERIFY2(banner().contains(QStringLiteral("is not the terrain that the plan was made with")), qPrintable(banner()));
    window_->action(QStringLiteral("planStart"))->trigger();
    QVERIFY2(banner().contains(QStringLiteral("terrain files have changed")), qPrintable(banner()));
  }

  void missionThatAnotherProgramHasOpen_isAskedAboutWithItsOwner_data() {
    QTest::addColumn<QString>("button");
    QTest::newRow("copy") << QStringLiteral("Open a copy");
    QTest::newRow("anyway") << QStringLiteral("Open anyway");
    QTest::newRow("called off") << QStringLiteral("Cancel");
  }

  void missionThatAnotherProgramHasOpen_isAskedAboutWithItsOwner() {
    QFETCH(QString, button);
    QProcess holder;
    holder.start(QStringLiteral(VOLPLANE_BIN_DIR "/lock_holder"), {mission_});
    QVERIFY(holder.waitForStarted() && holder.waitForReadyRead());
    const auto answer = answerBox(button);
    window_->take({mission_});
    QTRY_VERIFY_WITH_TIMEOUT(!answer->isEmpty(), kLong);
    const QString said = *answer;
    QVERIFY2(said.contains(QStringLiteral("job.vpm")) && said.contains(QSysInfo::machineHostName()) &&
                 said.contains(QString::number(holder.processId())) && said.contains(QStringLiteral("since")) && !said.contains('['),
             qPrintable(said));
    if (button == QStringLiteral("Cancel")) {
      QTest::qWait(0);
      QVERIFY(document().path().isEmpty() && document().mission().targets.empty());
    } else if (button == QStringLiteral("Open anyway")) {
      QCOMPARE(document().path(), mission_);
    } else {
      QVERIFY2(document().path().isEmpty(), "saving asks for another name");
      QCOMPARE(document().mission().targets.size(), std::size_t(5));
      QVERIFY2(banner().contains(QStringLiteral("copy")) && banner().contains(QString::number(holder.processId())), qPrintable(banner()));
    }
    holder.kill();
    holder.waitForFinished();
  }

  void missionOfAKilledProgram_isOpenedAtOnce_andLockedMeanwhile() {
    QProcess holder;
    holder.start(QStringLiteral(VOLPLANE_BIN_DIR "/lock_holder"), {mission_});
    QVERIFY(holder.waitForStarted() && holder.waitForReadyRead());
    holder.kill();
    QVERIFY(holder.waitForFinished());
    open(mission_);
    const QString lock = document::DocumentLock::lockFileOf(mission_);
    QVERIFY(QFile::exists(lock));
    window_->files().startNew();
    QVERIFY2(!QFile::exists(lock), "let go of with the document");
  }

  void missionThatWasChangedOnDisk_isNotOverwrittenUnasked() {
    open(mission_);
    rename("from the window");
    QFile file(mission_);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QByteArray theirs = file.readAll();
    theirs.replace("\"T05\"", "\"THEIRS\"");
    QVERIFY(file.resize(0) && file.seek(0) && file.write(theirs) == theirs.size());
    file.close();
    const auto said = answerBox(QStringLiteral("Cancel"));
    window_->action(QStringLiteral("fileSave"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!said->isEmpty() && !window_->files().isBusy(), kLong);
    QVERIFY2(said->contains(QStringLiteral("has been changed on disk")) && !said->contains('['), qPrintable(*said));
    QVERIFY(contentsOf(disk_->folder()).value(QStringLiteral("flights/job.vpm")) == theirs);
    QVERIFY(document().isModified());
    answerBox(QStringLiteral("Overwrite"));
    save();
    QVERIFY(contentsOf(disk_->folder()).value(QStringLiteral("flights/job.vpm")).contains("from the window"));
    rename("and again");
    save();  // no question: nobody but this window has written since
  }

  void planOfANewerProgram_besideTheMission_isLeftAloneAndTold() {
    QFile newer(disk_->path(QStringLiteral("flights/job.vpp")));
    QVERIFY(newer.open(QIODevice::WriteOnly));
    newer.write("{\"format\": \"volplane-plan\", \"version\": 99}");
    newer.close();
    open(mission_);
    QVERIFY2(desk().notes().join(' ').contains(QStringLiteral("newer Volplane")), qPrintable(desk().notes().join('|')));
    QVERIFY(document().plan() == nullptr);
  }

  void withoutOpenGl_theWindowPlans_andSaysInPlaceOfThe3dViewWhy() {
    open(mission_);
    window_->action(QStringLiteral("viewScene"))->trigger();
    QVERIFY(window_->sceneView() != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->sceneView()->problem().isEmpty(), kLong);
    const auto says = [this] {
      for (const QLabel* label : window_->sceneView()->findChildren<QLabel*>()) {
        if (label->isVisible() && label->text().contains(QStringLiteral("OpenGL"))) {
          return true;
        }
      }
      return false;
    };
    QTRY_VERIFY2(says(), qPrintable(window_->sceneView()->problem()));
    plan();
  }
};

QTEST_MAIN(TestFaults)
#include "tst_faults.moc"
