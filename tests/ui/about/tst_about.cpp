// About and --version: every library that the build looks for, every source of data, the same words in both.
#include "ui/about/about_dialog.h"
#include "ui/about/program_info.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>
#include <QTextBrowser>

using namespace vp::about;

namespace {

QString nameOf(const QString& found) {
  // what CMake's modules call otherwise
  static const QHash<QString, QString> names{{QStringLiteral("nlohmann_json"), QStringLiteral("nlohmann-json")},
                                             {QStringLiteral("Qt6"), QStringLiteral("Qt")},
                                             {QStringLiteral("GeographicLib/Geodesic.hpp"), QStringLiteral("GeographicLib")},
                                             {QStringLiteral("md4c-html.h"), QStringLiteral("MD4C")},
                                             {QStringLiteral("tl/expected.hpp"), QStringLiteral("libexpected")}};
  return names.value(found, found);
}

}  // namespace

class TestAbout : public QObject {
  Q_OBJECT

private slots:
  void libraries_underTheBuildsList_areAllNamedWithALicence() {
    QFile file(QStringLiteral(VOLPLANE_SOURCE_DIR "/packaging/cmake/VolplaneDependencies.cmake"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    QHash<QString, Library> known;
    for (const Library& library : libraries()) {
      QVERIFY2(!library.licence.isEmpty(), qPrintable(library.name));
      known.insert(library.name.toLower(), library);
    }
    static const QRegularExpression look(QStringLiteral("find_package\\((\\w+)|find_path\\(\\w+ (\\S+)"));
    int count = 0;
    for (auto it = look.globalMatch(text); it.hasNext();) {
      const QRegularExpressionMatch match = it.next();
      const QString name = nameOf(match.captured(1) + match.captured(2));
      if (name != QStringLiteral("Threads") && name != QStringLiteral("OpenGL")) {  // the C library's, and whatever driver is installed
        QVERIFY2(known.contains(name.toLower()), qPrintable(name));
        ++count;
      }
    }
    QVERIFY(count >= 12);
  }

  void versions_underTheLibrariesInUse_areWhole() {
    static const QRegularExpression version(QStringLiteral("^\\d+\\.\\d+\\.\\d+"));
    for (const Library& library : libraries()) {
      const bool says = QStringList{"GDAL", "PROJ", "Qt", "OpenSceneGraph"}.contains(library.name);
      QCOMPARE(!library.version.isEmpty(), says);
      QVERIFY2(!says || version.match(library.version).hasMatch(), qPrintable(library.name + library.version));
    }
  }

  void dialog_underACommit_showsAndCopiesAllOfVersionText() {
    QCoreApplication::setApplicationVersion(QStringLiteral("9.8.7"));
    QCoreApplication::instance()->setProperty("commit", QStringLiteral("v9.8-3-gabc"));
    AboutDialog dialog;
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    const QString shown = dialog.findChild<QTextBrowser*>(QStringLiteral("aboutDetails"))->toPlainText();
    dialog.findChild<QPushButton*>(QStringLiteral("aboutCopy"))->click();
    const QString copied = QGuiApplication::clipboard()->text();
    QCOMPARE(copied, versionText(QStringLiteral("volplane 9.8.7"), QStringLiteral("v9.8-3-gabc")));
    QVERIFY(copied.startsWith(QStringLiteral("volplane 9.8.7 (commit v9.8-3-gabc)\n")));
    for (const Library& library : libraries()) {
      QVERIFY(shown.contains(library.name) && shown.contains(library.version) && copied.contains(library.licence));
    }
    for (const DataSource& source : dataSources()) {
      QVERIFY(shown.contains(source.name) && shown.contains(source.rights) && copied.contains(source.rights));
    }
    if (const QString folder = qEnvironmentVariable("VOLPLANE_PICTURES"); !folder.isEmpty()) {
      QVERIFY(dialog.grab().save(folder + QStringLiteral("/about.png")));
    }
  }
};

QTEST_MAIN(TestAbout)
#include "tst_about.moc"
