#include "app/bench/gl/editor_frames.h"

#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "app/bench/meshes.h"
#include "app/editor/window/program.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

constexpr std::size_t million = 1'000'000;
constexpr glm::dvec2 over_object{400.0, 400.0}, over_panels{1050.0, 400.0},
    over_graph{400.0, 650.0};

/// The editor in a window of its own, and what its frames took.
class FramesOf {
  public:
    FramesOf(const std::string& platform, const std::string& mesh, std::uint32_t side,
             const std::string& light)
        : light_(light) {
        EditorOptions options;
        options.mesh = mesh;
        options.settings = {fmt::format("atlas.size={}", side)};
        options.light = light;
        options.gallery = mesh.starts_with("sample:");  // its pictures take half a minute
        auto window =
            std::make_unique<BenchWindow>(create_gl_context(platform), glm::ivec2(1280, 800));
        window_ = window.get();
        editor_ = std::make_unique<EditorProgram>(std::move(window), options);
        play(R"({"settle": true})");
        rest(1.5);
    }

    /// Plays script steps that are part of what is measured, then the pointer in circles about
    /// `middle` for `seconds`, with a button held where it `drags`; then rests.
    FramesBench run(const std::string& what, const std::string& steps, const glm::dvec2& middle,
                    bool drags, double seconds) {
        FramesBench bench{what, light_};
        bench.faces = editor_->baker().front().surface()->triangles;
        begin();
        if (!steps.empty()) play(steps);
        const double start = window_->seconds(), processor = processor_seconds();
        if (drags) {
            turn_with({{InputKind::move, middle}});
            turn_with(held(true));
        }
        window_->set_hand([&](double now) {
            const double turn = 3.0 * (now - start);
            return std::vector<InputEvent>{
                {InputKind::move, middle + 100.0 * glm::dvec2(std::cos(turn), std::sin(turn))}};
        });
        while (window_->seconds() < start + seconds) editor_->turn();
        bench.seconds = window_->seconds() - start;
        end(bench);
        bench.processor = 1e3 * (processor_seconds() - processor) / double(bench.frames);
        window_->set_hand({});
        if (drags) turn_with(held(false));
        measure_idleness(bench);
        return bench;
    }

    /// Plays steps that are not measured.
    void play(const std::string& steps) {
        editor_->play(parse_script(R"({"burl_input": 1, "steps": [)" + steps + "]}", "bench"), "");
    }

  private:
    void begin() {
        for (std::vector<double>* all : {&frames_, &object_, &screen_}) all->clear();
        window_->on_frame([this](const BenchWindow::Frame& frame) {
            frames_.push_back(1e3 * (frame.end - frame.begin));
            object_.push_back(1e3 * editor_->times().object);
            screen_.push_back(1e3 * editor_->times().screen);
        });
    }
    void end(FramesBench& bench) {
        window_->on_frame({});
        bench.frames = frames_.size();
        bench.frame = durations_of(frames_);
        bench.object = durations_of(object_);
        bench.screen = durations_of(screen_);
    }

    std::vector<InputEvent> held(bool down) const {
        InputEvent event{InputKind::button};
        event.down = down;
        return {event};
    }
    void turn_with(const std::vector<InputEvent>& events) {
        window_->set_hand([&, used = false](double) mutable {
            return std::exchange(used, true) ? std::vector<InputEvent>() : events;
        });
        editor_->turn();
        window_->set_hand({});
    }
    void rest(double seconds) {
        const double until = window_->seconds() + seconds;
        while (window_->seconds() < until) editor_->turn();
    }
    void measure_idleness(FramesBench& bench) {
        play(R"({"settle": true})");
        rest(2.0);
        std::size_t frames = 0;
        window_->on_frame([&](const BenchWindow::Frame&) { ++frames; });
        const double before = processor_seconds(), start = window_->seconds();
        rest(3.0);
        const double seconds = window_->seconds() - start;
        window_->on_frame({});
        bench.idle_share = (processor_seconds() - before) / seconds;
        bench.idle_frames = double(frames) / seconds;
    }

    std::string light_;
    BenchWindow* window_ = nullptr;
    std::unique_ptr<EditorProgram> editor_;
    std::vector<double> frames_, object_, screen_;
};

// Dear ImGui has one context, so that one editor lives at a time.

void turn_teapot(const std::string& platform, std::uint32_t side, const std::string& light,
                 std::vector<FramesBench>& rows) {
    FramesOf teapot(platform, "sample:teapot", side, light);
    rows.push_back(teapot.run("teapot turns, library open", "", over_object, true, 2.0));
    rows.push_back(teapot.run("over the library", "", over_panels, false, 2.0));
    teapot.play(R"({"click": "tab:Log"}, {"settle": true}, {"wait": 3})");
    rows.push_back(teapot.run("teapot turns", "", over_object, true, 2.0));
}

void open_panels(const std::string& platform, std::uint32_t side, std::vector<FramesBench>& rows) {
    FramesOf teapot(platform, "sample:teapot", side, "headlight");
    teapot.play(R"({"click": "tab:Log"}, {"wait": 3})");
    rows.push_back(
        teapot.run("the library opens", R"({"click": "tab:Library"})", over_panels, false, 1.0));
    rows.push_back(teapot.run("the graph opens", R"({"key": "N"})", over_graph, false, 1.0));
    rows.push_back(teapot.run("the graph moves", "", over_graph, true, 2.0));
}

}  // namespace

std::vector<FramesBench> bench_frames(const std::string& platform, std::uint32_t side) {
    std::vector<FramesBench> rows;
    const BenchFolder folder;
    const std::string large = folder.path / "sphere.ply";
    write_bench_ply(large, bumpy_sphere(million));
    for (const char* light : {"headlight", "studio"}) {
        turn_teapot(platform, side, light, rows);
        rows.push_back(FramesOf(platform, large, side, light)
                           .run("a million faces turn", "", over_object, true, 2.0));
    }
    open_panels(platform, side, rows);
    return rows;
}

Json frames_json(const FramesBench& bench) {
    return {{"does", bench.what},
            {"light", bench.light},
            {"faces", bench.faces},
            {"frames", bench.frames},
            {"seconds", bench.seconds},
            {"frame_ms", durations_json(bench.frame)},
            {"object_ms", durations_json(bench.object)},
            {"screen_ms", durations_json(bench.screen)},
            {"processor_ms_per_frame", bench.processor},
            {"idle_processor_share", bench.idle_share},
            {"idle_frames_per_second", bench.idle_frames}};
}

void print_frames(const std::vector<FramesBench>& rows) {
    const auto line = [](const auto&... cells) {
        fmt::print("{:<28} {:<10} {:>8} {:>9} {:>18} {:>10} {:>10} {:>10} {:>7} {:>9}\n", cells...);
    };
    fmt::print("\n");
    line("done", "light", "faces", "frames", "frame ms: median,", "object", "screen", "processor",
         "idle", "idle");
    line("", "", "", "per s", "95 %, longest", "median ms", "median ms", "ms/frame", "%",
         "frames/s");
    const auto number = [](double value, int digits = 1) {
        return fmt::format("{:.{}f}", value, digits);
    };
    for (const FramesBench& row : rows)
        line(
            row.what, row.light, row.faces, number(double(row.frames) / row.seconds),
            fmt::format("{:.1f} {:.1f} {:.1f}", row.frame.median, row.frame.p95, row.frame.longest),
            number(row.object.median), number(row.screen.median), number(row.processor),
            number(100.0 * row.idle_share, 2), number(row.idle_frames, 2));
}

}  // namespace burl
