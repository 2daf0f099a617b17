// Pages of a briefing: nothing outside the frame, nothing over anything else, nothing cut; and the PDF as poppler reads it.
#include "tests/support/planned_tour.h"
#include "ui/briefing/page_writer.h"
#include "ui/briefing/pictures.h"
#include "ui/briefing/write_briefing.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace vp;
using namespace vp::briefing;

namespace {

constexpr std::chrono::year_month_day kDay{std::chrono::year(2026), std::chrono::month(6), std::chrono::day(1)};

BriefingOptions someOptions() {
  BriefingOptions options;
  options.date = kDay;
  options.program = QStringLiteral("test 1.0");
  return options;
}

/// Says what is wrong with the boxes of a page; empty if nothing is.
QString faultOf(const Page& page, const Sheet& sheet) {
  const QRectF frame = sheet.frame.adjusted(-1.0, -1.0, 1.0, 1.0);
  std::vector<QRectF> boxes;
  for (const TextItem& item : page.texts) {
    const QFontMetricsF metrics(fontOf(item.type));
    const QString what = item.lines.join(QStringLiteral(" / "));
    if (!frame.contains(item.box)) {
      return QStringLiteral("outside the frame: ") + what;
    }
    if (item.box.height() < lineHeight(item.type) * static_cast<double>(item.lines.size()) - 0.5) {
      return QStringLiteral("too high: ") + what;
    }
    for (const QString& line : item.lines) {
      if (metrics.horizontalAdvance(line) > item.box.width() + 0.5) {
        return QStringLiteral("too wide: ") + line;
      }
    }
    if (fontOf(item.type).pixelSize() < kLeastPointSize * kPoint) {
      return QStringLiteral("too small: ") + what;
    }
    boxes.push_back(item.box.adjusted(0.5, 0.5, -0.5, -0.5));
  }
  for (const PictureItem& picture : page.pictures) {
    if (!frame.contains(picture.box)) {
      return QStringLiteral("picture outside the frame");
    }
    boxes.push_back(picture.box.adjusted(0.5, 0.5, -0.5, -0.5));
  }
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      if (boxes[a].intersects(boxes[b])) {
        return QStringLiteral("overlap: %1").arg(a < page.texts.size() ? page.texts[a].lines.join(QLatin1Char('/')) : QStringLiteral("picture"));
      }
    }
  }
  return {};
}

BriefingSource sourceOf(mission::Plan plan, const document::Situation& situation) {
  BriefingSource source;
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan.terrain) {
    checksums.push_back(file.sha256);
    source.terrainFiles.push_back({file.path, file.sha256, "2026-03-01"});
  }
  source.report = *safety::check({plan, *situation.terrain->grid, checksums}, Job());
  plan.certificate = source.report.certificate;
  source.terrain = situation.terrain;
  source.figures = *tourFigures(plan, *situation.terrain->grid, kDay, Job());
  source.plan = std::make_shared<const mission::Plan>(std::move(plan));
  return source;
}

}  // namespace

class TestBriefingPages : public QObject {
  Q_OBJECT

  document::Situation situation_;
  QTemporaryDir folder_;

  QByteArray poppler(const QString& program, const QByteArray& pdf, const QStringList& options) {
    const QString file = folder_.filePath("briefing.pdf");
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly) || out.write(pdf) != pdf.size()) {
      return {};
    }
    out.close();
    QProcess process;
    process.start(program, QStringList(options) << file << (program == "pdftotext" ? QStringList{"-"} : QStringList{}));
    process.waitForFinished(60'000);
    return process.exitCode() == 0 ? process.readAllStandardOutput() : QByteArray();
  }

