// Reads every source file against the table of who may include whom, and proves on made-up files that the rules bite.
#include "include_rules.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTest>

using vp::architecture::SourceTree;
using vp::architecture::Violation;

namespace {

SourceTree readTree() {
  SourceTree tree;
  const QDir root(QStringLiteral(VOLPLANE_SOURCE_DIR));
  for (const char* folder : {"core", "ui", "app", "maps"}) {
    QDirIterator files(root.filePath(QLatin1String(folder)), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      if (file.open(QIODevice::ReadOnly)) {
        tree[root.relativeFilePath(file.fileName()).toStdString()] = file.readAll().toStdString();
      }
    }
  }
  return tree;
}

std::string listed(const std::vector<Violation>& violations) {
  std::string text;
  for (const Violation& violation : violations) {
    text += "\n  " + violation.path + ":" + std::to_string(violation.line) + ": " + violation.what;
  }
  return text;
}

void addRow(const char* name, const char* path, const char* text, const char* expected = "") {
  QTest::newRow(name) << QString::fromLatin1(path) << QString::fromLatin1(text) << QString::fromLatin1(expected);
}

void addColumns() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("expected");
}

}  // namespace

class TestIncludes : public QObject {
  Q_OBJECT

private slots:
  void tree_followsTheRules() {
    const SourceTree tree = readTree();
    QVERIFY2(tree.size() > 40, "the sources were not found");
    std::vector<Violation> all;
    for (const auto& [path, text] : tree) {
      const std::vector<Violation> found = vp::architecture::checkFile(path, text);
      all.insert(all.end(), found.begin(), found.end());
    }
    QVERIFY2(all.empty(), listed(all).c_str());
  }

  void checker_sharesNothingWithThePlanner() {
    const SourceTree tree = readTree();
    QVERIFY(tree.contains("core/safety/checker.h"));
    const std::vector<Violation> found = vp::architecture::checkIndependenceOfSafety(tree);
    QVERIFY2(found.empty(), listed(found).c_str());
  }

  void secondOpinion_sharesNothingWithPlannerAndChecker() {
    const SourceTree tree = readTree();
    QVERIFY(tree.contains("core/audit/audit.h"));
    const std::vector<Violation> found = vp::architecture::checkIndependenceOfAudit(tree);
    QVERIFY2(found.empty(), listed(found).c_str());
  }

  void brokenRule_isFound_data() {
    addColumns();
    addRow("upwards", "core/geo/a.cpp", "#include \"core/terrain/elevation_grid.h\"\n", "core/geo may not include core/terrain");
    addRow("sideways", "core/terrain/a.cpp", "#include \"core/aircraft/glide_model.h\"\n", "core/terrain may not include core/aircraft");
    addRow("checker and planner", "core/safety/a.cpp", "#include \"core/landing/roadmap.h\"\n", "core/safety may not include core/landing");
    addRow("checker and tour", "core/safety/a.cpp", "#include \"core/tour/gtsp.h\"\n", "core/safety may not include core/tour");
    addRow("checker and curve functions", "core/safety/a.cpp", "#include \"core/flight/curve_sampling.h\"\n", "curve.h only");
    addRow("checker and pyramid", "core/safety/a.cpp", "#include \"core/terrain/terrain_pyramid.h\"\n", "not the pyramid");
    addRow("checker and second opinion", "core/safety/a.cpp", "#include \"core/audit/audit.h\"\n", "core/safety may not include core/audit");
    addRow("planner and second opinion", "core/tour/a.cpp", "#include \"core/audit/audit.h\"\n", "core/tour may not include core/audit");
    for (const char* folder : {"safety", "landing", "tour", "route", "emergency", "terrain", "risk", "formats"}) {
      const std::string text = std::string("#include \"core/") + folder + "/a.h\"\n";
      addRow((std::string("second opinion and ") + folder).c_str(), "core/audit/a.cpp", text.c_str(), "core/audit may not include");
    }
    addRow("second opinion and curve functions", "core/audit/a.cpp", "#include \"core/flight/curve_sampling.h\"\n", "no formula");
    addRow("second opinion and glide model", "core/audit/a.cpp", "#include \"core/aircraft/glide_model.h\"\n", "no formula");
    addRow("second opinion and shear", "core/audit/a.cpp", "#include \"core/air/wind_shear.h\"\n", "no formula");
    addRow("second opinion and conditions", "core/audit/a.cpp", "#include \"core/mission/glide_conditions.h\"\n", "no formula");
    addRow("core and window", "core/tour/a.cpp", "#include \"ui/map/view.h\"\n", "core/tour may not include ui/map");
    addRow("unknown folder", "core/magic/a.cpp", "#include \"core/base/result.h\"\n", "not in the table");
    addRow("maps and planner", "maps/a.cpp", "#include \"core/tour/gtsp.h\"\n", "maps may include");
    addRow("window and program", "ui/map/a.cpp", "#include \"app/cli/main.h\"\n", "ui may include");
    addRow("Qt in core", "core/base/a.cpp", "#include <QString>\n", "core/base may not include headers of Qt");
    addRow("Qt module in core", "core/mission/a.cpp", "#include <QtCore/QString>\n", "headers of Qt");
    addRow("OSG in core", "core/terrain/a.cpp", "#include <osg/Node>\n", "headers of OpenSceneGraph");
    addRow("OSG outside scene3d", "ui/map/a.cpp", "#include <osgViewer/Viewer>\n", "headers of OpenSceneGraph");
    addRow("GDAL in a header", "core/terrain/a.h", "#pragma once\n#include <gdal_priv.h>\n", ".cpp files only");
    addRow("GDAL in the wrong folder", "core/flight/a.cpp", "#  include <ogr_spatialref.h>\n", "headers of GDAL");
    addRow("JSON in a header", "core/formats/a.h", "#pragma once\n#include <nlohmann/json.hpp>\n", ".cpp files only");
    addRow("JSON in the wrong folder", "core/mission/a.cpp", "#include <nlohmann/json.hpp>\n", "nlohmann");
    addRow("GeographicLib outside geo", "core/safety/a.cpp", "#include <GeographicLib/Geodesic.hpp>\n", "GeographicLib");
    addRow("OMPL in tour", "core/tour/a.cpp", "#include <ompl/base/Planner.h>\n", "OMPL");
    addRow("CLI11 in core", "core/formats/a.cpp", "#include <CLI/CLI.hpp>\n", "CLI11");
    addRow("OpenSSL in a header", "core/terrain/a.h", "#pragma once\n#include <openssl/evp.h>\n", ".cpp files only");
    addRow("zlib in terrain", "core/terrain/a.cpp", "#include <zlib.h>\n", "zlib");
    addRow("fmt in a header", "core/geo/a.h", "#pragma once\n#include <fmt/core.h>\n", ".cpp files only");
    addRow("unknown library", "core/geo/a.cpp", "#include <curl/curl.h>\n", "neither");
    addRow("relative path", "core/geo/a.cpp", "#include \"pose.h\"\n", "not written from the root");
    addRow("angle brackets", "core/geo/a.cpp", "#include <core/geo/pose.h>\n", "angle brackets");
    addRow("no pragma once", "core/geo/a.h", "#include <vector>\n", "pragma once");
  }

