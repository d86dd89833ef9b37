#include "app/direct/forward_cube.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "app/scene/shading.h"
#include "procedural/bresenham/field.h"
#include "procedural/color/srgb.h"

namespace burl {

namespace {

/// The parallel projection of pixels: p = origin + x right + y down, and any multiple of `towards`.
struct Projection {
    Vec3d origin, right, down, towards;
};

Projection projection(double size, std::size_t side) {
    const Vec3d towards = Vec3d(-1.0, -1.0, 1.0) / std::sqrt(3.0);
    const Vec3d up = Vec3d(1.0, 1.0, 2.0) / std::sqrt(6.0);
    const Vec3d right = glm::cross(up, towards);
    // The hexagon is sqrt(8/3) high for a cube of side 1; a 20th of the picture stays free on each
    // side.
    const double pixel = size * std::sqrt(8.0 / 3.0) / (0.9 * double(side));
    const double half = 0.5 * double(side) - 0.5;
    return {Vec3d(0.5 * size) - half * pixel * (right - up), pixel * right, -pixel * up, towards};
}

struct Face {
    int axis = 0;
    double at = 0.0;  ///< the face's coordinate along the axis
    double light = 1.0;
};

/// The point projected along `towards` onto the face's plane.
Vec3d onto(const Face& face, const Vec3d& towards, const Vec3d& p) {
    return p + (face.at - p[face.axis]) / towards[face.axis] * towards;
}

bool within(const Face& face, double size, const Vec3d& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (axis != face.axis && !(p[axis] >= 0.0 && p[axis] < size)) return false;
    return true;
}

/// The pixels of a row that show a face: the first one, and their line through solid space.
struct Run {
    std::size_t x = 0;
    LatticeLine line;
};

Run run_of(const Face& face, const Projection& view, double size, std::size_t y, std::size_t side) {
    const Vec3d row = onto(face, view.towards, view.origin + double(y) * view.down);
    const Vec3d next = onto(face, view.towards, view.origin + double(y) * view.down + view.right);
    Run run{0, {row, next - row, 0.0, 0}};
    for (std::size_t x = 0; x < side; ++x) {
        if (!within(face, size, row + double(x) * run.line.step)) continue;
        if (run.line.count == 0) run.x = x;
        ++run.line.count;
    }
    run.line.first = double(run.x);
    return run;
}

}  // namespace

Image<Rgb8> draw_cube(const Texture& texture, double size, std::size_t side, CubeMethod method) {
    const Projection view = projection(size, side);
    const std::vector<Octave> octaves = expand_octaves(texture);
    const ForwardOptions never_anew{ForwardPrecision::float32, std::int64_t(1) << 62};
    const SrgbEncoder<std::uint8_t> encode;
    Image<Rgb8> picture(side, side, background_srgb);
    std::vector<double> f(side);
    for (const Face& face : {Face{0, 0.0, 0.7}, Face{1, 0.0, 0.5}, Face{2, size, 1.0}})
        for (std::size_t y = 0; y < side; ++y) {
            const Run run = run_of(face, view, size, y, side);
            const LatticeLine& line = run.line;
            for (std::size_t j = 0; method == CubeMethod::pixelwise && j < line.count; ++j)
                f[j] = evaluate_field(texture.quadric, octaves,
                                      line.start + (line.first + double(j)) * line.step);
            if (method == CubeMethod::forward && line.count > 0)
                forward_field(texture.quadric, octaves, line, never_anew, f.data());
            for (std::size_t j = 0; j < line.count; ++j) {
                const Vec3d c = face.light * evaluate_color(texture.colors, f[j]);
                picture(run.x + j, y) = {encode(c.x), encode(c.y), encode(c.z)};
            }
        }
    return picture;
}

Image<Rgb8> disagreement(const Image<Rgb8>& a, const Image<Rgb8>& b) {
    Image<Rgb8> picture = a;
    for (std::size_t y = 0; y < a.height(); ++y)
        for (std::size_t x = 0; x < a.width(); ++x) {
            if (a(x, y) != b(x, y))
                picture(x, y) = {0, 0, 0};
            else if (a(x, y) != background_srgb)
                picture(x, y) = {255, 255, 255};
        }
    return picture;
}

}  // namespace burl