private slots:
  void initTestCase() {
    QGuiApplication::setFont(QFont(QStringLiteral("DejaVu Sans")));
    situation_ = test::plannedSituation();
  }

  void fonts_areThoseOfThePackages() {
    for (const Type type : {Type::Body, Type::Strong, Type::Small, Type::Cell, Type::CellStrong, Type::Head, Type::Title}) {
      QVERIFY2(QFontInfo(fontOf(type)).family().startsWith("DejaVu Sans"), qPrintable(QFontInfo(fontOf(type)).family()));
    }
  }

  void everyPage_keepsItsTextInside_data() {
    QTest::addColumn<bool>("letter");
    QTest::addColumn<bool>("metric");
    QTest::addColumn<bool>("longNames");
    QTest::addColumn<bool>("tooLow");
    QTest::newRow("A4") << false << false << false << false;
    QTest::newRow("Letter, metric") << true << true << false << false;
    QTest::newRow("long and foreign names") << true << false << true << false;
    QTest::newRow("not verified") << false << false << true << true;
  }

  void everyPage_keepsItsTextInside() {
    QFETCH(bool, letter);
    QFETCH(bool, metric);
    QFETCH(bool, longNames);
    QFETCH(bool, tooLow);
    mission::Plan plan = situation_.plan->plan();
    if (longNames) {
      plan.mission.name = std::string("Überwachung der Lawinenhänge oberhalb von ") + std::string(300, 'M');
      plan.targets[0].target.name = plan.mission.targets[0].name = std::string(2000, 'W');
      plan.targets[1].target.name = plan.mission.targets[1].name = "Ægir – Œuvre Ђорђе Θεσσαλονίκη " + std::string(60, 'x');
      plan.sites[0].site.airportName = "Aérodrome international de la Très-Haute-Vallée, " + std::string(80, 'y');
    }
    if (tooLow) {
      for (mission::DecisionPoint& point : plan.tour) {
        point.altitude -= 300.0;
      }
    }
    BriefingOptions options = someOptions();
    options.paper = letter ? Paper::Letter : Paper::A4;
    options.units = style::Units(metric ? style::UnitSystem::Metric : style::UnitSystem::Aviation);
    const BriefingSource source = sourceOf(std::move(plan), situation_);
    QCOMPARE(source.report.isSafe(), !tooLow);
    const BriefingContent content = briefingContent(source, options);
    const Pictures pictures(source, content, options);
    const std::vector<Page> pages = layOutBriefing(content, pictures, options);
    QVERIFY(pages.size() >= 4);
    for (std::size_t i = 0; i < pages.size(); ++i) {
      const QString fault = faultOf(pages[i], Sheet::of(options.paper));
      QVERIFY2(fault.isEmpty(), qPrintable(QString("page %1: %2").arg(i + 1).arg(fault)));
      int marks = 0;
      bool isNumbered = false;
      for (const TextItem& item : pages[i].texts) {
        marks += item.lines.join(' ').startsWith("UNVERIFIED – DO NOT FLY –") ? 1 : 0;
        isNumbered = isNumbered || item.lines.contains(QString("Page %1 of %2").arg(i + 1).arg(pages.size()));
      }
      QVERIFY(isNumbered);
      QCOMPARE(marks, content.isVerified ? 0 : 2);
    }
  }

  void leastOfAllRows_isWhatTheCheckerFinds() {
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    double margin = 1e300;
    double clearance = 1e300;
    for (const Divert& divert : source.figures.diverts) {
      margin = std::min(margin, divert.margin);
      clearance = std::min(clearance, divert.worst.clearance);
    }
    int compared = 0;
    for (const mission::Margin& checked : source.report.margins) {
      if (checked.kind == "tour.glide") {
        QVERIFY2(std::abs(std::max(0.0, margin) - checked.value) < 1e-3, qPrintable(QString("%1 %2").arg(margin).arg(checked.value)));
        ++compared;
      } else if (checked.kind == "glide.clearance") {
        const double left = std::max(0.0, clearance - source.plan->mission.safety.clearance.si());
        QVERIFY2(left <= checked.value + 1e-3, qPrintable(QString("%1 %2").arg(left).arg(checked.value)));  // ours looks between points too
        ++compared;
      }
    }
    QCOMPARE(compared, 2);
  }

  void longTable_repeatsItsHead_andLosesNoRow() {
    Table table;
    table.title = "Many";
    table.columns = {{"No."}, {"Words", true}};
    for (int i = 0; i < 400; ++i) {
      table.rows.push_back({{QString::number(i), QString("row %1 ").arg(i).repeated(i % 40 + 1)}});
    }
    PageWriter writer(Sheet::of(Paper::A4), {"head", "date", "foot", ""});
    writer.table(table);
    const std::vector<Page> pages = writer.finish();
    QVERIFY(pages.size() > 5);
    int heads = 0;
    QStringList numbers;
    for (const Page& page : pages) {
      QCOMPARE(faultOf(page, Sheet::of(Paper::A4)), QString());
      for (const TextItem& item : page.texts) {
        heads += item.lines == QStringList{"Words"} ? 1 : 0;
        if (item.type == Type::Cell && item.alignment == Qt::AlignRight) {
          numbers << item.lines;
        }
      }
    }
    QCOMPARE(heads, static_cast<int>(pages.size()));
    QCOMPARE(numbers.size(), 400);
    for (int i = 0; i < 400; ++i) {
      QCOMPARE(numbers[i], QString::number(i));
    }
  }

  void longTable_endsWithSeveralRowsTogether() {
    for (int rows = 40; rows < 160; ++rows) {
      Table table;
      table.title = "Many";
      table.columns = {{"No."}, {"Words", true}};
      for (int i = 0; i < rows; ++i) {
        table.rows.push_back({{QString::number(i), "row"}});
      }
      PageWriter writer(Sheet::of(Paper::A4), {"head", "date", "foot", ""});
      writer.table(table);
      const std::vector<Page> pages = writer.finish();
      const auto last = std::count_if(pages.back().texts.begin(), pages.back().texts.end(),
                                      [](const TextItem& item) { return item.type == Type::Cell && item.alignment == Qt::AlignRight; });
      QVERIFY2(last >= 3, qPrintable(QString("%1 of %2 rows").arg(last).arg(rows)));
    }
  }

  void lastPage_holdsTheAssumptionsWithTheAbbreviations_howeverLongTheTablesAre() {
    const BriefingOptions options = someOptions();
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    BriefingContent content = briefingContent(source, options);
    const Pictures pictures(source, content, options);
    const Row row = content.targets.rows.front();
    for (int rows = 1; rows < 60; ++rows) {
      content.targets.rows.assign(static_cast<std::size_t>(rows), row);
      const std::vector<Page> pages = layOutBriefing(content, pictures, options);
      QStringList heads;
      for (const TextItem& item : pages.back().texts) {
        heads << (item.type == Type::Head ? item.lines : QStringList());
      }
      QVERIFY2(heads.contains("What these figures assume, and where they end") && heads.contains("Abbreviations"),
               qPrintable(QString("%1 rows: ").arg(rows) + heads.join(", ")));
      QCOMPARE(faultOf(pages.back(), Sheet::of(options.paper)), QString());
    }
  }

  void manyFindings_shareTheirPageWithTheRunways_andTheMapFollows() {
    const BriefingOptions options = someOptions();
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    BriefingContent content = briefingContent(source, options);
    const Pictures pictures(source, content, options);
    content.findings.rows.assign(16, {{"Note", "whole plan", "some words"}});
    const std::vector<Page> pages = layOutBriefing(content, pictures, options);
    QStringList second;
    for (const TextItem& item : pages[1].texts) {
      second << (item.type == Type::Head ? item.lines : QStringList());
    }
    QVERIFY2(second.startsWith("Findings") && second.contains(content.runways.title) && second.contains("Altitude profile"),
             qPrintable(second.join(", ")));
    const auto isMap = [](const TextItem& item) { return item.type == Type::Head && item.lines == QStringList{"Map"}; };
    QVERIFY(std::any_of(pages[2].texts.begin(), pages[2].texts.end(), isMap));
  }

  void numbers_keepTheirUnitsOnTheLine() {
    const QString words = QString("between 6_214 ft MSL and 725 m AGL at 65 kt over 3 NM").replace('_', QChar(0x2009));
    for (double width = 1.1 * textWidth("6_214 ft MSL", Type::Body); width < 900.0; width += 10.0) {
      const QStringList lines = brokenInto(words, Type::Body, width);
      QCOMPARE(lines.join(' '), words);
      for (const QString& line : lines) {
        const QString first = line.section(' ', 0, 0);
        QVERIFY2(!QStringList({"214", "ft", "MSL", "m", "AGL", "kt", "NM"}).contains(first), qPrintable(line));
        QVERIFY(textWidth(line, Type::Body) <= width);
      }
    }
  }

  void wordWiderThanItsLine_isBroken_andNothingIsLost() {
    const QString word(500, 'W');
    const QStringList lines = brokenInto(word, Type::Body, 1000.0);
    QVERIFY(lines.size() > 3);
    QCOMPARE(lines.join(QString()), word);
    for (const QString& line : lines) {
      QVERIFY(textWidth(line, Type::Body) <= 1000.0);
    }
  }

  void pdf_isReadByPoppler_andNamesEveryTargetAndRunway() {
    if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
      QSKIP("poppler-utils is not installed; packaging/dependencies.sh installs it");
    }
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    const Result<QByteArray> pdf = writeBriefing(source, someOptions(), Job());
    QVERIFY(pdf.has_value());
    const QByteArray info = poppler("pdfinfo", *pdf, {});
    QVERIFY2(info.contains("Pages:           " + QByteArray::number(pageCount(*pdf))), info);
    QVERIFY(info.contains(QByteArray::fromStdString(source.plan->mission.name)));
    QVERIFY(info.contains("A4"));
    const QString text = QString::fromUtf8(poppler("pdftotext", *pdf, {"-layout"}));
    for (const mission::TargetInFrame& target : source.plan->targets) {
      QVERIFY2(text.contains(QString::fromStdString(target.target.name)), target.target.name.c_str());
    }
    for (const Divert& divert : source.figures.diverts) {
      const mission::LandingSite& site = source.plan->sites[static_cast<std::size_t>(divert.site)].site;
      QVERIFY(text.contains(QString::fromStdString(site.airportIdent + " " + site.runwayIdent)));
    }
    QVERIFY(text.contains(QString("Page 1 of %1").arg(pageCount(*pdf))));
    const QByteArray fonts = poppler("pdffonts", *pdf, {});
    for (const QByteArray& line : fonts.split('\n').mid(2)) {
      QVERIFY2(line.isEmpty() || line.contains("yes no  yes") || line.contains("yes yes yes"), line);  // embedded, with Unicode
    }
  }

  void twoBriefings_areTheSameBytes() {
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    const Result<QByteArray> first = writeBriefing(source, someOptions(), Job());
    const Result<QByteArray> second = writeBriefing(source, someOptions(), Job());
    QVERIFY(first && second);
    QVERIFY(*first == *second);
    QVERIFY(first->contains("/CreationDate (D:20260601120000Z)"));
  }

  void monochrome_pages_haveNoColour() {
    if (QStandardPaths::findExecutable("pdftoppm").isEmpty()) {
      QSKIP("poppler-utils is not installed; packaging/dependencies.sh installs it");
    }
    BriefingOptions options = someOptions();
    options.monochrome = true;
    const Result<QByteArray> pdf = writeBriefing(sourceOf(situation_.plan->plan(), situation_), options, Job());
    QVERIFY(pdf.has_value());
    QImage map;
    QVERIFY(map.loadFromData(poppler("pdftoppm", *pdf, {"-f", "2", "-l", "2", "-r", "60", "-png"}), "PNG"));
    int inked = 0;
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const QColor color = map.pixelColor(x, y);
        QVERIFY(std::abs(color.red() - color.green()) <= 2 && std::abs(color.green() - color.blue()) <= 2);
        inked += color.red() < 250 ? 1 : 0;
      }
    }
    QVERIFY(inked > 10'000);
  }

  void withoutParts_theyAreLeftOut() {
    BriefingOptions options = someOptions();
    const BriefingSource source = sourceOf(situation_.plan->plan(), situation_);
    options.map = options.profile = options.glides = options.targets = false;
    const BriefingContent content = briefingContent(source, options);
    const Pictures pictures(source, content, options);
    for (const Page& page : layOutBriefing(content, pictures, options)) {
      QVERIFY(page.pictures.empty());
    }
  }

  void stopped_givesCancelled() {
    std::stop_source stop;
    stop.request_stop();
    const Result<QByteArray> pdf = writeBriefing(sourceOf(situation_.plan->plan(), situation_), someOptions(), Job(stop.get_token()));
    QVERIFY(!pdf);
    QCOMPARE(pdf.error().code, Errc::Cancelled);
  }
};

QTEST_MAIN(TestBriefingPages)
#include "tst_briefing_pages.moc"
