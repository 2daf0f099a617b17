#pragma once

#include <memory>

namespace osg {
class Group;  // NOLINT(cppcoreguidelines-virtual-class-destructor): counted references destroy
class Node;   // NOLINT(cppcoreguidelines-virtual-class-destructor)
}  // namespace osg

namespace vp::scene3d {

/** Nodes of the graphics library as shared pointers, so that headers need none of its headers. */
using GroupPointer = std::shared_ptr<osg::Group>;
using NodePointer = std::shared_ptr<osg::Node>;

/** Keeps a node alive as long as any copy of the pointer. In a .cpp that knows the node's type. */
template <typename T>
std::shared_ptr<T> keep(T* node) {
  node->ref();
  return std::shared_ptr<T>(node, [](T* n) { n->unref(); });
}

}  // namespace vp::scene3d