  void brokenRule_isFound() {
    QFETCH(QString, path);
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const std::vector<Violation> found = vp::architecture::checkFile(path.toStdString(), text.toStdString());
    QVERIFY2(found.size() == 1, listed(found).c_str());
    QVERIFY2(QString::fromStdString(found.front().what).contains(expected), found.front().what.c_str());
  }

  void keptRule_isNotReported_data() {
    addColumns();
    addRow("downwards through others", "core/tour/a.cpp", "#include \"core/base/result.h\"\n#include \"core/terrain/elevation_grid.h\"\n");
    addRow("checker and curve values", "core/safety/a.h", "#pragma once\n#include \"core/flight/curve.h\"\n");
    addRow("second opinion and values", "core/audit/a.h", "#pragma once\n#include \"core/flight/curve.h\"\n#include \"core/mission/plan.h\"\n");
    addRow("GDAL in the second opinion", "core/audit/a.cpp", "#include <gdal_priv.h>\n");
    addRow("GDAL in an adapter", "core/terrain/a.cpp", "#include <gdal_priv.h>\n#include <cpl_error.h>\n");
    addRow("Qt in a header of the window", "ui/map/a.h", "#pragma once\n#include <QWidget>\n");
    addRow("OSG in scene3d", "ui/scene3d/a.cpp", "#include <osg/Node>\n");
    addRow("standard library", "core/base/a.h", "#pragma once\n#include <stop_token>\n#include <cstdint>\n");
    addRow("in a comment", "core/geo/a.cpp", "// #include \"core/tour/gtsp.h\"\n");
    addRow("program", "app/cli/a.cpp", "#include <CLI/CLI.hpp>\n#include \"core/tour/gtsp.h\"\n#include \"app/cli/b.h\"\n");
  }

  void keptRule_isNotReported() {
    QFETCH(QString, path);
    QFETCH(QString, text);
    const std::vector<Violation> found = vp::architecture::checkFile(path.toStdString(), text.toStdString());
    QVERIFY2(found.empty(), listed(found).c_str());
  }

  void longFile_isFound() {
    QCOMPARE(vp::architecture::checkFile("core/geo/a.cpp", std::string(600, '\n')).size(), std::size_t{0});
    QCOMPARE(vp::architecture::checkFile("core/geo/a.cpp", std::string(601, '\n')).size(), std::size_t{1});
  }

  void plannerBehindOtherHeaders_isFound() {
    SourceTree tree{{"core/safety/a.cpp", "#include \"core/mission/b.h\"\n"},
                    {"core/mission/b.h", "#include \"core/mission/c.h\"\n#include \"core/flight/curve.h\"\n"},
                    {"core/mission/c.h", "#include \"core/mission/b.h\"\n"}};
    QCOMPARE(vp::architecture::checkIndependenceOfSafety(tree).size(), std::size_t{0});
    tree["core/mission/c.h"] = "#include \"core/flight/dubins.h\"\n";
    QCOMPARE(vp::architecture::checkIndependenceOfSafety(tree).size(), std::size_t{1});
  }

  void formulaBehindOtherHeaders_isFoundForTheSecondOpinion() {
    SourceTree tree{{"core/audit/a.cpp", "#include \"core/mission/plan.h\"\n"}, {"core/mission/plan.h", "#include \"core/flight/curve.h\"\n"}};
    QCOMPARE(vp::architecture::checkIndependenceOfAudit(tree).size(), std::size_t{0});
    tree["core/mission/plan.h"] = "#include \"core/safety/limits.h\"\n";
    QCOMPARE(vp::architecture::checkIndependenceOfAudit(tree).size(), std::size_t{1});
  }
};

QTEST_APPLESS_MAIN(TestIncludes)
#include "tst_includes.moc"
