// Which of many boxes meet a given one: an R*-tree (Beckmann et al. 1990) over boxes in the local frame.
#pragma once

#include "core/geo/pose.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace vp::risk {

/** An R*-tree over a fixed set of boxes; may be asked from several threads at once. */
class BoxTree {
public:
  BoxTree();
  /** @param boxes  local frame, m; none empty; each is known by its index */
  explicit BoxTree(const std::vector<geo::Box>& boxes);
  BoxTree(BoxTree&& other) noexcept;
  BoxTree& operator=(BoxTree&& other) noexcept;
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;
  ~BoxTree();

  [[nodiscard]] bool isEmpty() const;

  /** Writes into `out` the indices of the boxes that meet or touch `box` (local frame, m), in no order; what was in it is gone. */
  void meeting(const geo::Box& box, std::vector<std::size_t>& out) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;  // never null, except in what was moved from
};

}  // namespace vp::risk
