#pragma once
// The suite `burl bench editor`: a slider or stop dragged in real time, and how the picture follows
// it.
#include <cstdint>
#include <string>
#include <vector>

#include "app/base/json_text.h"

namespace burl {

/// Of some durations, in milliseconds.
struct Durations {
    double median = 0.0, p95 = 0.0, longest = 0.0;
};
/// All 0 of none.
Durations durations_of(std::vector<double> milliseconds);

struct EditorBench {
    std::string what{};      ///< the item dragged
    std::uint32_t side = 0;  ///< of the texture
    double seconds = 0.0;    ///< that the drag took
    std::size_t events = 0, frames = 0, textures = 0;
    std::size_t dropped_frames = 0;  ///< refreshes of the display that had to do without a new one
    /// From an event to the end of the first frame that shows its texture or a later one's; of
    /// every event.
    Durations latency{};
    Durations frame{};   ///< from input to the end of drawing, by OpenGL and all
    Durations panels{};  ///< the user interface's own part of it, without OpenGL
    /// Milliseconds from release to the end of the frame with the finest level, and to that of the
    /// first one with many samples a pixel.
    double finest_after = 0.0, smooth_after = 0.0;
    std::vector<std::size_t> levels{};  ///< how often each level was shown
    double processor = 0.0;   ///< milliseconds of processors, all threads', for each texture shown
    double idle_share = 0.0;  ///< processor time over time while nothing happens
};

/// Drags sliders and a colour stop of marble on `mesh` for `seconds` each with 60 events a second,
/// in a window nobody sees, drawn by OSMesa: all in software and on the machine's own threads.
/// Throws Error as EditorProgram does.
std::vector<EditorBench> bench_editor(const std::string& mesh, std::uint32_t side, double seconds);

Json editor_bench_json(const EditorBench& bench);
std::string editor_bench_table(const std::vector<EditorBench>& rows);

}  // namespace burl
