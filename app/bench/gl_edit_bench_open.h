#pragma once
// The suite `burl bench open`: a large mesh is dropped on the editor, in real time; when its first
// picture is there, when its patches are, and whether the editor answers meanwhile.
#include <string>

#include "app/bench/editor.h"

namespace burl {

/// Seconds from the drop on, if nothing else is said.
struct OpenBench {
    std::size_t faces = 0;
    double read = 0.0;     ///< the mesh was read
    double shown = 0.0;    ///< its first picture was on the screen
    double finest = 0.0;   ///< the first one at level 0 was
    double smooth = 0.0;   ///< it was with many samples a pixel
    double patches = 0.0;  ///< the one with the recipe's own atlas was
    double worked = 0.0;   ///< processor time of all threads until `shown`
    Durations frame{};     ///< from input to the end of drawing, while the pointer moves
    Durations panels{};    ///< the user interface's own part of it
    Durations thread{};    ///< processor time of its thread, drawing aside, uploads with it
    Durations turning{};   ///< frames in which the camera moves, after all that
    double closing = 0.0;  ///< that closing it takes while patches are laid out
};

/// Drops a bumpy sphere (app/bench/meshes.h) of about so many faces, as a binary PLY file, on the
/// editor with its first mesh, in a window nobody sees, drawn by OSMesa. Throws Error.
OpenBench bench_open(std::size_t faces);

Json open_bench_json(const OpenBench& bench);
std::string open_bench_table(const OpenBench& bench);

}  // namespace burl
