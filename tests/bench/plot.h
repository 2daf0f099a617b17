// A small plotter for bench_figures: lines with bands, drawn as SVG.
#pragma once

#include <string>
#include <vector>

namespace vp::bench {

/** A point of a line: median of runs and the band around it; the band has no width where there was one value. */
struct PlotPoint {
  double x = 0.0;
  double low = 0.0;
  double median = 0.0;
  double high = 0.0;
};

struct PlotLine {
  std::string name;
  std::string color;     ///< as in SVG
  bool isPaper = false;  ///< dashed with open marks: read from the paper, not measured
  std::vector<PlotPoint> points;
};

struct Plot {
  std::string title;
  std::string note;  ///< a second, smaller line
  std::string xLabel;
  std::string yLabel;
  std::vector<double> xTicks;
  bool isXLog = false;
  bool isYLog = false;
  std::vector<PlotLine> lines;
};

/** The plot as an SVG of 900 x 540 (SVG Tiny 1.2, so that QSvgRenderer draws it as browsers do). */
std::string toSvg(const Plot& plot);

}  // namespace vp::bench
