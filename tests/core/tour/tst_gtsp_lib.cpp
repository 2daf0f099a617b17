#include "core/tour/gtsp_lib.h"
#include "tests/core/tour/gtsp_cases.h"

#include <QTest>

#include <fstream>
#include <string>

using vp::Errc;
using vp::tour::parseGtspLib;

class TestGtspLib : public QObject {
  Q_OBJECT

private slots:
  void parse_underWeightFormats_givesMatrix_data();
  void parse_underWeightFormats_givesMatrix();
  void parse_underCoordinates_givesTsplibDistances();
  void parse_underBadText_namesLine_data();
  void parse_underBadText_namesLine();
  void load_underMissingFile_givesBadFile();
  void load_underDirectory_givesBadFile();
};

namespace {

std::string withWeights(const std::string& format, const std::string& weights) {
  return "NAME: t\nTYPE : AGTSP\nDIMENSION: 3\nGTSP_SETS : 2\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT: " + format +
         "\nEDGE_WEIGHT_SECTION\n" + weights + "\nGTSP_SET_SECTION :\n2 3 -1\n1 1 2 -1\nEOF\n";
}

std::string withPoints(const std::string& type, const std::string& points) {
  return "TYPE : GTSP (somebody)\r\nDIMENSION : 2\r\nGTSP_SETS: 2\r\nEDGE_WEIGHT_TYPE : " + type + "\r\nNODE_COORD_SECTION\r\n" + points +
         "\r\nGTSP_SET_SECTION\r\n1 1 -1\r\n2 2 -1\r\n";
}

}  // namespace

void TestGtspLib::parse_underWeightFormats_givesMatrix_data() {
  QTest::addColumn<QString>("format");
  QTest::addColumn<QString>("weights");
  QTest::addColumn<QList<double>>("matrix");
  QTest::newRow("full") << "FULL_MATRIX"
                        << "0 1 2\n3 0 4\n5 6 0" << QList<double>{0, 1, 2, 3, 0, 4, 5, 6, 0};
  QTest::newRow("upper row") << "UPPER_ROW"
                             << "1 2\n4" << QList<double>{0, 1, 2, 1, 0, 4, 2, 4, 0};
  QTest::newRow("lower row") << "LOWER_ROW"
                             << "1 2 4" << QList<double>{0, 1, 2, 1, 0, 4, 2, 4, 0};
  QTest::newRow("upper diagonal") << "UPPER_DIAG_ROW"
                                  << "9 1 2 9 4 9" << QList<double>{9, 1, 2, 1, 9, 4, 2, 4, 9};
  QTest::newRow("lower diagonal") << "LOWER_DIAG_ROW"
                                  << "9 1 9 2 4 9" << QList<double>{9, 1, 2, 1, 9, 4, 2, 4, 9};
  QTest::newRow("upper column") << "UPPER_COL"
                                << "1 2 4" << QList<double>{0, 1, 2, 1, 0, 4, 2, 4, 0};
}

void TestGtspLib::parse_underWeightFormats_givesMatrix() {
  QFETCH(QString, format);
  QFETCH(QString, weights);
  QFETCH(QList<double>, matrix);
  const auto instance = parseGtspLib(withWeights(format.toStdString(), weights.toStdString()), "t");
  QVERIFY2(instance.has_value(), instance ? "" : instance.error().message().c_str());
  QCOMPARE(instance->name, std::string("t"));
  QCOMPARE(instance->problem.cost, std::vector<double>(matrix.begin(), matrix.end()));
  QCOMPARE(instance->problem.sets, (std::vector<std::vector<int>>{{0, 1}, {2}}));
}

