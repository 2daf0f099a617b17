// Tables: columns as wide as what they hold, heads on every page.
#include "ui/briefing/page_writer.h"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>

namespace vp::briefing {
namespace {

constexpr double kPadX = 2.6 * kPoint;  // to each side of a cell
constexpr double kPadY = 1.4 * kPoint;
constexpr double kHairline = 0.4 * kPoint;
constexpr double kGroupLine = 0.9 * kPoint;
constexpr double kLongestWord = 70.0 * kPoint;  // text is broken inside words that are wider where room is short
constexpr double kMostSpread = 1.35;            // of the width that a column needs
constexpr std::size_t kLeastRows = 3;           // that go to the next page together
constexpr double kMostBlank = 0.5;              // of a page, left free to keep a table in one piece
const QColor kShade(0xEC, 0xEC, 0xEC);

Type cellType(const Row& row) {
  return row.isStrong ? Type::CellStrong : Type::Cell;
}

double widestLine(const QString& words, Type type) {
  double widest = 0.0;
  for (const QString& line : words.split(QLatin1Char('\n'))) {
    widest = std::max(widest, textWidth(line, type));
  }
  return widest;
}

double widestWord(const QString& words, Type type) {
  double widest = 0.0;
  for (const QString& word : words.simplified().split(QLatin1Char(' '))) {
    widest = std::max(widest, textWidth(word, type));
  }
  return widest;
}

}  // namespace

struct PageWriter::Layout {
  std::vector<double> x;  ///< left edges, and the right edge of the last column
  std::vector<QStringList> head;
  double headHeight = 0.0;
};

PageWriter::Layout PageWriter::layOut(const Table& table) const {
  const std::size_t count = table.columns.size();
  std::vector<double> wanted(count, 0.0);
  std::vector<double> least(count, 0.0);
  for (std::size_t c = 0; c < count; ++c) {
    const Column& column = table.columns[c];
    wanted[c] = least[c] = widestLine(column.head, Type::CellStrong);
    for (const Row& row : table.rows) {
      if (static_cast<qsizetype>(c) < row.cells.size()) {
        const QString& cell = row.cells[static_cast<qsizetype>(c)];
        const double whole = widestLine(cell, cellType(row));
        wanted[c] = std::max(wanted[c], whole);
        least[c] = std::max(
            least[c], column.isText && !column.isWhole && whole > kLongestWord ? std::min(kLongestWord, widestWord(cell, cellType(row))) : whole);
      }
    }
    wanted[c] += 2.0 * kPadX + 1.0;  // no line is broken for a rounding
    least[c] += 2.0 * kPadX + 1.0;
  }
  const double sumWanted = std::accumulate(wanted.begin(), wanted.end(), 0.0);
  const double sumLeast = std::accumulate(least.begin(), least.end(), 0.0);
  Layout layout;
  layout.x.push_back(body_.left());
  for (std::size_t c = 0; c < count; ++c) {
    double share = wanted[c] * std::min(kMostSpread, width() / sumWanted);
    if (sumWanted > width()) {
      share = least[c] + (sumWanted > sumLeast ? (wanted[c] - least[c]) * std::max(0.0, width() - sumLeast) / (sumWanted - sumLeast) : 0.0);
    }
    layout.x.push_back(layout.x.back() + share);
  }
  qsizetype lines = 1;
  for (std::size_t c = 0; c < count; ++c) {
    layout.head.push_back(table.columns[c].head.split(QLatin1Char('\n')));
    lines = std::max(lines, layout.head.back().size());
  }
  layout.headHeight = lineHeight(Type::CellStrong) * static_cast<double>(lines) + 2.0 * kPadY;
  return layout;
}

QStringList PageWriter::cellLines(const Layout& layout, const Table& table, const Row& row, std::size_t column) const {
  const QString cell = row.cells.value(static_cast<qsizetype>(column));
  const double room = layout.x[column + 1] - layout.x[column] - 2.0 * kPadX;
  return table.columns[column].isText && !table.columns[column].isWhole ? brokenInto(cell, cellType(row), room) : QStringList{cell};
}

double PageWriter::rowHeight(const Layout& layout, const Table& table, const Row& row) const {
  qsizetype most = 1;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    most = std::max(most, cellLines(layout, table, row, c).size());
  }
  return lineHeight(cellType(row)) * static_cast<double>(most) + 2.0 * kPadY;
}

