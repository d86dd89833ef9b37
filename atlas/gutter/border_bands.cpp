#include "atlas/gutter/border_bands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "atlas/solid/texel_rows.h"

namespace burl {
namespace {

/// Width in texels by which bands overlap, for texels on the line between two of them.
constexpr double overlap = 1e-6;

std::size_t next_corner(std::uint32_t edge) {
    return (edge % 3 + 1) % 3;
}

/// Whether the texture goes on across an edge of the mesh.
bool goes_on(const ChartedMesh& mesh, const EdgeNeighbours& neighbours, std::uint32_t edge) {
    const std::uint32_t t = edge / 3;
    bool found = false;
    neighbours.visit_opposite(edge, [&](std::uint32_t other) {
        const std::uint32_t u = other / 3;
        found = found || (mesh.charts[u] == mesh.charts[t] &&
                          mesh.corners[u][other % 3] == mesh.corners[t][next_corner(edge)] &&
                          mesh.corners[u][next_corner(other)] == mesh.corners[t][edge % 3]);
    });
    return found;
}

/// The right-hand side of an edge, away from its chart: unit vectors.
struct Facing {
    Vec2d along{0.0}, out{0.0};
};

Facing facing(const ChartEdge& edge) {
    const Vec2d along = glm::normalize(edge.b - edge.a);
    return {along, {along.y, -along.x}};
}

/// The direction in which an edge's band ends at a corner, half-way between the edge's own normal
/// and that of the next edge; at a concave corner the edge's own normal. `turn` is 1 at the edge's
/// end, -1 at its start.
Vec2d band_end(const Facing& own, const Facing& other, double turn) {
    if (turn * cross(own.along, other.along) < 0.0) return own.out;
    const Vec2d sum = own.out + other.out;
    const double length = glm::length(sum);
    return length > 1e-6 ? sum / length : turn * own.along;
}

/// The edges in the order of the places of their starts or ends.
class EndsInOrder {
  public:
    EndsInOrder(std::span<const ChartEdge> edges, Vec2d ChartEdge::*end)
        : edges_(edges), end_(end), order_(edges.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        std::ranges::sort(order_, {}, [&](std::uint32_t i) { return key(edges_[i].*end_, i); });
    }

    /// Calls visit(edge's number) for all edges with that end at the place.
    template <class Visit>
    void visit_at(const Vec2d& place, const Visit& visit) const {
        auto at = std::ranges::lower_bound(
            order_, key(place, 0), {}, [&](std::uint32_t i) { return key(edges_[i].*end_, i); });
        for (; at != order_.end() && edges_[*at].*end_ == place; ++at) visit(*at);
    }

  private:
    static std::tuple<double, double, std::uint32_t> key(const Vec2d& place, std::uint32_t i) {
        return {place.x, place.y, i};
    }

    std::span<const ChartEdge> edges_;
    Vec2d ChartEdge::*end_;
    std::vector<std::uint32_t> order_;
};

/// The texels of the gaps, with the nearest edge so far.
class NearestEdges {
  public:
    NearestEdges(std::span<const ChartEdge> edges, std::span<const TexelGap> gaps, double reach)
        : edges_(edges), gaps_(gaps), reach_(reach), first_(gaps.size() + 1, 0) {
        for (std::size_t i = 0; i < gaps.size(); ++i) first_[i + 1] = first_[i] + gaps[i].count;
        nearest_.resize(first_.back());
        low_ = gaps.front().y;
        for (std::uint32_t i = 0; i < gaps.size(); ++i)
            while (row_begin_.size() <= gaps[i].y - low_) row_begin_.push_back(i);
        row_begin_.push_back(static_cast<std::uint32_t>(gaps.size()));
        for (const TexelGap& gap : gaps) left_ = std::min(left_, gap.x);
        for (const TexelGap& gap : gaps) right_ = std::max(right_, gap.x + gap.count);
    }

    std::vector<std::uint32_t> run() {
        const EndsInOrder starts(edges_, &ChartEdge::a), ends(edges_, &ChartEdge::b);
        for (std::uint32_t i = 0; i < edges_.size(); ++i) {
            const Facing own = facing(edges_[i]);
            const auto widest = [&](const EndsInOrder& others, const Vec2d& place, double turn) {
                Vec2d end = own.out;
                bool alone = true;
                others.visit_at(place, [&](std::uint32_t other) {
                    alone = false;
                    const Vec2d more = band_end(own, facing(edges_[other]), turn);
                    if (glm::dot(more, own.out) < glm::dot(end, own.out)) end = more;
                });
                return alone ? turn * own.along : end;
            };
            visit_band(i, own, widest(ends, edges_[i].a, -1.0), widest(starts, edges_[i].b, 1.0));
        }
        std::vector<std::uint32_t> result(nearest_.size());
        std::ranges::transform(nearest_, result.begin(), &Nearest::edge);
        return result;
    }

