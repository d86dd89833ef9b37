#include "atlas/outline/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "atlas/base/elementary.h"
#include "atlas/chart/least_rectangle.h"

namespace burl {
namespace {

/// Classes of edges by the angle between their triangles, in radians: coplanar, smooth, sharp. The
/// box round two joined pieces may have this multiple of the area of their boxes.
constexpr std::array<double, 2> class_ends{0.01, 0.5};
constexpr std::array<double, 3> most_growth{0.0, 1.15, 1.03};
/// Depth to which triangles may overlap, and distance up to which places are the same, relative to
/// the square root of the surface's area.
constexpr double slack = 1e-7;

/// Two triangles' common edge, by its number (3 t + k) in both.
struct Joint {
    std::uint32_t a = 0, b = 0;
    std::size_t sharpness = 0;  ///< class of its angle
    double length = 0.0;
};

using Corners = std::array<Vec2d, 3>;

/// Whether `b` lies beyond some side of `a`, but for `depth`.
bool separated_by_a_side(const Corners& a, const Corners& b, double depth) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2d along = a[(k + 1) % 3] - a[k];
        const double most = depth * glm::length(along);
        if (std::ranges::all_of(b, [&](const Vec2d& q) { return cross(along, q - a[k]) <= most; }))
            return true;
    }
    return false;
}

/// A rigid motion of the plane.
struct Motion {
    Vec2d turn{1.0, 0.0}, shift{0.0};
    Vec2d operator()(const Vec2d& p) const {
        return Vec2d(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y) + shift;
    }
    /// The motion that takes the directed edge (a, b) to (p, q), which has the same length.
    static Motion between(const Vec2d& a, const Vec2d& b, const Vec2d& p, const Vec2d& q) {
        const Vec2d from = b - a, to = q - p;
        Motion motion{glm::normalize(Vec2d(glm::dot(from, to), cross(from, to)))};
        motion.shift = p - motion(a);
        return motion;
    }
};

/// Joins a surface's triangles, each of which is a piece at first.
class Net {
  public:
    Net(const Mesh& mesh, const Connectivity& connectivity, std::span<const std::uint32_t> faces,
        const NetOptions& options)
        : mesh_(mesh), options_(options), faces_(faces), other_(3 * faces.size(), none) {
        pieces_.resize(faces.size());
        std::unordered_map<std::uint32_t, std::uint32_t> local;
        for (std::uint32_t t = 0; t < faces.size(); ++t) {
            local.emplace(faces[t], t);
            lay_flat(t);
            const double own = 0.5 * cross(at_[t][1] - at_[t][0], at_[t][2] - at_[t][0]);
            has_area_ = has_area_ && own > 0.0;
            area_ += own;
            piece_of_.push_back(t);
            pieces_[t] = {{t}, {at_[t].begin(), at_[t].end()}, {}};
            pieces_[t].box = least_rectangle(pieces_[t].hull);
        }
        tolerance_ = slack * std::sqrt(area_);
        for (std::uint32_t t = 0; t < faces.size(); ++t)
            for (std::uint32_t k = 0; k < 3; ++k)
                if (const auto n = local.find(std::uint32_t(connectivity.neighbours[faces[t]][k]));
                    n != local.end())
                    find_joint(3 * t + k, n->second);
        std::ranges::stable_sort(joints_, [](const Joint& x, const Joint& y) {
            return x.sharpness != y.sharpness ? x.sharpness < y.sharpness : x.length > y.length;
        });
    }

    bool has_area() const { return has_area_; }

    void join_all() {
        for (const Joint& joint : joints_) join(joint);
    }

    std::size_t count() const {
        return std::size_t(
            std::ranges::count_if(pieces_, [](const Piece& p) { return !p.triangles.empty(); }));
    }

    /// Length of cuts across smooth edges relative to the boxes' perimeters. It is below 1 for
    /// tubes and cones, which need one cut, and far above for surfaces that are curved both ways,
    /// which become combs.
    double smooth_cuts() const {
        double cut = 0.0, round = 0.0;
        for (const Joint& joint : joints_)
            if (joint.sharpness < class_ends.size() && across(joint.a) == none)
                cut += 2.0 * joint.length;
        for (const Piece& piece : pieces_)
            if (!piece.triangles.empty()) round += piece.box.perimeter();
        return cut / round;
    }

