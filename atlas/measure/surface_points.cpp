#include "atlas/measure/surface_points.h"

#include <algorithm>
#include <cmath>

#include "atlas/base/random_unit.h"
#include "atlas/solid/weights.h"

namespace burl {

std::vector<SurfacePoint> area_uniform_points(const Mesh& mesh, std::size_t count,
                                              std::uint64_t seed) {
    std::vector<SurfacePoint> points;
    const std::vector<double> areas = triangle_areas(mesh).areas;
    double total = 0.0;
    for (const double area : areas) total += area;
    if (!(total > 0.0)) return points;
    points.reserve(count);
    double below = 0.0;
    std::uint32_t t = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double wanted = total * (double(i) + random_unit(seed, 3 * i)) / double(count);
        while (t + 1 < areas.size() && (areas[t] == 0.0 || below + areas[t] <= wanted))
            below += areas[t++];
        while (areas[t] == 0.0) --t;  // rounding ran past the last triangle with area
        const double root = std::sqrt(random_unit(seed, 3 * i + 1));
        const double v = random_unit(seed, 3 * i + 2);
        points.push_back({t, {1.0 - root, root * (1.0 - v), root * v}});
    }
    return points;
}

Vec3d face_normal(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const auto& p = mesh.positions;
    const Vec3d normal = glm::cross(p[b] - p[a], p[c] - p[a]);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : Vec3d(0.0);
}

}  // namespace burl