  private:
    struct Nearest {
        double square = std::numeric_limits<double>::infinity();  ///< of the distance, in texels
        double facing = 0.0;  ///< part of the distance along the edge's normal
        std::uint32_t edge = no_edge;
    };

    /// Visits the texels of edge i's band, whose sides run along `at_a` and `at_b`.
    void visit_band(std::uint32_t i, const Facing& own, const Vec2d& at_a, const Vec2d& at_b) {
        const ChartEdge& edge = edges_[i];
        // A band's end is within the tangents of the circle sector round the corner.
        const auto corner = [&](const Vec2d& side) {
            const double lean = glm::dot(side, own.along);
            return own.out + own.along * (lean / (1.0 + glm::dot(side, own.out)));
        };
        const Vec2d from(left_, low_);
        std::array<Vec2d, 6> band{edge.a,
                                  edge.b,
                                  edge.b + reach_ * at_b,
                                  edge.b + reach_ * corner(at_b),
                                  edge.a + reach_ * corner(at_a),
                                  edge.a + reach_ * at_a};
        for (Vec2d& point : band) point -= from;
        const auto rows = static_cast<std::uint32_t>(row_begin_.size() - 1);
        visit_slices(band, rows, overlap, [&](std::uint32_t row, const Interval& x) {
            const TexelRun run = centres_within(x.low - overlap, x.high + overlap, right_ - left_);
            if (run.count > 0) visit_texels(i, own, low_ + row, left_ + run.first, run.count);
        });
    }

    void visit_texels(std::uint32_t i, const Facing& own, std::uint32_t y, std::uint32_t x,
                      std::uint32_t count) {
        for (std::uint32_t g = row_begin_[y - low_]; g < row_begin_[y - low_ + 1]; ++g) {
            const TexelGap& gap = gaps_[g];
            const std::uint32_t begin = std::max(x, gap.x);
            const std::uint32_t end = std::min(x + count, gap.x + gap.count);
            for (std::uint32_t at = begin; at < end; ++at)
                offer(nearest_[first_[g] + (at - gap.x)], i, own, {at + 0.5, y + 0.5});
        }
    }

    void offer(Nearest& best, std::uint32_t i, const Facing& own, const Vec2d& q) const {
        const Vec2d to = q - edges_[i].nearest(q);
        const Nearest now{glm::dot(to, to), glm::dot(to, own.out), i};
        if (now.square > reach_ * reach_ || now.facing < -overlap) return;
        if (now.square < best.square || (now.square == best.square && now.facing > best.facing))
            best = now;
    }

    std::span<const ChartEdge> edges_;
    std::span<const TexelGap> gaps_;
    double reach_;
    std::vector<std::size_t> first_;  ///< number of each gap's first texel
    std::vector<Nearest> nearest_;
    std::uint32_t low_ = 0, left_ = no_edge, right_ = 0;  ///< the gaps' box
    std::vector<std::uint32_t> row_begin_;                ///< first gap of each row from low_ on
};

}  // namespace

Vec2d ChartEdge::nearest(const Vec2d& q) const {
    const Vec2d along = b - a;
    const double share = glm::dot(q - a, along) / glm::dot(along, along);
    return share <= 0.0 ? a : share >= 1.0 ? b : a + share * along;
}

ChartEdge chart_edge(const ChartedMesh& mesh, std::uint32_t edge) {
    const std::array<Vec2d, 3>& corners = mesh.corners[edge / 3];
    const bool mirrored = cross(corners[1] - corners[0], corners[2] - corners[0]) < 0.0;
    ChartEdge found{edge, corners[edge % 3], corners[next_corner(edge)]};
    if (mirrored) std::swap(found.a, found.b);
    return found;
}

std::vector<ChartEdge> chart_edges(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                                   std::span<const std::uint32_t> triangles) {
    std::vector<ChartEdge> edges;
    for (const std::uint32_t t : triangles)
        for (std::uint32_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
            if (goes_on(mesh, neighbours, edge)) continue;
            const ChartEdge found = chart_edge(mesh, edge);
            if (found.a != found.b) edges.push_back(found);
        }
    return edges;
}

std::vector<TexelGap> gaps_between(const Image<std::uint32_t>& owners, std::uint32_t first_row) {
    std::vector<TexelGap> gaps;
    for (std::uint32_t y = 0; y < owners.height(); ++y) {
        const auto row = owners.row(y);
        for (auto i = row.begin(); i != row.end();) {
            const auto begin = std::find(i, row.end(), no_owner);
            i = std::find_if(begin, row.end(), [](std::uint32_t t) { return t != no_owner; });
            if (begin != i)
                gaps.push_back(
                    {first_row + y, std::uint32_t(begin - row.begin()), std::uint32_t(i - begin)});
        }
    }
    return gaps;
}

std::vector<std::uint32_t> nearest_edges(std::span<const ChartEdge> edges,
                                         std::span<const TexelGap> gaps, double reach) {
    if (gaps.empty()) return {};
    return NearestEdges(edges, gaps, reach).run();
}

}  // namespace burl
