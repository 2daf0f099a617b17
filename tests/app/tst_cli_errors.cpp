// What bad input gets: one sentence that names file, place and remedy, exit 2, and nothing written.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>

using namespace vp::test;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

using Spoil = std::function<QByteArray(QByteArray)>;

Spoil replacing(const char* what, const char* with) {
  return [what, with](QByteArray mission) {
    const auto at = mission.indexOf(what);
    return at < 0 ? QByteArray("the fixture no longer holds what the test replaces") : mission.replace(at, static_cast<int>(qstrlen(what)), with);
  };
}

}  // namespace

Q_DECLARE_METATYPE(Spoil)

class TestCliErrors : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    QVERIFY(QFile::copy(kMaps + "mountain.tif", folder_.filePath("mountain.tif")));
    const QByteArray raster = readAll(kMaps + "mountain.tif");
    QVERIFY(writeAll(folder_.filePath("truncated.tif"), raster.left(raster.size() / 2)));
    QVERIFY(writeAll(folder_.filePath("text.tif"), "this is not a raster\n"));
    QVERIFY(writeAll(folder_.filePath("nocrs.asc"), "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n7 8 9\n"));
    QVERIFY(writeAll(folder_.filePath("broken.csv"), "\"id\",\"ident\"\n1,\"unterminated\n"));
    QVERIFY(writeAll(folder_.filePath("runways.csv"), "id,airport_ref\n"));
  }

  void mission_underOneFault_isRefusedWithASentence_data() {
    QTest::addColumn<Spoil>("spoil");
    QTest::addColumn<QStringList>("words");  // all must appear in the message
    QTest::addColumn<int>("status");
    const auto row = [](const char* name, const Spoil& spoil, const QStringList& words, int status = 2) {
      QTest::newRow(name) << spoil << words << status;
    };
    row("terrain missing", replacing("mountain.tif", "nowhere.tif"), {"nowhere.tif"});
    row("terrain truncated", replacing("mountain.tif", "truncated.tif"), {"truncated.tif"});
    row("terrain is text", replacing("mountain.tif", "text.tif"), {"text.tif"});
    row("terrain without CRS", replacing("mountain.tif", "nocrs.asc"), {"nocrs.asc", "coordinate"});
    row("malformed JSON", [](QByteArray m) { return m.left(m.size() / 2); }, {"mission.vpm", "line"});
    row("empty file", [](const QByteArray&) { return QByteArray(); }, {"mission.vpm"});
    row("unknown field", replacing("\"terrain\"", "\"terain\": [], \"terrain\""), {"mission.vpm", "terain"});
    row("newer version", replacing("\"version\": 1", "\"version\": 2"), {"version"});
    row("headings out of range", replacing("\"headings\": 8", "\"headings\": 0"), {"headings"});
    row("beta too small", replacing("\"headings\": 8", "\"headings\": 8, \"beta\": 1.5"), {"beta", "2"});
    row("latitude out of range", replacing("\"latitude_deg\": 46.98830355", "\"latitude_deg\": 146.98830355"), {"latitude"});
    row("aircraft unknown", replacing("cessna172-elasp", "cessna999"), {"cessna999"});
    row("target off the map",
        replacing("\"targets\": [", "\"targets\": [{\"name\": \"FAR\", \"latitude_deg\": 48.5, \"longitude_deg\": -25.0, \"height_m\": 100},"),
        {"FAR", "outside the terrain"});
    row("two targets at one place",
        replacing("\"targets\": [",
                  "\"targets\": [{\"name\": \"X1\", \"latitude_deg\": 47.0, \"longitude_deg\": -25.0}, {\"name\": \"X2\", \"latitude_deg\": 47.0, "
                  "\"longitude_deg\": -25.0},"),
        {"X1", "X2", "same place"});
    row("target below the ground",
        replacing("\"targets\": [",
                  "\"targets\": [{\"name\": \"LOW\", \"latitude_deg\": 47.0, \"longitude_deg\": -25.0, \"height_m\": 5, \"reference\": \"msl\"},"),
        {"LOW", "below the ground"});
    row("misspelt name in the site filter", replacing("\"terrain\"", "\"siteFilter\": {\"exclude\": [\"MTSX\"]}, \"terrain\""),
        {"MTSX", "siteFilter"});
    row("airfields missing", replacing("\"terrain\"", "\"airfields\": [{\"airports\": \"none.csv\", \"runways\": \"none2.csv\"}], \"terrain\""),
        {"none.csv"});
    row("airfields broken", replacing("\"terrain\"", "\"airfields\": [{\"airports\": \"broken.csv\", \"runways\": \"runways.csv\"}], \"terrain\""),
        {"broken.csv"});
    row("all sites excluded", replacing("\"terrain\"", "\"siteFilter\": {\"exclude\": [\"MTSW\", \"MTNE\", \"MTNW\"]}, \"terrain\""),
        {"landing site"});
    row("ceiling too low", replacing("\"terrain\"", "\"ceiling_m\": 900, \"terrain\""), {"target", "ceiling", "900"}, 1);
  }

  void mission_underOneFault_isRefusedWithASentence() {
    QFETCH(Spoil, spoil);
    QFETCH(QStringList, words);
    QFETCH(int, status);
    const QString mission = folder_.filePath("mission.vpm");
    QByteArray text = readAll(kMaps + "mountain-n5.vpm");
    text.replace("\"siteFilter\": {},", "");
    QVERIFY(writeAll(mission, spoil(text)));
    const CliResult result = runCli({"plan", mission, "-o", folder_.filePath("out.vpp"), "--roadmap-samples", "300", "--headings", "4"});
    QVERIFY2(result.status == status, QByteArray::number(result.status) + " " + result.err + result.out);
    QVERIFY(!result.crashed);
    for (const QString& word : words) {
      QVERIFY2(result.err.contains(word.toUtf8()), result.err);
    }
    QCOMPARE(result.err.trimmed().count('\n'), 0);  // one sentence, one line
    QVERIFY(!QFile::exists(folder_.filePath("out.vpp")));
  }

  // A mission from the mail must not clear the screen, colour its own lines or write "VERIFIED" below its name.
  void textsOfAFile_withControlCharacters_arePrintedAsPlainText() {
    const QByteArray evil = "M\\u001b[2J\\u001b[31m\\nVERIFIED\\u0007\\u007f";
    QByteArray text = readAll(kMaps + "mountain-n5.vpm");
    for (const QByteArray key : {"\"name\": \"", "\"id\": \""}) {
      text.replace(key, key + evil);
    }
    QVERIFY(text.count("u001b") > 10);
    const QString mission = folder_.filePath("evil.vpm");
    QVERIFY(writeAll(mission, text));
    const auto isPlain = [](const QByteArray& bytes) {
      return std::none_of(bytes.begin(), bytes.end(), [](char c) { return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f; });
    };
    const CliResult info = runCli({"info", mission});
    QVERIFY2(info.status == 0, info.err);
    QVERIFY(isPlain(info.out) && isPlain(info.err));
    QVERIFY2(info.out.contains("VERIFIED") && !info.out.contains("\nVERIFIED"), info.out);

    QVERIFY(writeAll(mission, text.replace("mountain.tif", evil + ".tif")));
    const CliResult refused = runCli({"info", mission});
    QCOMPARE(refused.status, 2);
    QVERIFY(isPlain(refused.err));
    QVERIFY2(refused.err.contains("VERIFIED") && refused.err.count('\n') == 1, refused.err);
  }

  void output_thatCannotBeWritten_isToldBeforePlanning() {
    for (const QString& output : {folder_.filePath("no/such/folder/x.vpp"), folder_.path(), QStringLiteral("/proc/x.vpp")}) {
      const CliResult result = runCli({"plan", kMaps + "mountain-n5.vpm", "-o", output, "--roadmap-samples", "100", "--headings", "2"});
      QCOMPARE(result.status, 2);
      QVERIFY2(!result.err.isEmpty(), qPrintable(output));
    }
  }

  void usage_isExitTwo() {
    for (const QStringList& arguments : {QStringList{},
                                         {"plan"},
                                         {"plan", "x.vpm"},
                                         {"fly", "x"},
                                         {"plan", "x.vpm", "-o", "y.vpp", "--headings", "many"},
                                         {"export", "x.vpp", "--format", "pigeon", "-o", "y"},
                                         {"verify", "none.vpp"},
                                         {"brief"},
                                         {"brief", "none.vpp", "-o", "y.pdf"},
                                         {"brief", kMaps + "alpine-n10.vpp", "-o", "y.pdf", "--paper", "a5"},
                                         {"brief", kMaps + "alpine-n10.vpp", "-o", "y.pdf", "--units", "furlongs"},
                                         {"brief", kMaps + "alpine-n10.vpp", "-o", "y.pdf", "--date", "2026-02-30"},
                                         {"brief", kMaps + "alpine-n10.vpp", "-o", "y.pdf", "--date", "tomorrow"},
                                         {"brief", kMaps + "alpine-n10.vpp", "-o", folder_.filePath("no/such/folder/x.pdf")},
                                         {"info", "none.tif"}}) {
      const CliResult result = runCli(arguments);
      QVERIFY2(result.status == 2, qPrintable(arguments.join(' ')));
      QVERIFY(!result.err.isEmpty());
    }
  }

private:
  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestCliErrors)
#include "tst_cli_errors.moc"
