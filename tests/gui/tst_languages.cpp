// The window in every language: menus in it, a letter after Alt for one entry only, no text cut off in dialogs and panels.
#include "app/gui/main_window.h"
#include "tests/gui/text_fit.h"
#include "tests/support/comma_locale.h"
#include "ui/dialogs/import_targets_dialog.h"
#include "ui/document/landing_case.h"
#include "ui/map/map_view.h"
#include "ui/style/language.h"

#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QMenuBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <clocale>
#include <functional>
#include <memory>

using namespace vp;

namespace {

constexpr int kPatience = 120'000;  // ms

/// The dialogs that block, by the actions that open them.
constexpr const char* kDialogs[] = {"editPreferences",  "editSettings", "editAircraft",         "editAirspaces", "editTarget",    "editWind",
                                    "fileFetchTerrain", "fileBriefing", "export-safe-altitude", "exportSeveral", "helpShortcuts", "viewJump"};

void addTranslations() {
  QTest::addColumn<QString>("language");
  QTest::newRow("de") << QStringLiteral("de");
  QTest::newRow("cs") << QStringLiteral("cs");
}

/// Shows each page of a dialog.
void throughPages(QDialog& dialog, const std::function<void(const QString& page)>& look) {
  auto* tabs = dialog.findChild<QTabWidget*>();
  for (int page = 0; page < (tabs != nullptr ? tabs->count() : 1); ++page) {
    if (tabs != nullptr) {
      tabs->setCurrentIndex(page);
    }
    QCoreApplication::processEvents();
    look(QStringLiteral("%1, page %2").arg(dialog.objectName()).arg(page + 1));
  }
}

}  // namespace

class TestLanguages : public QObject {
  Q_OBJECT

private slots:
  void init() {
    const QString language = QString::fromLatin1(QTest::currentDataTag());
    if (!language.isEmpty() && language != shown_) {
      open(language);
    }
  }
  void cleanupTestCase() {
    window_.reset();
    style::useLanguage(QStringLiteral("en"));
  }

  void menus_areInTheLanguage_data() {
    QTest::addColumn<QString>("titles");
    QTest::newRow("en") << QStringLiteral("File Edit Mission Plan View Help");
    QTest::newRow("de") << QStringLiteral("Datei Bearbeiten Mission Planung Ansicht Hilfe");
    QTest::newRow("cs") << QStringLiteral("Soubor Upravit Mise Plán Zobrazení Nápověda");
  }
  void menus_areInTheLanguage() {
    QStringList titles;
    for (const QAction* action : window_->menuBar()->actions()) {
      titles << action->text().remove(QLatin1Char('&'));
    }
    QTEST(titles.join(QLatin1Char(' ')), "titles");
  }

  void lettersOfMenus_meanOneThing_data() {
    QTest::addColumn<QString>("language");
    for (const QString& language : style::languages()) {
      QTest::newRow(qPrintable(language)) << language;
    }
  }
  void lettersOfMenus_meanOneThing() {
    QStringList doubles;
    QStringList titles;
    for (const QAction* action : window_->menuBar()->actions()) {
      titles << action->text();
      doubles << test::doubleMnemonics(*action->menu());
    }
    doubles << test::doubleMnemonics(titles);
    QVERIFY2(doubles.isEmpty(), qPrintable(doubles.join(QLatin1Char('\n'))));
  }

