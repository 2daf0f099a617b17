#include "ui/help/manual_pdf.h"

#include "core/formats/atomic_file.h"
#include "ui/help/manual_html.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>

#include <cmath>
#include <map>

namespace vp::help {
namespace {

constexpr int kDotsPerInch = 1200;
constexpr double kLayoutDots = 96.0;              // per inch, in which the text is laid out
constexpr double kMargin = 18.0;                  // mm
constexpr double kFoot = 28.0;                    // layout dots, for the line below the text
constexpr int kFootText = 11;                     // layout dots
constexpr double kMostPicture = 0.5;              // of a page's height
constexpr double kPictureScale = 0.62;            // layout dots for each pixel of a picture: text in it is then as large as that around it
constexpr int kMostLayouts = 20;                  // until neither page numbers nor headings move the text
const QString kSeparator = QStringLiteral("--");  // between file and anchor

using Pages = std::map<QString, int>;  ///< anchors and the pages that they are on, from 1

/// Rules for QTextDocument, which knows a part of CSS.
const QString kStyle = QStringLiteral(
    "h1 { font-size: 20pt; margin-top: 0; margin-bottom: 10px; page-break-before: always; } h2 { font-size: 14pt; margin-top: 18px; } "
    "h3 { font-size: 11.5pt; margin-top: 14px; } p, li { margin-top: 4px; margin-bottom: 4px; } a { color: #0b57a4; text-decoration: none; } "
    "table { border-collapse: collapse; margin-top: 6px; margin-bottom: 8px; } th, td { border: 0.6px solid #9aa3b2; padding: 3px 6px; } "
    "th { background-color: #eceff4; } pre { background-color: #f3f4f7; margin-left: 6px; } "
    "code, pre { font-family: \"DejaVu Sans Mono\"; font-size: 8.5pt; } "
    "blockquote { background-color: #fff4d6; margin-left: 12px; margin-right: 12px; }");

QString pageOf(const Pages& pages, const QString& anchor) {
  const auto found = pages.find(anchor);
  return QString::number(found == pages.end() ? 0 : found->second);
}

class Book {
public:
  Book(const Manual& manual, QString version) : manual_(manual), version_(std::move(version)) {}

  Result<void> read();
  [[nodiscard]] QByteArray write();

private:
  struct Read {
    Chapter chapter;
    Page page;
  };

  Result<QString> prepared(const Chapter& chapter, const Page& page) const;
  [[nodiscard]] QString referencesIn(const QString& body, const QString& file, const Pages& pages) const;
  [[nodiscard]] QString contents(const Pages& pages) const;
  [[nodiscard]] QString html(const Pages& pages) const;
  void lay(const Pages& pages);
  bool addBreaks();
  [[nodiscard]] int pageAt(const QTextBlock& block) const;
  [[nodiscard]] Pages pagesNow() const;
  void paintPages(QPdfWriter& writer);

