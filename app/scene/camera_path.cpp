#include "app/scene/camera_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "atlas/base/error.h"

namespace burl {

namespace {

struct CameraNumber {
    std::string_view name;
    double View::*member;
};

constexpr std::array camera_numbers{CameraNumber{"azimuth", &View::azimuth_degrees},
                                    CameraNumber{"elevation", &View::elevation_degrees},
                                    CameraNumber{"distance", &View::distance}};

const CameraNumber* find_camera_number(const std::string& path) {
    const std::string_view name = std::string_view(path).substr(camera_prefix.size());
    const auto* found = std::ranges::find(camera_numbers, name, &CameraNumber::name);
    return found == camera_numbers.end() ? nullptr : found;
}

Error bad_move(const NumberMove& move, std::string_view why) {
    return Error(ExitCode::usage, fmt::format("--animate {}: {}", move.said, why));
}

/// Throws Error(usage) for a number that the camera does not have, or values outside its range.
void check_camera_move(const NumberMove& move) {
    const CameraNumber* number = find_camera_number(move.path);
    if (!number)
        throw bad_move(move, "a camera has camera.azimuth, camera.elevation and camera.distance");
    if (number->member == &View::elevation_degrees &&
        std::max(std::abs(move.from), std::abs(move.to)) > 90.0)
        throw bad_move(move, "the elevation must lie between -90 and 90 degrees");
    if (number->member == &View::distance && !(std::min(move.from, move.to) > 0.0))
        throw bad_move(move, "the distance must be above 0 (in bounding-sphere radii)");
}

void add_camera_move(const NumberMove& move, bool turns, std::vector<NumberMove>& moves) {
    check_camera_move(move);
    if (turns && move.path == "camera.azimuth")
        throw bad_move(move, "--turntable turns the azimuth; leave one of them out");
    if (std::ranges::find(moves, move.path, &NumberMove::path) != moves.end())
        throw Error(ExitCode::usage, fmt::format("--animate: {} is given twice", move.path));
    moves.push_back(move);
}

}  // namespace

CameraMoves take_camera_moves(AnimationOptions& animation, int turntable, const View& start) {
    CameraMoves camera;
    std::erase_if(animation.keys, [&](const std::string& text) {
        const bool is_camera = text.starts_with(camera_prefix);
        if (is_camera) add_camera_move(parse_move(text), turntable > 0, camera.moves);
        return is_camera;
    });
    if (turntable > 0) {
        const double from = start.azimuth_degrees;
        camera.moves.push_back({"", "camera.azimuth", from, from + 360.0});
        animation.frames = turntable;
        animation.loop = true;
    }
    animation.recipes_may_rest = !camera.moves.empty();
    camera.frames = animation.frames;
    camera.loop = animation.loop;
    return camera;
}

std::vector<View> views(const CameraMoves& camera, const View& start) {
    std::vector<View> result(std::size_t(std::max(camera.frames, 1)), start);
    if (camera.frames == 0) return result;
    for (const NumberMove& move : camera.moves)
        for (int i = 0; i < camera.frames; ++i)
            result[std::size_t(i)].*find_camera_number(move.path)->member =
                value_at(move, i, camera.frames, camera.loop);
    return result;
}

}  // namespace burl