    std::vector<FlatChart> charts() const {
        std::vector<FlatChart> result;
        const std::vector<std::uint32_t> vertex = vertices();
        for (const Piece& piece : pieces_)
            if (!piece.triangles.empty()) result.push_back(chart_of(piece, vertex));
        return result;
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Piece {
        std::vector<std::uint32_t> triangles;
        std::vector<Vec2d> hull;
        TurnedRectangle box;  ///< least box round it
    };

    Vec3d point(std::uint32_t edge) const {
        return mesh_.positions[mesh_.triangles[faces_[edge / 3]][edge % 3]];
    }
    static std::uint32_t next(std::uint32_t edge) { return edge / 3 * 3 + (edge % 3 + 1) % 3; }
    const Vec2d& start(std::uint32_t edge) const { return at_[edge / 3][edge % 3]; }
    const Vec2d& end(std::uint32_t edge) const { return start(next(edge)); }

    /// Lays a triangle into the plane, its first edge along x.
    void lay_flat(std::uint32_t t) {
        const Vec3d a = point(3 * t + 1) - point(3 * t), b = point(3 * t + 2) - point(3 * t);
        const double length = glm::length(a);
        const double along = length > 0.0 ? glm::dot(a, b) / length : 0.0;
        const double height = length > 0.0 ? glm::length(glm::cross(a, b)) / length : 0.0;
        at_.push_back({Vec2d(0.0), Vec2d(length, 0.0), Vec2d(along, height)});
    }

    Vec3d normal(std::uint32_t t) const {
        return glm::normalize(
            glm::cross(point(3 * t + 1) - point(3 * t), point(3 * t + 2) - point(3 * t)));
    }

    /// Remembers the joint of an edge with triangle n.
    void find_joint(std::uint32_t edge, std::uint32_t n) {
        if (other_[edge] != none) return;
        const auto corner = [&](std::uint32_t e) { return mesh_.triangles[faces_[e / 3]][e % 3]; };
        std::uint32_t o = 3 * n;
        while (o < 3 * n + 3 && (other_[o] != none || corner(o) != corner(next(edge)) ||
                                 corner(next(o)) != corner(edge)))
            ++o;
        if (o == 3 * n + 3) return;
        other_[edge] = o;
        other_[o] = edge;
        const double cosine = std::clamp(glm::dot(normal(edge / 3), normal(n)), -1.0, 1.0);
        const double angle = angle_of(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine);
        const std::size_t sharpness =
            std::size_t(std::ranges::count_if(class_ends, [&](double end) { return angle > end; }));
        joints_.push_back({edge, o, sharpness, glm::distance(point(edge), point(next(edge)))});
    }

    /// Whether the two pieces with these edges are tried for the first time, as they are now: of a
    /// pair's joints, which often lie on a line, the first one counts.
    bool is_new_pair(std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax(piece_of_[a / 3], piece_of_[b / 3]);
        const std::pair sizes(pieces_[low].triangles.size(), pieces_[high].triangles.size());
        const auto [found, is_new] = tried_.try_emplace(std::uint64_t(low) << 32 | high, sizes);
        return is_new || std::exchange(found->second, sizes) != sizes;
    }

    /// Joins the two pieces at a joint, if that is allowed.
    void join(const Joint& joint) {
        std::uint32_t keep = joint.a, move = joint.b;
        if (pieces_[piece_of_[keep / 3]].triangles.size() <
            pieces_[piece_of_[move / 3]].triangles.size())
            std::swap(keep, move);
        Piece &to = pieces_[piece_of_[keep / 3]], &from = pieces_[piece_of_[move / 3]];
        if (&to == &from || !is_new_pair(keep, move)) return;
        const Motion motion = Motion::between(start(move), end(move), end(keep), start(keep));
        std::vector<Corners> moved;
        for (const std::uint32_t t : from.triangles)
            moved.push_back({motion(at_[t][0]), motion(at_[t][1]), motion(at_[t][2])});
        if (overlap(to, moved)) return;
        std::vector<Vec2d> hull = to.hull;
        for (const Vec2d& p : from.hull) hull.push_back(motion(p));
        hull = convex_hull(std::move(hull));
        const TurnedRectangle box = least_rectangle(hull);
        const bool flat = joint.sharpness == 0;
        if (box.longer() > (flat ? options_.longest_flat : options_.longest) ||
            (!flat &&
             box.area() > most_growth[joint.sharpness] * (to.box.area() + from.box.area())))
            return;
        if (lies_along(to, from, moved)) return;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            at_[from.triangles[i]] = moved[i];
            piece_of_[from.triangles[i]] = piece_of_[keep / 3];
        }
        to.triangles.insert(to.triangles.end(), from.triangles.begin(), from.triangles.end());
        to.hull = std::move(hull);
        to.box = box;
        from = {};
    }

