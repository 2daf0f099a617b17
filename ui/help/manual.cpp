#include "ui/help/manual.h"

#include "core/formats/aircraft_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace vp::help {
namespace {

const QString kContents = QStringLiteral("index");

Result<QByteArray> readPage(const QString& folder, const QString& file) {
  const QString path = QDir(folder).filePath(file + QStringLiteral(".md"));
  QFile source(path);
  if (!source.open(QIODevice::ReadOnly)) {
    return fail(Errc::BadFile, "this page of the manual cannot be read; install Volplane again", path.toStdString());
  }
  return source.readAll();
}

}  // namespace

QString Manual::bundledFolder() {
  for (const std::string& resources : formats::resourceFolders()) {
    const QDir folder(QString::fromStdString(resources) + QStringLiteral("/manual"));
    if (QFileInfo(folder.filePath(kContents + QStringLiteral(".md"))).isFile()) {
      return folder.absolutePath();
    }
  }
  return {};
}

Result<Manual> Manual::open(const QString& folder) {
  static const QRegularExpression link(QStringLiteral("<a href=\"([a-z0-9-]+)\\.html\">([^<]*)</a>"));
  Manual manual;
  manual.folder_ = folder;
  const Result<Page> contents = manual.page(kContents);
  if (!contents) {
    return forward(contents);
  }
  manual.title_ = contents->title;
  for (auto found = link.globalMatch(contents->body); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    manual.chapters_.push_back({match.captured(1), match.captured(2)});
  }
  if (manual.chapters_.empty()) {
    return fail(Errc::BadFormat, "the contents of the manual name no chapter; install Volplane again", folder.toStdString());
  }
  return manual;
}

Result<Page> Manual::page(const QString& file) const {
  const Result<QByteArray> markdown = readPage(folder_, file);
  if (!markdown) {
    return forward(markdown);
  }
  return pageFromMarkdown(*markdown);
}

}  // namespace vp::help
