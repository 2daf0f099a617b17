#include "ui/help/markdown.h"

#include <QRegularExpression>
#include <QTextDocumentFragment>

#include <md4c-html.h>

namespace vp::help {
namespace {

constexpr unsigned kDialect = MD_FLAG_TABLES | MD_FLAG_NOHTML;
constexpr unsigned kOutput = MD_HTML_FLAG_XHTML | MD_HTML_FLAG_SKIP_UTF8_BOM;

QString htmlOf(const QByteArray& markdown) {
  QByteArray html;
  const auto append = [](const MD_CHAR* text, MD_SIZE size, void* to) { static_cast<QByteArray*>(to)->append(text, static_cast<qsizetype>(size)); };
  md_html(markdown.constData(), static_cast<MD_SIZE>(markdown.size()), append, &html, kDialect, kOutput);
  return QString::fromUtf8(html);
}

/// Puts ids at headings and lists them; two of the same text get numbers.
void nameHeadings(Page& page) {
  static const QRegularExpression pattern(QStringLiteral("<h([1-6])>(.*?)</h\\1>"), QRegularExpression::DotMatchesEverythingOption);
  QString body;
  qsizetype done = 0;
  for (auto found = pattern.globalMatch(page.body); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    Heading heading{match.captured(1).toInt(), QTextDocumentFragment::fromHtml(match.captured(2)).toPlainText(), {}};
    const QString plain = anchorOf(heading.text);
    heading.anchor = plain;
    const auto isTaken = [&](const QString& anchor) {
      return std::any_of(page.headings.begin(), page.headings.end(), [&](const Heading& other) { return other.anchor == anchor; });
    };
    for (int number = 1; isTaken(heading.anchor); ++number) {
      heading.anchor = QStringLiteral("%1-%2").arg(plain).arg(number);
    }
    body += page.body.mid(done, match.capturedStart() - done) +
            QStringLiteral("<h%1 id=\"%2\">%3</h%1>").arg(match.captured(1), heading.anchor, match.captured(2));
    done = match.capturedEnd();
    page.headings.push_back(heading);
  }
  page.body = body + page.body.mid(done);
}

}  // namespace

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower()) {
    if (c.isLetterOrNumber() || c == QLatin1Char('-') || c == QLatin1Char('_')) {
      anchor += c;
    } else if (c.isSpace()) {
      anchor += QLatin1Char('-');
    }
  }
  return anchor;
}

Page pageFromMarkdown(const QByteArray& markdown) {
  static const QRegularExpression link(QStringLiteral("<a href=\"(?![a-z]+:)([^\"#]*)\\.md(#[^\"]*)?\""));
  Page page;
  page.body = htmlOf(markdown);
  page.body.replace(link, QStringLiteral("<a href=\"\\1.html\\2\""));
  nameHeadings(page);
  page.title = page.headings.empty() ? QString() : page.headings.front().text;
  return page;
}

}  // namespace vp::help
