// The suite `burl bench open`: a large mesh is dropped on the editor in real time, and the times to
// its first texture and to its patch atlas and the frame times meanwhile are measured.
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/base/stopwatch.h"
#include "app/bench/command.h"
#include "app/bench/gl/editor_window.h"
#include "app/bench/meshes.h"
#include "app/editor/window/program.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

/// Seconds from the drop to an event, unless stated otherwise.
struct OpenBench {
    std::size_t faces = 0;
    double read = 0.0;       ///< the mesh has been read
    double shown = 0.0;      ///< its first texture is on the screen
    double finest = 0.0;     ///< its first texture at level 0 is on the screen
    double smooth = 0.0;     ///< level 0 is drawn with several samples per pixel
    double own_atlas = 0.0;  ///< level 0 in the recipe's own atlas is on the screen
    double worked = 0.0;     ///< processor time of all threads until `shown`
    Durations frame{};   ///< frame time from input to the end of drawing, while the pointer moves
    Durations panels{};  ///< share of the user interface in the frame time
    /// Processor time of the user interface's thread per frame, without drawing, with uploads.
    Durations thread{};
    Durations turning{};   ///< frame time while the camera moves, afterwards
    double closing = 0.0;  ///< duration of closing the editor while the atlas is laid out
};

constexpr glm::ivec2 window_size{1280, 800};

/// The editor while it opens a mesh, with moving pointer input and a record of its frame times.
class Opening {
  public:
    explicit Opening(const std::string& file) : file_(file) {
        auto window = std::make_unique<BenchWindow>(create_osmesa_context(), window_size);
        window_ = window.get();
        editor_ = std::make_unique<EditorProgram>(std::move(window), EditorOptions{});
        while (!editor_->shown() || !editor_->settled()) editor_->turn();
        window_->on_frame([this](const BenchWindow::Frame& frame) {
            frames_.push_back(1e3 * (frame.end - frame.begin));
            panels_.push_back(1e3 * editor_->times().panels);
            thread_.push_back(1e3 * editor_->times().worked);
        });
        InputEvent drop{InputKind::drop};
        drop.files = {file_};
        drop_ = drop;
        start_ = window_->seconds();
        window_->set_hand([this](double seconds) { return hand(seconds); });
    }

    /// Runs turns until `done`; returns the seconds since the drop.
    template <class Done>
    double until(const Done& done) {
        while (!done(*editor_)) editor_->turn();
        return window_->seconds() - start_;
    }
    void turn_camera(double seconds) {
        frames_.clear();
        turns_ = true;
        const double end = window_->seconds() + seconds;
        until([&](EditorProgram&) { return window_->seconds() > end; });
    }
    double close() {
        double seconds = 0.0;
        timed(seconds, [&] { editor_.reset(); });
        return seconds;
    }

    Durations frames() const { return durations_of(frames_); }
    Durations panels() const { return durations_of(panels_); }
    Durations thread() const { return durations_of(thread_); }

  private:
    /// Returns pointer motion in a circle: over the panels, or as a drag on the object.
    std::vector<InputEvent> hand(double seconds) {
        const glm::dvec2 round(std::cos(3.0 * seconds), std::sin(3.0 * seconds));
        const glm::dvec2 middle = turns_ ? glm::dvec2(400, 400) : glm::dvec2(1050, 400);
        std::vector<InputEvent> events{{InputKind::move, middle + 100.0 * round}};
        if (drop_) events.push_back(*std::exchange(drop_, std::nullopt));
        if (turns_ && !pressed_) {
            pressed_ = true;
            events.push_back({InputKind::button});
            events.back().down = true;
        }
        return events;
    }

    std::string file_;
    BenchWindow* window_ = nullptr;
    std::unique_ptr<EditorProgram> editor_;
    std::optional<InputEvent> drop_;
    double start_ = 0.0;
    bool turns_ = false, pressed_ = false;
    std::vector<double> frames_, panels_, thread_;
};

/// Drops a bumpy sphere (app/bench/meshes.h) of about `faces` faces, as a binary PLY file, on the
/// editor with its start-up mesh, in an offscreen window drawn by OSMesa. Throws Error.
OpenBench bench_open(std::size_t faces) {
    const BenchFolder folder;
    OpenBench bench;
    const std::string file = folder.path / "sphere.ply";
    {
        const Mesh mesh = bumpy_sphere(faces);
        bench.faces = mesh.triangles.size();
        write_bench_ply(file, mesh);
    }
    const auto read = [&](EditorProgram& editor) { return editor.files().mesh() == file; };
    const auto shown = [&](EditorProgram& editor) {
        const auto surface = editor.baker().front().surface();
        return surface->triangles == bench.faces && editor.shown() &&
               editor.shown()->surface == surface->number;
    };
    const auto finest = [&](EditorProgram& editor) {
        return shown(editor) && editor.shown()->level == 0;
    };
    const auto smooth = [&](EditorProgram& editor) {
        return finest(editor) && editor.shown_smooth();
    };
    const auto own_atlas = [&](EditorProgram& editor) {
        return finest(editor) && editor.baker().front().surface()->atlas == "chart";
    };
    {
        Opening opening(file);
        const std::clock_t began = std::clock();
        bench.read = opening.until(read);
        bench.shown = opening.until(shown);
        bench.worked = double(std::clock() - began) / CLOCKS_PER_SEC;
        bench.finest = opening.until(finest);
        bench.smooth = opening.until(smooth);
        bench.own_atlas = opening.until(own_atlas);
        bench.frame = opening.frames();
        bench.panels = opening.panels();
        bench.thread = opening.thread();
        opening.turn_camera(2.0);
        bench.turning = opening.frames();
    }
    Opening opening(file);
    opening.until(finest);
    bench.closing = opening.close();
    return bench;
}

Json open_json(const OpenBench& bench) {
    return {{"faces", bench.faces},
            {"read_seconds", bench.read},
            {"shown_seconds", bench.shown},
            {"shown_processor_seconds", bench.worked},
            {"finest_seconds", bench.finest},
            {"smooth_seconds", bench.smooth},
            {"own_atlas_seconds", bench.own_atlas},
            {"frame_ms", durations_json(bench.frame)},
            {"panels_ms", durations_json(bench.panels)},
            {"thread_ms", durations_json(bench.thread)},
            {"turning_ms", durations_json(bench.turning)},
            {"closing_seconds", bench.closing}};
}

void print_open(const OpenBench& bench) {
    const auto row = [](const Durations& d) {
        return fmt::format("{:.1f} ({:.1f}, longest {:.1f}) ms", d.median, d.p95, d.longest);
    };
    fmt::print(
        "{} faces\n  read                  {:.2f} s\n  first picture         {:.2f} s ({:.2f} s of "
        "processors)\n"
        "  finest level          {:.2f} s, smooth {:.2f} s\n  its own atlas         {:.2f} s\n"
        "  frames, median (p95)  {}\n  panels alone          {}\n  worked, drawing aside {}\n  "
        "while turning         {}\n"
        "  closing meanwhile     {:.2f} s\n",
        bench.faces, bench.read, bench.shown, bench.worked, bench.finest, bench.smooth,
        bench.own_atlas, row(bench.frame), row(bench.panels), row(bench.thread), row(bench.turning),
        bench.closing);
}

}  // namespace

void run_open_bench(const BenchCommand& command) {
    const std::array rows{bench_open(command.size_or(1'000'000))};
    if (report_rows(command, rows, open_json)) print_open(rows[0]);
}

}  // namespace burl