  const Manual& manual_;
  QString version_;
  std::vector<Read> chapters_;
  QStringList breaks_;  ///< anchors of headings that begin a page
  QTextDocument document_;
  QSizeF size_;  ///< of the text on a page, layout dots
};

/// Pictures as wide as the page allows, anchors that are unique in the book.
Result<QString> Book::prepared(const Chapter& chapter, const Page& page) const {
  static const QRegularExpression image(QStringLiteral("<img src=\"([^\"]+)\""));
  static const QRegularExpression id(QStringLiteral(" id=\"([^\"]+)\""));
  QString body;
  qsizetype done = 0;
  for (auto found = image.globalMatch(page.body); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    const QString path = QDir(manual_.folder()).filePath(match.captured(1));
    const QImage picture(path);
    if (picture.isNull()) {
      return fail(Errc::BadFile, "this picture of the manual cannot be read; make it anew by packaging/screenshots", path.toStdString());
    }
    const double scale = std::min({kPictureScale, size_.width() / picture.width(), kMostPicture * size_.height() / picture.height()});
    body += page.body.mid(done, match.capturedStart() - done) + QStringLiteral("<img src=\"%1\" width=\"%2\" height=\"%3\"")
                                                                    .arg(path)
                                                                    .arg(qRound(scale * picture.width()))
                                                                    .arg(qRound(scale * picture.height()));
    done = match.capturedEnd();
  }
  body += page.body.mid(done);
  return body.replace(id, QStringLiteral(" id=\"%1%2\\1\"").arg(chapter.file, kSeparator));
}

Result<void> Book::read() {
  const double text = kLayoutDots / 25.4;  // layout dots in a millimetre
  const QSizeF paper = QPageSize(QPageSize::A4).size(QPageSize::Millimeter);
  size_ = QSizeF(std::floor((paper.width() - 2.0 * kMargin) * text), std::floor((paper.height() - 2.0 * kMargin) * text - kFoot));
  for (const Chapter& chapter : manual_.chapters()) {
    Result<Page> page = manual_.page(chapter.file);
    if (!page) {
      return forward(page);
    }
    Result<QString> body = prepared(chapter, *page);
    if (!body) {
      return forward(body);
    }
    page->body = std::move(*body);
    chapters_.push_back({chapter, std::move(*page)});
  }
  return {};
}

/// Links into the manual become words with a page number; those to the outside stay links.
QString Book::referencesIn(const QString& body, const QString& file, const Pages& pages) const {
  static const QRegularExpression link(QStringLiteral("<a href=\"(?:([a-z0-9-]+)\\.html)?(?:#([^\"]*))?\">(.*?)</a>"));
  QString result;
  qsizetype done = 0;
  for (auto found = link.globalMatch(body); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    const QString target = match.captured(1).isEmpty() ? file : match.captured(1);
    const auto chapter = std::find_if(chapters_.begin(), chapters_.end(), [&](const Read& r) { return r.chapter.file == target; });
    QString anchor = match.captured(2);
    if (anchor.isEmpty() && chapter != chapters_.end() && !chapter->page.headings.empty()) {
      anchor = chapter->page.headings.front().anchor;
    }
    result += body.mid(done, match.capturedStart() - done) + match.captured(3) +
              QStringLiteral(" (page&nbsp;%1)").arg(pageOf(pages, target + kSeparator + anchor));
    done = match.capturedEnd();
  }
  return result + body.mid(done);
}

QString Book::contents(const Pages& pages) const {
  QString html = QStringLiteral("<h1>Contents</h1>\n<table width=\"100%\" border=\"0\">\n");
  const auto row = [&](const QString& text, const QString& anchor, bool isChapter) {
    const QString cell = isChapter ? QStringLiteral("<b>%1</b>") : QStringLiteral("&nbsp;&nbsp;&nbsp;&nbsp;%1");
    html += QStringLiteral(
                "<tr><td style=\"border: none; padding: %3px 0px 0px 0px\">%1</td><td align=\"right\" style=\"border: none; padding: %3px "
                "0px 0px 0px\">%2</td></tr>\n")
                .arg(cell.arg(text.toHtmlEscaped()), pageOf(pages, anchor))
                .arg(isChapter ? 7 : 0);
  };
  for (std::size_t i = 0; i < chapters_.size(); ++i) {
    const Read& chapter = chapters_[i];
    for (const Heading& heading : chapter.page.headings) {
      if (heading.level <= 2) {
        const bool isChapter = heading.level == 1;
        row(isChapter ? QStringLiteral("%1  %2").arg(i + 1).arg(heading.text) : heading.text, chapter.chapter.file + kSeparator + heading.anchor,
            isChapter);
      }
    }
  }
  return html + QStringLiteral("</table>\n");
}

QString Book::html(const Pages& pages) const {
  QString html = QStringLiteral(
                     "<p style=\"font-size: 90pt\">&nbsp;</p><p style=\"font-size: 30pt\"><b>%1</b></p><p style=\"font-size: 12pt\">%2</p>"
                     "<p style=\"font-size: 12pt\">The promise is as good as its inputs. The pilot checks those, and remains in command.</p>\n%3")
                     .arg(manual_.title().toHtmlEscaped(), version_.toHtmlEscaped(), contents(pages));
  for (const Read& chapter : chapters_) {
    html += referencesIn(chapter.page.body, chapter.chapter.file, pages);
  }
  for (const QString& anchor : breaks_) {
    html.replace(QStringLiteral(" id=\"%1\">").arg(anchor), QStringLiteral(" id=\"%1\" style=\"page-break-before: always\">").arg(anchor));
  }
  return html;
}

/// Where its first line is: what stands before a break belongs to the block as well.
int Book::pageAt(const QTextBlock& block) const {
  double top = document_.documentLayout()->blockBoundingRect(block).top();
  if (block.layout()->lineCount() > 0) {
    top += block.layout()->lineAt(0).y();
  }
  return static_cast<int>((top + 0.5) / size_.height());
}

/// A heading that would end a page begins the next one: the first such of each chapter, as that moves all behind it.
bool Book::addBreaks() {
  bool isAdded = false;
  QString chapter;
  for (QTextBlock block = document_.begin(); block.isValid(); block = block.next()) {
    const QTextBlock next = block.next();
    const int level = block.blockFormat().headingLevel();
    const QStringList names = block.begin().fragment().charFormat().anchorNames();
    if (level <= 1 || names.isEmpty() || !next.isValid() || pageAt(block) == pageAt(next)) {
      continue;
    }
    const QString file = names.front().section(kSeparator, 0, 0);
    if (file != chapter && !breaks_.contains(names.front())) {
      chapter = file;
      breaks_ << names.front();
      isAdded = true;
    }
  }
  return isAdded;
}

Pages Book::pagesNow() const {
  Pages pages;
  for (QTextBlock block = document_.begin(); block.isValid(); block = block.next()) {
    for (auto fragment = block.begin(); !fragment.atEnd(); ++fragment) {
      for (const QString& name : fragment.fragment().charFormat().anchorNames()) {
        pages.try_emplace(name, pageAt(block) + 1);
      }
    }
  }
  return pages;
}

void Book::lay(const Pages& pages) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPointSizeF(9.5);
  document_.clear();
  document_.setDefaultFont(font);
  document_.setUseDesignMetrics(true);
  document_.setDocumentMargin(0.0);
  document_.setDefaultStyleSheet(kStyle);
  document_.setPageSize(size_);
  document_.setHtml(html(pages));
}

void Book::paintPages(QPdfWriter& writer) {
  QPainter painter(&writer);
  painter.scale(kDotsPerInch / kLayoutDots, kDotsPerInch / kLayoutDots);
  const Pages pages = pagesNow();
  for (int page = 0; page < document_.pageCount(); ++page) {
    if (page > 0) {
      writer.newPage();
    }
    painter.save();
    painter.translate(0.0, -page * size_.height());
    const QRectF part(0.0, page * size_.height(), size_.width(), size_.height());
    painter.setClipRect(part);
    QAbstractTextDocumentLayout::PaintContext context;
    context.clip = part;
    context.palette.setColor(QPalette::Text, Qt::black);
    document_.documentLayout()->draw(&painter, context);
    painter.restore();
    if (page == 0) {
      continue;  // the title
    }
    QString chapterTitle;
    for (const Read& chapter : chapters_) {
      const auto first = pages.find(chapter.chapter.file + kSeparator + chapter.page.headings.front().anchor);
      if (first != pages.end() && first->second <= page + 1) {
        chapterTitle = chapter.page.title;
      }
    }
    QFont font(document_.defaultFont());
    font.setPixelSize(kFootText);
    painter.setFont(font);
    painter.setPen(QColor(0x55, 0x5b, 0x66));
    const QRectF foot(0.0, size_.height(), size_.width(), kFoot);
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, chapterTitle);
    painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom, QString::number(page + 1));
  }
}

QByteArray Book::write() {
  Pages pages;
  for (int round = 0; round < kMostLayouts; ++round) {
    lay(pages);
    Pages now = pagesNow();
    if (!addBreaks() && now == pages) {
      break;
    }
    pages = std::move(now);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(kMargin, kMargin, kMargin, kMargin), QPageLayout::Millimeter);
  writer.setResolution(kDotsPerInch);
  writer.setTitle(manual_.title());
  writer.setCreator(version_);
  paintPages(writer);
  return bytes;
}

}  // namespace

Result<void> writeManualPdf(const Manual& manual, const QString& path, const QString& version) {
  Book book(manual, version);
  if (const Result<void> read = book.read(); !read) {
    return read;
  }
  return formats::writeFileAtomically(path.toStdString(), book.write().toStdString());
}

}  // namespace vp::help
