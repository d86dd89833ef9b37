// The suite `burl bench editor`: a slider or colour stop is dragged in real time, under the
// headlight and under an environment, and latency and frame times are measured.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/bench/command.h"
#include "app/bench/gl/editor_frames.h"
#include "app/bench/gl/editor_window.h"
#include "app/editor/window/program.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// The results of one drag.
struct EditorBench {
    std::string what{};         ///< widget that was dragged
    std::string light{}, by{};  ///< the light, and who makes the texture
    std::uint32_t side = 0;     ///< side of the texture in texels
    double seconds = 0.0;       ///< duration of the drag
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

InputEvent pointer(const glm::dvec2& at) {
    return {InputKind::move, at};
}

InputEvent left_button(bool down) {
    InputEvent event{InputKind::button};
    event.down = down;
    return event;
}

/// A dragged widget, its tab, and the drag's length in screen coordinates.
struct Subject {
    const char* tab;
    const char* item;
    double reach;
    const char* steps = "";  ///< script steps before the drag
};
constexpr std::array drag_subjects{
    Subject{"Parameters", "texture.input.noise.0.amplitude", 60.0},
    Subject{"Parameters", "texture.input.noise.0.frequency.0", 20.0},
    Subject{"Parameters", "solid.scale", 60.0}, Subject{"Colours", "texture.stops.1", 60.0},
    // Drags the texture on the object.
    Subject{"Parameters", "object", 120.0,
            R"({"key": "G"}, {"wait": 2}, {"click": "move.axes"},)"}};

constexpr double pixels_per_second = 90.0;

/// A drag to the right and back, repeatedly, in real time.
class Drag {
  public:
    Drag(EditorProgram& editor, BenchWindow& window, const Subject& subject, EditorBench& bench)
        : editor_(editor), window_(window), subject_(subject), bench_(bench) {}

    void run(double seconds) {
        from_ = editor_.items().find(subject_.item).value().middle();
        turn_with({pointer(from_)});
        turn_with({left_button(true)});
        const double processor = processor_seconds();
        start_ = window_.seconds();
        window_.on_frame([this](const BenchWindow::Frame& frame) { note(frame); });
        window_.set_hand([this](double now) { return hand(now - start_); });
        while (window_.seconds() < start_ + seconds) editor_.turn();
        bench_.seconds = window_.seconds() - start_;
        bench_.processor = 1e3 * (processor_seconds() - processor) /
                           double(std::max<std::size_t>(bench_.textures, 1));
        summarise();
        release();
        window_.on_frame({});
        window_.set_hand({});
    }

  private:
    struct Event {
        std::uint64_t request = 0;
        double at = 0.0;
    };

    /// Plays events in one frame.
    void turn_with(const std::vector<InputEvent>& events) {
        window_.set_hand([&, used = false](double) mutable {
            return std::exchange(used, true) ? std::vector<InputEvent>() : events;
        });
        editor_.turn();
        window_.set_hand({});
    }

    /// Returns the pointer moving to and fro, fast enough that every event is on another pixel, as
    /// others change nothing.
    std::vector<InputEvent> hand(double seconds) {
        const double turn = std::fmod(pixels_per_second * seconds / subject_.reach, 2.0);
        const double x = std::min(turn, 2.0 - turn);
        moved_ = true;
        return {pointer(from_ + glm::dvec2(subject_.reach * x, 0.0))};
    }

    void note(const BenchWindow::Frame& frame) {
        const std::uint64_t request = editor_.last_request();
        if (std::exchange(moved_, false) && request != asked_)
            open_.push_back({request, frame.begin});
        asked_ = request;
        frames_.push_back(1e3 * (frame.end - frame.begin));
        panels_.push_back(1e3 * editor_.times().panels);
        last_frame_ = frame.end;
        const EditPicture* picture = editor_.shown();
        if (!picture || picture->number == shown_) return;
        shown_ = picture->number;
        ++bench_.textures;
        bench_.levels.resize(std::max<std::size_t>(bench_.levels.size(), picture->level + 1));
        ++bench_.levels[picture->level];
        std::erase_if(open_, [&](const Event& event) {
            if (event.request > picture->request) return false;
            latencies_.push_back(1e3 * (frame.end - event.at));
            return true;
        });
    }

    /// Computes the figures of a drag; a display refresh without a frame is a dropped frame.
    void summarise() {
        bench_.events = latencies_.size() + open_.size();
        bench_.frames = frames_.size();
        const double refreshes = bench_.seconds / BenchWindow::refresh_seconds;
        bench_.dropped_frames =
            std::size_t(std::max(0.0, std::floor(refreshes) - double(frames_.size())));
        bench_.latency = durations_of(latencies_);
        bench_.frame = durations_of(frames_);
        bench_.panels = durations_of(panels_);
    }

    void release() {
        bool sent = false;
        window_.set_hand([&](double) {
            return std::exchange(sent, true) ? std::vector<InputEvent>()
                                             : std::vector{left_button(false)};
        });
        const double released = window_.seconds();
        const auto since = [&] { return 1e3 * (last_frame_ - released); };
        while (bench_.finest_after == 0.0 || bench_.smooth_after == 0.0) {
            editor_.turn();
            const EditPicture* picture = editor_.shown();
            if (!sent || picture->request < editor_.last_request() || picture->level > 0) continue;
            if (bench_.finest_after == 0.0) bench_.finest_after = since();
            if (editor_.shown_smooth()) bench_.smooth_after = since();
        }
    }

