#pragma once

#include "ui/briefing/briefing_content.h"
#include "ui/briefing/page.h"

#include <optional>
#include <vector>

namespace vp::briefing {

/** What stands on every page. */
struct PageMarks {
  QString head;     ///< upper left; shortened in the middle where it is too long
  QString date;     ///< upper right
  QString foot;     ///< lower left
  QString warning;  ///< across head and foot of every page; empty: none
};

/** Sets blocks one below the other and begins a new page where one does not fit. Nothing is cut: text is broken into lines, a
 *  row of a table stays in one piece unless it is longer than a page, heads of tables are repeated.
 *  @threads one at a time; needs fonts */
class PageWriter {
public:
  PageWriter(Sheet sheet, PageMarks marks);

  void title(const QString& words);
  /** @param with  units of height that stay with it on the page; a few lines if not said */
  void heading(const QString& words, std::optional<double> with = {});
  void paragraph(const QString& words, Type type = Type::Body);
  /** Text in a frame, with a heading in bold. */
  void frame(const QString& heading, const QString& words, bool isInverse);
  void facts(const std::vector<Fact>& facts);
  void table(const Table& table);
  /** A picture as wide as the page and `height` units high. */
  void picture(double height, std::function<void(QPainter&, const QRectF&)> draw);
  void gap(double points);
  void newPage();
  /** A new page if less than this is left on this one. */
  void need(double height);

  [[nodiscard]] double left() const { return body_.bottom() - y_; }  ///< units of height left on the page
  [[nodiscard]] double fullHeight() const { return body_.height(); }
  [[nodiscard]] double width() const { return body_.width(); }
  [[nodiscard]] double tableHeight(const Table& table) const;
  [[nodiscard]] double paragraphHeight(const QString& words, Type type) const;

  /** The pages with heads and feet, "page x of y" included. */
  std::vector<Page> finish();

private:
  struct Layout;
  [[nodiscard]] Layout layOut(const Table& table) const;
  [[nodiscard]] QStringList cellLines(const Layout& layout, const Table& table, const Row& row, std::size_t column) const;
  [[nodiscard]] double rowHeight(const Layout& layout, const Table& table, const Row& row) const;
  void tableHead(const Layout& layout, const Table& table);
  void tableRow(const Layout& layout, const Table& table, const Row& row, bool isShaded);
  void lines(const QStringList& lines, Type type, double x, double width, Qt::Alignment alignment = Qt::AlignLeft, QColor color = Qt::black);
  void mark(Page& page, std::size_t number, std::size_t count) const;
  Page& page() { return pages_.back(); }

  Sheet sheet_;
  PageMarks marks_;
  QRectF body_;
  std::vector<Page> pages_;
  double y_ = 0.0;
};

}  // namespace vp::briefing
