#include "app/light/cube_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/light/formulas.h"

namespace burl {

namespace {

/// The axes of a face: the direction of its middle, and those in which its columns and rows grow.
struct FaceAxes {
    Vec3d middle, right, below;
};

const std::array<FaceAxes, 6>& face_axes() {
    static const std::array<FaceAxes, 6> axes{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                               {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                               {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                               {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                               {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                               {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};
    return axes;
}

}  // namespace

CubePoint cube_point(const Vec3d& direction) {
    const Vec3d size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t face = 2 * std::size_t(axis) + (direction[axis] < 0.0 ? 1 : 0);
    const FaceAxes& axes = face_axes()[face];
    const double scale = 0.5 / size[axis];
    return {face,
            {0.5 + scale * glm::dot(direction, axes.right),
             0.5 + scale * glm::dot(direction, axes.below)}};
}

Vec3d cube_direction(const CubePoint& point) {
    const FaceAxes& axes = face_axes()[point.face];
    return axes.middle + (2.0 * point.at.x - 1.0) * axes.right +
           (2.0 * point.at.y - 1.0) * axes.below;
}

Vec3d cube_texel(const CubeFaces& faces, std::size_t face, double x, double y) {
    const double side = double(faces[0].width());
    if (x >= 0.0 && y >= 0.0 && x < side && y < side)
        return vec_of(faces[face](std::size_t(x), std::size_t(y)));
    const CubePoint other =
        cube_point(cube_direction({face, {(x + 0.5) / side, (y + 0.5) / side}}));
    const auto index = [&](double at) {
        return std::size_t(std::clamp(at * side, 0.0, side - 1.0));
    };
    return vec_of(faces[other.face](index(other.at.x), index(other.at.y)));
}

Vec3d cube_lookup(const CubeFaces& faces, const Vec3d& direction) {
    const CubePoint point = cube_point(direction);
    const double side = double(faces[0].width());
    const double x = point.at.x * side - 0.5, y = point.at.y * side - 0.5;
    const double column = std::floor(x), row = std::floor(y), fx = x - column, fy = y - row;
    const auto at = [&](double right, double below) {
        return cube_texel(faces, point.face, column + right, row + below);
    };
    return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
           fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

CubeFaces halved(const CubeFaces& faces) {
    const std::size_t side = faces[0].width() / 2;
    const auto weight = [&](std::size_t x, std::size_t y) {
        const double u = (double(x) + 0.5) / double(side) - 1.0,
                     v = (double(y) + 0.5) / double(side) - 1.0;
        return std::pow(1.0 + u * u + v * v, -1.5);
    };
    CubeFaces result;
    result.fill(Image<RgbF>(side, side));
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            const std::array<double, 4> w{weight(2 * x, 2 * y), weight(2 * x + 1, 2 * y),
                                          weight(2 * x, 2 * y + 1), weight(2 * x + 1, 2 * y + 1)};
            for (std::size_t f = 0; f < 6; ++f) {
                Vec3d sum(0.0);
                for (std::size_t k = 0; k < 4; ++k)
                    sum += w[k] * vec_of(faces[f](2 * x + k % 2, 2 * y + k / 2));
                sum /= w[0] + w[1] + w[2] + w[3];
                result[f](x, y) = rgb_of(sum);
            }
        }
    return result;
}

}  // namespace burl
