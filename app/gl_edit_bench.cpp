#include "app/gl_edit_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <thread>

#include "app/gl_edit_program.h"

namespace burl {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double event_seconds = 1.0 / 60.0;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::ranges::sort(values);
    return values[std::size_t(share * double(values.size() - 1) + 0.5)];
}

InputEvent pointer(const glm::dvec2& at) {
    return {InputKind::move, at};
}

InputEvent left_button(bool down) {
    InputEvent event{InputKind::button};
    event.down = down;
    return event;
}

/// One drag, in real time.
class Drag {
  public:
    Drag(EditorProgram& editor, EditorBench& bench) : editor_(editor), bench_(bench) {}

    void run(double seconds) {
        const ItemRect rect = *editor_.items().find(bench_.what);
        frame({pointer(rect.middle())});
        frame({left_button(true)});
        start_ = Clock::now();
        const double reach = 0.3 * (rect.high.x - rect.low.x);
        while (since(start_) < seconds) {
            const double turn = since(start_) / seconds;
            const double x = turn < 0.5 ? 2.0 * turn : 2.0 - 2.0 * turn;
            step(rect.middle() + glm::dvec2(reach * x, 0.0));
        }
        bench_.seconds = since(start_);
        release();
        summarise();
    }

  private:
    struct Event {
        std::uint64_t request = 0;
        double at = 0.0;
    };

    /// An event each 1/60 second; frames as fast as they come.
    void step(const glm::dvec2& at) {
        const double now = since(start_);
        std::vector<InputEvent> events;
        if (now >= next_event_) {
            events.push_back(pointer(at));
            next_event_ = std::max(next_event_ + event_seconds, now - event_seconds);
        }
        const bool moved = !events.empty();
        const std::uint64_t before = editor_.last_request();
        frame(events);
        if (moved && editor_.last_request() != before)
            open_.push_back({editor_.last_request(), now});
        if (!moved) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }

    void frame(const std::vector<InputEvent>& events) {
        const auto begin = Clock::now();
        editor_.frame(events);
        const double took = 1e3 * since(begin);
        ++bench_.frames;
        bench_.longest_frame = std::max(bench_.longest_frame, took);
        if (took > 1e3 / 30.0) ++bench_.dropped_frames;
        note_picture();
    }

    void note_picture() {
        const auto picture = editor_.baker().picture();
        if (!picture || picture->number == shown_) return;
        shown_ = picture->number;
        ++bench_.textures;
        bench_.levels.resize(std::max<std::size_t>(bench_.levels.size(), picture->level + 1));
        ++bench_.levels[picture->level];
        const double now = since(start_);
        std::erase_if(open_, [&](const Event& event) {
            if (event.request > picture->request) return false;
            latencies_.push_back(1e3 * (now - event.at));
            return true;
        });
    }

    void release() {
        const auto released = Clock::now();
        frame({left_button(false)});
        const std::uint64_t last = editor_.last_request();
        for (;;) {
            frame({});
            const auto picture = editor_.baker().picture();
            if (picture->request >= last && picture->level == 0) break;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        bench_.finest_after = 1e3 * since(released);
    }

    void summarise() {
        bench_.events = latencies_.size() + open_.size();
        bench_.latency_median = percentile(latencies_, 0.5);
        bench_.latency_p95 = percentile(latencies_, 0.95);
    }

    EditorProgram& editor_;
    EditorBench& bench_;
    Clock::time_point start_ = Clock::now();
    double next_event_ = 0.0;
    std::uint64_t shown_ = 0;
    std::vector<Event> open_;
    std::vector<double> latencies_;
};

/// Frames of the window as run() would make them while nothing happens: one a second.
double idle_share(EditorProgram& editor) {
    const double before = processor_seconds();
    const auto start = Clock::now();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    editor.frame({});
    return (processor_seconds() - before) / since(start);
}

}  // namespace

std::vector<EditorBench> bench_editor(const std::string& mesh, std::uint32_t side, double seconds) {
    EditorOptions options;
    options.mesh = mesh;
    options.settings = {fmt::format("atlas.size={}", side)};
    EditorProgram editor(create_unseen_window(create_osmesa_context(), {1280, 800}), options);
    editor.play(parse_script(R"({"burl_input": 1, "steps": [{"settle": true},
                                 {"click": "tab:Parameters"}, {"wait": 3}]})",
                             "bench"),
                "");
    std::vector<EditorBench> rows;
    for (const char* path :
         {"texture.input.noise.0.amplitude", "texture.input.noise.0.frequency.0", "solid.scale"}) {
        EditorBench bench;
        bench.what = path;
        bench.side = side;
        Drag(editor, bench).run(seconds);
        bench.idle_share = idle_share(editor);
        rows.push_back(std::move(bench));
    }
    return rows;
}

Json editor_bench_json(const EditorBench& bench) {
    return {{"slider", bench.what},
            {"side", bench.side},
            {"events", bench.events},
            {"frames_per_second", double(bench.frames) / bench.seconds},
            {"textures_per_second", double(bench.textures) / bench.seconds},
            {"latency_ms_median", bench.latency_median},
            {"latency_ms_p95", bench.latency_p95},
            {"longest_frame_ms", bench.longest_frame},
            {"dropped_frames", bench.dropped_frames},
            {"finest_level_after_ms", bench.finest_after},
            {"levels", bench.levels},
            {"idle_processor_share", bench.idle_share}};
}

std::string editor_bench_table(const std::vector<EditorBench>& rows) {
    std::string text =
        fmt::format("{:<36} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "slider", "textures",
                    "frames", "latency", "p95", "longest", "finest", "idle");
    text += fmt::format("{:<36} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "", "per s", "per s",
                        "ms", "ms", "frame", "after", "%");
    for (const EditorBench& row : rows)
        text +=
            fmt::format("{:<36} {:>9.1f} {:>9.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.2f}\n",
                        row.what, double(row.textures) / row.seconds,
                        double(row.frames) / row.seconds, row.latency_median, row.latency_p95,
                        row.longest_frame, row.finest_after, 100.0 * row.idle_share);
    return text;
}

}  // namespace burl
