// Corner search. Candidates are evaluated on a copy of the patch in which every inner edge between
// two border vertices is split, so that one factor serves all of them and none collapses anything.
#include "atlas/rectangle_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "atlas/laplacian.h"

namespace burl {
namespace {

using Corners = std::array<std::size_t, 4>;

/// Length of the loop up to each of its vertices, as a share of all; one entry more than vertices.
std::vector<double> loop_positions(const Patch& patch) {
    std::vector<double> position{0.0};
    for (const HalfEdge h : patch.loops[0])
        position.push_back(position.back() +
                           glm::length(patch.points[patch.end(h)] - patch.points[patch.start(h)]));
    const double all = position.back();
    for (std::size_t i = 0; i < position.size(); ++i)
        position[i] = all > 0.0 ? position[i] / all : double(i) / double(position.size() - 1);
    return position;
}

/// Places the border on the unit square's sides.
void place_border(const Patch& patch, const Corners& corners, const std::vector<double>& position,
                  std::vector<Vec2d>& uv) {
    const auto& loop = patch.loops[0];
    static constexpr std::array<std::array<double, 2>, 5> at{
        {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}};
    for (std::size_t side = 0; side < 4; ++side) {
        const std::size_t first = corners[side];
        const std::size_t count = (corners[(side + 1) % 4] + loop.size() - first) % loop.size();
        const auto from_first = [&](std::size_t i) {
            const std::size_t j = first + i;
            return j < loop.size() ? position[j] - position[first]
                                   : 1.0 + position[j - loop.size()] - position[first];
        };
        const double length = from_first(count);
        const Vec2d a(at[side][0], at[side][1]), b(at[side + 1][0], at[side + 1][1]);
        for (std::size_t i = 0; i < count; ++i) {
            // A little of equal spacing keeps border vertices apart that coincide on the mesh.
            const double even = double(i) / double(count);
            const double t =
                length > 0.0 ? 1e-6 * even + (1.0 - 1e-6) * from_first(i) / length : even;
            uv[patch.start(loop[(first + i) % loop.size()])] = a + t * (b - a);
        }
    }
}

std::vector<bool> inner_vertices(const Patch& patch) {
    std::vector<bool> inner(patch.points.size(), true);
    for (const HalfEdge h : patch.loops[0]) inner[patch.start(h)] = false;
    return inner;
}

/// Finds the best corners among candidates and their neighbours.
class CornerSearch {
  public:
    explicit CornerSearch(Patch patch)
        : patch_(split_all(std::move(patch))),
          position_(loop_positions(patch_)),
          laplacian_(patch_, inner_vertices(patch_)),
          measure_(patch_),
          uv_(patch_.points.size()) {}

    std::optional<Corners> run() {
        if (!laplacian_.factored()) return std::nullopt;
        try_sharpest();
        for (int start = 0; start < 4; ++start) try_lengths(start / 16.0, 0.25);
        for (const double first : {1.0 / 3.0, 0.42})
            for (int start = 0; start < 8; ++start) try_lengths(start / 16.0, first);
        for (const double step : {0.05, 0.02}) move_corners(step);
        if (!std::isfinite(best_distortion_)) return std::nullopt;
        return best_;
    }

  private:
    static Patch split_all(Patch patch) {
        std::vector<SideMask> border(patch.points.size(), 0);
        for (const HalfEdge h : patch.loops[0]) border[patch.start(h)] = 1;
        split_chords(patch, border);
        return patch;
    }

    std::size_t nearest_vertex(double place) const {
        place -= std::floor(place);
        const auto after = std::lower_bound(position_.begin(), position_.end(), place);
        std::size_t i = static_cast<std::size_t>(after - position_.begin());
        if (i > 0 && place - position_[i - 1] < position_[i] - place) --i;
        return i % patch_.loops[0].size();
    }

    void try_lengths(double start, double first) {
        attempt({nearest_vertex(start), nearest_vertex(start + first), nearest_vertex(start + 0.5),
                 nearest_vertex(start + 0.5 + first)});
    }

    void move_corners(double step) {
        for (std::size_t corner = 0; corner < 4; ++corner)
            for (const double by : {-step, step}) {
                Corners moved = best_;
                moved[corner] = nearest_vertex(position_[moved[corner]] + by);
                attempt(moved);
            }
    }

