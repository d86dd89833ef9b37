#include "atlas/shape/box_tree.h"

#include <algorithm>
#include <numeric>

namespace burl {

namespace {

Box3 joined(const Box3& a, const Box3& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

class BoxTreeBuilder {
  public:
    BoxTreeBuilder(std::span<const Box3> boxes, std::size_t leaf) : boxes_(boxes), leaf_(leaf) {
        tree_.items.resize(boxes.size());
        std::iota(tree_.items.begin(), tree_.items.end(), 0u);
    }

    ShapeBoxTree build() {
        if (!boxes_.empty()) add(0, std::uint32_t(boxes_.size()));
        return std::move(tree_);
    }

  private:
    void add(std::uint32_t begin, std::uint32_t end) {
        const std::size_t node = tree_.nodes.size();
        const Vec3d first = boxes_[tree_.items[begin]].centre();
        Box3 box = boxes_[tree_.items[begin]], centres{first, first};
        for (std::uint32_t i = begin + 1; i < end; ++i) {
            const Box3& next = boxes_[tree_.items[i]];
            box = joined(box, next);
            centres = joined(centres, {next.centre(), next.centre()});
        }
        tree_.nodes.push_back({box, begin, end, 0});
        if (end - begin <= leaf_) return;
        const std::uint32_t middle = begin + (end - begin) / 2;
        halve_along(longest_axis(centres.size()), begin, middle, end);
        add(begin, middle);
        tree_.nodes[node].second = std::uint32_t(tree_.nodes.size());
        add(middle, end);
    }

    static int longest_axis(const Vec3d& size) {
        if (size.x >= size.y && size.x >= size.z) return 0;
        return size.y >= size.z ? 1 : 2;
    }

    void halve_along(int axis, std::uint32_t begin, std::uint32_t middle, std::uint32_t end) {
        const auto before = [&](std::uint32_t i, std::uint32_t j) {
            const double a = boxes_[i].centre()[axis], b = boxes_[j].centre()[axis];
            return a < b || (a == b && i < j);
        };
        const auto items = tree_.items.begin();
        std::nth_element(items + begin, items + middle, items + end, before);
    }

    std::span<const Box3> boxes_;
    std::size_t leaf_;
    ShapeBoxTree tree_;
};

}  // namespace

ShapeBoxTree build_box_tree(std::span<const Box3> boxes, std::size_t leaf) {
    return BoxTreeBuilder(boxes, leaf).build();
}

Box3 box_of(std::span<const Vec3d> corners) {
    Box3 box{corners[0], corners[0]};
    for (const Vec3d& p : corners) box = joined(box, {p, p});
    return box;
}

double square_distance(const Box3& box, const Vec3d& p) {
    const Vec3d d = glm::max(glm::max(box.low - p, p - box.high), Vec3d(0.0));
    return glm::dot(d, d);
}

double farthest_square(const Box3& box, const Vec3d& p) {
    const Vec3d d = glm::max(glm::abs(p - box.low), glm::abs(box.high - p));
    return glm::dot(d, d);
}

}  // namespace burl
