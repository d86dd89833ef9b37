#include "app/light/padded_cube.h"

#include <algorithm>
#include <cmath>

#include "app/light/cube_map.h"

namespace burl {

PaddedCube::PaddedCube(const CubeFaces& faces) : side_(faces[0].width()), stride_(side_ + 2) {
    for (std::size_t f = 0; f < 6; ++f) {
        faces_[f] = Image<Vec3f>::unset(stride_, stride_);
        for (std::size_t y = 0; y < stride_; ++y)
            for (std::size_t x = 0; x < stride_; ++x)
                faces_[f](x, y) = Vec3f(cube_texel(faces, f, double(x) - 1.0, double(y) - 1.0));
    }
}

Vec3f PaddedCube::operator()(const Vec3f& d) const {
    const Vec3f size = glm::abs(d);
    std::size_t face = 0;
    float across = 0.0f, down = 0.0f, middle = 0.0f;
    if (size.x >= size.y && size.x >= size.z)
        face = d.x < 0.0f ? 1 : 0, across = d.x < 0.0f ? d.z : -d.z, down = -d.y, middle = size.x;
    else if (size.y >= size.z)
        face = d.y < 0.0f ? 3 : 2, across = d.x, down = d.y < 0.0f ? -d.z : d.z, middle = size.y;
    else
        face = d.z < 0.0f ? 5 : 4, across = d.z < 0.0f ? -d.x : d.x, down = -d.y, middle = size.z;
    const float scale = 0.5f * float(side_) / middle, half = 0.5f * float(side_) + 0.5f;
    const float x = half + scale * across, y = half + scale * down;
    const auto column = std::size_t(x), row = std::size_t(y);
    const float fx = x - float(column), fy = y - float(row);
    const Vec3f* at = faces_[face].pixels().data() + row * stride_ + column;
    const Vec3f upper = at[0] + fx * (at[1] - at[0]);
    const Vec3f lower = at[stride_] + fx * (at[stride_ + 1] - at[stride_]);
    return upper + fy * (lower - upper);
}

}  // namespace burl
