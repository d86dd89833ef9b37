#include "app/direct/infinite_plane.h"

#include <array>
#include <charconv>
#include <cmath>

#include "atlas/base/error.h"

namespace burl {

namespace {

Error bad_plane(const std::string& text) {
    return Error(ExitCode::usage,
                 fmt::format("'{}' is not a plane; write [RECIPE:]NX,NY,NZ,D for the points whose "
                             "NX x + NY y + NZ z is D, for example clouds:0,1,0,4",
                             text));
}

/// Parses four finite numbers, the first three not all 0, and normalises the plane. Throws
/// Error(usage).
Plane parse_numbers(const std::string& text, std::string_view rest) {
    std::array<double, 4> numbers{};
    const char* begin = rest.data();
    const char* const end = begin + rest.size();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [stop, error] = std::from_chars(begin, end, numbers[i]);
        const bool ends = i == 3 ? stop == end : stop != end && *stop == ',';
        if (error != std::errc() || !ends || !std::isfinite(numbers[i])) throw bad_plane(text);
        begin = stop + 1;
    }
    Vec3d normal(numbers[0], numbers[1], numbers[2]);
    const double longest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (!(longest > 0.0)) throw bad_plane(text);
    normal /= longest;
    const double length = longest * glm::length(normal);
    return {glm::normalize(normal), numbers[3] / length};
}

bool finite(const Vec3d& v) {
    return std::isfinite(v.x + v.y + v.z);
}

}  // namespace

PlaneArgument parse_plane(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const std::string_view numbers = colon == std::string::npos
                                         ? std::string_view(text)
                                         : std::string_view(text).substr(colon + 1);
    if (colon == 0) throw bad_plane(text);
    return {parse_numbers(text, numbers), colon == std::string::npos ? "" : text.substr(0, colon)};
}

SampleRays::SampleRays(const Camera& camera, const PictureSize& samples) : eye_(camera.eye) {
    const Vec3d across = camera.right / camera.focal_x, upwards = camera.up / camera.focal_y;
    steps_ = {2.0 / samples.width * across, -2.0 / samples.height * upwards};
    first_ = -camera.back - across + upwards;
}

Vec3d SampleRays::direction(int x, int y) const {
    return first_ + (x + 0.5) * steps_.u + (y + 0.5) * steps_.v;
}

std::optional<PlaneHit> meet(const SampleRays& rays, int x, int y, const Plane& plane) {
    const Vec3d direction = rays.direction(x, y);
    const double height = plane.offset - glm::dot(plane.normal, rays.eye());
    const double approach = glm::dot(plane.normal, direction);
    // A ray that is parallel within rounding errors counts as parallel.
    if (!(std::abs(approach) > 0x1p-48 * glm::length(direction))) return std::nullopt;
    PlaneHit hit;
    hit.depth = height / approach;
    if (!(hit.depth > 0.0)) return std::nullopt;
    hit.point = rays.eye() + hit.depth * direction;
    const auto moved = [&](const Vec3d& step) {
        return hit.depth * (step - glm::dot(plane.normal, step) / approach * direction);
    };
    hit.steps = {moved(rays.steps().u), moved(rays.steps().v)};
    if (!finite(hit.point) || !finite(hit.steps.u) || !finite(hit.steps.v)) return std::nullopt;
    return hit;
}

}  // namespace burl
