#include "core/risk/box_tree.h"

#include "core/base/expect.h"

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

namespace vp::risk {
namespace {

namespace bgi = boost::geometry::index;
using BoostPoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using BoostBox = boost::geometry::model::box<BoostPoint>;
using Entry = std::pair<BoostBox, std::size_t>;

BoostBox boostBox(const geo::Box& box) {
  return {{box.minX, box.minY}, {box.maxX, box.maxY}};
}

std::vector<Entry> entriesOf(const std::vector<geo::Box>& boxes) {
  std::vector<Entry> entries;
  entries.reserve(boxes.size());
  for (const geo::Box& box : boxes) {
    VP_EXPECT(!box.isEmpty());
    entries.emplace_back(boostBox(box), entries.size());
  }
  return entries;
}

}  // namespace

struct BoxTree::Tree {
  bgi::rtree<Entry, bgi::rstar<16>> entries;
};

BoxTree::BoxTree() : tree_(std::make_unique<Tree>()) {}
BoxTree::BoxTree(const std::vector<geo::Box>& boxes) : tree_(std::make_unique<Tree>(Tree{bgi::rtree<Entry, bgi::rstar<16>>(entriesOf(boxes))})) {}
BoxTree::BoxTree(BoxTree&& other) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&& other) noexcept = default;
BoxTree::~BoxTree() = default;

bool BoxTree::isEmpty() const {
  return tree_->entries.empty();
}

void BoxTree::meeting(const geo::Box& box, std::vector<std::size_t>& out) const {
  out.clear();
  tree_->entries.query(bgi::intersects(boostBox(box)),
                       boost::make_function_output_iterator([&out](const Entry& entry) { out.push_back(entry.second); }));
}

}  // namespace vp::risk