    /// The four border vertices where the surface's outline turns most, at least a twentieth of the
    /// outline apart: a flat rectangle's own corners.
    void try_sharpest() {
        const auto& loop = patch_.loops[0];
        std::vector<double> angle(patch_.points.size(), 0.0);
        for (std::size_t t = 0; t < patch_.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const Triangle& v = patch_.triangles[t];
                const Vec3d a = patch_.points[v[(k + 1) % 3]] - patch_.points[v[k]];
                const Vec3d b = patch_.points[v[(k + 2) % 3]] - patch_.points[v[k]];
                angle[v[k]] += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
            }
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < loop.size(); ++i)
            order.emplace_back(angle[patch_.start(loop[i])], i);
        std::sort(order.begin(), order.end());
        std::vector<std::size_t> chosen;
        for (const auto& [turn, i] : order) {
            const bool apart = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
                const double gap = std::abs(position_[i] - position_[other]);
                return std::min(gap, 1.0 - gap) >= 0.05;
            });
            if (apart) chosen.push_back(i);
            if (chosen.size() == 4) break;
        }
        if (chosen.size() == 4) attempt({chosen[0], chosen[1], chosen[2], chosen[3]});
    }

    void attempt(Corners corners) {
        std::sort(corners.begin(), corners.end());
        if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) return;
        const auto [known, fresh] = tried_.emplace(corners, 0.0);
        if (!fresh) return;
        place_border(patch_, corners, position_, uv_);
        laplacian_.solve_harmonic(uv_);
        known->second = measure_(uv_).distortion();
        if (known->second < best_distortion_) {
            best_distortion_ = known->second;
            best_ = corners;
        }
    }

    Patch patch_;
    std::vector<double> position_;
    PatchLaplacian laplacian_;
    StretchMeasure measure_;
    std::vector<Vec2d> uv_;
    std::map<Corners, double> tried_;
    Corners best_{};
    double best_distortion_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<SideMask> side_masks(const Patch& patch, const Corners& corners) {
    const auto& loop = patch.loops[0];
    std::vector<SideMask> sides(patch.points.size(), 0);
    for (std::size_t side = 0; side < 4; ++side) {
        const std::size_t last = corners[(side + 1) % 4];
        for (std::size_t i = corners[side];; i = (i + 1) % loop.size()) {
            SideMask& mask = sides[patch.start(loop[i])];
            mask = static_cast<SideMask>(mask | (1u << side));
            if (i == last) break;
        }
    }
    return sides;
}

std::optional<Corners> find_corners(const Patch& patch) {
    if (patch.loops.size() != 1 || patch.loops[0].size() < 4) return std::nullopt;
    if (patch.loops[0].size() == 4) return Corners{0, 1, 2, 3};
    return CornerSearch(patch).run();
}

std::optional<RectangleMap> harmonic_map(const Patch& patch, const Corners& corners) {
    RectangleMap map;
    map.corners = corners;
    map.sides = side_masks(patch, corners);
    map.uv.resize(patch.points.size());
    const StretchMeasure measure(patch);
    for (const EdgeWeights weights : {EdgeWeights::cotangent, EdgeWeights::uniform}) {
        place_border(patch, corners, loop_positions(patch), map.uv);
        const PatchLaplacian laplacian(patch, inner_vertices(patch), weights);
        if (!laplacian.factored()) continue;
        laplacian.solve_harmonic(map.uv);
        map.stretch = measure(map.uv);
        if (map.stretch.finite()) return map;
    }
    return std::nullopt;
}

std::optional<RectangleMap> map_onto_rectangle(Patch& patch, const DescentOptions& options) {
    const auto corners = find_corners(patch);
    if (!corners) return std::nullopt;
    Patch refined = patch;
    const std::uint32_t extra = split_chords(refined, side_masks(refined, *corners));
    auto map = harmonic_map(refined, *corners);
    if (!map) return std::nullopt;
    map->extra_vertices = extra;
    descend(refined, *map, options);
    patch = std::move(refined);
    return map;
}

}  // namespace burl
