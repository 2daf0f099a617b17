#include "ui/briefing/pictures.h"

#include "ui/briefing/figure_text.h"
#include "ui/briefing/page.h"
#include "ui/document/plan_situation.h"
#include "ui/map/chart_frame.h"
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
#include <optional>

namespace vp::briefing {
namespace {

constexpr double kPixel = kInch / 96.0;    // the views draw in pixels of 1/96 inch: their smallest text is then 8.25 points
constexpr double kGroundResolution = 2.5;  // pixels of the ground per such pixel, 240 per inch
constexpr double kGreyResolution = 3.0;    // the same of pictures that are an image as a whole
constexpr int kProfileFont = 13;           // px, so that its small text has 8.25 points
constexpr std::size_t kNamedTargets = 24;  // more targets than this are called by their numbers alone
constexpr qsizetype kLongestLabel = 14;    // characters of a name beside its number
constexpr double kBar = 9.0;               // px to each side of the tour
constexpr double kBeforeThreshold = 22.0;  // px from a threshold to the letter of its runway
constexpr double kSymbol = 22.0;           // px, of a target, kept free of letters
constexpr double kLeastGround = 500.0;     // m, so that a tour along a line has a width
constexpr double kRoundGlide = 22.0;       // px, free around a glide
constexpr double kBesideArrow = 52.0;      // px, the place of the north arrow
constexpr double kAboveScale = 54.0;       // px, the place of the scale bar

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
    scene_.options.legend = false;
    scene_.options.targetHeights = false;  // in the table of targets
    renderer_ = std::make_unique<map::MapRenderer>(scene_);
    style_.units = options.units;
    style_.font = fontOf(Type::Body);
    style_.font.setPixelSize(kProfileFont);
    style_.onPaper = true;
  }

  using Draw = std::function<void(QPainter&, QSizeF)>;
  void draw(QPainter& painter, const QRectF& box, const Draw& draw) const;
  void drawMap(QPainter& painter, const map::MapCamera& camera, std::optional<double> glideFrom) const;
  [[nodiscard]] map::MapCamera glideCamera(const document::EngineOut& glide, QSizeF size) const;
  struct Plate {
    QRectF box;
    QString letter;
  };
  [[nodiscard]] std::vector<Plate> plates(const map::MapCamera& camera, map::LabelPlacer& places) const;
  void drawBars(QPainter& painter, const map::MapCamera& camera) const;
  void drawPlates(QPainter& painter, const std::vector<Plate>& plates) const;
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
  painter.setClipRect(QRectF(QPointF(0.0, 0.0), size), Qt::IntersectClip);
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

/// Where the letters of the runways stand: on the stretches of the tour, and before the thresholds.
std::vector<Pictures::Private::Plate> Pictures::Private::plates(const map::MapCamera& camera, map::LabelPlacer& places) const {
  const QFont font = map::chartFont(map::TextSize::Normal, true);
  std::vector<Plate> plates;
  const auto put = [&](int site, QPointF centre) {
    const QString letter = FigureText::letter(content_.letterOf[static_cast<std::size_t>(site)]);
    QRectF box(QPointF(0.0, 0.0), map::textSize({letter}, font) + QSizeF(9.0, 3.0));
    box.moveCenter(centre);
    if (!places.placeAt(box)) {
      return false;
    }
    plates.push_back({box, letter});
    return true;
  };
  for (std::size_t i = 0; i < content_.letterOf.size(); ++i) {
    if (content_.letterOf[i] >= 0) {
      const geo::Pose& pose = source_.plan->sites[i].pose;
      const QPointF along(std::cos(pose.heading), -std::sin(pose.heading));
      const QPointF across(along.y(), -along.x());
      for (const QPointF& step : {-along, -2.0 * along, across - along, -across - along, -3.0 * along, 2.0 * across - along, -2.0 * across - along}) {
        if (put(static_cast<int>(i), camera.toScreen(pose.point()) + kBeforeThreshold * step)) {
          break;
        }
      }
    }
  }
  for (const Divert& divert : source_.figures.diverts) {
    const double start = source_.figures.legs[static_cast<std::size_t>(divert.leg)].start;
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8}) {
      if (put(divert.site, camera.toScreen(plan().at(start + divert.from + share * (divert.to - divert.from)).pose.point()))) {
        break;
      }
    }
  }
  return plates;
}