void TestGtspLib::parse_underCoordinates_givesTsplibDistances() {
  const auto distance = [](const std::string& type, const std::string& points) {
    const auto instance = parseGtspLib(withPoints(type, points), "t");
    return instance ? instance->problem.at(0, 1) : -1.0;
  };
  const std::string points = "1 0.0 0.0\n2 1.5e0 2";
  QCOMPARE(distance("EUC_2D", points), 3.0);  // 2.5 rounds up
  QCOMPARE(distance("CEIL_2D", "1 0 0\n2 1 2"), 3.0);
  QCOMPARE(distance("MAN_2D", points), 4.0);
  QCOMPARE(distance("MAX_2D", points), 2.0);
  QCOMPARE(distance("ATT", "1 0 0\n2 10 0"), 4.0);  // sqrt(10) = 3.16 rounds to 3 < 3.16, so 4
  // First two places of TSPLIB's burma14, whose edge is known to cost 153.
  QCOMPARE(distance("GEO", "1 16.47 96.10\n2 16.47 94.44"), 153.0);
}

void TestGtspLib::parse_underBadText_namesLine_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("expected");
  const auto full = [](const char* weights) { return QString::fromStdString(withWeights("FULL_MATRIX", weights)); };
  QTest::newRow("empty") << ""
                         << "no costs";
  QTest::newRow("other type") << "TYPE : TSP\n"
                              << "line 1";
  QTest::newRow("dimension") << "NAME : a\nDIMENSION : many\n"
                             << "line 2";
  QTest::newRow("unknown keyword") << "NAME : a\n\nWEIGHTS : b\n"
                                   << "line 3";
  QTest::newRow("weights before dimension") << "EDGE_WEIGHT_SECTION\n1 2\n"
                                            << "line 1";
  QTest::newRow("format") << QString::fromStdString(withWeights("FUNCTION", "1")) << "line 7";
  QTest::newRow("short weights") << full("0 1 2\n3 0 4\n5 6") << "line 11";
  QTest::newRow("word in weights") << full("0 1 2\n3 oh 4\n5 6 0") << "line 9";
  QTest::newRow("negative weight") << full("0 1 2\n3 0 -4\n5 6 0") << "line 9";
  QTest::newRow("no sets") << "DIMENSION : 1\nGTSP_SETS : 1\nEDGE_WEIGHT_SECTION\n0\nEOF\n"
                           << "no sets";
  QTest::newRow("node twice") << full("0 1 2\n3 0 4\n5 6 0").replace("1 1 2 -1", "1 1 3 -1") << "line 13";
  QTest::newRow("open set") << full("0 1 2\n3 0 4\n5 6 0").replace("1 1 2 -1", "1 1 2") << "line 14";
  QTest::newRow("lost node") << full("0 1 2\n3 0 4\n5 6 0").replace("1 1 2 -1", "1 1 -1") << "node 2";
  QTest::newRow("coordinates") << QString::fromStdString(withPoints("EUC_2D", "1 0 0\n2 5")) << "line 8";
}

void TestGtspLib::parse_underBadText_namesLine() {
  QFETCH(QString, text);
  QFETCH(QString, expected);
  const auto instance = parseGtspLib(text.toStdString(), "bad.gtsp");
  QVERIFY(!instance);
  QVERIFY(instance.error().code == Errc::BadFormat || instance.error().code == Errc::Unsupported);
  const QString message = QString::fromStdString(instance.error().message());
  QVERIFY2(message.contains(expected) && message.contains("bad.gtsp"), qPrintable(message));
}

void TestGtspLib::load_underMissingFile_givesBadFile() {
  const auto instance = vp::tour::loadGtspLib("/nowhere/none.gtsp");
  QVERIFY(!instance);
  QCOMPARE(instance.error().code, Errc::BadFile);
}

void TestGtspLib::load_underDirectory_givesBadFile() {
  const auto instance = vp::tour::loadGtspLib("/");
  QVERIFY(!instance);
  QCOMPARE(instance.error().code, Errc::BadFile);
}

QTEST_APPLESS_MAIN(TestGtspLib)
#include "tst_gtsp_lib.moc"
