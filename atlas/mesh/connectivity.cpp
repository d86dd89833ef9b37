// The half-edge structure of OpenMesh, used for its connectivity alone (no points, no properties).
// This is the only source that includes it: it compiles slowly and prints to streams of its own.
#include "atlas/mesh/connectivity.h"

#include <ios>
#include <unordered_map>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

namespace burl {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Number of faces after which a point goes on with a fresh vertex: OpenMesh walks round a vertex
/// for each face it adds there, and a hub of a million faces would take hours.
constexpr std::uint32_t most_faces_per_vertex = 4096;

bool repeats_a_point(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Silences OpenMesh's error stream, to which it reports complex edges; they are counted instead.
void silence_openmesh() {
    static const bool silent = [] {
        ::omerr().disable();
        ::omerr().setstate(std::ios_base::badbit);  // skips the formatting, too
        return true;
    }();
    static_cast<void>(silent);
}

/// Adds a mesh's triangles to a half-edge structure, each exactly once.
class HalfEdgeBuilder {
  public:
    explicit HalfEdgeBuilder(const Mesh& mesh) : vertex_of_point_(mesh.positions.size()) {
        const std::size_t faces = mesh.triangles.size();
        half_edges_.reserve(mesh.positions.size(), faces + faces / 2, faces);
        triangle_of_face_.reserve(faces);
        half_edges_.resize(mesh.positions.size(), 0, 0);
        for (std::uint32_t p = 0; p < vertex_of_point_.size(); ++p)
            vertex_of_point_[p].handle = VertexHandle(static_cast<int>(p));
        for (std::uint32_t t = 0; t < faces; ++t)
            if (!repeats_a_point(mesh.triangles[t])) add(t, mesh.triangles[t]);
    }

    std::uint64_t split_faces() const { return split_faces_; }
    void neighbours_to(Connectivity& connectivity) const;

  private:
    /// A half-edge vertex that stands for a mesh point, and the number of its faces.
    struct Place {
        VertexHandle handle;
        std::uint32_t faces = 0;
    };

    void add(std::uint32_t triangle, const Triangle& points) {
        triangle_of_face_.push_back(static_cast<std::int32_t>(triangle));
        if (half_edges_.add_face(vertex(points[0]), vertex(points[1]), vertex(points[2]))
                .is_valid())
            return;
        ++split_faces_;
        if (half_edges_.add_face(second(points[0]), second(points[1]), second(points[2]))
                .is_valid())
            return;
        const VertexHandle a = half_edges_.new_vertex(), b = half_edges_.new_vertex(),
                           c = half_edges_.new_vertex();
        half_edges_.add_face(a, b, c);
    }

    VertexHandle counted(Place& place) {
        if (!place.handle.is_valid() || place.faces == most_faces_per_vertex)
            place = {half_edges_.new_vertex(), 0};
        ++place.faces;
        return place.handle;
    }
    VertexHandle vertex(std::uint32_t point) { return counted(vertex_of_point_[point]); }
    /// The point's second vertex, for faces that do not fit at its first one: sheets that meet
    /// others along a complex edge, or lie on them, stay connected among themselves.
    VertexHandle second(std::uint32_t point) { return counted(second_vertex_of_point_[point]); }

    std::int32_t triangle_across(HalfedgeHandle edge) const {
        const FaceHandle face = half_edges_.face_handle(half_edges_.opposite_halfedge_handle(edge));
        return face.is_valid() ? triangle_of_face_[static_cast<std::size_t>(face.idx())] : -1;
    }

    OpenMesh::TriConnectivity half_edges_;
    std::vector<Place> vertex_of_point_;
    std::unordered_map<std::uint32_t, Place> second_vertex_of_point_;
    std::vector<std::int32_t> triangle_of_face_;
    std::uint64_t split_faces_ = 0;
};

void HalfEdgeBuilder::neighbours_to(Connectivity& connectivity) const {
    for (std::size_t f = 0; f < triangle_of_face_.size(); ++f) {
        auto& sides = connectivity.neighbours[static_cast<std::size_t>(triangle_of_face_[f])];
        // A face's own half-edge is its last one, from corner 2 to corner 0.
        HalfedgeHandle edge = half_edges_.halfedge_handle(FaceHandle(static_cast<int>(f)));
        for (std::int32_t& side : sides) {
            edge = half_edges_.next_halfedge_handle(edge);
            side = triangle_across(edge);
            ++(side < 0 ? connectivity.boundary_edges : connectivity.interior_edges);
        }
    }
    connectivity.interior_edges /= 2;  // counted from both sides
}

/// Number of components of triangles connected across edges; triangles with a repeated point belong
/// to none.
std::uint64_t count_shells(const Mesh& mesh, const Connectivity& connectivity) {
    std::vector<bool> seen(mesh.triangles.size(), false);
    std::vector<std::uint32_t> open;
    std::uint64_t shells = 0;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start] || repeats_a_point(mesh.triangles[start])) continue;
        ++shells;
        seen[start] = true;
        open.push_back(start);
        while (!open.empty()) {
            const std::uint32_t t = open.back();
            open.pop_back();
            for (const std::int32_t side : connectivity.neighbours[t]) {
                if (side < 0 || seen[static_cast<std::size_t>(side)]) continue;
                seen[static_cast<std::size_t>(side)] = true;
                open.push_back(static_cast<std::uint32_t>(side));
            }
        }
    }
    return shells;
}

}  // namespace

Connectivity build_connectivity(const Mesh& mesh) {
    silence_openmesh();
    Connectivity connectivity;
    connectivity.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
    const HalfEdgeBuilder builder(mesh);
    builder.neighbours_to(connectivity);
    connectivity.split_faces = builder.split_faces();
    connectivity.shells = count_shells(mesh, connectivity);
    return connectivity;
}

void cut_between(Connectivity& connectivity, const Mesh& mesh,
                 std::span<const std::uint32_t> labels) {
    if (labels.empty()) return;
    connectivity.labels.assign(labels.begin(), labels.end());
    std::uint64_t cut = 0;
    for (std::size_t t = 0; t < connectivity.neighbours.size(); ++t)
        for (std::int32_t& side : connectivity.neighbours[t]) {
            if (side < 0 || labels[std::size_t(side)] == labels[t]) continue;
            side = -1;
            ++cut;
        }
    connectivity.interior_edges -= cut / 2;  // counted from both sides
    connectivity.boundary_edges += cut;
    connectivity.shells = count_shells(mesh, connectivity);
}

}  // namespace burl
