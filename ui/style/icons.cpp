#include "ui/style/icons.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

// A static library's resources are linked in only if somebody asks for them; the macro must stand outside namespaces.
static void initResources() {
  Q_INIT_RESOURCE(icons);
}

namespace vp::style {
namespace {

constexpr auto kStrokeInFiles = "#444444";
constexpr double kDisabledOpacity = 0.4;

/// Draws one SVG in one colour.
class ChartIconEngine : public QIconEngine {
public:
  ChartIconEngine(QByteArray svg, QColor color, QColor accent) : svg_(std::move(svg)), color_(color), accent_(accent) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    QByteArray colored = svg_;
    const QColor color = state == QIcon::On ? accent_ : color_;
    colored.replace(kStrokeInFiles, color.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(colored);
    painter->save();
    painter->setOpacity(painter->opacity() * (mode == QIcon::Disabled ? kDisabledOpacity : 1.0));
    const int side = std::min(rect.width(), rect.height());
    renderer.render(painter, QRectF(rect.x() + (rect.width() - side) / 2.0, rect.y() + (rect.height() - side) / 2.0, side, side));
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new ChartIconEngine(svg_, color_, accent_); }

private:
  QByteArray svg_;
  QColor color_;
  QColor accent_;
};

}  // namespace

QIcon icon(const QString& name, Theme theme) {
  initResources();
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  const ChartColors& colors = ChartColors::of(theme);
  return QIcon(new ChartIconEngine(file.readAll(), colors.text, colors.selection));
}

}  // namespace vp::style
