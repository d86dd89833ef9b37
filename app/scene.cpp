#include "app/scene.h"

#include "app/normals.h"

namespace burl {

Scene scene_from_mesh(const Mesh& mesh, const SceneMaterial& material) {
    const std::vector<Vec3f> normals = corner_normals(mesh, 40.0);
    Scene scene;
    for (const Part& part : mesh.parts) {
        Surface surface;
        surface.material = material;
        surface.placements = part.instances;
        for (std::uint32_t k = 0; k < part.triangle_count; ++k) {
            const std::size_t t = part.first_triangle + k;
            surface.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
            for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
                surface.positions.push_back(mesh.positions[mesh.triangles[t][corner - 3 * t]]);
                surface.normals.push_back(normals[corner]);
                if (!mesh.corners.uvs.empty()) surface.uvs.push_back(mesh.corners.uvs[corner]);
                if (!mesh.corners.colors.empty()) {
                    surface.colors.push_back(mesh.corners.colors[corner]);
                }
            }
        }
        scene.surfaces.push_back(std::move(surface));
    }
    return scene;
}

Sphere bounding_sphere(const Scene& scene) {
    return sphere_around([&](auto visit) {
        for (const Surface& surface : scene.surfaces) {
            for (const Mat4d& placement : surface.placements) {
                for (const Triangle& triangle : surface.triangles) {
                    for (const std::uint32_t vertex : triangle) {
                        visit(Vec3d(placement * Vec4d(surface.positions[vertex], 1.0)));
                    }
                }
            }
        }
    });
}

}  // namespace burl
