// F1 and Help: the page that belongs to what is in front, and menus of the window as the manual names them.
#include "app/gui/help_controller.h"
#include "app/gui/main_window.h"
#include "ui/help/manual.h"
#include "ui/help/manual_window.h"
#include "ui/map/map_view.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/panels/site_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/profile/profile_view.h"
#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <QTreeWidget>

#include <memory>

using namespace vp;

namespace {

const QString kManual = QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/manual");

/// Entries as a pilot reads them: "Mission settings…" with its mnemonic is "mission settings".
QString plain(QString text) {
  return text.remove(QLatin1Char('&')).remove(QChar(0x2026)).trimmed().toLower();
}

bool hasEntry(const QList<QAction*>& actions, QStringList path) {
  const QString wanted = plain(path.takeFirst());
  return std::any_of(actions.begin(), actions.end(), [&](const QAction* action) {
    return plain(action->text()) == wanted && (path.isEmpty() || (action->menu() != nullptr && hasEntry(action->menu()->actions(), path)));
  });
}

}  // namespace

class TestHelp : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    qputenv("VOLPLANE_RESOURCES", VOLPLANE_SOURCE_DIR "/resources");
    window_ = std::make_unique<gui::MainWindow>(settings_.filePath(QStringLiteral("volplane.ini")));
    QVERIFY(window_->help().shown() == nullptr);  // a start reads nothing of the manual
    window_->show();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpp")});
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().situation().plan != nullptr, 120'000);
  }
  void cleanupTestCase() { window_.reset(); }

  void f1_opensThePageOfTheView_data() {
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QString>("page");
    QTest::newRow("map") << QString() << "map";
    QTest::newRow("profile") << "profileDock"
                             << "profile";
    QTest::newRow("decision points") << "decisionsDock"
                                     << "profile#decision-points";
    QTest::newRow("targets") << "targetsDock"
                             << "targets";
    QTest::newRow("runways") << "runwaysDock"
                             << "runways";
    QTest::newRow("engine out") << "engineOutDock"
                                << "engine-out";
    QTest::newRow("landing now") << "landingDock"
                                 << "landing-now";
    QTest::newRow("plan") << "planDock"
                          << "plan";
  }
  void f1_opensThePageOfTheView() {
    QFETCH(QString, dock);
    QFETCH(QString, page);
    QWidget* view = &window_->mapView();
    if (!dock.isEmpty()) {
      auto* found = window_->findChild<QDockWidget*>(dock);
      found->raise();
      view = found->widget();
      for (QWidget* child : view->findChildren<QWidget*>()) {  // what the focus goes to in it
        if (child->isVisible() && child->isEnabled() && child->focusPolicy() != Qt::NoFocus && view->focusPolicy() == Qt::NoFocus) {
          view = child;
          break;
        }
      }
    }
    pressF1In(view);
    QCOMPARE(shownPage(), page);
    closeManual();
  }

  void f1_in3d_opensItsPage() {
    window_->showScene(true);
    pressF1In(window_->sceneView());
    QCOMPARE(shownPage(), QStringLiteral("scene"));
    closeManual();
    window_->showScene(false);
  }

  void f1_onAPageOfAPanel_opensItsSection() {
    window_->findChild<QDockWidget*>(QStringLiteral("landingDock"))->raise();
    auto* tabs = window_->findChild<QTabWidget*>(QStringLiteral("landingTabs"));
    tabs->setCurrentIndex(1);
    QCOMPARE(gui::HelpController::pageFor(tabs->currentWidget()), QStringLiteral("landing-now#runways"));
    tabs->setCurrentIndex(0);
  }

  void dialogs_haveHelpThatOpensTheirPage_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("page");
    QTest::newRow("wind") << "editWind"
                          << "wind";
    QTest::newRow("settings") << "editSettings"
                              << "settings#safety";
    QTest::newRow("aircraft") << "editAircraft"
                              << "aircraft";
    QTest::newRow("airspace") << "editAirspaces"
                              << "airspace";
    QTest::newRow("preferences") << "editPreferences"
                                 << "preferences";
    QTest::newRow("briefing") << "fileBriefing"
                              << "briefing";
    QTest::newRow("export") << "exportSeveral"
                            << "exports";
    QTest::newRow("safe altitudes") << "export-safe-altitude"
                                    << "exports#lowest-safe-altitude-map";
    QTest::newRow("terrain") << "fileFetchTerrain"
                             << "fetching#terrain";
    QTest::newRow("jump") << "viewJump"
                          << "map#finding-places";
  }
  void dialogs_haveHelpThatOpensTheirPage() {
    QFETCH(QString, action);
    QFETCH(QString, page);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().roadmap() != nullptr, 120'000);
    QString byButton;
    QString byKey;
    QTimer::singleShot(0, window_.get(), [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) {
        return;
      }
      if (auto* box = dialog->findChild<QDialogButtonBox*>(); box != nullptr && box->button(QDialogButtonBox::Help) != nullptr) {
        box->button(QDialogButtonBox::Help)->click();
        byButton = shownPage();
        closeManual();
      }
      QTest::keyClick(dialog, Qt::Key_F1);
      byKey = shownPage();
      closeManual();
      dialog->reject();
    });
    window_->action(action)->trigger();
    QCOMPARE(byButton, page);
    QCOMPARE(byKey.section(QLatin1Char('#'), 0, 0), page.section(QLatin1Char('#'), 0, 0));
  }

  void everyPageOfTheTable_isInTheManual() {
    const Result<help::Manual> manual = help::Manual::open(kManual);
    QVERIFY(manual);
    for (const QString& entry : gui::HelpController::allPages()) {
      const Result<help::Page> page = manual->page(entry.section(QLatin1Char('#'), 0, 0));
      QVERIFY2(page, qPrintable(entry));
      const QString anchor = entry.section(QLatin1Char('#'), 1);
      QVERIFY2(
          anchor.isEmpty() || std::any_of(page->headings.begin(), page->headings.end(), [&](const help::Heading& h) { return h.anchor == anchor; }),
          qPrintable(entry));
    }
  }

  void menusNamedInTheManual_areInTheWindow() {
    static const QRegularExpression entry(QStringLiteral("\\*\\*([^*>]+(?: > [^*>]+)+)\\*\\*"));
    int count = 0;
    for (const QString& name : QDir(kManual).entryList({QStringLiteral("*.md")})) {
      QFile file(kManual + QLatin1Char('/') + name);
      QVERIFY(file.open(QIODevice::ReadOnly));
      const QString text = QString::fromUtf8(file.readAll());
      for (auto found = entry.globalMatch(text); found.hasNext(); ++count) {
        const QString path = found.next().captured(1);
        QVERIFY2(hasEntry(window_->menuBar()->actions(), path.split(QStringLiteral(" > "))), qPrintable(name + QStringLiteral(": ") + path));
      }
    }
    QVERIFY(count > 50);
  }

  void manual_goesBackAndForthAndSearches() {
    window_->help().show(QStringLiteral("wind"));
    help::ManualWindow* manual = window_->help().shown();
    auto* text = manual->findChild<QTextBrowser*>(QStringLiteral("manualText"));
    QVERIFY(text->toPlainText().contains(QStringLiteral("METAR")));
    auto* contents = manual->findChild<QTreeWidget*>(QStringLiteral("manualContents"));
    QCOMPARE(contents->currentItem()->text(0), QStringLiteral("Wind"));
    QVERIFY(contents->currentItem()->childCount() > 2);  // its sections
    manual->showPage(QStringLiteral("settings#approach"));
    QVERIFY(text->toPlainText().contains(QStringLiteral("obstacle surface")));
    manual->findChild<QAction*>(QStringLiteral("manualBack"))->trigger();
    QCOMPARE(shownPage(), QStringLiteral("wind"));
    manual->findChild<QAction*>(QStringLiteral("manualForward"))->trigger();
    QCOMPARE(shownPage(), QStringLiteral("settings#approach"));
    QVERIFY(manual->find(QStringLiteral("high key")));
    QCOMPARE(text->textCursor().selectedText().toLower(), QStringLiteral("high key"));
    const int first = text->textCursor().position();
    QVERIFY(manual->find(QStringLiteral("high key")));  // from the top again
    QVERIFY(text->textCursor().position() <= first || !text->textCursor().selectedText().isEmpty());
    QVERIFY(!manual->find(QStringLiteral("no such words")));
    emit text->anchorClicked(QUrl(QStringLiteral("wind.html")));
    QCOMPARE(shownPage(), QStringLiteral("wind"));
    manual->findChild<QAction*>(QStringLiteral("manualHome"))->trigger();
    QCOMPARE(shownPage(), QStringLiteral("index"));
    closeManual();
  }

  void manualThatIsNotThere_isSaid() {
    help::ManualWindow window(QStringLiteral("/no/such/folder"), style::Theme::Light);
    window.showPage(QStringLiteral("map"));
    QVERIFY(window.findChild<QTextBrowser*>(QStringLiteral("manualText"))->toPlainText().contains(QStringLiteral("not found")));
  }

private:
  [[nodiscard]] QString shownPage() const {
    const help::ManualWindow* manual = window_->help().shown();
    return manual != nullptr && manual->isVisible() ? manual->shownPage() : QStringLiteral("no manual");
  }
  void pressF1In(QWidget* view) {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    view->setFocus();
    QTRY_VERIFY(QApplication::focusWidget() == view || view->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
  }
  void closeManual() {
    if (help::ManualWindow* manual = window_->help().shown()) {
      delete manual;
    }
  }

  QTemporaryDir settings_;
  std::unique_ptr<gui::MainWindow> window_;
};

QTEST_MAIN(TestHelp)
#include "tst_help.moc"