    bool overlap(const Piece& piece, std::span<const Corners> others) const {
        Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
        for (const Corners& b : others)
            for (const Vec2d& q : b) low = glm::min(low, q), high = glm::max(high, q);
        for (const std::uint32_t t : piece.triangles) {
            const Corners& a = at_[t];
            const Vec2d a_low = glm::min(glm::min(a[0], a[1]), a[2]),
                        a_high = glm::max(glm::max(a[0], a[1]), a[2]);
            if (a_high.x <= low.x || a_low.x >= high.x || a_high.y <= low.y || a_low.y >= high.y)
                continue;
            for (const Corners& b : others)
                if (!separated_by_a_side(a, b, tolerance_) &&
                    !separated_by_a_side(b, a, tolerance_))
                    return true;
        }
        return false;
    }

    /// Whether borders of the two pieces lie along each other that belong to different places of
    /// the surface: lookups beside one would see the other, for no gutter fits between.
    bool lies_along(const Piece& piece, const Piece& other, std::span<const Corners> moved) const {
        if (!(options_.gap > 0.0)) return false;
        double length = 0.0;
        for (const std::uint32_t t : piece.triangles)
            for (std::uint32_t a = 3 * t; a < 3 * t + 3; ++a) {
                if (across(a) != none) continue;
                for (std::size_t i = 0; i < moved.size(); ++i)
                    for (std::uint32_t k = 0; k < 3; ++k)
                        length += length_along(a, 3 * other.triangles[i] + k,
                                               {moved[i][k], moved[i][(k + 1) % 3]});
                if (length > 2.0 * options_.gap) return true;
            }
        return false;
    }

    /// The length of edge a that lies beside edge b, of which the ends are moved to `places`.
    double length_along(std::uint32_t a, std::uint32_t b,
                        const std::array<Vec2d, 2>& places) const {
        const Vec2d &p = start(a), &q = end(a);
        const double gap = options_.gap;
        const Vec2d low = glm::min(places[0], places[1]) - gap,
                    high = glm::max(places[0], places[1]) + gap;
        if (std::max(p.x, q.x) < low.x || std::min(p.x, q.x) > high.x ||
            std::max(p.y, q.y) < low.y || std::min(p.y, q.y) > high.y || across(b) != none)
            return 0.0;
        constexpr int samples = 8;
        int beside = 0;
        for (int i = 0; i < samples; ++i) {
            const double u = (i + 0.5) / samples;
            const Vec2d along = places[1] - places[0];
            const Vec2d at = glm::mix(p, q, u);
            const double square = glm::dot(along, along);
            const double v =
                square > 0.0 ? std::clamp(glm::dot(at - places[0], along) / square, 0.0, 1.0) : 0.0;
            if (glm::distance(at, places[0] + v * along) > gap) continue;
            const Vec3d here = glm::mix(point(a), point(next(a)), u),
                        there = glm::mix(point(b), point(next(b)), v);
            if (glm::distance(here, there) > 3.0 * gap) ++beside;
        }
        return beside * glm::distance(p, q) / samples;
    }

