#pragma once
// The suite `burl bench editor`: a slider or colour stop is dragged in real time, and latency and
// frame times are measured.
#include <cstdint>
#include <string>
#include <vector>

#include "app/base/json_text.h"

namespace burl {

/// Percentiles of durations, in milliseconds.
struct Durations {
    double median = 0.0, p95 = 0.0, longest = 0.0;
};
/// Computes the percentiles; 0 where there are no durations.
Durations durations_of(std::vector<double> milliseconds);

/// The results of one drag.
struct EditorBench {
    std::string what{};      ///< widget that was dragged
    std::uint32_t side = 0;  ///< side of the texture in texels
    double seconds = 0.0;    ///< duration of the drag
    std::size_t events = 0, frames = 0, textures = 0;
    std::size_t dropped_frames = 0;  ///< display refreshes without a new frame
    /// Time from an event to the end of the first frame that shows its texture or a later one, over
    /// all events.
    Durations latency{};
    Durations frame{};   ///< frame time from input to the end of drawing, OpenGL included
    Durations panels{};  ///< share of the user interface in the frame time, without OpenGL
    /// Milliseconds from the release to the end of the first frame at level 0, and to that of the
    /// first one with several samples per pixel.
    double finest_after = 0.0, smooth_after = 0.0;
    std::vector<std::size_t> levels{};  ///< number of textures shown at each level
    double processor = 0.0;   ///< processor time of all threads per texture shown, in milliseconds
    double idle_share = 0.0;  ///< processor time per time while nothing happens
};

/// Drags sliders and a colour stop of marble on `mesh` for `seconds` each, with 60 events a second,
/// in an offscreen window drawn by OSMesa: all in software, on the machine's own threads. Throws
/// Error as EditorProgram does.
std::vector<EditorBench> bench_editor(const std::string& mesh, std::uint32_t side, double seconds);

Json editor_bench_json(const EditorBench& bench);
std::string editor_bench_table(const std::vector<EditorBench>& rows);

}  // namespace burl
