#pragma once
// A bounding volume hierarchy (BVH): finds the boxes that a ray or a box intersects without testing
// all of them. It is built by median splits of the boxes' centres along the longest axis, which for
// triangles of similar size is as good as costlier rules and takes O(n log n).
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "app/scene/camera.h"

namespace burl {

/// An axis-aligned bounding box (AABB) in float32, rounded outwards from float64.
struct BoxBounds {
    Vec3f low{std::numeric_limits<float>::infinity()};
    Vec3f high{-std::numeric_limits<float>::infinity()};

    void add(const Vec3d& point);
    void add(const BoxBounds& other);
    bool overlaps(const BoxBounds& other) const;
};

/// A ray prepared for tests against many boxes.
class BoxRay {
  public:
    explicit BoxRay(const Ray& ray);
    /// A lower bound of the t at which the ray enters the box, at least the ray's begin; infinite
    /// where the ray does not meet the box up to `end`.
    double entry(const BoxBounds& box, double end) const;

  private:
    Vec3d origin_, inverse_;
    double begin_;
};

/// The hierarchy over boxes; immutable. Items are numbered as the boxes given.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const BoxBounds> boxes);

    /// Calls visit(item) for all items whose boxes overlap `box`, and perhaps a few more, in
    /// unspecified order.
    template <class Visit>
    void overlapping(const BoxBounds& box, Visit visit) const;
    /// Calls visit(item) for all items whose boxes the ray meets at t <= `end`, and perhaps a few
    /// more, nearer nodes first. visit may lower `end` as it finds intersections.
    template <class Visit>
    void along(const Ray& ray, double& end, Visit visit) const;

  private:
    static constexpr std::uint32_t leaf_items = 4;
    /// The stack's size; median splits of 2^32 items stay far below it.
    static constexpr std::size_t deepest = 64;

    struct Node {
        BoxBounds box{};
        /// The first index into items_ of a leaf; else the node of the second child (the first
        /// child is the next node).
        std::uint32_t first = 0;
        std::uint32_t count = 0;  ///< the number of a leaf's items; 0 for inner nodes
    };
    struct Item {
        Vec3f centre{0.0f};
        std::uint32_t number = 0;
    };

    std::uint32_t build(std::span<const BoxBounds> boxes, std::span<Item> items);
    template <class Visit>
    void visit_leaf(const Node& node, Visit& visit) const {
        for (std::uint32_t i = 0; i < node.count; ++i) visit(items_[node.first + i]);
    }

    std::vector<Node> nodes_;  ///< depth-first, the root first
    std::vector<std::uint32_t> items_;
};

template <class Visit>
void BoxTree::overlapping(const BoxBounds& box, Visit visit) const {
    std::array<std::uint32_t, deepest> waiting{};
    std::size_t count = nodes_.empty() ? 0 : 1;
    while (count > 0) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        if (!node.box.overlaps(box)) continue;
        if (node.count > 0) {
            visit_leaf(node, visit);
            continue;
        }
        waiting[count++] = node.first;
        waiting[count++] = at + 1;
    }
}

template <class Visit>
void BoxTree::along(const Ray& ray, double& end, Visit visit) const {
    struct Waiting {
        std::uint32_t node = 0;
        double entry = 0.0;
    };
    if (nodes_.empty()) return;
    const BoxRay prepared(ray);
    std::array<Waiting, deepest> waiting{};
    std::size_t count = 0;
    const auto wait = [&](std::uint32_t node) {
        waiting[count++] = {node, prepared.entry(nodes_[node].box, end)};
    };
    wait(0);
    while (count > 0) {
        const Waiting next = waiting[--count];
        if (next.entry > end) continue;
        const Node& node = nodes_[next.node];
        if (node.count > 0) {
            visit_leaf(node, visit);
            continue;
        }
        wait(node.first);
        wait(next.node + 1);
        if (waiting[count - 1].entry > waiting[count - 2].entry)
            std::swap(waiting[count - 1], waiting[count - 2]);
    }
}

}  // namespace burl
