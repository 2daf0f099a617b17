#pragma once
// How far two pictures are apart, told so that another font rasteriser or another rounding in OpenGL counts little, and a
// missing line, a wrong colour or a shifted frame counts much.

#include <QColor>
#include <QImage>

#include <algorithm>
#include <cstdlib>

namespace vp::test {

/** Every pixel the mean of factor x factor pixels (box filter); what does not fill a box is left out. */
inline QImage boxScaled(const QImage& picture, int factor) {
  const QImage source = picture.convertToFormat(QImage::Format_RGB32);
  QImage result(source.width() / factor, source.height() / factor, QImage::Format_RGB32);
  const int area = factor * factor;
  for (int y = 0; y < result.height(); ++y) {
    for (int x = 0; x < result.width(); ++x) {
      int red = area / 2;
      int green = area / 2;
      int blue = area / 2;
      for (int i = 0; i < area; ++i) {
        const QRgb pixel = source.pixel(x * factor + i % factor, y * factor + i / factor);
        red += qRed(pixel);
        green += qGreen(pixel);
        blue += qBlue(pixel);
      }
      result.setPixel(x, y, qRgb(red / area, green / area, blue / area));
    }
  }
  return result;
}

struct PictureDifference {
  double mean = 255.0;      ///< of all pixels and channels, 0 .. 255
  double strayShare = 1.0;  ///< of pixels in which some channel differs by more than kStray
  QImage picture = {};      ///< white where equal, red the stronger the difference
  static constexpr int kStray = 24;
};

/** @pre none; pictures of different sizes differ in everything */
inline PictureDifference differenceOf(const QImage& a, const QImage& b) {
  PictureDifference result;
  if (a.isNull() || a.size() != b.size()) {
    return result;
  }
  result.picture = QImage(a.size(), QImage::Format_RGB32);
  qint64 sum = 0;
  qint64 stray = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int red = std::abs(qRed(p) - qRed(q));
      const int green = std::abs(qGreen(p) - qGreen(q));
      const int blue = std::abs(qBlue(p) - qBlue(q));
      const int most = std::max({red, green, blue});
      sum += red + green + blue;
      stray += most > PictureDifference::kStray ? 1 : 0;
      const int paper = std::max(0, 255 - 4 * most);
      result.picture.setPixel(x, y, qRgb(255, paper, paper));
    }
  }
  const double pixels = static_cast<double>(a.width()) * a.height();
  result.mean = static_cast<double>(sum) / (3.0 * pixels);
  result.strayShare = static_cast<double>(stray) / pixels;
  return result;
}

}  // namespace vp::test
