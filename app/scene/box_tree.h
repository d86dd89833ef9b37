#pragma once
// A bounding volume hierarchy: which of many boxes a ray or a box meets, without asking all of
// them. Built by halving at the median of the boxes' centres along their longest side, which for
// triangles of similar size is as good as costlier rules and takes O(n log n).
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "app/scene/ray.h"

namespace burl {

/// A box around things in double, rounded outwards.
struct BoxBounds {
    Vec3f low{std::numeric_limits<float>::infinity()};
    Vec3f high{-std::numeric_limits<float>::infinity()};

    void add(const Vec3d& point);
    void add(const BoxBounds& other);
    bool overlaps(const BoxBounds& other) const;
};

/// A ray prepared to be met with many boxes.
class BoxRay {
  public:
    explicit BoxRay(const Ray& ray);
    /// Where the ray enters the box, at or before the exact t; more than `end`: not before that.
    double entry(const BoxBounds& box, double end) const;

  private:
    Vec3d origin_, inverse_;
    double begin_;
};

/// Immutable; items are numbered as the boxes given.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const BoxBounds> boxes);

    /// Calls visit(item) for all items whose boxes overlap `box` and perhaps a few more, in no
    /// order to rely on.
    template <class Visit>
    void overlapping(const BoxBounds& box, Visit visit) const;
    /// Calls visit(item) for all items whose boxes the ray meets at t <= `end`, near ones first and
    /// perhaps a few more; visit may lower `end` as it finds what the ray meets.
    template <class Visit>
    void along(const Ray& ray, double& end, Visit visit) const;

  private:
    static constexpr std::uint32_t leaf_items = 4;
    static constexpr std::size_t deepest = 64;  ///< median splits of 2^32 items stay far below

    struct Node {
        BoxBounds box{};
        std::uint32_t first = 0;  ///< of a leaf's items; else the second child (the first is next)
        std::uint32_t count = 0;  ///< of a leaf's items; 0: no leaf
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

    std::vector<Node> nodes_;  ///< the root first
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
