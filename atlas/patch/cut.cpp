// A cut removes the adjacency of two triangles; the vertices along the path then separate by
// themselves (rebuild_vertices()).
#include "atlas/patch/cut.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace burl {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

/// Inner half-edges by the vertex they leave. Both directions of an inner edge are in the lists.
class EdgesByVertex {
  public:
    explicit EdgesByVertex(const Patch& patch) : begin_(patch.points.size() + 1, 0) {
        const auto count = static_cast<HalfEdge>(3 * patch.triangles.size());
        for (HalfEdge h = 0; h < count; ++h)
            if (!patch.on_border(h)) ++begin_[patch.start(h) + 1];
        for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        edges_.resize(begin_.back());
        std::vector<std::size_t> place(begin_.begin(), begin_.end() - 1);
        for (HalfEdge h = 0; h < count; ++h)
            if (!patch.on_border(h)) edges_[place[patch.start(h)]++] = h;
    }
    std::span<const HalfEdge> leaving(std::uint32_t vertex) const {
        return {edges_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
    }

  private:
    std::vector<std::size_t> begin_;
    std::vector<HalfEdge> edges_;
};

/// Distances from a set of vertices, and the half-edge each vertex was reached by.
struct Distances {
    std::vector<double> value;
    std::vector<HalfEdge> reached_by;
};

/// Dijkstra's shortest paths from the vertices of a loop. Border vertices are reached but never
/// passed through, so that a path touches the border at its ends only.
Distances distances_from_loop(const Patch& patch, const std::vector<HalfEdge>& loop) {
    const EdgesByVertex edges(patch);
    Distances d{std::vector<double>(patch.points.size(), unreached),
                std::vector<HalfEdge>(patch.points.size(), 0)};
    std::vector<bool> border(patch.points.size(), false);
    for (const auto& any : patch.loops)
        for (const HalfEdge h : any) border[patch.start(h)] = true;
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const HalfEdge h : loop) {
        d.value[patch.start(h)] = 0.0;
        open.emplace(0.0, patch.start(h));
    }
    while (!open.empty()) {
        const auto [distance, vertex] = open.top();
        open.pop();
        if (distance > d.value[vertex] || (border[vertex] && distance > 0.0)) continue;
        for (const HalfEdge h : edges.leaving(vertex)) {
            const std::uint32_t to = patch.end(h);
            const double reach = distance + glm::length(patch.points[to] - patch.points[vertex]);
            if (reach >= d.value[to]) continue;
            d.value[to] = reach;
            d.reached_by[to] = h;
            open.emplace(reach, to);
        }
    }
    return d;
}

void cut(Patch& patch, HalfEdge h) {
    const HalfEdge other = patch.across(h);
    patch.neighbours[h / 3][h % 3] = -1;
    patch.neighbours[other / 3][other % 3] = -1;
}

/// Cuts along the path on which `vertex` was reached.
void cut_back_from(Patch& patch, const Distances& distances, std::uint32_t vertex) {
    std::vector<HalfEdge> path;
    while (distances.value[vertex] > 0.0) {
        path.push_back(distances.reached_by[vertex]);
        vertex = patch.start(path.back());
    }
    for (const HalfEdge h : path) cut(patch, h);
    rebuild_vertices(patch);
}

bool is_mesh_border(const Patch& patch, const Connectivity& connectivity,
                    const std::vector<HalfEdge>& loop) {
    return std::all_of(loop.begin(), loop.end(), [&](HalfEdge h) {
        const std::uint32_t face = patch.faces[h / 3];
        return face != not_in_mesh && connectivity.neighbours[face][h % 3] < 0;
    });
}

void add_fan(Patch& patch, const std::vector<HalfEdge>& loop) {
    const auto hub = static_cast<std::uint32_t>(patch.points.size());
    Vec3d centroid(0.0);
    for (const HalfEdge h : loop) centroid += patch.points[patch.start(h)];
    patch.points.push_back(centroid / double(loop.size()));
    patch.origins.push_back({});
    const auto first = static_cast<std::int32_t>(patch.triangles.size());
    const auto count = static_cast<std::int32_t>(loop.size());
    for (std::int32_t i = 0; i < count; ++i) {
        const HalfEdge h = loop[static_cast<std::size_t>(i)];
        patch.triangles.push_back({patch.end(h), patch.start(h), hub});
        patch.faces.push_back(not_in_mesh);
        // Edge 1 runs from the loop edge's start to the hub: the fan's previous triangle lies
        // there.
        patch.neighbours.push_back({static_cast<std::int32_t>(h / 3),
                                    first + (i + count - 1) % count, first + (i + 1) % count});
        patch.neighbours[h / 3][h % 3] = first + i;
    }
}

}  // namespace

std::uint32_t slit_tube(Patch& patch, std::uint32_t most_cuts) {
    std::uint32_t cuts = 0;
    for (; patch.loops.size() > 1 && cuts < most_cuts; ++cuts) {
        const Distances distances = distances_from_loop(patch, patch.loops[0]);
        double nearest = unreached;
        std::uint32_t target = 0;
        for (std::size_t i = 1; i < patch.loops.size(); ++i)
            for (const HalfEdge h : patch.loops[i])
                if (const double d = distances.value[patch.start(h)]; d < nearest) {
                    nearest = d;
                    target = patch.start(h);
                }
        if (!(nearest < unreached) || nearest <= 0.0) break;
        cut_back_from(patch, distances, target);
    }
    return cuts;
}

bool slit_sock(Patch& patch) {
    if (patch.loops.empty()) return false;
    const Distances distances = distances_from_loop(patch, patch.loops[0]);
    std::vector<bool> border(patch.points.size(), false);
    for (const auto& loop : patch.loops)
        for (const HalfEdge h : loop) border[patch.start(h)] = true;
    double farthest = 0.0;
    std::uint32_t tip = 0;
    for (std::uint32_t v = 0; v < patch.points.size(); ++v)
        if (!border[v] && distances.value[v] < unreached && distances.value[v] > farthest) {
            farthest = distances.value[v];
            tip = v;
        }
    if (!(farthest > 0.0)) return false;
    cut_back_from(patch, distances, tip);
    return true;
}

std::uint32_t fan_holes(Patch& patch, const Connectivity& connectivity, double most) {
    if (patch.loops.size() < 2) return 0;
    const double longest = length_of(patch, patch.loops[0]);
    std::uint32_t closed = 0;
    const auto loops = patch.loops;
    for (std::size_t i = 1; i < loops.size(); ++i) {
        if (length_of(patch, loops[i]) > most * longest) continue;
        if (!is_mesh_border(patch, connectivity, loops[i])) continue;
        add_fan(patch, loops[i]);
        ++closed;
    }
    if (closed > 0) rebuild_vertices(patch);
    return closed;
}

std::optional<DiskCuts> cut_to_disk(Patch& patch, const Connectivity& connectivity) {
    const PatchTopology topology = topology_of(patch);
    if (topology.handles > 0 || topology.loops == 0) return std::nullopt;
    DiskCuts cuts;
    cuts.holes_closed = fan_holes(patch, connectivity);
    cuts.tubes_slit = slit_tube(patch);
    if (!topology_of(patch).is_disk()) return std::nullopt;
    return cuts;
}

}  // namespace burl
