#pragma once
// The suite `burl bench open`: a large mesh is dropped on the editor in real time, and the times to
// its first texture and to its patch atlas and the frame times meanwhile are measured.
#include <string>

#include "app/bench/gl/editor.h"

namespace burl {

/// Seconds from the drop to an event, unless stated otherwise.
struct OpenBench {
    std::size_t faces = 0;
    double read = 0.0;     ///< the mesh has been read
    double shown = 0.0;    ///< its first texture is on the screen
    double finest = 0.0;   ///< its first texture at level 0 is on the screen
    double smooth = 0.0;   ///< level 0 is drawn with several samples per pixel
    double patches = 0.0;  ///< level 0 in the recipe's own atlas is on the screen
    double worked = 0.0;   ///< processor time of all threads until `shown`
    Durations frame{};     ///< frame time from input to the end of drawing, while the pointer moves
    Durations panels{};    ///< share of the user interface in the frame time
    /// Processor time of the user interface's thread per frame, without drawing, with uploads.
    Durations thread{};
    Durations turning{};   ///< frame time while the camera moves, afterwards
    double closing = 0.0;  ///< duration of closing the editor while patches are laid out
};

/// Drops a bumpy sphere (app/bench/meshes.h) of about `faces` faces, as a binary PLY file, on the
/// editor with its start-up mesh, in an offscreen window drawn by OSMesa. Throws Error.
OpenBench bench_open(std::size_t faces);

Json open_bench_json(const OpenBench& bench);
std::string open_bench_table(const OpenBench& bench);

}  // namespace burl
