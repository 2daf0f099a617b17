#include "ui/briefing/pictures.h"

#include "ui/briefing/figure_text.h"
#include "ui/briefing/page.h"
#include "ui/document/plan_situation.h"
#include "ui/map/map_renderer.h"
#include "ui/map/render_map.h"
#include "ui/map/tile_layer.h"
#include "ui/profile/glide_profile_renderer.h"
#include "ui/profile/profile_renderer.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vp::briefing {
namespace {

constexpr double kPixel = kInch / 96.0;      // the views draw in pixels of 1/96 inch: their smallest text is then 8.25 points
constexpr double kGroundResolution = 2.5;    // pixels of the ground per such pixel, 240 per inch
constexpr double kGreyResolution = 3.0;      // the same of pictures that are an image as a whole
constexpr int kProfileFont = 13;             // px, so that its small text has 8.25 points
constexpr std::size_t kNamedTargets = 24;    // more targets than this are called by their numbers alone
constexpr qsizetype kLongestLabel = 14;      // characters of a name beside its number
constexpr double kBar = 9.0;                 // px to each side of the tour
constexpr double kRoundGlide = 0.12;         // of the shorter side, free around a glide

/// The plan with its targets called by their numbers in the tour.
mission::Plan labelled(const mission::Plan& plan, const TourFigures& figures) {
  mission::Plan copy = plan;
  for (std::size_t i = 0; i < figures.visits.size(); ++i) {
    std::string& name = copy.targets[static_cast<std::size_t>(figures.visits[i].target)].target.name;
    QString label = QString::number(i + 1);
    const QString own = QString::fromStdString(name).simplified();
    if (figures.visits.size() <= kNamedTargets && own.size() <= kLongestLabel && own != label) {
      label += QStringLiteral(" · ") + own;
    }
    name = label.toStdString();
  }
  return copy;
}

}  // namespace

class Pictures::Private {
public:
  Private(const BriefingSource& source, const BriefingContent& content, const BriefingOptions& options)
      : source_(source), content_(content), options_(options) {
    situation_ = document::situationOf(std::make_shared<const mission::Plan>(labelled(*source.plan, source.figures)), source.terrain);
    scene_.situation = situation_;
    scene_.units = options.units;
    renderer_ = std::make_unique<map::MapRenderer>(scene_);
    style_.units = options.units;
    style_.font = fontOf(Type::Body);
    style_.font.setPixelSize(kProfileFont);
  }

  using Draw = std::function<void(QPainter&, QSizeF)>;
  void draw(QPainter& painter, const QRectF& box, const Draw& draw) const;
  void drawMap(QPainter& painter, const map::MapCamera& camera, bool withDiverts) const;
  void drawDiverts(QPainter& painter, const map::MapCamera& camera, map::LabelPlacer& labels) const;
  [[nodiscard]] std::vector<QRectF> barBoxes(const map::MapCamera& camera) const;
  [[nodiscard]] const document::PlanView& plan() const { return *situation_.plan; }

  const BriefingSource& source_;
  const BriefingContent& content_;
  const BriefingOptions& options_;
  document::Situation situation_;
  map::MapScene scene_;
  std::unique_ptr<map::MapRenderer> renderer_;
  profile::ProfileStyle style_;
};

void Pictures::Private::draw(QPainter& painter, const QRectF& box, const Draw& draw) const {
  const QSizeF size = box.size() / kPixel;
  painter.save();
  painter.translate(box.topLeft());
  painter.scale(kPixel, kPixel);
  if (options_.monochrome) {
    QImage image((size * kGreyResolution).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(kGreyResolution);
    image.fill(Qt::white);
    QPainter inner(&image);
    draw(inner, size);
    inner.end();
    painter.drawImage(QRectF(QPointF(0.0, 0.0), size), image.convertToFormat(QImage::Format_Grayscale8));
  } else {
    draw(painter, size);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 0.8));
  painter.drawRect(QRectF(QPointF(0.0, 0.0), size).adjusted(0.4, 0.4, -0.4, -0.4));
  painter.restore();
}

