// The colour language: readable on its backgrounds, and told apart without full colour vision.
#include "ui/style/chart_colors.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using vp::style::ChartColors;
using vp::style::Theme;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

/// How linear RGB looks to a person without one kind of cone.
/// @source G. M. Machado, M. M. Oliveira, L. A. F. Fernandes 2009, A Physiologically-based Model for Simulation of Color
/// Vision Deficiency, IEEE Transactions on Visualization and Computer Graphics 15(6), 1291-1298; severity 1.0
constexpr Matrix kNormal{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
constexpr Matrix kProtanopia{{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeuteranopia{{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

Triple times(const Matrix& m, const Triple& v) {
  Triple product{};
  for (std::size_t i = 0; i < 3; ++i) {
    product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  }
  return product;
}

/// sRGB to linear, IEC 61966-2-1.
Triple linear(const QColor& color) {
  Triple result{color.redF(), color.greenF(), color.blueF()};
  for (double& c : result) {
    c = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return result;
}

/// CIELAB under D65, CIE 15:2004.
Triple lab(const Triple& rgb) {
  constexpr Matrix toXyz{{{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  constexpr Triple white{0.95047, 1.0, 1.08883};
  Triple f = times(toXyz, rgb);
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = f[i] / white[i];
    f[i] = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  }
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

Triple seen(const QColor& color, const Matrix& vision) {
  Triple rgb = times(vision, linear(color));
  for (double& c : rgb) {
    c = std::clamp(c, 0.0, 1.0);
  }
  return lab(rgb);
}

/// Colour difference, CIE 1976; about 2 is just noticeable side by side, 20 is told apart at a glance.
double difference(const QColor& a, const QColor& b, const Matrix& vision) {
  const Triple x = seen(a, vision);
  const Triple y = seen(b, vision);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

double luminance(const QColor& color) {
  const Triple rgb = linear(color);
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// Contrast ratio, W3C Web Content Accessibility Guidelines 2.1, 1.4.3: 4.5 for text, 3 for graphics.
double contrast(const QColor& a, const QColor& b) {
  return (std::max(luminance(a), luminance(b)) + 0.05) / (std::min(luminance(a), luminance(b)) + 0.05);
}

}  // namespace

class TestChartColors : public QObject {
  Q_OBJECT

private slots:
  void differenceAndContrast_ofKnownColors_areRight() {
    QVERIFY(std::abs(contrast(Qt::black, Qt::white) - 21.0) < 1e-9);
    QVERIFY(std::abs(difference(Qt::black, Qt::white, kNormal) - 100.0) < 0.1);
    // red and green of one lightness: far apart for most, near for a deuteranope
    const QColor red(0xC8, 0x50, 0x28);
    const QColor green(0x6E, 0x82, 0x28);
    QVERIFY(difference(red, green, kNormal) > 50.0);
    QVERIFY(difference(red, green, kDeuteranopia) < 0.4 * difference(red, green, kNormal));
    for (const Matrix& vision : {kProtanopia, kDeuteranopia}) {
      QVERIFY(difference(Qt::white, Qt::gray, vision) > 30.0);  // lightness is seen by all
    }
  }

  void text_isReadable_data() { themes(); }
  void text_isReadable() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    for (const QColor& ground : {c.panel, c.sky}) {
      QVERIFY(contrast(c.text, ground) >= 7.0);
      QVERIFY(contrast(c.mutedText, ground) >= 4.5);
    }
    QVERIFY(contrast(c.text, c.textHalo) >= 7.0);  // the halo stands between text and any tint
  }

  void signs_standOutFromTheirGround_data() { themes(); }
  void signs_standOutFromTheirGround() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    for (const QColor& sign : {c.route, c.safeAltitude, c.pitchOnly, c.violation, c.glideAmple, c.ground, c.cursor}) {
      QVERIFY2(contrast(sign, c.sky) >= 3.0, qPrintable(sign.name()));
    }
    QVERIFY(contrast(c.route, c.routeCasing) >= 3.0);
    QVERIFY(contrast(c.target, c.textHalo) >= 4.5 && contrast(c.runway, c.textHalo) >= 4.5);
    QVERIFY(contrast(c.unknown, c.unknownBase) >= 3.0);
    QVERIFY(contrast(c.selection, c.panel) >= 3.0);
    QVERIFY(contrast(c.ground, c.corridor) >= 1.9);  // centre line before corridor, both filled
  }

  void routeGlideAndWarning_areToldApartByEveryone_data() { themes(); }
  void routeGlideAndWarning_areToldApartByEveryone() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    const std::array signs{c.route, c.glideAmple, c.glideTight, c.violation};
    for (const Matrix& vision : {kNormal, kProtanopia, kDeuteranopia}) {
      for (std::size_t i = 0; i < signs.size(); ++i) {
        for (std::size_t j = i + 1; j < signs.size(); ++j) {
          const double apart = difference(signs[i], signs[j], vision);
          QVERIFY2(apart >= 20.0, qPrintable(QStringLiteral("%1 %2 %3").arg(signs[i].name(), signs[j].name()).arg(apart)));
        }
      }
    }
  }

  void weather_isReadableAndNoOtherSign_data() { themes(); }
  void weather_isReadableAndNoOtherSign() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    QVERIFY(contrast(c.weather, c.textHalo) >= 4.5);  // its words
    QVERIFY(contrast(c.weather, c.routeCasing) >= 3.0);
    for (const double height : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      QVERIFY(contrast(c.weather, ChartColors::tint(static_cast<Theme>(theme), height)) >= (height < 1.0 ? 3.0 : 1.2));  // its casing stands on snow
    }
    for (const Matrix& vision : {kNormal, kProtanopia, kDeuteranopia}) {
      for (const QColor& other : {c.route, c.glideAmple, c.glideTight, c.violation}) {
        QVERIFY2(difference(c.weather, other, vision) >= 20.0, qPrintable(other.name()));
      }
    }
  }

  /// Not a matter of hue: whoever sees none must see that a tour is out of date by its pattern, but most will see it by colour.
  void outdatedRoute_isPaler_data() { themes(); }
  void outdatedRoute_isPaler() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    QVERIFY(c.routeOutdated.hsvSaturationF() < 0.3 * c.route.hsvSaturationF());
    QVERIFY(difference(c.route, c.routeOutdated, kNormal) >= 40.0);
  }

  void glide_runsFromTightToAmpleAndRedOnlyBelowZero_data() { themes(); }
  void glide_runsFromTightToAmpleAndRedOnlyBelowZero() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    QCOMPARE(c.glide(-0.01), c.violation);
    QCOMPARE(c.glide(0.0), c.glideTight);
    QCOMPARE(c.glide(ChartColors::kAmpleMargin), c.glideAmple);
    QCOMPARE(c.glide(1e6), c.glideAmple);
    double last = -1.0;
    for (double margin = 0.0; margin <= ChartColors::kAmpleMargin; margin += 5.0) {
      const double away = difference(c.glide(margin), c.glideTight, kNormal);
      QVERIFY(away > last);
      last = away;
      QVERIFY(difference(c.glide(margin), c.violation, kNormal) >= 60.0);
      // Half way to ample the colour comes near the red of a violation for a deuteranope (8 of light, 9 of dark colours): there the
      // line pattern tells them apart. Nearer than that it must not come.
      QVERIFY(difference(c.glide(margin), c.violation, kProtanopia) >= 15.0);
      QVERIFY(difference(c.glide(margin), c.violation, kDeuteranopia) >= 7.5);
    }
  }

  void altitudeScale_isOrderedInLightnessForEveryone() {
    for (const Matrix& vision : {kNormal, kProtanopia, kDeuteranopia}) {
      double last = -1.0;
      for (int i = 0; i <= 50; ++i) {
        const double lightness = seen(ChartColors::altitudeScale(i / 50.0), vision)[0];
        QVERIFY2(lightness > last, qPrintable(QString::number(i)));
        last = lightness;
      }
    }
    QCOMPARE(ChartColors::altitudeScale(-1.0), ChartColors::altitudeScale(0.0));
    QCOMPARE(ChartColors::altitudeScale(2.0), ChartColors::altitudeScale(1.0));
  }

  void tint_isQuietUnderTheSigns_data() { themes(); }
  void tint_isQuietUnderTheSigns() {
    QFETCH(int, theme);
    const ChartColors& c = ChartColors::of(static_cast<Theme>(theme));
    for (int i = 0; i <= 20; ++i) {
      const QColor tint = ChartColors::tint(static_cast<Theme>(theme), i / 20.0);
      QVERIFY(tint.hsvSaturationF() < 0.45);
      for (const Matrix& vision : {kNormal, kProtanopia, kDeuteranopia}) {
        QVERIFY2(difference(tint, c.route, vision) >= 20.0, qPrintable(tint.name()));
        QVERIFY2(difference(tint, c.violation, vision) >= 20.0, qPrintable(tint.name()));
      }
    }
  }

private:
  static void themes() {
    QTest::addColumn<int>("theme");
    QTest::newRow("light") << static_cast<int>(Theme::Light);
    QTest::newRow("dark") << static_cast<int>(Theme::Dark);
  }
};

QTEST_GUILESS_MAIN(TestChartColors)
#include "tst_chart_colors.moc"
