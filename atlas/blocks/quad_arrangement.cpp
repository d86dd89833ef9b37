// The decision: exchanging the halves a and b of a node changes the sum of squared distances to
// neighbours by a multiple of (a - b) . (sum (low - m) - sum (high - m)), where low and high are
// the centres of the clusters beside the two places and m = (a + b) / 2, so the sign of one scalar
// product decides.
#include "atlas/blocks/quad_arrangement.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/each_index.h"

namespace burl {

namespace {

constexpr int swap_sweeps = 2;  // passes per level; the second sees the neighbours' decisions

/// A node at its place on the current level of the tree, with the data that its neighbours read.
struct Spot {
    QuadSpot spot;
    bool leaf = false, upright = false;
    bool exchanged = false;      ///< whether the second half comes first
    Vec3d first{0.0}, second{};  ///< centres of the halves, of a leaf its own twice

    /// Centre of the half at low or high coordinates.
    const Vec3d& centre(bool high) const { return high == exchanged ? first : second; }
};

/// All nodes of one depth of the tree, and the leaves above it, at their places.
class Level {
  public:
    Level(std::span<const QuadNode> nodes, int log_size) : nodes_(nodes), spots_(1) {
        spots_[0] = spot_of({0, {0, 0, log_size, log_size}, {no_spot, no_spot, no_spot, no_spot}});
    }

    bool has_nodes() const {
        return std::ranges::any_of(spots_, [](const Spot& s) { return !s.leaf; });
    }
    void decide() {
        for (int sweep = 0; sweep < swap_sweeps; ++sweep)
            for (Spot& spot : spots_)
                if (!spot.leaf) decide(spot);
    }
    /// The next level, on which every node is replaced by its halves.
    Level halved() const;
    std::vector<QuadSpot> spots() const {
        std::vector<QuadSpot> result;
        result.reserve(spots_.size());
        for (const Spot& s : spots_) result.push_back(s.spot);
        return result;
    }

  private:
    explicit Level(std::span<const QuadNode> nodes) : nodes_(nodes) {}
    Spot spot_of(const QuadSpot& spot) const;
    QuadSpot half_of(const Spot& s, bool high, std::span<const std::uint32_t> begin) const;
    const Vec3d& beside(const Spot& s, QuadSide side, const Vec2d& at) const;
    void decide(Spot& s) const;

    std::span<const QuadNode> nodes_;
    std::vector<Spot> spots_;
};

double width(const QuadPlace& at) {
    return double(1u << at.log_width);
}
double height(const QuadPlace& at) {
    return double(1u << at.log_height);
}

/// Whether a point lies in the high half of a place.
bool is_high(const QuadPlace& at, bool upright, const Vec2d& point) {
    return upright ? point.y > at.y + 0.5 * height(at) : point.x > at.x + 0.5 * width(at);
}

QuadPlace half_place(QuadPlace at, bool upright, bool high) {
    upright ? --at.log_height : --at.log_width;
    if (high) (upright ? at.y : at.x) += 1u << (upright ? at.log_height : at.log_width);
    return at;
}

/// The point a quarter of a texel outside the middle of a side.
Vec2d outside(const QuadPlace& at, QuadSide side) {
    constexpr double little = 0.25;
    const Vec2d low(at.x, at.y), size(width(at), height(at));
    switch (side) {
        case quad_left:
            return {low.x - little, low.y + 0.5 * size.y};
        case quad_right:
            return {low.x + size.x + little, low.y + 0.5 * size.y};
        case quad_below:
            return {low.x + 0.5 * size.x, low.y - little};
        case quad_above:
            break;
    }
    return {low.x + 0.5 * size.x, low.y + size.y + little};
}

Spot Level::spot_of(const QuadSpot& spot) const {
    const QuadNode& node = nodes_[spot.node];
    Spot result;
    result.spot = spot;
    result.leaf = node.half == 0;
    result.first = result.second = node.centre;
    if (result.leaf) return result;
    const int aspect = spot.at.log_width - spot.at.log_height;
    result.upright = (node.upright >> (aspect + most_quad_aspect) & 1) != 0;
    result.first = nodes_[spot.node + 1].centre;
    result.second = nodes_[spot.node + 2 * node.half].centre;
    return result;
}

/// Centre of the cluster beyond the side at that point.
const Vec3d& Level::beside(const Spot& s, QuadSide side, const Vec2d& at) const {
    const Spot& other = spots_[s.spot.beside[side]];
    return other.centre(!other.leaf && is_high(other.spot.at, other.upright, at));
}

void Level::decide(Spot& s) const {
    const bool up = s.upright;
    const Vec3d &a = s.first, &b = s.second;
    const Vec3d middle = 0.5 * (a + b);
    const QuadPlace& at = s.spot.at;
    Vec3d pull{0.0};
    for (const QuadSide side : quad_sides) {
        if (s.spot.beside[side] == no_spot) continue;
        // Only one half ends at such a side.
        const bool ends_here = (side == quad_below || side == quad_above) == up;
        if (ends_here) {
            const double length = up ? width(at) : height(at);
            const Vec3d off = beside(s, side, outside(at, side)) - middle;
            pull += (side == quad_left || side == quad_below ? length : -length) * off;
            continue;
        }
        const double length = 0.5 * (up ? height(at) : width(at));
        for (const bool high : {false, true}) {
            const Vec2d there = outside(half_place(at, up, high), side);
            pull += (high ? -length : length) * (beside(s, side, there) - middle);
        }
    }
    s.exchanged = glm::dot(a - b, pull) < 0.0;
}

/// The low or high half of a node, or the same leaf, on the next level; begin[i] is the number of
/// the first half of spot i there.
QuadSpot Level::half_of(const Spot& s, bool high, std::span<const std::uint32_t> begin) const {
    QuadSpot half = s.spot;
    if (!s.leaf) {
        half.node += high == s.exchanged ? 1 : 2 * nodes_[s.spot.node].half;
        half.at = half_place(s.spot.at, s.upright, high);
    }
    for (const QuadSide side : quad_sides) {
        const std::uint32_t number = s.spot.beside[side];
        if (number == no_spot) continue;
        const Spot& other = spots_[number];
        const bool other_high =
            !other.leaf && is_high(other.spot.at, other.upright, outside(half.at, side));
        half.beside[side] = begin[number] + (other_high ? 1u : 0u);
    }
    return half;
}

Level Level::halved() const {
    Level next(nodes_);
    std::vector<std::uint32_t> begin(spots_.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        begin[i] = count;
        count += spots_[i].leaf ? 1 : 2;
    }
    next.spots_.resize(count);
    for_each_index(spots_.size(), [&](std::size_t i) {
        const Spot& s = spots_[i];
        for (const bool high : {false, true}) {
            if (s.leaf && high) break;
            QuadSpot half = half_of(s, high, begin);
            if (!s.leaf)
                half.beside[s.upright ? (high ? quad_below : quad_above)
                                      : (high ? quad_left : quad_right)] =
                    begin[i] + (high ? 0 : 1);
            next.spots_[begin[i] + (high ? 1 : 0)] = next.spot_of(half);
        }
    });
    return next;
}

}  // namespace

std::vector<QuadSpot> arrange(std::span<const QuadNode> nodes, int log_size) {
    Level level(nodes, log_size);
    while (level.has_nodes()) {
        level.decide();
        level = level.halved();
    }
    return level.spots();
}

}  // namespace burl