/// A bar across the tour where the runway changes, and the runway's letter in the middle of the stretch.
void Pictures::Private::drawDiverts(QPainter& painter, const map::MapCamera& camera, map::LabelPlacer& labels) const {
  const TourFigures& figures = source_.figures;
  const style::ChartColors& colors = scene_.colors();
  const QFont font = map::chartFont(map::TextSize::Normal, true);
  for (std::size_t i = 0; i < figures.diverts.size(); ++i) {
    const Divert& divert = figures.diverts[i];
    const double start = figures.legs[static_cast<std::size_t>(divert.leg)].start;
    const Divert& before = figures.diverts[(i + figures.diverts.size() - 1) % figures.diverts.size()];
    if (before.site != divert.site) {
      const geo::Pose pose = plan().at(start + divert.from).pose;
      const QPointF at = camera.toScreen(pose.point());
      const QPointF across(std::sin(pose.heading), std::cos(pose.heading));
      painter.setPen(QPen(colors.routeCasing, 4.5, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(at - across * kBar, at + across * kBar);
      painter.setPen(QPen(colors.text, 2.2, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(at - across * kBar, at + across * kBar);
    }
    const QString letter = FigureText::letter(content_.letterOf[static_cast<std::size_t>(divert.site)]);
    const QSizeF size = map::textSize({letter}, font) + QSizeF(9.0, 3.0);
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8}) {
      QRectF plate(QPointF(0.0, 0.0), size);
      plate.moveCenter(camera.toScreen(plan().at(start + divert.from + share * (divert.to - divert.from)).pose.point()));
      if (labels.placeAt(plate)) {
        painter.setPen(QPen(colors.text, 1.2));
        painter.setBrush(Qt::white);
        painter.drawRoundedRect(plate, 2.0, 2.0);
        painter.setFont(font);
        painter.drawText(plate, Qt::AlignCenter, letter);
        break;
      }
    }
  }
}

void Pictures::Private::drawMap(QPainter& painter, const map::MapCamera& camera, bool withDiverts) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(camera.screen(), scene_.colors().unknownBase);
  if (renderer_->relief() != nullptr) {
    map::TileLayer::drawNow(painter, *renderer_->relief(), camera, kGroundResolution);
  }
  if (renderer_->overlay() != nullptr) {
    map::TileLayer::drawNow(painter, *renderer_->overlay(), camera, kGroundResolution);
  }
  const std::vector<QRectF> reserved = renderer_->frameBoxes(camera);
  renderer_->drawObjects(painter, camera, reserved);
  renderer_->drawCursor(painter, camera);
  if (withDiverts) {
    map::LabelPlacer labels(camera.screen());
    for (const QRectF& box : reserved) {
      labels.reserve(box);
    }
    for (const document::ShownTarget& target : *situation_.targets) {
      QRectF symbol(0.0, 0.0, 22.0, 22.0);
      symbol.moveCenter(camera.toScreen(target.point));
      labels.reserve(symbol);
    }
    drawDiverts(painter, camera, labels);
  }
  renderer_->drawFrame(painter, camera);
}

Pictures::Pictures(const BriefingSource& source, const BriefingContent& content, const BriefingOptions& options)
    : d_(std::make_unique<Private>(source, content, options)) {}

Pictures::~Pictures() = default;

void Pictures::map(QPainter& painter, const QRectF& box) const {
  d_->draw(painter, box, [this](QPainter& inner, QSizeF size) {
    d_->renderer_->setCursor({});
    d_->drawMap(inner, map::homeCamera(d_->situation_, size), true);
  });
}

void Pictures::profile(QPainter& painter, const QRectF& box) const {
  d_->draw(painter, box, [this](QPainter& inner, QSizeF size) { profile::ProfileRenderer(d_->situation_, d_->style_, size).paint(inner); });
}

void Pictures::glideMap(QPainter& painter, const QRectF& box, double distance) const {
  d_->draw(painter, box, [this, distance](QPainter& inner, QSizeF size) {
    geo::Box ground;
    for (const document::GlidePoint& point : d_->plan().engineOutAt(distance).path) {
      ground.add(point.pose.point());
    }
    d_->renderer_->setCursor(distance);
    const map::MapCamera camera = map::MapCamera({}, 50.0, size).fittedTo(ground, kRoundGlide * std::min(size.width(), size.height()));
    d_->drawMap(inner, camera, false);
  });
}

void Pictures::glideProfile(QPainter& painter, const QRectF& box, double distance) const {
  d_->draw(painter, box, [this, distance](QPainter& inner, QSizeF size) {
    const document::EngineOut glide = d_->plan().engineOutAt(distance);
    profile::GlideProfileRenderer(d_->plan(), glide, d_->style_, QRectF(QPointF(0.0, 0.0), size)).paint(inner);
  });
}

}  // namespace vp::briefing