  void dialogs_cutOffNothing_data() { addTranslations(); }
  void dialogs_cutOffNothing() {
    QStringList cut;
    int seen = 0;
    throughDialogs([&](const QDialog& dialog, const QString& page) {
      ++seen;
      for (const QString& one : test::cutTexts(dialog)) {
        cut << page + QStringLiteral(": ") + one;
      }
    });
    QVERIFY(seen > static_cast<int>(std::size(kDialogs)));
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QLatin1Char('\n'))));
  }

  void panels_cutOffNothing_data() { addTranslations(); }
  void panels_cutOffNothing() {
    QStringList cut;
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
      dock->show();
      dock->raise();
      QCoreApplication::processEvents();
      for (const QString& one : test::cutTexts(*dock)) {
        cut << dock->objectName() + QStringLiteral(": ") + one;
      }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QLatin1Char('\n'))));
  }

  /// The two looks above find what they look for.
  void looks_findWhatIsWrong() {
    QWidget page;
    QLabel label(QStringLiteral("A label that is too long for its place"), &page);
    QLabel lines(QStringLiteral("A label of several lines that is too long for its place"), &page);
    QPushButton button(QStringLiteral("A button that is too narrow"), &page);
    QComboBox box(&page);
    box.addItem(QStringLiteral("A choice that is too long for its place"));
    lines.setWordWrap(true);
    page.resize(400, 300);
    const auto setSizes = [&](int width, int height) {
      for (QWidget* widget :
           {static_cast<QWidget*>(&label), static_cast<QWidget*>(&lines), static_cast<QWidget*>(&button), static_cast<QWidget*>(&box)}) {
        widget->resize(width, height);
      }
    };
    page.show();
    setSizes(390, 60);
    QVERIFY2(test::cutTexts(page).isEmpty(), qPrintable(test::cutTexts(page).join(QLatin1Char('\n'))));
    setSizes(60, 20);
    QCOMPARE(test::cutTexts(page).size(), 4);
    QMenu menu;
    menu.addAction(QStringLiteral("&Open"));
    menu.addMenu(QStringLiteral("&Save"))->addAction(QStringLiteral("&Open"));
    QVERIFY(test::doubleMnemonics(menu).isEmpty());
    menu.addAction(QStringLiteral("C&ost"));
    QCOMPARE(test::doubleMnemonics(menu).size(), 1);
  }

  void save_isTheSameUnderACommaLocale() {
    open(QStringLiteral("de"));
    const QByteArray withPoint = savedMission(QStringLiteral("point"));
    QVERIFY(withPoint.contains("1234.5"));
    const QString problem = test::makeCommaLocale(settings_.path());
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    qputenv("LOCPATH", settings_.path().toLocal8Bit());
    QVERIFY(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    QCOMPARE(std::localeconv()->decimal_point, ",");  // else this test would compare nothing
    const QByteArray withComma = savedMission(QStringLiteral("comma"));
    std::setlocale(LC_ALL, "C.UTF-8");
    qunsetenv("LOCPATH");
    QLocale::setDefault(before);
    QVERIFY(withPoint == withComma);
  }

private:
  /// A mission in a folder of its own that is opened, changed and saved by the window.
  QByteArray savedMission(const QString& name) {
    QDir(settings_.path()).mkpath(name);
    const QDir folder(settings_.filePath(name));
    for (const char* file : {"alpine-n10.vpm", "alpine.tif", "alpine-airports.csv", "alpine-runways.csv"}) {
      QFile::copy(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + QLatin1String(file), folder.filePath(QLatin1String(file)));
    }
    const QString mission = folder.filePath(QStringLiteral("alpine-n10.vpm"));
    window_->take({mission});
    jobs::Workspace& workspace = window_->workspace();
    const bool isOpen =
        QTest::qWaitFor([&] { return workspace.document().path() == mission && workspace.activity() == jobs::Workspace::Activity::Idle; }, kPatience);
    workspace.document().edit(QStringLiteral("change"), [](mission::Mission& m) { m.safety.clearance = Length::fromSi(1234.5); });
    window_->action(QStringLiteral("fileSave"))->trigger();
    const bool isSaved = isOpen && QTest::qWaitFor([&] { return !window_->isWindowModified(); }, kPatience);
    QFile file(mission);
    return isSaved && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  void open(const QString& language) {
    window_.reset();
    style::useLanguage(language);
    shown_ = language;
    window_ = std::make_unique<gui::MainWindow>(settings_.filePath(language + QStringLiteral("/volplane.ini")));
    window_->resize(1480, 920);
    window_->show();
    if (language == QStringLiteral("en")) {
      return;  // only its menus are looked at
    }
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpp")});
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().situation().plan != nullptr, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().activity() == jobs::Workspace::Activity::Idle, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().roadmap() != nullptr, kPatience);  // the map of lowest safe altitudes asks for it
    document::ViewState& view = window_->workspace().view();
    view.selectTarget(0);
    view.setPinned(window_->workspace().situation().plan->length() * 0.45);
  }

  /// Opens each dialog, looks at each page of it, and closes it.
  void throughDialogs(const std::function<void(const QDialog& dialog, const QString& page)>& look) {
    for (const char* action : kDialogs) {
      bool isSeen = false;
      QTimer::singleShot(100, window_.get(), [&] {
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
          isSeen = true;
          throughPages(*dialog, [&](const QString& page) { look(*dialog, QLatin1String(action) + QStringLiteral(" ") + page); });
          dialog->reject();
        }
      });
      window_->action(QLatin1String(action))->trigger();
      QTRY_VERIFY2(isSeen, action);
    }
    for (const auto& [action, name] : {std::pair{"missionFiles", "missionFilesDialog"}, std::pair{"missionWeather", "weatherListDialog"}}) {
      window_->action(QLatin1String(action))->trigger();
      auto* dialog = window_->findChild<QDialog*>(QLatin1String(name));
      QVERIFY2(dialog != nullptr, name);
      throughPages(*dialog, [&](const QString& page) { look(*dialog, page); });
      dialog->close();
    }
    jobs::TargetsOfFile places;
    places.path = QStringLiteral("survey.gpx");
    places.read = [](const formats::TargetImportOptions&, const Job&) -> jobs::TargetsOfFile::Found { return formats::ImportedTargets{}; };
    places.found = places.read({}, Job{});
    dialogs::ImportTargetsDialog dialog(places, window_->workspace().view().units(), window_.get());
    dialog.show();
    throughPages(dialog, [&](const QString& page) { look(dialog, page); });
  }

  QTemporaryDir settings_;
  QString shown_;
  std::unique_ptr<gui::MainWindow> window_;
};

QTEST_MAIN(TestLanguages)
#include "tst_languages.moc"
