#include "ui/briefing/page_writer.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>

namespace vp::briefing {
namespace {

constexpr double kMarkGap = 4.0 * kPoint;
constexpr double kHairline = 0.4 * kPoint;
constexpr double kFrameLine = 1.2 * kPoint;
constexpr double kFramePad = 6.0 * kPoint;
const QColor kInverse(Qt::white);

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

}  // namespace

PageWriter::PageWriter(Sheet sheet, PageMarks marks) : sheet_(sheet), marks_(std::move(marks)), body_(sheet.frame) {
  const double bar = lineHeight(Type::Small) + kMarkGap + (marks_.warning.isEmpty() ? 0.0 : lineHeight(Type::Strong) + kMarkGap);
  body_.adjust(0.0, bar + kMarkGap, 0.0, -bar - kMarkGap);
  newPage();
}

void PageWriter::newPage() {
  pages_.emplace_back();
  y_ = body_.top();
}

void PageWriter::need(double height) {
  if (height > left() && y_ > body_.top()) {
    newPage();
  }
}

void PageWriter::gap(double points) {
  if (y_ > body_.top()) {
    y_ += points * kPoint;
  }
}

void PageWriter::lines(const QStringList& lines, Type type, double x, double width, Qt::Alignment alignment, QColor color) {
  page().texts.push_back({QRectF(x, y_, width, lineHeight(type) * static_cast<double>(lines.size())), lines, type, alignment, color});
}

void PageWriter::title(const QString& words) {
  paragraph(words, Type::Title);
}

void PageWriter::heading(const QString& words, std::optional<double> with) {
  gap(10.0);
  const double height = lineHeight(Type::Head);
  need(height + with.value_or(6.0 * lineHeight(Type::Body)));
  paragraph(words, Type::Head);
  gap(2.0);
}

void PageWriter::paragraph(const QString& words, Type type) {
  for (const QString& line : brokenInto(words, type, width())) {
    need(lineHeight(type));
    lines({line}, type, body_.left(), width());
    y_ += lineHeight(type);
  }
}

double PageWriter::paragraphHeight(const QString& words, Type type) const {
  return lineHeight(type) * static_cast<double>(brokenInto(words, type, width()).size());
}

void PageWriter::frame(const QString& heading, const QString& words, bool isInverse) {
  const double inside = width() - 2.0 * kFramePad;
  const QStringList head = brokenInto(heading, Type::Head, inside);
  const QStringList body = brokenInto(words, Type::Body, inside);
  const double headHeight = lineHeight(Type::Head) * static_cast<double>(head.size());
  const double height = headHeight + lineHeight(Type::Body) * static_cast<double>(body.size()) + 2.0 * kFramePad;
  if (height > fullHeight()) {  // a certificate with very many exceptions
    paragraph(heading, Type::Head);
    paragraph(words);
    return;
  }
  need(height);
  page().shapes.push_back({QRectF(body_.left(), y_, width(), height), isInverse ? QColor(Qt::black) : QColor(), kFrameLine});
  const double bottom = y_ + height;
  y_ += kFramePad;
  const QColor color = isInverse ? QColor(Qt::white) : QColor(Qt::black);
  lines(head, Type::Head, body_.left() + kFramePad, inside, Qt::AlignLeft, color);
  y_ += headHeight;
  lines(body, Type::Body, body_.left() + kFramePad, inside, Qt::AlignLeft, color);
  y_ = bottom;
  gap(6.0);
}

void PageWriter::facts(const std::vector<Fact>& facts) {
  double names = 0.0;
  for (const Fact& fact : facts) {
    names = std::max(names, textWidth(fact.name, Type::Strong));
  }
  names += 8.0 * kPoint;
  for (const Fact& fact : facts) {
    const QStringList value = brokenInto(fact.value, Type::Body, width() - names);
    const double height = lineHeight(Type::Body) * static_cast<double>(value.size());
    need(height);
    lines({fact.name}, Type::Strong, body_.left(), names);
    lines(value, Type::Body, body_.left() + names, width() - names);
    y_ += height + 1.5 * kPoint;
  }
}

void PageWriter::picture(double height, std::function<void(QPainter&, const QRectF&)> draw) {
  need(height);
  page().pictures.push_back({QRectF(body_.left(), y_, width(), height), std::move(draw)});
  y_ += height;
}

/// Head and foot: rules, words, page numbers and, where the plan is not verified, a black bar that says so.
void PageWriter::mark(Page& page, std::size_t number, std::size_t count) const {
  const QRectF& frame = sheet_.frame;
  const double small = lineHeight(Type::Small);
  const double bar = marks_.warning.isEmpty() ? 0.0 : lineHeight(Type::Strong) + kMarkGap;
  const double headRule = frame.top() + bar + small + 0.5 * kMarkGap;
  const double footRule = frame.bottom() - bar - small - 0.5 * kMarkGap;
  page.shapes.push_back({QRectF(frame.left(), headRule, frame.width(), 0.0), {}, kHairline});
  page.shapes.push_back({QRectF(frame.left(), footRule, frame.width(), 0.0), {}, kHairline});
  const QString pages = Words::tr("Page %1 of %2").arg(number).arg(count);
  const auto place = [&](const QString& leftWords, const QString& rightWords, double y) {
    const double right = textWidth(rightWords, Type::SmallStrong) + kPoint;
    const double rest = frame.width() - right - 2.0 * kMarkGap;
    const QString shortened = QFontMetricsF(fontOf(Type::Small)).elidedText(leftWords, Qt::ElideMiddle, rest - kPoint);
    page.texts.push_back({QRectF(frame.left(), y, rest, small), {shortened}, Type::Small, Qt::AlignLeft, Qt::black});
    page.texts.push_back({QRectF(frame.right() - right, y, right, small), {rightWords}, Type::SmallStrong, Qt::AlignRight, Qt::black});
  };
  place(marks_.head, marks_.date, frame.top() + bar);
  place(marks_.foot, pages, frame.bottom() - bar - small);
  if (bar > 0.0) {
    for (const double y : {frame.top(), frame.bottom() - bar + kMarkGap}) {
      const QRectF box(frame.left(), y, frame.width(), lineHeight(Type::Strong));
      page.shapes.push_back({box, Qt::black, kHairline});
      page.texts.push_back({box, {marks_.warning}, Type::Strong, Qt::AlignHCenter, kInverse});
    }
  }
}

std::vector<Page> PageWriter::finish() {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    mark(pages_[i], i + 1, pages_.size());
  }
  return std::move(pages_);
}

}  // namespace vp::briefing
