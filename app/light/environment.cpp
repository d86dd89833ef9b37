#include "app/light/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/light/formulas.h"
#include "app/light/halls.h"
#include "app/light/skies.h"
#include "atlas/base/each_index.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

using std::numbers::pi;

/// The light of a built-in environment, before it is scaled.
struct BuiltIn {
    EnvironmentNote note;
    Vec3d (*light)(const Vec3d& direction);
    int fineness = 1;  ///< a pixel is the mean of fineness x fineness points, where edges are sharp
};

constexpr std::array built_ins{
    BuiltIn{
        {"studio", "soft boxes round a dark room: for metal, varnish and stone"}, studio_light, 2},
    BuiltIn{{"overcast", "a grey sky over dull ground: soft, without shadows"}, overcast_light},
    BuiltIn{{"sun", "a clear sky with a low sun: hard shadows, blue fill"}, sun_light},
    BuiltIn{{"dusk", "the sky after sunset: warm from one side, blue from the other", 0.55},
            dusk_light},
    BuiltIn{{"warehouse", "a hall with skylights, windows and an open gate"}, warehouse_light, 2},
    BuiltIn{{"neutral", "even white light from all sides: for judging colours"}, neutral_light}};

std::size_t wrapped(std::ptrdiff_t x, std::size_t width) {
    const auto w = std::ptrdiff_t(width);
    return std::size_t(((x % w) + w) % w);
}

/// The map's value at column x and row y, in pixels from the first one's centre; columns go round.
Vec3d bilinear(const Image<RgbF>& map, double x, double y) {
    const double column = std::floor(x), row = std::floor(y);
    const double fx = x - column, fy = y - row;
    const auto at = [&](int right, int below) {
        const double line = std::clamp(row + below, 0.0, double(map.height()) - 1.0);
        return vec_of(map(wrapped(std::ptrdiff_t(column) + right, map.width()), std::size_t(line)));
    };
    return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
           fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

/// The mean over a pixel.
Vec3d pixel_light(const BuiltIn& made, std::size_t x, std::size_t y, std::size_t height) {
    const int n = made.fineness;
    Vec3d sum(0.0);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            sum += made.light(direction_at({(double(x) + (i + 0.5) / n) / (2.0 * double(height)),
                                            (double(y) + (j + 0.5) / n) / double(height)}));
    return sum / double(n * n);
}

/// The brightness of white paper, averaged over the upper half of a ball of it: the mean over all
/// directions of (1 + height) times luminance.
double paper_light(const Image<RgbF>& map) {
    double sum = 0.0, weights = 0.0;
    for (std::size_t y = 0; y < map.height(); ++y) {
        const double angle = pi * (double(y) + 0.5) / double(map.height());
        const double weight = std::sin(angle);
        double row = 0.0;
        for (const RgbF& p : map.row(y)) row += luminance(vec_of(p));
        sum += weight * (1.0 + std::cos(angle)) * row;
        weights += weight * double(map.width());
    }
    return sum / weights;
}

}  // namespace

Vec2d equirectangular(const Vec3d& direction) {
    const double length = glm::length(direction);
    const double up = length > 0.0 ? std::clamp(direction.y / length, -1.0, 1.0) : 0.0;
    return {0.5 + std::atan2(direction.z, direction.x) / (2.0 * pi), std::acos(up) / pi};
}

Vec3d direction_at(const Vec2d& uv) {
    const double azimuth = 2.0 * pi * (uv.x - 0.5), angle = pi * uv.y;
    const double out = std::sin(angle);
    return {out * std::cos(azimuth), std::cos(angle), out * std::sin(azimuth)};
}

Vec3d light_from(const Environment& environment, const Vec3d& direction) {
    return light_at(environment, equirectangular(direction));
}

Vec3d light_at(const Environment& environment, const Vec2d& uv) {
    const Image<RgbF>& map = environment.radiance;
    return bilinear(map, uv.x * double(map.width()) - 0.5, uv.y * double(map.height()) - 0.5);
}

std::span<const EnvironmentNote> environment_notes() {
    static constexpr auto notes = [] {
        std::array<EnvironmentNote, built_ins.size()> all{};
        std::ranges::transform(built_ins, all.begin(), &BuiltIn::note);
        return all;
    }();
    return notes;
}

Environment make_environment(std::string_view name, std::size_t height) {
    const auto made =
        std::ranges::find(built_ins, name, [](const BuiltIn& b) { return b.note.name; });
    if (made == built_ins.end())
        throw Error(ExitCode::usage,
                    fmt::format("there is no environment '{}'; `burl list environments` names "
                                "them, and an .exr or .hdr is given by its path",
                                name));
    Environment result{Image<RgbF>(2 * height, height)};
    Image<RgbF>& map = result.radiance;
    for_each_index(
        height,
        [&](std::size_t y) {
            for (std::size_t x = 0; x < map.width(); ++x)
                map(x, y) = rgb_of(pixel_light(*made, x, y, height));
        },
        4);
    const auto scale = float(made->note.paper / paper_light(map));
    map = converted<RgbF>(map, [scale](const RgbF& p) {
        return RgbF{scale * p.r, scale * p.g, scale * p.b};
    });
    return result;
}

Environment turned(const Environment& environment, double azimuth) {
    const Image<RgbF>& map = environment.radiance;
    const double width = double(map.width()), shift = azimuth / 360.0 * width;
    Environment result{Image<RgbF>(map.width(), map.height())};
    for (std::size_t y = 0; y < map.height(); ++y)
        for (std::size_t x = 0; x < map.width(); ++x)
            result.radiance(x, y) =
                rgb_of(bilinear(map, std::fmod(double(x) + shift, width), double(y)));
    return result;
}

}  // namespace burl
