#include "atlas/outline/free_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "atlas/base/elementary.h"
#include "atlas/chart/coarse_map.h"
#include "atlas/chart/laplacian.h"
#include "atlas/chart/last_steps.h"
#include "atlas/chart/stretch_sweeps.h"

namespace burl {
namespace {

constexpr double keep_from_collapse = 0.8;  ///< longest step, relative to that to a collapse
/// Iterations over which gains are averaged, and after which a descent is given up that will not
/// reach the wanted energy: gains only get smaller by then.
constexpr int gain_window = 3, before_giving_up = 8;
/// Times the wanted energy above which a descent is given up after `settling` iterations: of 1,749
/// that came to a wanted energy none was above 92 then.
constexpr double hopeless = 200.0;
constexpr int settling = 2;

/// Triangles of the largest patch that is mapped directly; a larger one is mapped by way of one
/// with a step_down-th of its triangles.
constexpr std::size_t most_direct = 4000, step_down = 4;
/// Sweeps over single vertices, and iterations of the descent, that smooth a map which was carried
/// over from a coarse patch.
constexpr int smoothing_sweeps = 2, smoothing_iterations = 100;

using Field = VertexField;

/// The Laplacian as a guess of the Hessian: exact for maps near an isometry, at the price of a
/// Cholesky factor.
class LaplacianGuess {
  public:
    LaplacianGuess(const Patch& patch, const WeightedEdges& edges)
        : edges_(edges), laplacian_(edges, all_but_one(patch)) {}

    bool usable() const { return laplacian_.factored(); }
    void apply_inverse(Field& field) const { laplacian_.apply_inverse(field); }
    /// Sum of w |move_a - move_b|^2 over the edges.
    double square(const Field& move) const {
        double sum = 0.0;
        for (const WeightedEdges::Edge& e : edges_.edges) {
            const Vec2d d = move[e.a] - move[e.b];
            sum += e.weight * glm::dot(d, d);
        }
        return sum;
    }

  private:
    static std::vector<bool> all_but_one(const Patch& patch) {
        std::vector<bool> is_free(patch.points.size(), true);
        is_free[patch.triangles[0][0]] = false;
        return is_free;
    }

    const WeightedEdges& edges_;
    PatchLaplacian laplacian_;
};

/// The Laplacian's diagonal as a guess of the Hessian, which suits maps that are rough in detail
/// only, as one carried over from a coarser patch.
class DiagonalGuess {
  public:
    explicit DiagonalGuess(const Patch& patch) : diagonal_(patch.points.size(), 0.0) {
        for (const WeightedEdges::Edge& e : edges_with_weights(patch, EdgeWeights::cotangent)) {
            diagonal_[e.a] += e.weight;
            diagonal_[e.b] += e.weight;
        }
    }

    bool usable() const { return true; }
    void apply_inverse(Field& field) const {
        for (std::size_t v = 0; v < field.size(); ++v) field[v] /= diagonal_[v];
    }
    double square(const Field& move) const {
        double sum = 0.0;
        for (std::size_t v = 0; v < move.size(); ++v)
            sum += diagonal_[v] * glm::dot(move[v], move[v]);
        return sum;
    }

  private:
    std::vector<double> diagonal_;
};

/// One descent on a map's energy.
template <class Guess>
class Descent {
  public:
    Descent(const Patch& patch, const Guess& guess, Field& places)
        : guess_(guess), places_(places), energy_(patch) {}

    int run(const FreeMapOptions& options) {
        Field gradient(places_.size());
        value_ = energy_(places_, gradient);
        if (!guess_.usable() || !std::isfinite(value_)) return 0;
        std::vector<double> before{value_};
        int done = 0;
        while (done < options.iterations) {
            const Field old_places = places_, old_gradient = gradient;
            if (!step_along(direction(gradient), gradient)) {
                if (steps_.empty()) break;
                steps_.clear();
                continue;
            }
            ++done;
            before.push_back(value_);
            if (ends(before, options)) break;
            remember(old_places, old_gradient, gradient);
        }
        return done;
    }

