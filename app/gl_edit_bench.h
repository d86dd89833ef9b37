#pragma once
// The suite `burl bench editor`: a slider dragged by a script in real time, and how the picture
// follows it.
#include <cstdint>
#include <string>
#include <vector>

#include "app/json_text.h"

namespace burl {

struct EditorBench {
    std::string what{};      ///< the slider's path
    std::uint32_t side = 0;  ///< of the texture
    double seconds = 0.0;    ///< that the drag took
    std::size_t events = 0, frames = 0, textures = 0;
    /// Milliseconds from an event to the end of the first frame that shows its texture or a later
    /// one's; of every event.
    double latency_median = 0.0, latency_p95 = 0.0;
    double longest_frame = 0.0;      ///< milliseconds that the user interface was held up for most
    std::size_t dropped_frames = 0;  ///< that took longer than 1/30 second
    double finest_after = 0.0;       ///< milliseconds from release to the finest level
    std::vector<std::size_t> levels{};  ///< how often each level was shown
    double idle_share = 0.0;            ///< processor time over time while nothing happens
};

/// Drags each of the sliders of marble on `mesh` for `seconds` with 60 events a second, in a window
/// nobody sees, drawn by OSMesa: all in software and on the machine's own threads. Throws Error as
/// EditorProgram does.
std::vector<EditorBench> bench_editor(const std::string& mesh, std::uint32_t side, double seconds);

Json editor_bench_json(const EditorBench& bench);
std::string editor_bench_table(const std::vector<EditorBench>& rows);

}  // namespace burl
