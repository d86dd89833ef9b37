#include "app/scene/box_tree.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace burl {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float rounded_down(double x) {
    const float nearest = float(x);
    return double(nearest) <= x ? nearest : std::nextafter(nearest, -infinity);
}

float rounded_up(double x) {
    return -rounded_down(-x);
}

int longest_axis(const Vec3f& size) {
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

}  // namespace

void BoxBounds::add(const Vec3d& point) {
    for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], rounded_down(point[k]));
        high[k] = std::max(high[k], rounded_up(point[k]));
    }
}

void BoxBounds::add(const BoxBounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

bool BoxBounds::overlaps(const BoxBounds& other) const {
    for (int k = 0; k < 3; ++k)
        if (low[k] > other.high[k] || high[k] < other.low[k]) return false;
    return true;
}

BoxRay::BoxRay(const Ray& ray)
    : origin_(ray.origin), inverse_(1.0 / ray.direction), begin_(ray.begin) {}

double BoxRay::entry(const BoxBounds& box, double end) const {
    // Each slab's distances have an error of less than three roundings and are widened by four
    // (Ize, "Robust BVH Ray Traversal", 2013). A ray within a slab's plane gives NaN there;
    // comparisons with NaN are false, so the other slabs decide.
    constexpr double wider = 1.0 + 0x1p-51, narrower = 1.0 - 0x1p-51;
    double enter = begin_, leave = end;
    for (int k = 0; k < 3; ++k) {
        const bool backwards = std::signbit(inverse_[k]);
        const double near = ((backwards ? box.high : box.low)[k] - origin_[k]) * inverse_[k];
        const double far = ((backwards ? box.low : box.high)[k] - origin_[k]) * inverse_[k];
        if (near * narrower > enter) enter = near * narrower;
        if (far * wider < leave) leave = far * wider;
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

BoxTree::BoxTree(std::span<const BoxBounds> boxes) {
    std::vector<Item> items(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        items[i] = {0.5f * boxes[i].low + 0.5f * boxes[i].high, std::uint32_t(i)};
    if (items.empty()) return;
    nodes_.reserve(items.size());
    items_.reserve(items.size());
    build(boxes, items);
    nodes_.shrink_to_fit();
}

/// Appends the subtree of the items, its root first, and returns the root's index.
std::uint32_t BoxTree::build(std::span<const BoxBounds> boxes, std::span<Item> items) {
    const auto at = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    if (items.size() <= leaf_items) {
        Node& leaf = nodes_[at];
        leaf.first = std::uint32_t(items_.size());
        leaf.count = std::uint32_t(items.size());
        for (const Item& item : items) {
            leaf.box.add(boxes[item.number]);
            items_.push_back(item.number);
        }
        return at;
    }
    Vec3f low(infinity), high(-infinity);
    for (const Item& item : items) {
        low = glm::min(low, item.centre);
        high = glm::max(high, item.centre);
    }
    const int axis = longest_axis(high - low);
    const std::size_t half = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(half), items.end(),
                     [axis](const Item& a, const Item& b) {
                         return std::pair(a.centre[axis], a.number) <
                                std::pair(b.centre[axis], b.number);
                     });
    build(boxes, items.first(half));
    const std::uint32_t second = build(boxes, items.subspan(half));
    nodes_[at].first = second;
    nodes_[at].box = nodes_[at + 1].box;
    nodes_[at].box.add(nodes_[second].box);
    return at;
}

}  // namespace burl
