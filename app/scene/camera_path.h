#pragma once
// Cameras that move: --animate camera.azimuth=FROM:TO and --turntable, view by view. Together with
// the numbers of recipes that move (app/options/animation.h) they make the frames of `burl render`.
#include <string>
#include <vector>

#include "app/options/animation.h"
#include "app/scene/camera.h"

namespace burl {

/// The prefix of the camera's numbers among the paths of --animate.
inline constexpr std::string_view camera_prefix = "camera.";

/// The moves of a camera over a picture's frames.
struct CameraMoves {
    std::vector<NumberMove> moves{};
    int frames = 0;  ///< 0: a single picture
    bool loop = false;
};

/// Takes the texts of --animate that move the camera out of the animation's keys, which are then
/// those of recipes alone; frames of recipes may stand still where any is left (recipes_may_rest).
/// A `turntable` of n > 0 frames adds one turn of the azimuth from `start` on, and makes the
/// animation a loop of n frames. Throws Error(usage) for a number that the camera does not have,
/// that leaves its range or moves twice.
CameraMoves take_camera_moves(AnimationOptions& animation, int turntable, const View& start);

/// The views of all frames; `start` alone for a single picture.
std::vector<View> views(const CameraMoves& camera, const View& start);

}  // namespace burl
