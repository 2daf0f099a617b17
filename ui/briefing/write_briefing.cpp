#include "ui/briefing/write_briefing.h"

#include "ui/briefing/page_writer.h"
#include "ui/briefing/pictures.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>

#include <algorithm>

namespace vp::briefing {
namespace {

constexpr double kProfileHeight = 235.0 * kPoint;
constexpr double kAroundProfile = 60.0 * kPoint;
constexpr double kLeastBefore = 0.45;  // of a page that is left before the map: enough to go on there
constexpr double kBehindBullet = 2.0;  // points
const QString kBullet = QStringLiteral("• ");
constexpr double kLeastMap = 300.0 * kPoint;
constexpr double kRoundMap = 1.1;  // of the height of what is shown, so that names find room
constexpr double kFairMap = 0.75;  // of the size that a map could have; if the runways leave it less, they go to the next page
constexpr double kGlideHeight = 195.0 * kPoint;
constexpr double kGlideMapShare = 0.44;  // of the width of a glide's picture

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

void addFirstPage(PageWriter& writer, const BriefingContent& content) {
  writer.title(content.title);
  writer.paragraph(Words::tr("Engine-out briefing, %1").arg(content.date));
  writer.gap(6.0);
  writer.frame(content.verdict, content.statement, !content.isVerified);
  writer.facts(content.facts);
  writer.table(content.sources);
  if (!content.margins.rows.empty()) {
    writer.table(content.margins);
  }
  for (const Table* table : {&content.findings, &content.airspaces}) {
    if (!table->rows.empty()) {
      writer.table(*table);
    }
  }
}

/// @param isWithRunways  the table of runways goes below, if there is room
void addMap(PageWriter& writer, const BriefingContent& content, const Pictures& pictures, bool isWithRunways) {
  writer.newPage();
  writer.heading(Words::tr("Map"));
  writer.paragraph(
      Words::tr("Targets by their numbers in the tour. A bar across the tour: from here on the glides lead to another runway, whose letter "
                "stands on the stretch."),
      Type::Small);
  writer.gap(3.0);
  const double below = isWithRunways ? writer.tableHeight(content.runways) + 12.0 * kPoint : 0.0;
  const double wanted = std::max(kLeastMap, kRoundMap * pictures.mapAspect() * writer.width());
  const double beside = writer.left() - below;
  const double height = std::min(wanted, beside >= std::max(kLeastMap, kFairMap * std::min(wanted, writer.left())) ? beside : writer.left());
  writer.picture(height, [&pictures](QPainter& painter, const QRectF& box) { pictures.map(painter, box); });
}

void addProfile(PageWriter& writer, const Pictures& pictures) {
  writer.need(kProfileHeight + kAroundProfile);
  writer.heading(Words::tr("Altitude profile"));
  writer.picture(kProfileHeight, [&pictures](QPainter& painter, const QRectF& box) { pictures.profile(painter, box); });
}

/// Map, runways and profile. The map wants a page of its own unless the runways are few; what room there is before it is theirs.
void addOverview(PageWriter& writer, const BriefingContent& content, const Pictures& pictures, const BriefingOptions& options) {
  const double profile = kProfileHeight + kAroundProfile;
  const double runways = writer.tableHeight(content.runways);
  const bool isFirst = runways <= writer.left() && writer.left() >= kLeastBefore * writer.fullHeight();
  const bool isProfileFirst = isFirst && options.profile && runways + profile <= writer.left();
  if (isFirst) {
    writer.table(content.runways);
  }
  if (isProfileFirst) {
    addProfile(writer, pictures);
  }
  addMap(writer, content, pictures, !isFirst);
  if (!isFirst) {
    writer.table(content.runways);
  }
  if (options.profile && !isProfileFirst) {
    addProfile(writer, pictures);
  }
}

/// Assumptions and abbreviations on one page, so that no last page holds a line or two.
void addClosing(PageWriter& writer, const BriefingContent& content) {
  QStringList abbreviations;
  for (const Fact& fact : content.abbreviations) {
    abbreviations << fact.name + QStringLiteral(": ") + fact.value;
  }
  const QString explained = abbreviations.join(QStringLiteral("; ")) + QLatin1Char('.');
  double height = 2.0 * (lineHeight(Type::Head) + 12.0 * kPoint) + writer.paragraphHeight(explained, Type::Small);
  for (const QString& line : content.assumptions) {
    height += writer.paragraphHeight(kBullet + line, Type::Body) + kBehindBullet * kPoint;
  }
  if (height <= writer.fullHeight()) {
    writer.need(height);
  }
  writer.heading(Words::tr("What these figures assume, and where they end"));
  for (const QString& line : content.assumptions) {
    writer.paragraph(kBullet + line);
    writer.gap(kBehindBullet);
  }
  writer.heading(Words::tr("Abbreviations"), writer.paragraphHeight(explained, Type::Small) + kBehindBullet * kPoint);
  writer.paragraph(explained, Type::Small);
}

void addGlide(PageWriter& writer, const GlideCaption& caption, const Pictures& pictures) {
  writer.gap(8.0);
  writer.need(kGlideHeight + 60.0 * kPoint);
  writer.paragraph(caption.title, Type::Strong);
  QStringList facts;
  for (const Fact& fact : caption.facts) {
    facts << QString(fact.name + QLatin1Char(' ') + fact.value).replace(QLatin1Char(' '), QChar(QChar::Nbsp));  // broken between facts only
  }
  writer.paragraph(facts.join(QStringLiteral(" · ")), Type::Body);
  writer.gap(3.0);
  const double distance = caption.distance;
  writer.picture(kGlideHeight, [&pictures, distance](QPainter& painter, const QRectF& box) {
    const double middle = box.left() + kGlideMapShare * box.width();
    pictures.glideMap(painter, QRectF(box.topLeft(), QPointF(middle - 2.0 * kPoint, box.bottom())), distance);
    pictures.glideProfile(painter, QRectF(QPointF(middle + 2.0 * kPoint, box.top()), box.bottomRight()), distance);
  });
}

PageMarks marksOf(const BriefingContent& content, const BriefingOptions& options) {
  PageMarks marks;
  marks.head = content.title;
  marks.date = content.date;
  marks.foot = Words::tr("%1 · %2 · altitudes above mean sea level")
                   .arg(options.program, content.isCalm ? Words::tr("calm air assumed") : Words::tr("wind as on the first page"));
  if (!content.isVerified) {
    marks.warning = Words::tr("UNVERIFIED – DO NOT FLY – no one has shown that a glide to a runway exists");
  }
  return marks;
}

/// The writer stamps the moment of writing; the date of the briefing takes its place, in as many bytes.
void setCreationDate(QByteArray& pdf, std::chrono::year_month_day date) {
  const QByteArray day = QStringLiteral("%1%2%3")
                             .arg(static_cast<int>(date.year()), 4, 10, QLatin1Char('0'))
                             .arg(static_cast<unsigned>(date.month()), 2, 10, QLatin1Char('0'))
                             .arg(static_cast<unsigned>(date.day()), 2, 10, QLatin1Char('0'))
                             .toLatin1();
  const QByteArray key = QByteArrayLiteral("/CreationDate (D:");
  const qsizetype at = pdf.indexOf(key);
  const qsizetype end = at < 0 ? -1 : pdf.indexOf(')', at);
  if (end < 0) {
    return;
  }
  const qsizetype from = at + key.size();
  const QByteArray stamp = (day + "120000Z)").leftJustified(end + 1 - from, ' ');
  pdf.replace(from, stamp.size(), stamp);
}

}  // namespace

std::vector<Page> layOutBriefing(const BriefingContent& content, const Pictures& pictures, const BriefingOptions& options) {
  PageWriter writer(Sheet::of(options.paper), marksOf(content, options));
  addFirstPage(writer, content);
  if (options.map) {
    addOverview(writer, content, pictures, options);
  } else {
    writer.table(content.runways);
    if (options.profile) {
      addProfile(writer, pictures);
    }
  }
  if (options.legs) {
    writer.table(content.legs);
  }
  if (options.engineOut) {
    writer.table(content.engineOut);
  }
  if (options.glides) {
    for (const GlideCaption& caption : content.glides) {
      addGlide(writer, caption, pictures);
    }
  }
  if (options.targets) {
    writer.table(content.targets);
  }
  addClosing(writer, content);
  return writer.finish();
}

int pageCount(const QByteArray& pdf) {
  static const QRegularExpression page(QStringLiteral("/Type\\s*/Page\\b(?!s)"));
  int count = 0;
  for (auto match = page.globalMatch(QString::fromLatin1(pdf)); match.hasNext(); match.next()) {
    ++count;
  }
  return count;
}

Result<QByteArray> writeBriefing(const BriefingSource& source, const BriefingOptions& options, const Job& job) {
  const BriefingContent content = briefingContent(source, options);
  const Pictures pictures(source, content, options);
  const std::vector<Page> pages = layOutBriefing(content, pictures, options);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter pdf(&buffer);
    pdf.setResolution(static_cast<int>(kInch));
    pdf.setPageSize(QPageSize(options.paper == Paper::A4 ? QPageSize::A4 : QPageSize::Letter));
    pdf.setPageMargins(QMarginsF());
    pdf.setTitle(content.title);
    pdf.setCreator(options.program);
    QPainter painter(&pdf);
    if (!painter.isActive()) {
      return fail(Errc::OutputFailed, Words::tr("the PDF could not be made").toStdString());
    }
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (job.stopRequested()) {
        return fail(Errc::Cancelled, Words::tr("stopped").toStdString());
      }
      job.progress(static_cast<double>(i) / static_cast<double>(pages.size()), Words::tr("briefing: pages").toStdString());
      if (i > 0) {
        pdf.newPage();
      }
      paintPage(painter, pages[i]);
    }
  }
  setCreationDate(bytes, options.date);
  return bytes;
}

}  // namespace vp::briefing
