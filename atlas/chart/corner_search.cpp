// Candidates are solved for in batches: first some of equal and unequal proportions all round the
// outline, then the best with each corner moved by 5 % and 2 % of the outline.
#include "atlas/chart/corner_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "atlas/base/elementary.h"
#include "atlas/chart/chord_split.h"
#include "atlas/chart/laplacian.h"
#include "atlas/chart/stretch.h"

namespace burl {
namespace {

constexpr std::size_t first_candidates = 8;  ///< candidates after which a hopeless search ends

/// Length of the loop up to each of its vertices, as a share of the whole; one entry more than
/// vertices.
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

void place_on_sides(const Patch& patch, const Corners& corners, const std::vector<double>& position,
                    std::span<Vec2d> uv) {
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
            // A small share of equal spacing keeps border vertices apart that coincide on the mesh.
            const double even = double(i) / double(count);
            const double t =
                length > 0.0 ? 1e-6 * even + (1.0 - 1e-6) * from_first(i) / length : even;
            uv[patch.start(loop[(first + i) % loop.size()])] = a + t * (b - a);
        }
    }
}

Patch with_chords_split(Patch patch) {
    split_border_chords(patch);
    return patch;
}

/// Finds the best corners among the first candidates and their neighbours.
class CornerSearch {
  public:
    explicit CornerSearch(const Patch& patch)
        : patch_(with_chords_split(patch)),
          position_(loop_positions(patch_)),
          edges_(weighted_edges(patch_)),
          laplacian_(edges_, inner_vertices(patch_)),
          measure_(patch_),
          vertices_(patch.points.size()) {}

    std::optional<CornerChoice> run(double hopeless) {
        if (!laplacian_.factored()) return std::nullopt;
        if (patch_.loops[0].size() == 4) {
            judge({Corners{0, 1, 2, 3}});
            return choice();
        }
        std::vector<Corners> candidates = by_length();
        const std::span all(candidates);
        judge({sharpest()});
        judge(all.first(first_candidates));
        if (best_.distortion <= hopeless) {
            judge(all.subspan(first_candidates));
            for (const double step : {0.05, 0.02}) move_corners(step);
        }
        return choice();
    }

  private:
    std::optional<CornerChoice> choice() {
        if (!std::isfinite(best_.distortion)) return std::nullopt;
        std::erase_if(edges_.order, [this](std::uint32_t v) { return v >= vertices_; });
        best_.order = std::move(edges_.order);
        return std::move(best_);
    }

    std::size_t nearest_vertex(double place) const {
        place -= std::floor(place);
        const auto after = std::lower_bound(position_.begin(), position_.end(), place);
        std::size_t i = static_cast<std::size_t>(after - position_.begin());
        if (i > 0 && place - position_[i - 1] < position_[i] - place) --i;
        return i % patch_.loops[0].size();
    }

    std::vector<Corners> by_length() const {
        std::vector<Corners> result;
        const auto add = [&](double start, double first) {
            result.push_back({nearest_vertex(start), nearest_vertex(start + first),
                              nearest_vertex(start + 0.5), nearest_vertex(start + 0.5 + first)});
        };
        for (int start = 0; start < 4; ++start) add(start / 16.0, 0.25);
        for (const double first : {1.0 / 3.0, 0.42})
            for (int start = 0; start < 8; ++start) add(start / 16.0, first);
        return result;
    }