    EditorProgram& editor_;
    BenchWindow& window_;
    Subject subject_;
    EditorBench& bench_;
    glm::dvec2 from_{0.0};
    double start_ = 0.0, last_frame_ = 0.0;
    bool moved_ = false;
    std::uint64_t asked_ = 0, shown_ = 0;
    std::vector<Event> open_;
    std::vector<double> latencies_, frames_, panels_;
};

void rest(EditorProgram& editor, const BenchWindow& window, double seconds) {
    const double until = window.seconds() + seconds;
    while (window.seconds() < until) editor.turn();
}

/// Returns the idle processor load, after the last drag's background work has ended.
double idle_share(EditorProgram& editor, const BenchWindow& window) {
    rest(editor, window, 0.5);
    const double before = processor_seconds(), start = window.seconds();
    rest(editor, window, 2.0);
    return (processor_seconds() - before) / (window.seconds() - start);
}

double share_of_finest(const EditorBench& row) {
    return row.textures == 0 ? 0.0 : double(row.levels.front()) / double(row.textures);
}

/// Drags sliders and a colour stop of marble on the teapot for four seconds each, with 60 events a
/// second, in an offscreen window, with OSMesa all in software on the machine's own threads. Throws
/// Error as EditorProgram does.
std::vector<EditorBench> bench_editor(const std::string& platform, std::uint32_t side,
                                      const std::string& light, EditSynthesis by) {
    EditorOptions options;
    options.light = light;
    options.synthesis = by;
    options.mesh = "sample:teapot";
    options.settings = {fmt::format("atlas.size={}", side)};
    auto owned = std::make_unique<BenchWindow>(create_gl_context(platform), glm::ivec2(1280, 800));
    BenchWindow& window = *owned;
    EditorProgram editor(std::move(owned), options);
    std::vector<EditorBench> rows;
    for (const Subject& subject : drag_subjects) {
        editor.play(parse_script(fmt::format(R"({{"burl_input": 1, "steps": [{{"settle": true}},
                                 {{"click": "tab:{}"}}, {} {{"wait": 3}}]}})",
                                             subject.tab, subject.steps),
                                 "bench"),
                    "");
        EditorBench bench;
        bench.what = subject.item;
        bench.light = light;
        bench.by = to_string(by);
        bench.side = side;
        Drag(editor, window, subject, bench).run(4.0);
        bench.idle_share = idle_share(editor, window);
        rows.push_back(std::move(bench));
    }
    return rows;
}

Json drag_json(const EditorBench& bench) {
    return {{"dragged", bench.what},
            {"light", bench.light},
            {"texture_by", bench.by},
            {"side", bench.side},
            {"events", bench.events},
            {"frames_per_second", double(bench.frames) / bench.seconds},
            {"dropped_frames", bench.dropped_frames},
            {"textures_per_second", double(bench.textures) / bench.seconds},
            {"latency_ms", durations_json(bench.latency)},
            {"frame_ms", durations_json(bench.frame)},
            {"panels_ms", durations_json(bench.panels)},
            {"finest_level_after_ms", bench.finest_after},
            {"smooth_after_ms", bench.smooth_after},
            {"levels", bench.levels},
            {"processor_ms_per_texture", bench.processor},
            {"idle_processor_share", bench.idle_share}};
}

void print_drags(const std::vector<EditorBench>& rows) {
    constexpr std::array titles{std::array{"textures", "per s"},
                                std::array{"at level 0", "%"},
                                std::array{"frames", "per s"},
                                std::array{"frames", "missed"},
                                std::array{"latency", "median ms"},
                                std::array{"latency", "95 %"},
                                std::array{"frame", "median ms"},
                                std::array{"frame", "longest"},
                                std::array{"panels", "longest"},
                                std::array{"finest", "after ms"},
                                std::array{"smooth", "after ms"},
                                std::array{"processor", "ms/texture"},
                                std::array{"idle", "%"}};
    for (const std::size_t line : {0, 1}) {
        fmt::print("{:<34}{:<10}{:<5}", line == 0 ? "dragged" : "", line == 0 ? "light" : "",
                   line == 0 ? "by" : "");
        for (const auto& title : titles) fmt::print(" {:>10}", title[line]);
        fmt::print("\n");
    }
    for (const EditorBench& row : rows) {
        fmt::print("{:<34}{:<10}{:<5}", row.what, row.light, row.by);
        for (const double figure :
             {double(row.textures) / row.seconds, 100.0 * share_of_finest(row),
              double(row.frames) / row.seconds, double(row.dropped_frames), row.latency.median,
              row.latency.p95, row.frame.median, row.frame.longest, row.panels.longest,
              row.finest_after, row.smooth_after, row.processor, 100.0 * row.idle_share})
            fmt::print(" {:>10.1f}", figure);
        fmt::print("\n");
    }
    std::fflush(stdout);  // minutes pass until the next
}

}  // namespace

void run_editor_bench(const BenchCommand& command) {
    const auto side = std::uint32_t(command.size_or(1024));
    Json rows = Json::array();
    for (const EditSynthesis by : {EditSynthesis::host, EditSynthesis::gl}) {
        if (by == EditSynthesis::gl && command.gl == "osmesa") continue;  // the host's processor
        for (const char* light : {"headlight", "studio"}) {
            const std::vector<EditorBench> drags = bench_editor(command.gl, side, light, by);
            for (const EditorBench& row : drags) rows.push_back(drag_json(row));
            if (!command.json) print_drags(drags);
        }
    }
    const std::vector<FramesBench> frames = bench_frames(command.gl, side);
    for (const FramesBench& row : frames) rows.push_back(frames_json(row));
    write_report(command, rows);
    if (!command.json) print_frames(frames);
}

}  // namespace burl
