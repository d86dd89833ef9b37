#include "atlas/build/atlas_pose.h"

#include <utility>

namespace burl {
namespace {

/// Builds the pose of a refined mesh corner by corner.
class RefinedPose {
  public:
    RefinedPose(const MeshPose& pose, std::size_t triangles) : pose_(pose) {
        result_.name = pose.name;
        result_.positions.reserve(3 * triangles);
    }
    /// Appends a corner half-way between two corners of the input mesh, or at one of them (a == b).
    void add(std::size_t a, std::size_t b) {
        const Vec3d &p = pose_.positions[a], &q = pose_.positions[b];
        result_.positions.push_back(a == b ? p : 0.5 * p + 0.5 * q);
        if (pose_.normals.empty()) return;
        const Vec3f n = pose_.normals[a];
        result_.normals.push_back(a == b ? n : n + pose_.normals[b]);
    }
    MeshPose take() { return std::move(result_); }

  private:
    const MeshPose& pose_;
    MeshPose result_;
};

/// The input mesh's corner (3 face + k) at which the face has the point; the k-th if the face has
/// the point twice and that corner is one of them.
std::size_t corner_at(const Mesh& mesh, std::uint32_t face, std::uint32_t point, std::size_t k) {
    const Triangle& triangle = mesh.triangles[face];
    const std::size_t first = 3 * std::size_t{face};
    if (triangle[k] == point) return first + k;
    return triangle[0] == point ? first : triangle[1] == point ? first + 1 : first + 2;
}

}  // namespace

MeshPose atlas_pose(const MeshPose& pose, const Mesh& input, const MeshAtlas& atlas) {
    check_pose(pose, input);
    const PatchAtlas* patches = atlas.patches();
    if (!patches) return pose;
    const RefinedMesh& refined = patches->refined;
    const std::size_t count = refined.mesh.triangles.size();
    RefinedPose result(pose, count);
    auto cut = refined.cut_faces.begin();
    std::uint32_t face = 0;
    for (std::size_t t = 0; t < count; ++face) {
        const bool is_cut = cut != refined.cut_faces.end() && cut->face == face;
        const std::size_t end = t + (is_cut ? cut->pieces : 1);
        if (is_cut) ++cut;
        for (; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t point = refined.mesh.triangles[t][k];
                const VertexOrigin origin =
                    point < input.positions.size()
                        ? VertexOrigin{point, point}
                        : refined.extra_points[point - input.positions.size()];
                result.add(corner_at(input, face, origin.a, k),
                           corner_at(input, face, origin.b, k));
            }
    }
    return result.take();
}

}  // namespace burl
