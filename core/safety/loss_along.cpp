#include "core/safety/loss_along.h"

#include "core/base/expect.h"

#include <algorithm>
#include <cmath>

namespace vp::safety {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kCell = 2.0 * Angle::kPi / CourseTable::kCells;
constexpr double kQuantum = 0x1p-40;  // losses per metre are rounded up to whole ones: all sums up to 2^13 of them are exact
constexpr double kEdge = 1e-12;       // rad that a cell reaches beyond its edges, more than rounding of a course

}  // namespace

AngleRange coursesOf(double course, const flight::Piece& piece) {
  if (piece.turn == flight::Turn::Straight) {
    return {course, course};
  }
  const double angle = piece.length / piece.radius;
  const double turned = angle < 2.0 * Angle::kPi ? angle : 2.0 * Angle::kPi;  // also if it is no number
  return piece.turn == flight::Turn::Left ? AngleRange{course, course + turned} : AngleRange{course - turned, course};
}

/// A radius with no glide in the strongest wind from behind, where the bank is the steepest, may have none on some course: all of them are looked at.
CourseTable::CourseTable(const std::vector<WindGlide>& glides, const WindSet& winds, double radius)
    : radius_(radius), isKnown_(kCells / kBlock, false), unknown_(kCells / kBlock), rates_(kCells, 0.0), sums_(kCells + 1, 0.0) {
  const bool isSurelyFinite =
      std::all_of(glides.begin(), glides.end(), [&](const WindGlide& glide) { return glide.getsOn(winds.strongest(), radius); });
  if (!isSurelyFinite) {
    learn(glides, winds, {0.0, 2.0 * Angle::kPi});
    isFinite_ = sums_.back() < kInfinity;
  }
}

void CourseTable::learnBlock(const std::vector<WindGlide>& glides, const WindSet& winds, int block) {
  for (int i = block * kBlock; i < (block + 1) * kBlock; ++i) {
    double most = 0.0;
    for (const WindGlide& glide : glides) {
      most = std::max(most, glide.mostInTurn(winds, radius_, {i * kCell - kEdge, (i + 1) * kCell + kEdge}));
    }
    rates_[static_cast<std::size_t>(i)] = std::ceil(most / kQuantum) * kQuantum;
  }
  isKnown_[static_cast<std::size_t>(block)] = true;
  --unknown_;
}

/// A cell more on each side, for courses that rounding has put there.
void CourseTable::learn(const std::vector<WindGlide>& glides, const WindSet& winds, AngleRange courses) {
  if (unknown_ == 0) {
    return;
  }
  constexpr int kBlocks = kCells / kBlock;
  const double first = std::floor((courses.from / kCell - 1.0) / kBlock);
  const double last = std::min(std::floor((courses.to / kCell + 1.0) / kBlock), first + kBlocks - 1.0);
  bool isNew = false;
  for (double at = first; at <= last; at += 1.0) {
    const int block = static_cast<int>(at - std::floor(at / kBlocks) * kBlocks);
    if (!isKnown_[static_cast<std::size_t>(block)]) {
      learnBlock(glides, winds, block);
      isNew = true;
    }
  }
  for (std::size_t i = 0; isNew && i < rates_.size(); ++i) {
    sums_[i + 1] = sums_[i] + rates_[i];
  }
}

CourseTable::Place CourseTable::placeOf(double course) {
  const double cells = course / kCell;
  const double whole = std::floor(cells);
  return {whole, cells - whole};
}

std::size_t CourseTable::indexOf(double cell) {
  return static_cast<std::size_t>(cell - std::floor(cell / kCells) * kCells);
}

/// Sum of all cells from the first on to the lower edge of this one. What is not known counts nothing, here and there alike.
double CourseTable::sumTo(double cell) const {
  return std::floor(cell / kCells) * sums_.back() + sums_[indexOf(cell)];
}

/// Sums of whole quanta are exact, and so are their differences, whatever was learned before.
double CourseTable::between(double from, double to) const {
  const Place a = placeOf(from);
  const Place b = placeOf(to);
  VP_EXPECT(isKnown_[indexOf(a.cell) / kBlock] && isKnown_[indexOf(b.cell) / kBlock]);
  return kCell * ((sumTo(b.cell) - sumTo(a.cell)) + (b.part * rates_[indexOf(b.cell)] - a.part * rates_[indexOf(a.cell)]));
}

double CourseTable::rateAt(double course) const {
  const std::size_t cell = indexOf(placeOf(course).cell);
  VP_EXPECT(isKnown_[cell / kBlock]);
  return rates_[cell];
}

/// The last cell whose lower edge is not beyond the place looked for.
double CourseTable::courseAt(double from, double integral) const {
  const Place a = placeOf(from);
  const double sought = integral / kCell + a.part * rates_[indexOf(a.cell)];
  const auto upTo = [&](double cell) { return sumTo(cell) - sumTo(a.cell); };
  double step = 1.0;
  double low = a.cell;
  while (upTo(low) > sought) {
    low -= step;
    step *= 2.0;
  }
  double high = std::max(low, a.cell) + 1.0;
  for (step = 1.0; upTo(high) <= sought; step *= 2.0) {
    high += step;
  }
  while (high - low > 1.0) {
    const double middle = std::floor(0.5 * (low + high));
    (upTo(middle) <= sought ? low : high) = middle;
  }
  return kCell * (low + (sought - upTo(low)) / rates_[indexOf(low)]);
}

double nextCourseBreak(double course, double side, double radius, double distance) {
  const double cells = (course + side * distance / radius) / kCell;
  double edge = side > 0.0 ? std::floor(cells) + 1.0 : std::ceil(cells) - 1.0;
  double next = side * (edge * kCell - course) * radius;
  while (!(next > distance)) {  // an edge that rounding has put here
    edge += side;
    next = side * (edge * kCell - course) * radius;
  }
  return next;
}

LossAlong::LossAlong(const CourseTable& table, double course, double side, double radius)
    : table_(&table), course_(course), side_(side), radius_(radius) {}

double LossAlong::nextBreak(double distance) const {
  return table_ == nullptr ? kInfinity : nextCourseBreak(course_, side_, radius_, distance);
}

}  // namespace vp::safety
