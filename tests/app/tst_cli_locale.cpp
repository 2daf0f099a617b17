// Files are the same whatever the locale of the user: a decimal comma in one of them would be read as another number, or not at all.
#include "tests/support/cli_run.h"
#include "tests/support/comma_locale.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

constexpr auto kMission = VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm";

}  // namespace

class TestCliLocale : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    const QString problem = makeCommaLocale(folder_.path());
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    useComma(true);
    QProcess tell;
    tell.start(QStringLiteral("locale"), {QStringLiteral("decimal_point")});
    QVERIFY(tell.waitForFinished());
    QCOMPARE(tell.readAll().trimmed(), QByteArray(","));  // else this test would compare nothing
    useComma(false);
    plan_ = folder_.filePath(QStringLiteral("plan.vpp"));
    const CliResult made = runCli({QStringLiteral("plan"), QLatin1String(kMission), QStringLiteral("-o"), plan_, QStringLiteral("--quiet")});
    QVERIFY2(made.status == 0, made.err);
  }

  void files_areTheSame_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char* file, const QStringList& arguments) { QTest::newRow(file) << QString::fromLatin1(file) << arguments; };
    const auto words = [](const char* text) { return QString::fromLatin1(text).split(QLatin1Char(' ')); };
    row("wind.vpp", words("plan @mission --wind 240+-20/8.5+-4.5kt --clearance 45.5 -o @"));
    row("exports", words("export @plan --folder @ --format fms,fms3,fpl,gpx,kml,wpt,pln,lnmpln,plan,cup,fgfp,geojson,csv"));
    row("briefing.pdf", words("brief @plan --date 2026-06-01 -o @"));
    row("map.png", words("render @plan --view map -o @"));
    row("profile.png", words("render @plan --view profile -o @"));
    row("safe.kml", words("safe-altitude @plan -o @"));
    row("safe.tif", words("safe-altitude @plan -o @"));
    row("mission.vpm", words("new-mission --terrain @terrain --airports @airports --runways @runways --target 46.5625,-27.1425,First,250.5 -o @"));
    row("verify.json", words("verify @plan --json"));
  }
  void files_areTheSame() {
    QFETCH(QString, file);
    QFETCH(QStringList, arguments);
    useComma(false);
    const QByteArray withPoint = madeBy(arguments, file);
    QVERIFY(withPoint.size() > 50);
    useComma(true);
    const QByteArray withComma = madeBy(arguments, file);
    QVERIFY2(withPoint == withComma, qPrintable(QStringLiteral("%1 and %2 bytes").arg(withPoint.size()).arg(withComma.size())));
  }

  void cleanup() { useComma(false); }

private:
  void useComma(bool isWanted) {
    if (isWanted) {
      qputenv("LOCPATH", folder_.path().toLocal8Bit());
      qputenv("LC_ALL", "de_DE.UTF-8");
      qputenv("LANGUAGE", "de");
    } else {
      qunsetenv("LOCPATH");
      qputenv("LC_ALL", "C.UTF-8");
      qputenv("LANGUAGE", "en");
    }
  }

  /// The file, or what is printed where no file is asked for; without the moment that some formats put into it.
  QByteArray madeBy(QStringList arguments, const QString& file) {
    const QString maps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");
    const QString output = folder_.filePath(file);
    QFile::remove(output);
    QDir(output).removeRecursively();
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@mission$")), QLatin1String(kMission));
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@plan$")), plan_);
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@terrain$")), maps + QStringLiteral("alpine.tif"));
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@airports$")), maps + QStringLiteral("alpine-airports.csv"));
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@runways$")), maps + QStringLiteral("alpine-runways.csv"));
    const bool isFile = arguments.contains(QStringLiteral("@"));
    arguments.replaceInStrings(QRegularExpression(QStringLiteral("^@$")), output);
    const CliResult result = runCli(arguments);
    if (result.status != 0) {
      qWarning("%s", result.err.constData());
      return {};
    }
    QByteArray bytes = isFile ? readAll(output) : result.out;
    for (const QFileInfo& one : QDir(output).entryInfoList(QDir::Files, QDir::Name)) {
      bytes += one.fileName().toUtf8() + readAll(one.filePath());
    }
    QString text = QString::fromLatin1(bytes);
    text.remove(QRegularExpression(QStringLiteral("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d+)?Z?")));
    return text.toLatin1();
  }

  QTemporaryDir folder_;
  QString plan_;
};

QTEST_GUILESS_MAIN(TestCliLocale)
#include "tst_cli_locale.moc"
