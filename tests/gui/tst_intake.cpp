// Files that are dropped on the window: targets are chosen from, doubtful files asked about, and what is wrong is told in one sentence.
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "tests/gui/operator.h"

#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>

#include <csignal>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

using namespace vp;
using dialogs::MessageBanner;
using test::answerMessageBox;
using test::drop;
using test::inDialog;

namespace {

constexpr int kLong = 120'000;  // ms; a guard against hanging

}  // namespace

class TestIntake : public QObject {
  Q_OBJECT

private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<gui::MainWindow>(folder_->filePath(QStringLiteral("settings.ini")));
    hasRead_ = false;
    connect(&window_->files(), &gui::FileController::working, this, [this](const QString& text) { hasRead_ = hasRead_ || !text.isEmpty(); });
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void cleanup() { window_.reset(); }

  void someOfManyTargets_areChosenAndUndoneInOneStep() {
    QByteArray text = "name,latitude,longitude,height_m\n";
    for (int i = 0; i < 900; ++i) {
      text += "W" + QByteArray::number(i) + ",46." + QByteArray::number(1000 + i) + ",9.5,150\n";
    }
    desk().document().edit(QStringLiteral("Add target"), [](mission::Mission& m) {
      m.targets.push_back({"W10", {47.0, 9.0}, 100.0, mission::HeightReference::AboveGround});
    });
    inDialog(QStringLiteral("importTargetsDialog"), [](QDialog& dialog) {
      dialog.findChild<QPushButton*>(QStringLiteral("importNone"))->click();
      dialog.findChild<QLineEdit*>(QStringLiteral("importSearch"))->setText(QStringLiteral("W10"));
      dialog.findChild<QPushButton*>(QStringLiteral("importAll"))->click();
      dialog.accept();
    });
    drop(*window_, {write("ways.csv", text)});
    QTRY_COMPARE_WITH_TIMEOUT(targets().size(), std::size_t(12), kLong);  // W10, W100 to W109 and the one that was there
    QCOMPARE(targets()[1].name, std::string("W10 2"));
    QCOMPARE(targets()[2].height_m, 150.0);
    QVERIFY2(banner().text().startsWith(QStringLiteral("11 target(s) imported from ways.csv")), qPrintable(banner().text()));
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Import targets from ways.csv"));
    desk().document().undoStack().undo();
    QCOMPARE(targets().size(), std::size_t(1));
    QVERIFY(!window_->files().isBusy());
  }

  void doubtfulFile_isAskedAbout_data() {
    QTest::addColumn<QString>("answer");
    QTest::addColumn<int>("airfields");
    QTest::addColumn<int>("dialogs");
    QTest::newRow("airfields") << "Airfields" << 1 << 0;
    QTest::newRow("targets") << "Targets" << 0 << 1;
    QTest::newRow("left out") << "Leave" << 0 << 0;
  }

  void doubtfulFile_isAskedAbout() {
    QFETCH(QString, answer);
    QFETCH(int, airfields);
    QFETCH(int, dialogs);
    int shown = 0;
    if (dialogs > 0) {
      inDialog(QStringLiteral("importTargetsDialog"), [&shown](QDialog& dialog) {
        ++shown;
        dialog.reject();
      });
    }
    answerMessageBox(answer);
    drop(*window_, {write("fields.csv", "name,latitude,longitude,course_deg,length_m\nStrip,46.6,9.6,120,400\n")});
    QTRY_VERIFY_WITH_TIMEOUT(hasRead_ && !window_->files().isBusy(), kLong);
    QCOMPARE(static_cast<int>(desk().document().mission().airfields.size()), airfields);
    QCOMPARE(shown, dialogs);
    QVERIFY(targets().empty());
  }

  void tooManyTargets_areRefusedInOneSentenceWhileTheWindowTurns() {
    QByteArray text = "name,latitude,longitude\n";
    for (int i = 0; i < 1'000'000; ++i) {
      text += "W,46." + QByteArray::number(1000000 + i) + ",9.5\n";
    }
    const QString file = write("world.csv", text);
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
    timer.start(0);
    QStringList told;
    connect(&window_->files(), &gui::FileController::working, this, [&told](const QString& said) { told << said; });
    window_->files().importTargets(file);
    QVERIFY(window_->files().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->files().isBusy(), kLong);
    QVERIFY(turns > 0);
    QCOMPARE(told.first(), QStringLiteral("Reading world.csv"));
    QCOMPARE(told.last(), QString());
    QVERIFY(banner().isVisible() && banner().kind() == MessageBanner::Kind::Failure);
    QVERIFY2(banner().text().contains(QStringLiteral("1000000 places")), qPrintable(banner().text()));
    QVERIFY(targets().empty() && !desk().document().isModified());
  }

  void longReading_canBeStoppedAtAClick() {
    // a file that nobody else gets open as long as it is leased (fcntl(2)), as on a drive that does not answer
    const QString slow = write("slow.csv", "name,latitude,longitude\n");
    std::signal(SIGIO, SIG_IGN);
    const int lease = ::open(qPrintable(slow), O_RDWR | O_CLOEXEC);
    QVERIFY(lease >= 0 && ::fcntl(lease, F_SETLEASE, F_WRLCK) == 0);
    window_->files().importTargets(slow);
    const auto stopButton = [this] {
      QPushButton* found = nullptr;
      for (auto* button : banner().findChildren<QPushButton*>()) {
        found = button->isVisible() && button->text() == QStringLiteral("Stop") ? button : found;
      }
      return found;
    };
    QTRY_VERIFY_WITH_TIMEOUT(stopButton() != nullptr, kLong);
    QCOMPARE(banner().text(), QStringLiteral("Reading slow.csv…"));
    stopButton()->click();
    QVERIFY(!window_->files().isBusy());
    QVERIFY(!banner().isVisible());
    window_->files().importTargets(write("ways.csv", "name,latitude,longitude\nHut,46.5,9.5\n"));
    inDialog(QStringLiteral("importTargetsDialog"), [](QDialog& dialog) { dialog.accept(); });
    QTRY_COMPARE_WITH_TIMEOUT(targets().size(), std::size_t(1), kLong);
    ::close(lease);  // so that the thread that was forgotten can end
    window_.reset();
  }

  void anotherMission_closesTheDialogAndGetsNothing() {
    inDialog(QStringLiteral("importTargetsDialog"), [this](QDialog& dialog) {
      desk().document().startNew();
      QVERIFY(!dialog.isVisible());
    });
    drop(*window_, {write("ways.csv", "name,latitude,longitude\nHut,46.5,9.5\n")});
    QTRY_VERIFY_WITH_TIMEOUT(hasRead_ && !window_->files().isBusy(), kLong);
    QVERIFY(targets().empty() && !desk().document().isModified());
  }

private:
  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] MessageBanner& banner() const { return window_->banner(); }
  [[nodiscard]] const std::vector<mission::Target>& targets() const { return desk().document().mission().targets; }
  [[nodiscard]] QString write(const QString& name, const QByteArray& bytes) const {
    QFile file(folder_->filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
      qFatal("cannot write %s", qPrintable(name));
    }
    return file.fileName();
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<gui::MainWindow> window_;
  bool hasRead_ = false;  ///< something was read, perhaps to its end
};

QTEST_MAIN(TestIntake)
#include "tst_intake.moc"