    /// Judges the best corners with each single corner moved by `step` of the outline either way,
    /// then with all corners moved at once to where the single moves were better.
    void move_corners(double step) {
        const Corners from = best_.corners;
        const double before = best_.distortion;
        std::vector<Corners> moves(8, from);
        std::array<std::size_t, 8> moved;
        for (std::size_t i = 0; i < moves.size(); ++i)
            moves[i][i / 2] = moved[i] =
                nearest_vertex(position_[from[i / 2]] + (i % 2 == 0 ? -step : step));
        const std::vector<double> distortion = judge(moves);
        Corners all = from;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::size_t i =
                2 * corner + (distortion[2 * corner + 1] < distortion[2 * corner] ? 1 : 0);
            if (distortion[i] < before) all[corner] = moved[i];
        }
        judge({all});
    }

    /// The four border vertices where the surface's outline turns most, at least a twentieth of the
    /// outline apart: a flat rectangle's own corners. Where there are fewer than four, position 0
    /// fills the rest.
    Corners sharpest() const {
        const auto& loop = patch_.loops[0];
        std::vector<double> angle(patch_.points.size(), 0.0);
        std::vector<bool> inner = inner_vertices(patch_);
        for (const Triangle& v : patch_.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                if (inner[v[k]]) continue;
                const Vec3d a = patch_.points[v[(k + 1) % 3]] - patch_.points[v[k]];
                const Vec3d b = patch_.points[v[(k + 2) % 3]] - patch_.points[v[k]];
                angle[v[k]] += angle_of(glm::length(glm::cross(a, b)), glm::dot(a, b));
            }
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < loop.size(); ++i)
            order.emplace_back(angle[patch_.start(loop[i])], i);
        std::sort(order.begin(), order.end());
        Corners chosen{};
        std::size_t count = 0;
        for (const auto& [turn, i] : order) {
            const bool apart =
                std::all_of(chosen.begin(), chosen.begin() + count, [&](std::size_t other) {
                    const double gap = std::abs(position_[i] - position_[other]);
                    return std::min(gap, 1.0 - gap) >= 0.05;
                });
            if (apart) chosen[count++] = i;
            if (count == 4) break;
        }
        return chosen;
    }

    std::vector<double> judge(std::initializer_list<Corners> one) {
        std::vector<Corners> candidates(one);
        return judge(std::span<Corners>(candidates));
    }

    /// Distortions of the candidates; infinite where two corners are the same. Keeps the best.
    std::vector<double> judge(std::span<Corners> candidates) {
        std::vector<Corners> fresh;
        for (Corners& corners : candidates) {
            std::sort(corners.begin(), corners.end());
            const double unknown = std::numeric_limits<double>::infinity();
            if (!known_.emplace(corners, unknown).second) continue;
            if (std::adjacent_find(corners.begin(), corners.end()) == corners.end())
                fresh.push_back(corners);
        }
        std::vector<std::vector<Vec2d>> fields(fresh.size());
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            fields[i].resize(patch_.points.size());
            place_on_sides(patch_, fresh[i], position_, fields[i]);
        }
        laplacian_.solve_harmonic(fields);
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            const double d = known_[fresh[i]] = measure_(fields[i]).distortion();
            if (d < best_.distortion) best_ = {fresh[i], d, std::move(fields[i]), {}};
        }
        std::vector<double> result;
        for (const Corners& corners : candidates) result.push_back(known_[corners]);
        return result;
    }

    Patch patch_;
    std::vector<double> position_;
    WeightedEdges edges_;
    PatchLaplacian laplacian_;
    StretchMeasure measure_;
    std::size_t vertices_;  ///< number of vertices of the unsplit patch
    std::map<Corners, double> known_;
    CornerChoice best_;
};

}  // namespace

std::optional<CornerChoice> search_corners(const Patch& patch, double hopeless) {
    if (patch.loops.size() != 1 || patch.loops[0].size() < 4) return std::nullopt;
    return CornerSearch(patch).run(hopeless);
}

void place_border(const Patch& patch, const Corners& corners, std::span<Vec2d> uv) {
    place_on_sides(patch, corners, loop_positions(patch), uv);
}

std::vector<bool> inner_vertices(const Patch& patch) {
    std::vector<bool> inner(patch.points.size(), true);
    for (const HalfEdge h : patch.loops[0]) inner[patch.start(h)] = false;
    return inner;
}

}  // namespace burl
