#include "tests/bench/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::bench {
namespace {

constexpr double kWidth = 900.0;
constexpr double kHeight = 540.0;
constexpr double kLeft = 95.0;
constexpr double kRight = 640.0;  // the legend stands right of it
constexpr double kTop = 80.0;
constexpr double kBottom = 470.0;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

std::string label(double x, double y, const char* anchor, double size, const std::string& text, const std::string& more = "") {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}" font-size="{}" fill="#222"{}>{}</text>)"
                     "\n",
                     x, y, anchor, size, more, escaped(text));
}

std::string segment(double x1, double y1, double x2, double y2, const std::string& color, double width, const std::string& more = "") {
  return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="{}" stroke-width="{}"{}/>)"
                     "\n",
                     x1, y1, x2, y2, color, width, more);
}

/// Maps values to places along one side of the plot.
struct Axis {
  double from = 0.0;
  double to = 1.0;
  double begin = 0.0;
  double end = 1.0;
  bool isLog = false;

  [[nodiscard]] double scaled(double value) const { return isLog ? std::log10(value) : value; }
  [[nodiscard]] double at(double value) const { return begin + (end - begin) * (scaled(value) - scaled(from)) / (scaled(to) - scaled(from)); }
};

/// Round steps of 1, 2 or 5; decades on a logarithmic axis.
std::vector<double> ticksOf(const Axis& axis) {
  std::vector<double> ticks;
  if (axis.isLog) {
    for (double tick = axis.from; tick <= axis.to * 1.0001; tick *= 10.0) {
      ticks.push_back(tick);
    }
    return ticks;
  }
  const double rough = (axis.to - axis.from) / 6.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = power * (rough / power < 1.5 ? 1.0 : rough / power < 3.5 ? 2.0 : rough / power < 7.5 ? 5.0 : 10.0);
  for (double k = std::ceil(axis.from / step - 1e-9); k * step <= axis.to + 1e-9 * step; k += 1.0) {
    ticks.push_back(k * step);
  }
  return ticks;
}

Axis xAxis(const Plot& plot) {
  const auto [low, high] = std::minmax_element(plot.xTicks.begin(), plot.xTicks.end());
  const double room = plot.isXLog ? 1.0 : 0.05 * (*high - *low);
  return {plot.isXLog ? *low / 1.15 : *low - room, plot.isXLog ? *high * 1.15 : *high + room, kLeft, kRight, plot.isXLog};
}

Axis yAxis(const Plot& plot) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const PlotLine& line : plot.lines) {
    for (const PlotPoint& point : line.points) {
      if (!plot.isYLog || point.low > 0.0) {
        low = std::min(low, point.low);
      }
      high = std::max(high, point.high);
    }
  }
  if (plot.isYLog) {
    return {std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::ceil(std::log10(high))), kBottom, kTop, true};
  }
  const double room = std::max(0.08 * (high - low), 1e-9);
  return {low >= 0.0 && low < 0.5 * high ? 0.0 : low - room, high + room, kBottom, kTop, false};
}

std::string drawGrid(const Plot& plot, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double tick : ticksOf(y)) {
    svg += segment(kLeft, y.at(tick), kRight, y.at(tick), "#ddd", 1.0);
    svg += label(kLeft - 8.0, y.at(tick) + 5.0, "end", 14, fmt::format("{:g}", std::abs(tick) < 1e-12 ? 0.0 : tick));
  }
  for (const double tick : plot.xTicks) {
    svg += segment(x.at(tick), kBottom, x.at(tick), kBottom + 6.0, "#222", 1.0);
    svg += label(x.at(tick), kBottom + 22.0, "middle", 14, fmt::format("{:g}", tick));
  }
  svg += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="none" stroke="#222" stroke-width="1"/>)"
                     "\n",
                     kLeft, kTop, kRight - kLeft, kBottom - kTop);
  return svg;
}

std::string drawMark(double x, double y, const PlotLine& line) {
  return fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="4" fill="{}" stroke="{}" stroke-width="1.5"/>)"
                     "\n",
                     x, y, line.isPaper ? "#fff" : line.color, line.color);
}

std::string drawLine(const PlotLine& line, const Axis& x, const Axis& y) {
  std::string band;
  std::string path;
  std::string back;
  std::string marks;
  const auto height = [&](double value) { return y.at(y.isLog ? std::max(value, y.from) : value); };
  for (const PlotPoint& point : line.points) {
    path += fmt::format("{:.1f},{:.1f} ", x.at(point.x), height(point.median));
    band += fmt::format("{:.1f},{:.1f} ", x.at(point.x), height(point.high));
    back = fmt::format("{:.1f},{:.1f} ", x.at(point.x), height(point.low)) + back;
    marks += drawMark(x.at(point.x), height(point.median), line);
  }
  std::string svg;
  if (!line.isPaper) {
    svg += fmt::format("<polygon points=\"{}{}\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"none\"/>\n", band, back, line.color);
  }
  svg += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, line.color,
                     line.isPaper ? " stroke-dasharray=\"6,5\"" : "");
  return svg + marks;
}

std::string drawLegend(const Plot& plot) {
  std::string svg;
  double y = kTop + 12.0;
  for (const PlotLine& line : plot.lines) {
    svg += segment(kRight + 15.0, y, kRight + 45.0, y, line.color, 2.0, line.isPaper ? " stroke-dasharray=\"6,5\"" : "");
    svg += drawMark(kRight + 30.0, y, line);
    svg += label(kRight + 53.0, y + 5.0, "start", 13, line.name);
    y += 24.0;
  }
  return svg;
}

}  // namespace

std::string toSvg(const Plot& plot) {
  const Axis x = xAxis(plot);
  const Axis y = yAxis(plot);
  std::string svg = fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" version="1.2" baseProfile="tiny" width="{0}" height="{1}" viewBox="0 0 {0} {1}" font-family="DejaVu Sans, sans-serif">)"
      "\n",
      kWidth, kHeight);
  svg += fmt::format("<rect x=\"0\" y=\"0\" width=\"{}\" height=\"{}\" fill=\"#fff\"/>\n", kWidth, kHeight);
  svg += label(kLeft, 32.0, "start", 18, plot.title) + label(kLeft, 56.0, "start", 13, plot.note);
  svg += drawGrid(plot, x, y);
  for (const PlotLine& line : plot.lines) {
    svg += drawLine(line, x, y);
  }
  const double middle = 0.5 * (kTop + kBottom);
  svg += label(0.5 * (kLeft + kRight), kBottom + 48.0, "middle", 15, plot.xLabel);
  svg += label(28.0, middle, "middle", 15, plot.yLabel, fmt::format(R"svg( transform="rotate(-90 28 {:.1f})")svg", middle));
  return svg + drawLegend(plot) + "</svg>\n";
}

}  // namespace vp::bench