    /// The edge on the other side of an edge, where both lie in one piece and are joined there.
    std::uint32_t across(std::uint32_t edge) const {
        const std::uint32_t o = other_[edge];
        if (o == none || piece_of_[edge / 3] != piece_of_[o / 3]) return none;
        const bool same = glm::distance(start(edge), end(o)) <= tolerance_ &&
                          glm::distance(end(edge), start(o)) <= tolerance_;
        return same ? o : none;
    }

    /// A number of the vertex at each corner, shared by corners that are joined.
    std::vector<std::uint32_t> vertices() const {
        DisjointSets sets(other_.size());
        for (std::uint32_t edge = 0; edge < other_.size(); ++edge)
            if (const std::uint32_t o = across(edge); o != none) {
                sets.join(edge, next(o));
                sets.join(next(edge), o);
            }
        std::vector<std::uint32_t> vertex(other_.size());
        for (std::uint32_t c = 0; c < vertex.size(); ++c) vertex[c] = sets.find(c);
        return vertex;
    }

    FlatChart chart_of(const Piece& piece, const std::vector<std::uint32_t>& vertex) const {
        FlatChart chart;
        std::unordered_map<std::uint32_t, std::uint32_t> number;
        std::vector<std::uint32_t> triangles = piece.triangles;
        std::ranges::sort(triangles);
        for (const std::uint32_t t : triangles) {
            chart.faces.push_back(faces_[t]);
            Triangle& corners = chart.triangles.emplace_back();
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t v = vertex[3 * t + k];
                const auto [found, is_new] = number.emplace(v, std::uint32_t(chart.places.size()));
                if (is_new) chart.places.push_back(start(v));
                corners[k] = found->second;
            }
            chart.area += triangle_area(mesh_, faces_[t]);
        }
        chart.outline = outline_of(triangles, vertex);
        return chart;
    }

    /// The border that has the largest area.
    std::vector<Vec2d> outline_of(const std::vector<std::uint32_t>& triangles,
                                  const std::vector<std::uint32_t>& vertex) const {
        std::vector<Vec2d> outline;
        double most = -std::numeric_limits<double>::infinity();
        std::vector<bool> seen(other_.size(), false);
        for (const std::uint32_t t : triangles)
            for (std::uint32_t first = 3 * t; first < 3 * t + 3; ++first) {
                if (seen[first] || across(first) != none) continue;
                std::vector<Vec2d> loop;
                double twice = 0.0;
                for (std::uint32_t edge = first; !seen[edge];) {
                    seen[edge] = true;
                    loop.push_back(start(vertex[edge]));
                    twice += cross(start(edge), end(edge));
                    edge = next(edge);
                    while (across(edge) != none) edge = next(across(edge));
                }
                if (twice <= most) continue;
                most = twice;
                outline = std::move(loop);
            }
        return outline;
    }

    const Mesh& mesh_;
    NetOptions options_;
    std::span<const std::uint32_t> faces_;
    std::vector<Corners> at_;           ///< places of the triangles' corners
    std::vector<std::uint32_t> other_;  ///< edge on the other side of each edge
    std::vector<std::uint32_t> piece_of_;
    std::vector<Piece> pieces_;
    std::vector<Joint> joints_;
    /// Sizes of pairs of pieces when they were tried last.
    std::unordered_map<std::uint64_t, std::pair<std::size_t, std::size_t>> tried_;
    double area_ = 0.0, tolerance_ = 0.0;
    bool has_area_ = true;
};

}  // namespace

std::optional<std::vector<FlatChart>> unfold(const Mesh& mesh, const Connectivity& connectivity,
                                             std::span<const std::uint32_t> faces,
                                             const NetOptions& options) {
    if (faces.size() > most_unfolded) return std::nullopt;
    Net net(mesh, connectivity, faces, options);
    if (!net.has_area()) return std::nullopt;
    net.join_all();
    if (net.count() > options.most || net.smooth_cuts() > 1.0) return std::nullopt;
    return net.charts();
}

}  // namespace burl