    double energy() const { return value_; }

  private:
    /// Whether the descent ends, by its values so far: the first one and that of each iteration.
    static bool ends(const std::vector<double>& values, const FreeMapOptions& options) {
        const auto done = int(values.size()) - 1;
        const double value = values.back();
        if (done >= settling && value > hopeless * options.wanted) return true;
        if (done <= gain_window) return false;
        const double gain = (values[std::size_t(done - gain_window)] - value) / gain_window;
        if (gain < options.least_gain * (value - 1.0)) return true;
        return done >= before_giving_up &&
               value - options.wanted > gain * (options.iterations - done);
    }

    Field direction(const Field& gradient) const {
        return steps_.direction(gradient, [&](Field& d) {
            guess_.apply_inverse(d);
            for (Vec2d& value : d) value *= scale_;
        });
    }

    /// Moves along d, halving the step until the energy falls enough (Armijo), and sets the
    /// gradient there; false, with nothing moved, if it never does.
    bool step_along(const Field& d, Field& gradient) {
        const double slope = dot(d, gradient), before = value_;
        if (!(slope < 0.0)) return false;
        double step = std::min(1.0, keep_from_collapse * energy_.step_to_collapse(places_, d));
        Field moved, there(gradient.size());
        for (int halvings = 0; halvings < 30; ++halvings, step *= 0.5) {
            moved = places_;
            add_scaled(moved, step, d);
            const double after = energy_(moved, there);
            if (!(after <= before + 1e-4 * step * slope)) continue;
            value_ = after;
            places_ = std::move(moved);
            gradient = std::move(there);
            return true;
        }
        return false;
    }

    void remember(const Field& old_places, const Field& old_gradient, const Field& gradient) {
        Field move = places_, change = gradient;
        add_scaled(move, -1.0, old_places);
        add_scaled(change, -1.0, old_gradient);
        const double product = dot(move, change);
        if (!(product > 0.0)) return;
        scale_ = guess_.square(move) / product;
        steps_.add(std::move(move), std::move(change), product);
    }

    const Guess& guess_;
    Field& places_;
    IsometryEnergy energy_;
    LastSteps steps_;
    double value_ = std::numeric_limits<double>::infinity(), scale_ = 1.0;
};

/// Descends from the map's places, and sets its energy and iterations.
template <class Guess>
void descend(const Patch& patch, const Guess& guess, const FreeMapOptions& options, FreeMap& map) {
    Descent descent(patch, guess, map.places);
    map.iterations = descent.run(options);
    map.energy = descent.energy();
}

/// The harmonic map onto a circle with the patch's area, on which the border's vertices have the
/// distances that they have along the border; nothing if it has a flip.
std::optional<Field> onto_circle(const Patch& patch, const WeightedEdges& edges) {
    const std::vector<HalfEdge>& loop = patch.loops[0];
    const double radius = std::sqrt(area_of(patch) / std::numbers::pi);
    const double turn = 2.0 * std::numbers::pi / length_of(patch, loop);
    std::vector<bool> is_free(patch.points.size(), true);
    std::vector<Field> fields{Field(patch.points.size(), Vec2d(0.0))};
    double at = 0.0;
    for (const HalfEdge h : loop) {
        const std::uint32_t v = patch.start(h);
        fields[0][v] = radius * Vec2d(cosine(turn * at), sine(turn * at));
        is_free[v] = false;
        at += glm::distance(patch.points[v], patch.points[patch.end(h)]);
    }
    const PatchLaplacian laplacian(edges, is_free);
    if (!laplacian.factored()) return std::nullopt;
    laplacian.solve_harmonic(fields);
    const Field& q = fields[0];
    for (const auto& [i, j, k] : patch.triangles)
        if (!(cross(q[j] - q[i], q[k] - q[i]) > 0.0)) return std::nullopt;
    return std::move(fields[0]);
}

/// An edge of an outline: its ends' places and vertices.
struct OutlineEdge {
    Vec2d a, b;
    std::uint32_t i, j;

