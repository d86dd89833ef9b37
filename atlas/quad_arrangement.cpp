// Exchanging the halves a and b changes the sum of squared distances to neighbours by a multiple
// of (a - b) . (sum (low - m) - sum (high - m)), low and high being what lies beside the two places
// and m = (a + b) / 2, so the sign of one scalar product decides.
#include "atlas/quad_arrangement.h"

#include <algorithm>
#include <cmath>

namespace burl {

namespace {

constexpr int sweeps = 2;  // per level; later ones see what the neighbours have decided
constexpr std::array<QuadSide, 4> all_sides{quad_left, quad_right, quad_below, quad_above};

/// A node at its place on the current level of the tree.
struct Spot {
    QuadSpot spot;
    bool exchanged = false;  ///< the second half comes first
};

class Level {
  public:
    Level(std::span<const QuadNode> nodes, int log_size) : nodes_(nodes) {
        spots_.push_back(
            {{0, {0, 0, log_size, log_size}, {no_spot, no_spot, no_spot, no_spot}}, false});
    }

    bool has_nodes() const {
        return std::ranges::any_of(spots_, [this](const Spot& s) { return !is_leaf(s); });
    }
    void decide() {
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (Spot& spot : spots_)
                if (!is_leaf(spot)) decide(spot);
    }
    /// Every node gives way to its halves.
    Level halved() const;
    std::vector<QuadSpot> spots() const {
        std::vector<QuadSpot> result;
        result.reserve(spots_.size());
        for (const Spot& s : spots_) result.push_back(s.spot);
        return result;
    }

  private:
    explicit Level(std::span<const QuadNode> nodes) : nodes_(nodes) {}
    const QuadNode& node_of(const Spot& s) const { return nodes_[s.spot.node]; }
    bool is_leaf(const Spot& s) const { return node_of(s).half == 0; }
    bool upright(const Spot& s) const {
        const int aspect = s.spot.at.log_width - s.spot.at.log_height;
        return (node_of(s).upright >> (aspect + most_quad_aspect) & 1) != 0;
    }
    /// Number of the half that lies low or high.
    std::uint32_t half(const Spot& s, bool high) const {
        return s.spot.node + (high == s.exchanged ? 1 : 2 * node_of(s).half);
    }
    Vec3d beside(const Spot& s, QuadSide side, const Vec2d& at) const;
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

/// The point a little outside the middle of a side.
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

/// Centre of what lies at that point, beside that side.
Vec3d Level::beside(const Spot& s, QuadSide side, const Vec2d& at) const {
    const Spot& other = spots_[s.spot.beside[side]];
    if (is_leaf(other)) return node_of(other).centre;
    return nodes_[half(other, is_high(other.spot.at, upright(other), at))].centre;
}

void Level::decide(Spot& s) const {
    const bool up = upright(s);
    const Vec3d a = nodes_[s.spot.node + 1].centre,
                b = nodes_[s.spot.node + 2 * node_of(s).half].centre, middle = 0.5 * (a + b);
    const QuadPlace& at = s.spot.at;
    Vec3d pull{0.0};
    for (const QuadSide side : all_sides) {
        if (s.spot.beside[side] == no_spot) continue;
        const bool ends_here = (side == quad_below || side == quad_above) == up;  // one half does
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

Level Level::halved() const {
    Level next(nodes_);
    std::vector<std::uint32_t> begin(spots_.size());  // where each spot's halves begin
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        begin[i] = count;
        count += is_leaf(spots_[i]) ? 1 : 2;
    }
    next.spots_.reserve(count);
    const auto number_at = [&](std::uint32_t i, const Vec2d& point) {
        const Spot& s = spots_[i];
        return begin[i] + (!is_leaf(s) && is_high(s.spot.at, upright(s), point) ? 1u : 0u);
    };
    for (std::size_t i = 0; i < spots_.size(); ++i) {
        const Spot& s = spots_[i];
        const bool leaf = is_leaf(s), up = !leaf && upright(s);
        for (const bool high : {false, true}) {
            if (leaf && high) break;
            Spot part;
            part.spot = leaf ? s.spot
                             : QuadSpot{half(s, high),
                                        half_place(s.spot.at, up, high),
                                        {no_spot, no_spot, no_spot, no_spot}};
            for (const QuadSide side : all_sides)
                if (s.spot.beside[side] != no_spot)
                    part.spot.beside[side] =
                        number_at(s.spot.beside[side], outside(part.spot.at, side));
            if (!leaf)
                part.spot.beside[up ? (high ? quad_below : quad_above)
                                    : (high ? quad_left : quad_right)] = begin[i] + (high ? 0 : 1);
            next.spots_.push_back(part);
        }
    }
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
