#pragma once
// Frame times of the editor while a hand does what makes no texture: turns the object, opens
// panels.
#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/gl/editor_window.h"

namespace burl {

/// The frames of one thing that a hand does.
struct FramesBench {
    std::string what{}, light{};
    std::size_t faces = 0, frames = 0;
    double seconds = 0.0;
    Durations frame{};  ///< from input to the end of drawing, OpenGL included
    /// Parts of the frame: the object, and the user interface's pixels.
    Durations object{}, screen{};
    double processor = 0.0;  ///< processor time of all threads per frame, in milliseconds
    /// Processor time per time once all rests, and frames drawn a second.
    double idle_share = 0.0, idle_frames = 0.0;
};

/// Plays in an offscreen window, under the headlight and under an environment: the
/// teapot in marble of a texture `side` texels a side and a mesh of a million faces turn for two
/// seconds; the library and the graph open and are moved over. Throws Error.
std::vector<FramesBench> bench_frames(const std::string& platform, std::uint32_t side);

Json frames_json(const FramesBench& bench);
void print_frames(const std::vector<FramesBench>& rows);

}  // namespace burl