    bool crosses(const OutlineEdge& o) const {
        if (i == o.i || i == o.j || j == o.i || j == o.j) return false;
        const auto apart = [](const Vec2d& p, const Vec2d& q, const OutlineEdge& e) {
            return cross(q - p, e.a - p) * cross(q - p, e.b - p) < 0.0;
        };
        return apart(a, b, o) && apart(o.a, o.b, *this);
    }
};

/// The map of a patch by way of its coarse patch; nothing where that has no map, or one that is
/// worse than wanted.
std::optional<FreeMap> map_coarsely(const Patch& patch, const CoarsePatch& coarse,
                                    const FreeMapOptions& options) {
    const auto of_coarse = map_freely(coarse.patch, options);
    if (!of_coarse || !(of_coarse->energy <= options.wanted)) return std::nullopt;
    auto places = carry_to_fine(patch, coarse, of_coarse->places);
    if (!places) return std::nullopt;
    sweep_stretch(patch, *places, 1.0, smoothing_sweeps);
    FreeMap map{std::move(*places)};
    FreeMapOptions smoothing = options;
    smoothing.iterations = smoothing_iterations;
    descend(patch, DiagonalGuess(patch), smoothing, map);
    if (!std::isfinite(map.energy)) return std::nullopt;
    return map;
}

std::optional<FreeMap> map_directly(const Patch& patch, const FreeMapOptions& options) {
    const WeightedEdges edges = weighted_edges(patch);
    std::optional<Field> start = onto_circle(patch, edges);
    if (!start)
        start = onto_circle(patch, weighted_edges(patch, EdgeWeights::uniform, edges.order));
    if (!start) return std::nullopt;
    FreeMap map{std::move(*start)};
    descend(patch, LaplacianGuess(patch, edges), options, map);
    if (!std::isfinite(map.energy)) return std::nullopt;
    return map;
}

}  // namespace

std::optional<FreeMap> map_freely(const Patch& patch, const FreeMapOptions& options) {
    if (patch.loops.empty() || patch.loops[0].size() < 3) return std::nullopt;
    if (patch.triangles.size() > most_direct) {
        const CoarsePatch coarse = coarsen_patch(patch, patch.triangles.size() / step_down);
        if (2 * coarse.patch.triangles.size() <= patch.triangles.size())
            return map_coarsely(patch, coarse, options);
    }
    return map_directly(patch, options);
}

bool overlaps_itself(const Patch& patch, std::span<const Vec2d> places) {
    std::vector<OutlineEdge> edges;
    Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
    double length = 0.0;
    for (const auto& loop : patch.loops)
        for (const HalfEdge h : loop) {
            const std::uint32_t i = patch.start(h), j = patch.end(h);
            edges.push_back({places[i], places[j], i, j});
            low = glm::min(low, places[i]);
            high = glm::max(high, places[i]);
            length += glm::distance(places[i], places[j]);
        }
    // A grid with about as many cells along its sides as the outline has edges.
    const double cell = length / double(edges.size());
    if (!(cell > 0.0) || !std::isfinite(cell)) return true;
    const auto columns = std::size_t((high.x - low.x) / cell) + 1;
    const auto rows = std::size_t((high.y - low.y) / cell) + 1;
    std::vector<std::vector<std::uint32_t>> grid(columns * rows);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        const Vec2d first = (glm::min(edges[e].a, edges[e].b) - low) / cell;
        const Vec2d last = (glm::max(edges[e].a, edges[e].b) - low) / cell;
        for (auto y = std::size_t(first.y); y <= std::min(std::size_t(last.y), rows - 1); ++y)
            for (auto x = std::size_t(first.x); x <= std::min(std::size_t(last.x), columns - 1);
                 ++x) {
                std::vector<std::uint32_t>& here = grid[y * columns + x];
                for (const std::uint32_t other : here)
                    if (edges[e].crosses(edges[other])) return true;
                here.push_back(e);
            }
    }
    return false;
}

}  // namespace burl
