#pragma once

#include <QByteArray>
#include <QString>

#include <vector>

namespace vp::help {

/** A heading of a page, and the name by which links reach it: page.html#anchor. */
struct Heading {
  int level = 1;  ///< 1 to 6, as in HTML
  QString text;   ///< as it is read, without marks
  QString anchor;
};

/** A page of the manual as XHTML: what stands in its body. */
struct Page {
  QString title;  ///< its first heading
  QString body;   ///< links to other pages end in .html, headings have ids
  std::vector<Heading> headings;
};

/** Markdown of CommonMark with tables, as XHTML.
 *  @param markdown  UTF-8; raw HTML in it comes out as text
 *  @return links to NAME.md lead to NAME.html; a heading's anchor is its text in lower case, words joined by dashes, as on GitHub
 *  @threads pure    @source spec.commonmark.org 0.30, by md4c */
Page pageFromMarkdown(const QByteArray& markdown);

/** The anchor of a heading of that text: letters and digits in lower case, dashes for spaces, nothing else but dashes and underscores. */
QString anchorOf(const QString& heading);

}  // namespace vp::help
