#include "ui/help/manual_html.h"

#include "core/formats/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace vp::help {
namespace {

Result<void> copy(const QString& from, const QString& to) {
  QFile source(from);
  if (!source.open(QIODevice::ReadOnly)) {
    return fail(Errc::BadFile, "this file of the manual cannot be read; install Volplane again", from.toStdString());
  }
  QDir().mkpath(QFileInfo(to).path());
  return formats::writeFileAtomically(to.toStdString(), source.readAll().toStdString());
}

QString link(const QString& file, const QString& title, const char* attributes = "") {
  return QStringLiteral("<a href=\"%1.html\"%3>%2</a>").arg(file, title, QLatin1String(attributes));
}

/// The list of chapters at the side of each page.
QString sideOf(const Manual& manual, const QString& current) {
  QString side = QStringLiteral("<nav>\n<p>%1</p>\n<ol>\n").arg(link(QStringLiteral("index"), manual.title()));
  for (const Chapter& chapter : manual.chapters()) {
    side += QStringLiteral("<li>%1</li>\n").arg(link(chapter.file, chapter.title, chapter.file == current ? " aria-current=\"page\"" : ""));
  }
  return side + QStringLiteral("</ol>\n</nav>\n");
}

/// Links to the chapters before and after.
QString footOf(const Manual& manual, const QString& current, const QString& version) {
  const std::vector<Chapter>& chapters = manual.chapters();
  const auto here = std::find_if(chapters.begin(), chapters.end(), [&](const Chapter& chapter) { return chapter.file == current; });
  QStringList links;
  if (here != chapters.end() && here != chapters.begin()) {
    links << QStringLiteral("← ") + link(std::prev(here)->file, std::prev(here)->title, " rel=\"prev\"");
  }
  const auto next = here == chapters.end() ? chapters.begin() : std::next(here);
  if (next != chapters.end()) {
    links << link(next->file, next->title, " rel=\"next\"") + QStringLiteral(" →");
  }
  return QStringLiteral("<footer><p>%1</p><p>%2</p></footer>\n").arg(links.join(QStringLiteral(" · ")), version);
}

QString documentOf(const Manual& manual, const QString& file, const Page& page, const QString& version) {
  const QString title = file == QLatin1String("index") ? manual.title() : QStringLiteral("%1 – %2").arg(page.title, manual.title());
  return QStringLiteral(
             "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
             "<meta charset=\"utf-8\" />\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\" />\n<title>%1</title>\n"
             "<link rel=\"stylesheet\" href=\"style.css\" />\n</head>\n<body>\n%2<main>\n%3%4</main>\n</body>\n</html>\n")
      .arg(title.toHtmlEscaped(), sideOf(manual, file), page.body, footOf(manual, file, version));
}

}  // namespace

QStringList picturesOf(const Page& page) {
  static const QRegularExpression image(QStringLiteral("<img src=\"([^\"]+)\""));
  QStringList paths;
  for (auto found = image.globalMatch(page.body); found.hasNext();) {
    paths << found.next().captured(1);
  }
  return paths;
}

Result<void> writeManualHtml(const Manual& manual, const QString& folder, const QString& version) {
  const QDir to(folder);
  if (!QDir().mkpath(folder)) {
    return fail(Errc::OutputFailed, "this folder cannot be made; choose another one", folder.toStdString());
  }
  std::vector<Chapter> pages = manual.chapters();
  pages.insert(pages.begin(), {QStringLiteral("index"), manual.title()});
  for (const Chapter& chapter : pages) {
    const Result<Page> page = manual.page(chapter.file);
    if (!page) {
      return forward(page);
    }
    for (const QString& picture : picturesOf(*page)) {
      if (const Result<void> copied = copy(QDir(manual.folder()).filePath(picture), to.filePath(picture)); !copied) {
        return copied;
      }
    }
    const QByteArray html = documentOf(manual, chapter.file, *page, version).toUtf8();
    const QString path = to.filePath(chapter.file + QStringLiteral(".html"));
    if (const Result<void> written = formats::writeFileAtomically(path.toStdString(), html.toStdString()); !written) {
      return written;
    }
  }
  return copy(QDir(manual.folder()).filePath(QStringLiteral("style.css")), to.filePath(QStringLiteral("style.css")));
}

}  // namespace vp::help