double PageWriter::tableHeight(const Table& table) const {
  const Layout layout = layOut(table);
  double height = layout.headHeight + lineHeight(Type::Head) + 12.0 * kPoint;
  height += lineHeight(Type::Small) * static_cast<double>(brokenInto(table.note, Type::Small, width()).size()) + 3.0 * kPoint;
  for (const Row& row : table.rows) {
    height += rowHeight(layout, table, row);
  }
  return height;
}

void PageWriter::tableHead(const Layout& layout, const Table& table) {
  const double right = layout.x.back();
  page().shapes.push_back({QRectF(body_.left(), y_, right - body_.left(), 0.0), {}, kGroupLine});
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const double used = lineHeight(Type::CellStrong) * static_cast<double>(layout.head[c].size());
    page().texts.push_back({QRectF(layout.x[c] + kPadX, y_ + layout.headHeight - kPadY - used, layout.x[c + 1] - layout.x[c] - 2.0 * kPadX, used),
                            layout.head[c], Type::CellStrong, table.columns[c].isText ? Qt::AlignLeft : Qt::AlignRight, Qt::black});
  }
  y_ += layout.headHeight;
  page().shapes.push_back({QRectF(body_.left(), y_, right - body_.left(), 0.0), {}, kGroupLine});
}

void PageWriter::tableRow(const Layout& layout, const Table& table, const Row& row, bool isShaded) {
  const double height = rowHeight(layout, table, row);
  const QRectF box(body_.left(), y_, layout.x.back() - body_.left(), height);
  if (isShaded) {
    page().shapes.push_back({box, kShade, 0.0});
  }
  if (row.startsGroup) {
    page().shapes.push_back({QRectF(box.left(), y_, box.width(), 0.0), {}, kHairline});
  }
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const QStringList words = cellLines(layout, table, row, c);
    if (words != QStringList{QString()}) {
      page().texts.push_back({QRectF(layout.x[c] + kPadX, y_ + kPadY, layout.x[c + 1] - layout.x[c] - 2.0 * kPadX,
                                     lineHeight(cellType(row)) * static_cast<double>(words.size())),
                              words, cellType(row), table.columns[c].isText ? Qt::AlignLeft : Qt::AlignRight, Qt::black});
    }
  }
  y_ += height;
}

void PageWriter::table(const Table& table) {
  const Layout layout = layOut(table);
  const double firstRow = table.rows.empty() ? 0.0 : rowHeight(layout, table, table.rows.front());
  const double noteHeight =
      table.note.isEmpty() ? 0.0 : lineHeight(Type::Small) * static_cast<double>(brokenInto(table.note, Type::Small, width()).size());
  const double whole = tableHeight(table);
  if (whole > left() && whole <= fullHeight() && left() < kMostBlank * fullHeight()) {
    newPage();  // a table that fits on one page is found on one page
  }
  gap(10.0);
  need(lineHeight(Type::Head) + noteHeight + layout.headHeight + 3.0 * firstRow + 5.0 * kPoint);
  paragraph(table.title, Type::Head);
  if (!table.note.isEmpty()) {
    paragraph(table.note, Type::Small);
  }
  gap(3.0);
  tableHead(layout, table);
  bool isShaded = false;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row& row = table.rows[i];
    double together = rowHeight(layout, table, row);
    if (i + kLeastRows == table.rows.size()) {  // the last ones are not parted
      for (std::size_t k = i + 1; k < table.rows.size(); ++k) {
        together += rowHeight(layout, table, table.rows[k]);
      }
    }
    if (together > left() && left() < fullHeight() - layout.headHeight) {
      newPage();
      paragraph(QCoreApplication::translate("Briefing", "%1, continued").arg(table.title), Type::SmallStrong);
      gap(2.0);
      tableHead(layout, table);
      isShaded = false;
    }
    tableRow(layout, table, row, isShaded);
    isShaded = !isShaded;
  }
  page().shapes.push_back({QRectF(body_.left(), y_, layout.x.back() - body_.left(), 0.0), {}, kGroupLine});
}

}  // namespace vp::briefing