/// A bar across the tour where the runway changes.
void Pictures::Private::drawBars(QPainter& painter, const map::MapCamera& camera) const {
  const TourFigures& figures = source_.figures;
  const style::ChartColors& colors = scene_.colors();
  for (std::size_t i = 0; i < figures.diverts.size(); ++i) {
    const Divert& divert = figures.diverts[i];
    const Divert& before = figures.diverts[(i + figures.diverts.size() - 1) % figures.diverts.size()];
    if (before.site != divert.site) {
      const geo::Pose pose = plan().at(figures.legs[static_cast<std::size_t>(divert.leg)].start + divert.from).pose;
      const QPointF at = camera.toScreen(pose.point());
      const QPointF across(kBar * std::sin(pose.heading), kBar * std::cos(pose.heading));
      painter.setPen(QPen(colors.routeCasing, 4.5, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(at - across, at + across);
      painter.setPen(QPen(colors.text, 2.2, Qt::SolidLine, Qt::FlatCap));
      painter.drawLine(at - across, at + across);
    }
  }
}

void Pictures::Private::drawPlates(QPainter& painter, const std::vector<Plate>& plates) const {
  painter.setFont(map::chartFont(map::TextSize::Normal, true));
  for (const Plate& plate : plates) {
    painter.setPen(QPen(scene_.colors().text, 1.2));
    painter.setBrush(Qt::white);
    painter.drawRoundedRect(plate.box, 2.0, 2.0);
    painter.drawText(plate.box, Qt::AlignCenter, plate.letter);
  }
}

/// The whole glide between north arrow and scale bar.
map::MapCamera Pictures::Private::glideCamera(const document::EngineOut& glide, QSizeF size) const {
  geo::Box ground;
  for (const document::GlidePoint& point : glide.path) {
    ground.add(point.pose.point());
  }
  const QSizeF inner(size.width() - kBesideArrow, size.height() - kAboveScale);
  const map::MapCamera fitted = map::MapCamera({}, 50.0, inner).fittedTo(ground, kRoundGlide);
  const geo::Point centre = fitted.centre();
  const double half = 0.5 * fitted.metresPerPixel();
  return {{centre.x + half * kBesideArrow, centre.y - half * kAboveScale}, fitted.metresPerPixel(), size};
}

/// @param glideFrom  m along the tour: with the glide from there and without the letters
void Pictures::Private::drawMap(QPainter& painter, const map::MapCamera& camera, std::optional<double> glideFrom) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(camera.screen(), scene_.colors().unknownBase);
  if (renderer_->relief() != nullptr) {
    map::TileLayer::drawNow(painter, *renderer_->relief(), camera, kGroundResolution);
  }
  std::vector<QRectF> reserved = renderer_->frameBoxes(camera);
  std::vector<Plate> letters;
  if (glideFrom) {
    for (const document::GlidePoint& point : plan().engineOutAt(*glideFrom).path) {
      QRectF box(0.0, 0.0, kBar, kBar);
      box.moveCenter(camera.toScreen(point.pose.point()));
      reserved.push_back(box);
    }
  } else {
    map::LabelPlacer places(camera.screen());
    for (const QRectF& box : reserved) {
      places.reserve(box);
    }
    for (const document::ShownTarget& target : *situation_.targets) {
      QRectF symbol(0.0, 0.0, kSymbol, kSymbol);
      symbol.moveCenter(camera.toScreen(target.point));
      places.reserve(symbol);
    }
    letters = plates(camera, places);
    for (const Plate& plate : letters) {
      reserved.push_back(plate.box);  // names keep off the letters
    }
  }
  renderer_->drawObjects(painter, camera, reserved);
  renderer_->drawCursor(painter, camera);
  if (!glideFrom) {
    drawBars(painter, camera);
    drawPlates(painter, letters);
  }
  map::ChartFrame(scene_, camera, nullptr).draw(painter);  // the words on a glide stand beside its picture
}

Pictures::Pictures(const BriefingSource& source, const BriefingContent& content, const BriefingOptions& options)
    : d_(std::make_unique<Private>(source, content, options)) {}

Pictures::~Pictures() = default;

void Pictures::map(QPainter& painter, const QRectF& box) const {
  d_->draw(painter, box, [this](QPainter& inner, QSizeF size) {
    d_->renderer_->setCursor({});
    d_->drawMap(inner, map::homeCamera(d_->situation_, size), {});
  });
}

double Pictures::mapAspect() const {
  const geo::Box box = map::contentBox(d_->situation_);
  return box.isEmpty() ? 1.0 : (box.maxY - box.minY + kLeastGround) / (box.maxX - box.minX + kLeastGround);
}

void Pictures::profile(QPainter& painter, const QRectF& box) const {
  d_->draw(painter, box, [this](QPainter& inner, QSizeF size) { profile::ProfileRenderer(d_->situation_, d_->style_, size).paint(inner); });
}

void Pictures::glideMap(QPainter& painter, const QRectF& box, double distance) const {
  d_->draw(painter, box, [this, distance](QPainter& inner, QSizeF size) {
    d_->renderer_->setCursor(distance);
    d_->drawMap(inner, d_->glideCamera(d_->plan().engineOutAt(distance), size), distance);
  });
}

void Pictures::glideProfile(QPainter& painter, const QRectF& box, double distance) const {
  d_->draw(painter, box, [this, distance](QPainter& inner, QSizeF size) {
    const document::EngineOut glide = d_->plan().engineOutAt(distance);
    profile::GlideProfileRenderer(d_->plan(), glide, d_->style_, QRectF(QPointF(0.0, 0.0), size)).paint(inner);
  });
}

}  // namespace vp::briefing
