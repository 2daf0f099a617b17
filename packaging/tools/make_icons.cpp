// make_icons FOLDER SVG...: draws each SVG at the sizes of the hicolor icon theme, as FOLDER/SIZExSIZE/NAME.png, with the
// renderer that the window uses too.
#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>

#include <cstdio>

namespace {

constexpr int kSizes[] = {16, 22, 24, 32, 48, 64, 128, 256, 512};  // px: the fixed sizes of hicolor that menus, task bars and stores ask for

bool draw(QSvgRenderer& renderer, int size, const QString& file) {
  QImage image(size, size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  renderer.render(&painter);
  painter.end();
  return QDir().mkpath(QFileInfo(file).path()) && image.save(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("make_icons FOLDER SVG...\n", stderr);
    return 2;
  }
  for (int i = 2; i < argc; ++i) {
    const QString source = QString::fromLocal8Bit(argv[i]);
    QSvgRenderer renderer(source);
    for (const int size : kSizes) {
      const QString file = QStringLiteral("%1/%2x%2/%3.png").arg(QString::fromLocal8Bit(argv[1])).arg(size).arg(QFileInfo(source).baseName());
      if (!renderer.isValid() || !draw(renderer, size, file)) {
        std::fprintf(stderr, "make_icons: %s could not be drawn to %s\n", argv[i], qPrintable(file));
        return 1;
      }
    }
  }
  return 0;
}
